//! A constant wrench.

use super::Situation;
use crate::algebra::Vec3;
use crate::scalar::Real;
use crate::screw::Screw;

/// The axes in which the components of a wrench are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Body axes.
    Body,
    /// World axes.
    World,
}

impl Axes {
    /// The wrench in body axes about the mass centre of a force and a moment given in these axes at a point.
    #[inline(always)]
    pub fn about_com<T: Real>(self, given: Screw<T>, at: Vec3<T>, s: &Situation<'_, T>) -> Screw<T> {
        let local = match self {
            Axes::Body => given,
            Axes::World => Screw::new(
                s.rotation.transpose_apply(given.linear),
                s.rotation.transpose_apply(given.angular),
            ),
        };
        let arm = at - s.inertia.com;
        Screw::new(local.linear, arm.cross_add(local.linear, local.angular))
    }
}

/// A wrench in body axes about the body origin, taken about the mass centre.
#[inline(always)]
pub fn about_com<T: Real>(wrench: Screw<T>, s: &Situation<'_, T>) -> Screw<T> {
    Screw::new(wrench.linear, wrench.linear.cross_add(s.inertia.com, wrench.angular))
}

/// A force and a moment, constant in body or world axes, applied at a point of the body. Konoplev (1.1)
#[derive(Clone, Copy, Debug)]
pub struct ConstantWrench<T> {
    /// Force and moment, N and N m, in `axes`.
    pub wrench: Screw<T>,
    /// Point of application, body axes, from the body origin, m.
    pub at: Vec3<T>,
    /// The axes of the components.
    pub axes: Axes,
}

impl<T: Real> ConstantWrench<T> {
    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        self.axes.about_com(self.wrench, self.at, s)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> ConstantWrench<U> {
        ConstantWrench { wrench: self.wrench.map(f), at: self.at.map(f), axes: self.axes }
    }
}
