//! The Mises inertia matrix and what it does to screws: (1.5), (1.6).

mod validity;

pub use validity::{
    BodyDefect, check_com, check_mass, from_other_bodies, from_tensor_about_com, from_tensor_about_origin,
    principal_moments,
};

use crate::algebra::{Mat3, Mat6, Sym3, Vec3};
use crate::scalar::Real;
use crate::screw::Screw;

/// The mass properties of a rigid body about an arbitrary body frame: the Mises inertia matrix Θ.
///
/// Kept as mass, mass centre and inertia about the mass centre with their inverses, so that neither Θ
/// nor Θ⁻¹ is formed where a body moves.
#[derive(Clone, Copy, Debug)]
pub struct Inertia<T> {
    /// Mass m, kg.
    pub mass: T,
    /// Mass centre r_c in body axes, from the origin of the body frame, m.
    pub com: Vec3<T>,
    /// Inertia tensor about the mass centre, body axes, kg m².
    pub about_com: Sym3<T>,
    /// 1/m.
    pub(crate) inverse_mass: T,
    /// The inverse of `about_com`.
    pub(crate) inverse_about_com: Sym3<T>,
}

impl<T: Real> Inertia<T> {
    /// Of a mass, a mass centre and the inertia about the mass centre.
    #[inline(always)]
    pub fn new(mass: T, com: Vec3<T>, about_com: Sym3<T>) -> Self {
        Self { mass, com, about_com, inverse_mass: T::one() / mass, inverse_about_com: about_com.inverse() }
    }

    /// Of a mass, a mass centre and the inertia J about the origin of the body frame.
    pub fn of_origin(mass: T, com: Vec3<T>, about_origin: Sym3<T>) -> Self {
        Self::new(mass, com, about_origin - Sym3::of_unit_mass(com).scale(mass))
    }

    /// The inertia tensor J about the origin of the body frame.
    #[inline(always)]
    pub fn about_origin(&self) -> Sym3<T> {
        self.about_com + Sym3::of_unit_mass(self.com).scale(self.mass)
    }

    /// Θ = \[\[mE, m⟨r_c⟩ᵀ\], \[m⟨r_c⟩, J\]\]. Konoplev (1.6)
    pub fn matrix(&self) -> Mat6<T> {
        let s = Mat3::skew(self.com.scale(self.mass));
        Mat6::new(Mat3::identity().scale(self.mass), s.transpose(), s, self.about_origin().full())
    }

    /// Θ⁻¹, in closed form: constant, so it is computed once. Konoplev (1.11)
    pub fn inverse_matrix(&self) -> Mat6<T> {
        let (s, j) = (Mat3::skew(self.com), self.inverse_about_com.full());
        let sj = s * j;
        Mat6::new(Mat3::identity().scale(self.inverse_mass) - sj * s, sj, -(j * s), j)
    }

    /// The momentum ΘV = (p; K) about the body origin, by blocks. Konoplev (1.5)
    #[inline(always)]
    pub fn momentum(&self, twist: Screw<T>) -> Screw<T> {
        let p = (twist.linear + twist.angular.cross(self.com)).scale(self.mass);
        Screw::new(p, self.about_com.apply(twist.angular) + self.com.cross(p))
    }

    /// Θ⁻¹F for a wrench whose moment is taken about the mass centre: ω = Jc⁻¹M_c, v = f/m + r_c × ω.
    #[inline(always)]
    pub fn solve_about_com(&self, s: Screw<T>) -> Screw<T> {
        let w = self.inverse_about_com.apply(s.angular);
        Screw::new(self.com.cross_add(w, s.linear.scale(self.inverse_mass)), w)
    }

    /// The kinetic energy T = ½ VᵀΘV, J.
    #[inline(always)]
    pub fn kinetic_energy(&self, twist: Screw<T>) -> T {
        let u = twist.linear + twist.angular.cross(self.com);
        let w = twist.angular;
        (self.mass * u.dot(u) + w.dot(self.about_com.apply(w))) * T::lit(0.5)
    }

    /// The same body in another body frame: `origin` of the new frame in old axes, `rotation` old from new.
    pub fn in_frame(&self, origin: Vec3<T>, rotation: Mat3<T>) -> Self {
        Self::new(self.mass, rotation.transpose_apply(self.com - origin), self.about_com.turned(rotation))
    }

    /// Two bodies of one frame, rigidly joined.
    pub fn joined(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        let com = (self.com.scale(self.mass) + other.com.scale(other.mass)).scale(T::one() / mass);
        let shifted = |b: &Self| b.about_com + Sym3::of_unit_mass(b.com - com).scale(b.mass);
        Self::new(mass, com, shifted(self) + shifted(other))
    }

    /// The ten inertial parameters θ = (m, m r_c, J about the origin: xx, xy, xz, yy, yz, zz).
    pub fn parameters(&self) -> [T; 10] {
        let s = self.com.scale(self.mass);
        let j = self.about_origin();
        [self.mass, s.x, s.y, s.z, j.xx, j.xy, j.xz, j.yy, j.yz, j.zz]
    }

    /// The independent numbers passed through `f` one by one; the inverses are computed anew.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> Inertia<U> {
        Inertia::new(f(self.mass), self.com.map(f), self.about_com.map(f))
    }
}
