//! Damping by the motion of the body origin.

use super::Situation;
use super::wrench::about_com;
use crate::algebra::{Mat6, Vec3};
use crate::scalar::Real;
use crate::screw::Screw;

/// A 6×6 matrix of coefficients.
#[derive(Clone, Copy, Debug)]
pub enum Coefficients<T> {
    /// Of six numbers on the diagonal.
    Diagonal(Screw<T>),
    /// Of all 36 numbers.
    Full(Mat6<T>),
}

impl<T: Real> Coefficients<T> {
    /// The product with a screw.
    #[inline(always)]
    fn apply(&self, s: Screw<T>) -> Screw<T> {
        match self {
            Self::Diagonal(d) => Screw::new(times(d.linear, s.linear), times(d.angular, s.angular)),
            Self::Full(m) => m.apply(s),
        }
    }

    /// The numbers passed through `f`.
    #[inline(always)]
    fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> Coefficients<U> {
        match self {
            Self::Diagonal(d) => Coefficients::Diagonal(d.map(f)),
            Self::Full(m) => {
                Coefficients::Full(Mat6::new(m.ll.map(f), m.la.map(f), m.al.map(f), m.aa.map(f)))
            }
        }
    }
}

/// The product of two vectors component by component.
#[inline(always)]
pub(super) fn times<T: Real>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    Vec3::new(a.x * b.x, a.y * b.y, a.z * b.z)
}

/// The absolute values of the components.
#[inline(always)]
fn absolute<T: Real>(a: Vec3<T>) -> Vec3<T> {
    Vec3::new(a.x.abs(), a.y.abs(), a.z.abs())
}

/// F = −D V, with V the twist of the body origin in body axes.
#[derive(Clone, Copy, Debug)]
pub struct LinearDamping<T> {
    /// D: N s/m, N s/rad, N m s/m and N m s/rad by blocks.
    pub coefficients: Coefficients<T>,
}

impl<T: Real> LinearDamping<T> {
    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let given = self.coefficients.apply(s.twist);
        about_com(-given, s)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> LinearDamping<U> {
        LinearDamping { coefficients: self.coefficients.map(f) }
    }
}

/// F = −D (|V| V), with each component of the twist times its own size (Fossen, Handbook of Marine Craft
/// Hydrodynamics and Motion Control, 2011, section 6.4).
#[derive(Clone, Copy, Debug)]
pub struct QuadraticDamping<T> {
    /// D, by blocks in N, N m per (m/s)² and (rad/s)².
    pub coefficients: Coefficients<T>,
}

impl<T: Real> QuadraticDamping<T> {
    /// The wrench about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let (v, w) = (s.twist.linear, s.twist.angular);
        let given = self.coefficients.apply(Screw::new(times(absolute(v), v), times(absolute(w), w)));
        about_com(-given, s)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> QuadraticDamping<U> {
        QuadraticDamping { coefficients: self.coefficients.map(f) }
    }
}
