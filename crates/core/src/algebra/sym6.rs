//! Symmetric matrices that act on screws.

use super::{Mat3, Sym3, Vec3};
use crate::scalar::Real;
use crate::screw::Screw;
use std::ops::Add;

/// A symmetric 6×6 matrix, linear part first: 21 numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sym6<T> {
    /// Upper left: linear from linear.
    pub ll: Sym3<T>,
    /// Upper right, linear from angular; its transpose stands lower left.
    pub la: Mat3<T>,
    /// Lower right: angular from angular.
    pub aa: Sym3<T>,
}

impl<T: Real> Sym6<T> {
    /// The symmetric part of 36 numbers by rows.
    pub fn from_slice(m: &[T]) -> Self {
        let entry = |i: usize, j: usize| (m[6 * i + j] + m[6 * j + i]) * T::lit(0.5);
        let row = |i: usize, j: usize| Vec3::new(entry(i, j), entry(i, j + 1), entry(i, j + 2));
        let block = |i: usize, j: usize| Mat3::from_rows(row(i, j), row(i + 1, j), row(i + 2, j));
        Self { ll: Sym3::of(block(0, 0)), la: block(0, 3), aa: Sym3::of(block(3, 3)) }
    }

    /// The product with a screw.
    #[inline(always)]
    pub fn apply(self, s: Screw<T>) -> Screw<T> {
        Screw::new(
            self.ll.apply(s.linear) + self.la.apply(s.angular),
            self.la.transpose_apply(s.linear) + self.aa.apply(s.angular),
        )
    }

    /// The same quadratic form of the motion of the point `r`: XᵀAX with X = \[\[E, ⟨r⟩\], \[0, E\]\].
    #[inline(always)]
    pub fn about(self, r: Vec3<T>) -> Self {
        let s = Mat3::skew(r);
        let moved = self.ll.full() * s;
        let turned = s.transpose() * self.la;
        let aa = self.aa.full() + turned + turned.transpose() + s.transpose() * moved;
        Self { ll: self.ll, la: self.la + moved, aa: Sym3::of(aa) }
    }

    /// A⁻¹ s of a positive definite matrix, by A = LDLᵀ without roots or choices.
    #[inline(always)]
    pub fn solve(self, s: Screw<T>) -> Screw<T> {
        let zero = T::zero();
        let (a, b, c) = (self.ll.full(), self.la.transpose(), self.aa.full());
        let mut l = [[zero; 6]; 6];
        for i in 0..3 {
            a.rows[i].store(&mut l[i]);
            b.rows[i].store(&mut l[3 + i]);
            c.rows[i].store(&mut l[3 + i][3..]);
        }
        let mut inverse = [zero; 6];
        for j in 0..6 {
            let mut scaled = [zero; 6];
            let mut pivot = l[j][j];
            for k in 0..j {
                // The rows above hold the pivots themselves on the diagonal.
                scaled[k] = l[j][k] * l[k][k];
                pivot = pivot - l[j][k] * scaled[k];
            }
            l[j][j] = pivot;
            inverse[j] = T::one() / pivot;
            for row in &mut l[j + 1..] {
                for k in 0..j {
                    row[j] = row[j] - row[k] * scaled[k];
                }
                row[j] = row[j] * inverse[j];
            }
        }
        let mut x = [zero; 6];
        s.store(&mut x);
        for i in 1..6 {
            for k in 0..i {
                x[i] = x[i] - l[i][k] * x[k];
            }
        }
        for i in 0..6 {
            x[i] = x[i] * inverse[i];
        }
        for i in (0..5).rev() {
            for k in i + 1..6 {
                x[i] = x[i] - l[k][i] * x[k];
            }
        }
        Screw::from_slice(&x)
    }

    /// The 21 numbers passed through `f` one by one.
    #[inline(always)]
    pub fn map<U: Real>(self, f: &mut impl FnMut(T) -> U) -> Sym6<U> {
        Sym6 { ll: self.ll.map(f), la: self.la.map(f), aa: self.aa.map(f) }
    }
}

impl<T: Real> Add for Sym6<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self { ll: self.ll + o.ll, la: self.la + o.la, aa: self.aa + o.aa }
    }
}
