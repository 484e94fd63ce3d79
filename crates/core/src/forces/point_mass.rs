//! Gravity of a point mass.

use super::Situation;
use crate::algebra::Vec3;
use crate::scalar::Real;
use crate::screw::Screw;

/// Attraction by a point mass (or a sphere), acting at the mass centre, with or without the torque of its
/// gradient over the body.
#[derive(Clone, Copy, Debug)]
pub struct PointMassGravity<T> {
    /// Gravitational parameter GM, m³/s².
    pub mu: T,
    /// Position of the attracting centre, world axes, m.
    pub center: Vec3<T>,
    /// Whether the gradient torque 3μ/r⁵ (r × J_c r) acts.
    ///
    /// Its counterpart, a force smaller than the attraction by the square of body size over distance, is left out
    /// (Hughes, Spacecraft Attitude Dynamics, 1986, section 8.1).
    pub gradient_torque: bool,
}

impl<T: Real> PointMassGravity<T> {
    /// The attraction −μ m r/r³ and the gradient torque.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let r = s.rotation.transpose_apply(s.com_position() - self.center);
        let inverse_square = T::one() / r.dot(r);
        let strength = self.mu * inverse_square * inverse_square.sqrt();
        let pull = r.scale(-(strength * s.inertia.mass));
        if !self.gradient_torque {
            return Screw::new(pull, Vec3::zero());
        }
        let torque = r.cross(s.inertia.about_com.apply(r)).scale(T::lit(3.0) * strength * inverse_square);
        Screw::new(pull, torque)
    }

    /// −μ m / r, zero at infinity; the small part that belongs to the gradient is left out as its force is.
    pub fn potential_energy(&self, s: &Situation<'_, T>) -> T {
        -(self.mu * s.inertia.mass / (s.com_position() - self.center).norm())
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> PointMassGravity<U> {
        PointMassGravity { mu: f(self.mu), center: self.center.map(f), gradient_torque: self.gradient_torque }
    }
}
