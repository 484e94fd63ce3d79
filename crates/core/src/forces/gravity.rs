//! Uniform gravity: the gravity screw of the paper.

use super::Situation;
use crate::algebra::Vec3;
use crate::scalar::Real;
use crate::screw::Screw;

/// Gravity of one acceleration everywhere: G = S_c \[Cᵀ\](λ; λ), λ = m g. Konoplev (1.12)
#[derive(Clone, Copy, Debug)]
pub struct UniformGravity<T> {
    /// Acceleration, world axes, m/s²: (0, 0, g) when the third world axis points down.
    pub acceleration: Vec3<T>,
}

impl<T: Real> UniformGravity<T> {
    /// The weight \[Cᵀ\]λ, which has no moment about the mass centre. Konoplev (1.12)
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let weight = s.rotation.transpose_apply(self.acceleration).scale(s.inertia.mass);
        Screw::new(weight, Vec3::zero())
    }

    /// −m g · r_c, zero with the mass centre at the world origin.
    pub fn potential_energy(&self, s: &Situation<'_, T>) -> T {
        -(s.inertia.mass * self.acceleration.dot(s.com_position()))
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> UniformGravity<U> {
        UniformGravity { acceleration: self.acceleration.map(f) }
    }
}
