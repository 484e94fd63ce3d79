//! The forces that most models have, one of each kind, as straight code.
//!
//! In a loop over all kinds of force everything that they read has to be in memory; here it stays in registers.

use super::damping::times;
use super::{
    Axes, Coefficients, ConstantWrench, Force, InputWrench, LinearDamping, Situation, UniformGravity,
};
use crate::algebra::Vec3;
use crate::inertia::Inertia;
use crate::scalar::Real;
use crate::screw::Screw;

/// The first force of each of some simple kinds.
#[derive(Clone, Debug)]
pub struct Usual<T> {
    gravity: Option<UniformGravity<T>>,
    /// The diagonal.
    damping: Option<Screw<T>>,
    /// In body axes; and the same about the mass centre, which does not change.
    constant: Option<(ConstantWrench<T>, Screw<T>)>,
    /// In body axes; and where it acts from the mass centre.
    input: Option<(InputWrench<T>, Vec3<T>)>,
}

impl<T> Default for Usual<T> {
    fn default() -> Self {
        Self { gravity: None, damping: None, constant: None, input: None }
    }
}

impl<T: Real> Usual<T> {
    /// Takes a force on a body that is the first of such a kind; whether it did.
    #[inline(always)]
    pub fn take(&mut self, force: &Force<T>, body: &Inertia<T>) -> bool {
        match force {
            Force::UniformGravity(f) if self.gravity.is_none() => self.gravity = Some(*f),
            Force::LinearDamping(LinearDamping { coefficients: Coefficients::Diagonal(d) })
                if self.damping.is_none() =>
            {
                self.damping = Some(*d);
            }
            Force::ConstantWrench(f) if self.constant.is_none() && f.axes == Axes::Body => {
                let (arm, w) = (f.at - body.com, f.wrench);
                self.constant = Some((*f, Screw::new(w.linear, arm.cross_add(w.linear, w.angular))));
            }
            Force::InputWrench(f) if self.input.is_none() && f.axes == Axes::Body => {
                self.input = Some((*f, f.at - body.com));
            }
            _ => return false,
        }
        true
    }

    /// The sum of their wrenches in body axes about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let (mut force, mut moment) = (Vec3::zero(), Vec3::zero());
        if let Some(f) = &self.gravity {
            force = f.about_com(s).linear;
        }
        if let Some(d) = self.damping {
            let drag = times(d.linear, s.twist.linear);
            force = force - drag;
            moment = s.inertia.com.cross(drag) - times(d.angular, s.twist.angular);
        }
        if let Some((_, w)) = self.constant {
            (force, moment) = (force + w.linear, moment + w.angular);
        }
        if let Some((f, arm)) = self.input {
            let [i, j, k, l, m, n] = f.places;
            let pushed = Vec3::new(s.inputs[i], s.inputs[j], s.inputs[k]);
            let turned = Vec3::new(s.inputs[l], s.inputs[m], s.inputs[n]);
            (force, moment) = (force + pushed, arm.cross_add(pushed, moment + turned));
        }
        Screw::new(force, moment)
    }

    /// The acceleration of gravity, world axes.
    #[inline(always)]
    pub(crate) fn acceleration(&self) -> Option<Vec3<T>> {
        self.gravity.as_ref().map(
            #[inline(always)]
            |f| f.acceleration,
        )
    }

    /// The diagonal of the damping.
    #[inline(always)]
    pub(crate) fn damping(&self) -> Option<Screw<T>> {
        self.damping
    }

    /// The wrench of inputs, in body axes, and where it acts from the mass centre.
    #[inline(always)]
    pub(crate) fn input(&self) -> Option<(InputWrench<T>, Vec3<T>)> {
        self.input
    }

    /// The place behind the last input that they read.
    pub fn inputs_end(&self) -> usize {
        self.input.map_or(0, |(f, _)| Force::InputWrench(f).inputs_end())
    }

    /// The parameters passed through `f`, for a body that went before.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U, body: &Inertia<U>) -> Usual<U> {
        let mut all = Usual::default();
        if let Some(force) = &self.gravity {
            all.take(&Force::UniformGravity(force.map(f)), body);
        }
        if let Some(d) = self.damping {
            let coefficients = Coefficients::Diagonal(d.map(f));
            all.take(&Force::LinearDamping(LinearDamping { coefficients }), body);
        }
        if let Some((force, _)) = &self.constant {
            all.take(&Force::ConstantWrench(force.map(f)), body);
        }
        if let Some((force, _)) = &self.input {
            all.take(&Force::InputWrench(force.map(f)), body);
        }
        all
    }
}
