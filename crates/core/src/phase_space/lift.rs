//! A body made ready to run: with its forces in one piece, over another scalar, in another chart.

use super::{Chart, FreeBody};
use crate::forces::Acting;
use crate::scalar::Real;

impl FreeBody<f64> {
    /// The same body over another scalar, every parameter a constant of it.
    pub fn lift<T: Real>(&self) -> FreeBody<T> {
        let mut lifted = T::call(
            #[inline(always)]
            || self.map(&mut T::lit),
        );
        lifted.compiled = self.compiled.clone();
        lifted
    }

    /// The same model with its forces made ready to run: to be done once, before it is lifted.
    pub fn made_ready(self) -> Self {
        let moving = self.left.as_ref().is_some_and(|left| !left.contents.is_empty());
        let acting = Some(Acting::new(&self.forces, &self.inertia, moving));
        Self { acting, ..self }
    }

    /// The same model with its orientation as a quaternion.
    pub fn in_quaternions(&self) -> Self {
        let compiled = self.compiled.as_ref().map(|[_, block]| [block.clone(), block.clone()]);
        Self { chart: Chart::Quaternion, compiled, ..self.clone() }
    }
}
