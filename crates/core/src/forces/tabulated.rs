//! A wrench tabulated over time.

use super::{Axes, Situation};
use crate::algebra::Vec3;
use crate::scalar::{Real, Table};
use crate::screw::Screw;

/// A force and a moment given by tables over time, in body or world axes, applied at a point of the body.
#[derive(Clone, Debug)]
pub struct TabulatedWrench<T> {
    /// The six components over time; none where a component is always zero.
    pub components: [Option<Table>; 6],
    /// Point of application, body axes, from the body origin, m.
    pub at: Vec3<T>,
    /// The axes of the components.
    pub axes: Axes,
}

impl<T: Real> TabulatedWrench<T> {
    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let mut six = [T::zero(); 6];
        for (x, table) in six.iter_mut().zip(&self.components) {
            if let Some(table) = table {
                *x = s.time.lookup(table);
            }
        }
        self.axes.about_com(Screw::from_slice(&six), self.at, s)
    }

    /// Times at which a component or its slope jumps.
    pub fn breaks(&self) -> Vec<f64> {
        self.components.iter().flatten().flat_map(|t| t.breaks().iter().copied()).collect()
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> TabulatedWrench<U> {
        TabulatedWrench { components: self.components.clone(), at: self.at.map(f), axes: self.axes }
    }
}
