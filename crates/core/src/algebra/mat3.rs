//! Matrices of three rows and three columns.

use super::{Vec3, basis};
use crate::scalar::Real;
use std::ops::{Add, Mul, Neg, Sub};

/// A 3×3 matrix, kept by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat3<T> {
    /// The three rows.
    pub rows: [Vec3<T>; 3],
}

impl<T: Real> Mat3<T> {
    /// A matrix of its rows.
    #[inline(always)]
    pub fn from_rows(a: Vec3<T>, b: Vec3<T>, c: Vec3<T>) -> Self {
        Self { rows: [a, b, c] }
    }
    /// A matrix of its columns.
    #[inline(always)]
    pub fn from_columns(a: Vec3<T>, b: Vec3<T>, c: Vec3<T>) -> Self {
        Self::from_rows(a, b, c).transpose()
    }
    /// The zero matrix.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::from_rows(Vec3::zero(), Vec3::zero(), Vec3::zero())
    }
    /// The unit matrix E.
    #[inline(always)]
    pub fn identity() -> Self {
        Self::from_rows(basis(0), basis(1), basis(2))
    }
    /// A constant matrix, given by rows.
    #[inline(always)]
    pub fn lit(m: [[f64; 3]; 3]) -> Self {
        Self::from_rows(Vec3::lit(m[0]), Vec3::lit(m[1]), Vec3::lit(m[2]))
    }
    /// The nine numbers of a slice, by rows.
    #[inline(always)]
    pub fn from_slice(m: &[T]) -> Self {
        Self::from_rows(Vec3::from_slice(&m[..3]), Vec3::from_slice(&m[3..6]), Vec3::from_slice(&m[6..9]))
    }
    /// Writes the nine numbers by rows.
    #[inline(always)]
    pub fn store(self, out: &mut [T]) {
        self.rows[0].store(&mut out[..3]);
        self.rows[1].store(&mut out[3..6]);
        self.rows[2].store(&mut out[6..9]);
    }
    /// The diagonal matrix.
    #[inline(always)]
    pub fn diagonal(d: Vec3<T>) -> Self {
        let o = T::zero();
        Self::from_rows(Vec3::new(d.x, o, o), Vec3::new(o, d.y, o), Vec3::new(o, o, d.z))
    }
    /// The skew matrix ⟨a⟩ of a vector: `⟨a⟩ b = a × b`.
    #[inline(always)]
    pub fn skew(a: Vec3<T>) -> Self {
        let o = T::zero();
        Self::from_rows(Vec3::new(o, -a.z, a.y), Vec3::new(a.z, o, -a.x), Vec3::new(-a.y, a.x, o))
    }
    /// The transpose.
    #[inline(always)]
    pub fn transpose(self) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z))
    }
    /// Column `j`.
    #[inline(always)]
    pub fn column(self, j: usize) -> Vec3<T> {
        self.transpose().rows[j]
    }
    /// The product with a column.
    #[inline(always)]
    pub fn apply(self, v: Vec3<T>) -> Vec3<T> {
        Vec3::new(self.rows[0].dot(v), self.rows[1].dot(v), self.rows[2].dot(v))
    }
    /// The product of the transpose with a column.
    #[inline(always)]
    pub fn transpose_apply(self, v: Vec3<T>) -> Vec3<T> {
        let [a, b, c] = self.rows;
        a.scale_add(v.x, b.scale_add(v.y, c.scale(v.z)))
    }
    /// The product with a number.
    #[inline(always)]
    pub fn scale(self, s: T) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(a.scale(s), b.scale(s), c.scale(s))
    }
    /// The determinant.
    #[inline(always)]
    pub fn determinant(self) -> T {
        let [a, b, c] = self.rows;
        a.dot(b.cross(c))
    }
    /// The inverse, in closed form. Not finite for a singular matrix.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let [a, b, c] = self.rows;
        let (u, v, w) = (b.cross(c), c.cross(a), a.cross(b));
        let s = T::one() / a.dot(u);
        Self::from_columns(u.scale(s), v.scale(s), w.scale(s))
    }
    /// The entries passed through `f` one by one, by rows.
    #[inline(always)]
    pub fn map<U: Real>(self, f: &mut impl FnMut(T) -> U) -> Mat3<U> {
        let [a, b, c] = self.rows;
        Mat3::from_rows(a.map(f), b.map(f), c.map(f))
    }
}

impl<T: Real> Add for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.rows, o.rows);
        Self::from_rows(a + x, b + y, c + z)
    }
}

impl<T: Real> Sub for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.rows, o.rows);
        Self::from_rows(a - x, b - y, c - z)
    }
}

impl<T: Real> Neg for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(-a, -b, -c)
    }
}

impl<T: Real> Mul for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(o.transpose_apply(a), o.transpose_apply(b), o.transpose_apply(c))
    }
}
