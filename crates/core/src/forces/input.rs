//! The control u as a wrench. (3.2)

use super::{Axes, Situation};
use crate::algebra::Vec3;
use crate::scalar::Real;
use crate::screw::Screw;

/// Six inputs of u as force and moment in body or world axes, applied at a point of the body. Konoplev (3.2)
#[derive(Clone, Copy, Debug)]
pub struct InputWrench<T> {
    /// Place of the first of the six in u.
    pub first: usize,
    /// Point of application, body axes, from the body origin, m.
    pub at: Vec3<T>,
    /// The axes of the components.
    pub axes: Axes,
}

impl<T: Real> InputWrench<T> {
    /// How many inputs the element reads.
    pub const COUNT: usize = 6;

    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        self.axes.about_com(Screw::from_slice(&s.inputs[self.first..]), self.at, s)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> InputWrench<U> {
        InputWrench { first: self.first, at: self.at.map(f), axes: self.axes }
    }
}
