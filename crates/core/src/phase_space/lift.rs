//! A body made ready to run: with one law for all traced forces, over another scalar, in another chart.

use super::{Chart, FreeBody};
use crate::forces::{Force, Traced};
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

    /// The same model with one law for all traced forces: to be made once, before it is lifted.
    pub fn with_one_law(self) -> Self {
        let mut laws = Vec::new();
        for force in &self.forces {
            if let Force::Traced(law) = force {
                laws.push(law);
            }
        }
        let law = Traced::<f64>::joined(&laws);
        Self { law, ..self }
    }

    /// The same model with its orientation as a quaternion.
    pub fn in_quaternions(&self) -> Self {
        let compiled = self.compiled.as_ref().map(|[_, block]| [block.clone(), block.clone()]);
        Self { chart: Chart::Quaternion, compiled, ..self.clone() }
    }
}
