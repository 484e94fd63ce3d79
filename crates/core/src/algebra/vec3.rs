//! Vectors of three components.

use crate::scalar::Real;
use std::ops::{Add, Neg, Sub};

/// A vector of three components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<T> {
    /// First component.
    pub x: T,
    /// Second component.
    pub y: T,
    /// Third component.
    pub z: T,
}

/// The unit vector along axis `i` (0, 1 or 2).
#[inline(always)]
pub fn basis<T: Real>(i: usize) -> Vec3<T> {
    let mut e = [T::zero(); 3];
    e[i] = T::one();
    Vec3::from_array(e)
}

impl<T: Real> Vec3<T> {
    /// A vector of its components.
    #[inline(always)]
    pub fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(T::zero(), T::zero(), T::zero())
    }
    /// A constant vector.
    #[inline(always)]
    pub fn lit(v: [f64; 3]) -> Self {
        Self::new(T::lit(v[0]), T::lit(v[1]), T::lit(v[2]))
    }
    /// A vector of an array.
    #[inline(always)]
    pub fn from_array(v: [T; 3]) -> Self {
        Self::new(v[0], v[1], v[2])
    }
    /// The first three numbers of a slice.
    #[inline(always)]
    pub fn from_slice(v: &[T]) -> Self {
        Self::new(v[0], v[1], v[2])
    }
    /// The components.
    #[inline(always)]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }
    /// Writes the components into the first three places of a slice.
    #[inline(always)]
    pub fn store(self, out: &mut [T]) {
        out[0] = self.x;
        out[1] = self.y;
        out[2] = self.z;
    }
    /// The scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> T {
        self.x.fma(o.x, self.y.fma(o.y, self.z * o.z))
    }
    /// The vector product.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Self::new(
            self.y.fma(o.z, -(self.z * o.y)),
            self.z.fma(o.x, -(self.x * o.z)),
            self.x.fma(o.y, -(self.y * o.x)),
        )
    }
    /// `self × o + p`.
    #[inline(always)]
    pub fn cross_add(self, o: Self, p: Self) -> Self {
        Self::new(
            self.y.fma(o.z, (-self.z).fma(o.y, p.x)),
            self.z.fma(o.x, (-self.x).fma(o.z, p.y)),
            self.x.fma(o.y, (-self.y).fma(o.x, p.z)),
        )
    }
    /// The product with a number.
    #[inline(always)]
    pub fn scale(self, s: T) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
    /// `self * s + o`.
    #[inline(always)]
    pub fn scale_add(self, s: T, o: Self) -> Self {
        Self::new(self.x.fma(s, o.x), self.y.fma(s, o.y), self.z.fma(s, o.z))
    }
    /// The length.
    #[inline(always)]
    pub fn norm(self) -> T {
        self.dot(self).sqrt()
    }
    /// The components passed through `f` one by one: another scalar type, a constant of it, a list.
    #[inline(always)]
    pub fn map<U: Real>(self, f: &mut impl FnMut(T) -> U) -> Vec3<U> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }
}

impl<T: Real> Add for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl<T: Real> Sub for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
