//! Matrices that act on screws: four 3×3 blocks.
//!
//! They are the literal form of the equations, to read, to teach and to test against;
//! the running kernel never forms one.

use super::{Mat3, Vec3};
use crate::scalar::Real;
use crate::screw::Screw;
use std::ops::{Add, Mul, Sub};

/// A 6×6 matrix of four 3×3 blocks, linear part first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat6<T> {
    /// Upper left: linear from linear.
    pub ll: Mat3<T>,
    /// Upper right: linear from angular.
    pub la: Mat3<T>,
    /// Lower left: angular from linear.
    pub al: Mat3<T>,
    /// Lower right: angular from angular.
    pub aa: Mat3<T>,
}

impl<T: Real> Mat6<T> {
    /// A matrix of its blocks, by rows.
    #[inline(always)]
    pub fn new(ll: Mat3<T>, la: Mat3<T>, al: Mat3<T>, aa: Mat3<T>) -> Self {
        Self { ll, la, al, aa }
    }
    /// diag(a, b).
    #[inline(always)]
    pub fn diagonal(a: Mat3<T>, b: Mat3<T>) -> Self {
        Self::new(a, Mat3::zero(), Mat3::zero(), b)
    }
    /// The unit matrix.
    pub fn identity() -> Self {
        Self::diagonal(Mat3::identity(), Mat3::identity())
    }
    /// The transpose.
    pub fn transpose(self) -> Self {
        Self::new(self.ll.transpose(), self.al.transpose(), self.la.transpose(), self.aa.transpose())
    }
    /// The product with a screw.
    #[inline(always)]
    pub fn apply(self, s: Screw<T>) -> Screw<T> {
        Screw::new(
            self.ll.apply(s.linear) + self.la.apply(s.angular),
            self.al.apply(s.linear) + self.aa.apply(s.angular),
        )
    }
    /// The inverse by blocks; `ll` and its Schur complement must be regular.
    pub fn inverse(self) -> Self {
        let a = self.ll.inverse();
        let s = (self.aa - self.al * a * self.la).inverse();
        let u = a * self.la * s;
        let w = self.al * a;
        Self::new(a + u * w, -u, -(s * w), s)
    }
    /// Reads 36 numbers, by rows.
    pub fn from_slice(m: &[T]) -> Self {
        let row = |i: usize, j: usize| Vec3::from_slice(&m[6 * i + j..6 * i + j + 3]);
        let block = |i: usize, j: usize| Mat3::from_rows(row(i, j), row(i + 1, j), row(i + 2, j));
        Self::new(block(0, 0), block(0, 3), block(3, 0), block(3, 3))
    }
    /// Writes 36 numbers, by rows.
    pub fn store(self, out: &mut [T]) {
        for i in 0..3 {
            self.ll.rows[i].store(&mut out[6 * i..]);
            self.la.rows[i].store(&mut out[6 * i + 3..]);
            self.al.rows[i].store(&mut out[6 * i + 18..]);
            self.aa.rows[i].store(&mut out[6 * i + 21..]);
        }
    }
}

impl<T: Real> Add for Mat6<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.ll + o.ll, self.la + o.la, self.al + o.al, self.aa + o.aa)
    }
}

impl<T: Real> Sub for Mat6<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.ll - o.ll, self.la - o.la, self.al - o.al, self.aa - o.aa)
    }
}

impl<T: Real> Mul for Mat6<T> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(
            self.ll * o.ll + self.la * o.al,
            self.ll * o.la + self.la * o.aa,
            self.al * o.ll + self.aa * o.al,
            self.al * o.la + self.aa * o.aa,
        )
    }
}
