//! Screws and their transforms: section 1, (1.1)–(1.4) and (1.9).
//!
//! A screw is a pair of vectors, **linear part first**: a twist (v; ω), a wrench (force; moment) or a
//! momentum (p; K). The second vector of a wrench or a momentum is taken about the origin of its frame.

use crate::algebra::{Mat3, Mat6, Vec3};
use crate::scalar::Real;
use std::ops::{Add, Neg, Sub};

/// A twist, a wrench or a momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screw<T> {
    /// Velocity (m/s), force (N) or momentum (kg m/s).
    pub linear: Vec3<T>,
    /// Angular velocity (rad/s), moment (N m) or angular momentum (kg m²/s).
    pub angular: Vec3<T>,
}

impl<T: Real> Screw<T> {
    /// A screw of its two vectors.
    #[inline(always)]
    pub fn new(linear: Vec3<T>, angular: Vec3<T>) -> Self {
        Self { linear, angular }
    }
    /// The zero screw.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(Vec3::zero(), Vec3::zero())
    }
    /// The screw `S (x; x) = (x; r × x)` of a vector on a line through the point `r`,
    /// S = diag(E, ⟨r⟩): the wrench of a force `x` applied at `r`. Konoplev (1.1)
    #[inline(always)]
    pub fn at_point(x: Vec3<T>, r: Vec3<T>) -> Self {
        Self::new(x, r.cross(x))
    }
    /// The same wrench with its moment about the point `r` instead of the origin.
    #[inline(always)]
    pub fn about_point(self, r: Vec3<T>) -> Self {
        Self::new(self.linear, self.linear.cross_add(r, self.angular))
    }
    /// Six numbers of a slice.
    #[inline(always)]
    pub fn from_slice(s: &[T]) -> Self {
        Self::new(Vec3::from_slice(&s[..3]), Vec3::from_slice(&s[3..6]))
    }
    /// Writes six numbers.
    #[inline(always)]
    pub fn store(self, out: &mut [T]) {
        self.linear.store(&mut out[..3]);
        self.angular.store(&mut out[3..6]);
    }
    /// The product with a number.
    #[inline(always)]
    pub fn scale(self, s: T) -> Self {
        Self::new(self.linear.scale(s), self.angular.scale(s))
    }
    /// The sum of the products of components: the power of a wrench on a twist.
    #[inline(always)]
    pub fn dot(self, o: Self) -> T {
        self.linear.dot(o.linear) + self.angular.dot(o.angular)
    }
    /// The components passed through `f` one by one.
    #[inline(always)]
    pub fn map<U: Real>(self, f: &mut impl FnMut(T) -> U) -> Screw<U> {
        Screw::new(self.linear.map(f), self.angular.map(f))
    }
}

impl<T: Real> Add for Screw<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::new(self.linear + o.linear, self.angular + o.angular)
    }
}

impl<T: Real> Sub for Screw<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::new(self.linear - o.linear, self.angular - o.angular)
    }
}

impl<T: Real> Neg for Screw<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.linear, -self.angular)
    }
}

/// S = diag(E, ⟨r⟩) of the point `r`: `S (x; x)` is the screw of the vector x through it. Konoplev (1.1)
pub fn line_matrix<T: Real>(r: Vec3<T>) -> Mat6<T> {
    Mat6::diagonal(Mat3::identity(), Mat3::skew(r))
}

/// The wrench transform L = T \[C\] = \[\[C, 0\], \[⟨o⟩C, C\]\], world from body: `o` is the position of the body
/// origin in world axes, `c` the rotation. Konoplev (1.2), (1.3)
pub fn wrench_transform<T: Real>(o: Vec3<T>, c: Mat3<T>) -> Mat6<T> {
    let translation = Mat6::new(Mat3::identity(), Mat3::zero(), Mat3::skew(o), Mat3::identity());
    translation * Mat6::diagonal(c, c)
}

/// The inverse wrench transform L⁻¹ = \[\[Cᵀ, 0\], \[−Cᵀ⟨o⟩, Cᵀ\]\], body from world. Konoplev (1.4)
pub fn wrench_transform_inverse<T: Real>(o: Vec3<T>, c: Mat3<T>) -> Mat6<T> {
    let ct = c.transpose();
    Mat6::new(ct, Mat3::zero(), -(ct * Mat3::skew(o)), ct)
}

/// A wrench or momentum carried from the body frame to the world frame, by blocks: `L s`. Konoplev (1.2)
#[inline(always)]
pub fn world_from_body<T: Real>(o: Vec3<T>, c: Mat3<T>, s: Screw<T>) -> Screw<T> {
    let linear = c.apply(s.linear);
    Screw::new(linear, c.apply(s.angular) + o.cross(linear))
}

/// A wrench or momentum carried from the world frame to the body frame, by blocks: `L⁻¹ s`. Konoplev (1.4)
#[inline(always)]
pub fn body_from_world<T: Real>(o: Vec3<T>, c: Mat3<T>, s: Screw<T>) -> Screw<T> {
    Screw::new(c.transpose_apply(s.linear), c.transpose_apply(s.angular - o.cross(s.linear)))
}

/// Φ = L⁻¹ dL/dt = \[\[⟨ω⟩, 0\], \[⟨v⟩, ⟨ω⟩\]\] of a twist in body axes. Konoplev (1.9)
pub fn force_cross<T: Real>(twist: Screw<T>) -> Mat6<T> {
    let w = Mat3::skew(twist.angular);
    Mat6::new(w, Mat3::zero(), Mat3::skew(twist.linear), w)
}

/// `Φ(V) s` by blocks: (ω × f; v × f + ω × m). Konoplev (1.9)
#[inline(always)]
pub fn force_cross_apply<T: Real>(twist: Screw<T>, s: Screw<T>) -> Screw<T> {
    let (v, w) = (twist.linear, twist.angular);
    Screw::new(w.cross(s.linear), v.cross(s.linear) + w.cross(s.angular))
}
