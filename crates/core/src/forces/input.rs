//! The control u as a wrench. (3.2)

use super::{Axes, Situation};
use crate::algebra::Vec3;
use crate::scalar::Real;
use crate::screw::Screw;

/// Six inputs of u as force and moment in body or world axes, applied at a point of the body. Konoplev (3.2)
#[derive(Clone, Copy, Debug)]
pub struct InputWrench<T> {
    /// Places of the six in the inputs.
    pub places: [usize; 6],
    /// Point of application, body axes, from the body origin, m.
    pub at: Vec3<T>,
    /// The axes of the components.
    pub axes: Axes,
}

impl<T: Real> InputWrench<T> {
    /// Six places from a first one on.
    pub fn from_place(first: usize) -> [usize; 6] {
        std::array::from_fn(|k| first + k)
    }

    /// Its six inputs.
    #[inline(always)]
    pub(super) fn read(&self, inputs: &[T]) -> Screw<T> {
        let [i, j, k, l, m, n] = self.places;
        Screw::new(Vec3::new(inputs[i], inputs[j], inputs[k]), Vec3::new(inputs[l], inputs[m], inputs[n]))
    }

    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        self.axes.about_com(self.read(s.inputs), self.at, s)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> InputWrench<U> {
        InputWrench { places: self.places, at: self.at.map(f), axes: self.axes }
    }
}
