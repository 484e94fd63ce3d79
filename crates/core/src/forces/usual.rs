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
    damping: Option<Screw<T>>,
    /// In body axes.
    constant: Option<ConstantWrench<T>>,
    /// In body axes; and where it acts from the mass centre.
    input: Option<(InputWrench<T>, Vec3<T>)>,
    sum: Sum<T>,
}

/// What they add up to; zero where there are none, for a product costs less than a branch.
#[derive(Clone, Debug)]
struct Sum<T> {
    /// The acceleration of gravity, world axes.
    field: Vec3<T>,
    /// The diagonal of the damping.
    damping: Screw<T>,
    /// The constant wrench about the mass centre.
    constant: Screw<T>,
}

impl<T: Real> Default for Usual<T> {
    /// Without any.
    #[inline(always)]
    fn default() -> Self {
        let sum = Sum { field: Vec3::zero(), damping: Screw::zero(), constant: Screw::zero() };
        Self { gravity: None, damping: None, constant: None, input: None, sum }
    }
}

impl<T: Real> Usual<T> {
    /// Takes a force on a body that is the first of such a kind; whether it did.
    #[inline(always)]
    pub fn take(&mut self, force: &Force<T>, body: &Inertia<T>) -> bool {
        match force {
            Force::UniformGravity(f) if self.gravity.is_none() => {
                self.sum.field = f.acceleration;
                self.gravity = Some(*f);
            }
            Force::LinearDamping(LinearDamping { coefficients: Coefficients::Diagonal(d) })
                if self.damping.is_none() =>
            {
                self.sum.damping = *d;
                self.damping = Some(*d);
            }
            Force::ConstantWrench(f) if self.constant.is_none() && f.axes == Axes::Body => {
                let (arm, w) = (f.at - body.com, f.wrench);
                self.sum.constant = Screw::new(w.linear, arm.cross_add(w.linear, w.angular));
                self.constant = Some(*f);
            }
            Force::InputWrench(f) if self.input.is_none() && f.axes == Axes::Body => {
                self.input = Some((*f, f.at - body.com));
            }
            _ => return false,
        }
        true
    }

    /// The constant wrench and that of the inputs, about the mass centre.
    #[inline(always)]
    fn pushes(&self, inputs: &[T]) -> Screw<T> {
        let constant = self.sum.constant;
        match &self.input {
            Some((f, arm)) => {
                let Screw { linear, angular } = f.read(inputs);
                let moment = arm.cross_add(linear, constant.angular + angular);
                Screw::new(constant.linear + linear, moment)
            }
            None => constant,
        }
    }

    /// The same forces, to the last bit, with inputs that do not change among what is constant.
    #[inline(always)]
    pub fn with_constant(&self, inputs: &[T]) -> Self {
        let mut all = self.clone();
        all.sum.constant = self.pushes(inputs);
        all.input = None;
        all
    }

    /// The sum of their wrenches but for the weight, in body axes about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let (pushes, damping) = (self.pushes(s.inputs), &self.sum.damping);
        let drag = times(damping.linear, s.twist.linear);
        // Two short sums are ready before one long one.
        let slowed = s.inertia.com.cross_add(drag, -times(damping.angular, s.twist.angular));
        Screw::new(pushes.linear - drag, pushes.angular + slowed)
    }

    /// What gravity accelerates every mass by, body axes.
    #[inline(always)]
    pub fn field(&self, s: &Situation<'_, T>) -> Vec3<T> {
        s.rotation.transpose_apply(self.sum.field)
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
        if let Some(force) = &self.constant {
            all.take(&Force::ConstantWrench(force.map(f)), body);
        }
        if let Some((force, _)) = &self.input {
            all.take(&Force::InputWrench(force.map(f)), body);
        }
        all
    }
}
