//! A body made ready to run: over another scalar, with one law for all traced forces, in another chart.

use super::{Chart, FreeBody};
use crate::forces::{Force, Traced};
use crate::scalar::Real;

impl FreeBody<f64> {
    /// The same body over another scalar, every parameter a constant of it.
    pub fn lift<T: Real>(&self) -> FreeBody<T> {
        let joined = self.with_one_law();
        let mut lifted = T::call(
            #[inline(always)]
            || joined.map(&mut T::lit),
        );
        lifted.compiled = self.compiled.clone();
        lifted
    }

    /// The same model with one law for all traced forces.
    fn with_one_law(&self) -> Self {
        let (laws, others): (Vec<_>, Vec<_>) =
            self.forces.iter().partition(|f| matches!(f, Force::Traced(_)));
        let laws: Vec<&Traced<f64>> = laws
            .into_iter()
            .filter_map(|f| if let Force::Traced(law) = f { Some(law) } else { None })
            .collect();
        let law = Traced::<f64>::joined(&laws);
        if law.is_none() {
            return self.clone();
        }
        Self { forces: others.into_iter().cloned().collect(), law, ..self.clone() }
    }

    /// The same model with its orientation as a quaternion.
    pub fn in_quaternions(&self) -> Self {
        let compiled = self.compiled.as_ref().map(|[_, block]| [block.clone(), block.clone()]);
        Self { chart: Chart::Quaternion, compiled, ..self.clone() }
    }
}
