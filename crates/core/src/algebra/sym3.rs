//! Symmetric matrices of three rows and columns.

use super::{Mat3, Vec3};
use crate::scalar::Real;
use std::ops::{Add, Sub};

/// A symmetric 3×3 matrix: six numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sym3<T> {
    /// Entry (1, 1).
    pub xx: T,
    /// Entries (1, 2) and (2, 1).
    pub xy: T,
    /// Entries (1, 3) and (3, 1).
    pub xz: T,
    /// Entry (2, 2).
    pub yy: T,
    /// Entries (2, 3) and (3, 2).
    pub yz: T,
    /// Entry (3, 3).
    pub zz: T,
}

impl<T: Real> Sym3<T> {
    /// The upper triangle, by rows.
    #[inline(always)]
    pub fn from_array(a: [T; 6]) -> Self {
        Self { xx: a[0], xy: a[1], xz: a[2], yy: a[3], yz: a[4], zz: a[5] }
    }
    /// The upper triangle, by rows.
    #[inline(always)]
    pub fn to_array(self) -> [T; 6] {
        [self.xx, self.xy, self.xz, self.yy, self.yz, self.zz]
    }
    /// The symmetric part of a matrix.
    #[inline(always)]
    pub fn of(m: Mat3<T>) -> Self {
        let [a, b, c] = m.rows;
        let half = T::lit(0.5);
        Self {
            xx: a.x,
            xy: (a.y + b.x) * half,
            xz: (a.z + c.x) * half,
            yy: b.y,
            yz: (b.z + c.y) * half,
            zz: c.z,
        }
    }
    /// The full matrix.
    #[inline(always)]
    pub fn full(self) -> Mat3<T> {
        let (a, b, c) = (self.xx, self.yy, self.zz);
        Mat3::from_rows(
            Vec3::new(a, self.xy, self.xz),
            Vec3::new(self.xy, b, self.yz),
            Vec3::new(self.xz, self.yz, c),
        )
    }
    /// The product with a column.
    #[inline(always)]
    pub fn apply(self, v: Vec3<T>) -> Vec3<T> {
        self.full().apply(v)
    }
    /// The inverse, in closed form. Not finite for a singular matrix.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let (a, b, c) = (self.xx, self.yy, self.zz);
        let (f, g, h) = (self.yz, self.xz, self.xy);
        let xx = b.fma(c, -(f * f));
        let xy = g.fma(f, -(h * c));
        let xz = h.fma(f, -(g * b));
        let s = T::one() / a.fma(xx, h.fma(xy, g * xz));
        Self {
            xx: xx * s,
            xy: xy * s,
            xz: xz * s,
            yy: a.fma(c, -(g * g)) * s,
            yz: g.fma(h, -(a * f)) * s,
            zz: a.fma(b, -(h * h)) * s,
        }
    }
    /// `rᵀr E − r rᵀ` = ⟨r⟩ᵀ⟨r⟩: the inertia of a unit mass at `r`.
    #[inline(always)]
    pub fn of_unit_mass(r: Vec3<T>) -> Self {
        let (xx, yy, zz) = (r.x * r.x, r.y * r.y, r.z * r.z);
        Self { xx: yy + zz, xy: -(r.x * r.y), xz: -(r.x * r.z), yy: xx + zz, yz: -(r.y * r.z), zz: xx + yy }
    }
    /// `CᵀAC`: the same tensor in the axes that are the columns of `C`.
    #[inline(always)]
    pub fn turned(self, c: Mat3<T>) -> Self {
        Self::of(c.transpose() * self.full() * c)
    }
    /// The product with a number.
    #[inline(always)]
    pub fn scale(self, s: T) -> Self {
        Self {
            xx: self.xx * s,
            xy: self.xy * s,
            xz: self.xz * s,
            yy: self.yy * s,
            yz: self.yz * s,
            zz: self.zz * s,
        }
    }
    /// The six numbers passed through `f` one by one.
    #[inline(always)]
    pub fn map<U: Real>(self, f: &mut impl FnMut(T) -> U) -> Sym3<U> {
        Sym3 {
            xx: f(self.xx),
            xy: f(self.xy),
            xz: f(self.xz),
            yy: f(self.yy),
            yz: f(self.yz),
            zz: f(self.zz),
        }
    }
}

impl<T: Real> Add for Sym3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self {
            xx: self.xx + o.xx,
            xy: self.xy + o.xy,
            xz: self.xz + o.xz,
            yy: self.yy + o.yy,
            yz: self.yz + o.yz,
            zz: self.zz + o.zz,
        }
    }
}

impl<T: Real> Sub for Sym3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self {
            xx: self.xx - o.xx,
            xy: self.xy - o.xy,
            xz: self.xz - o.xz,
            yy: self.yy - o.yy,
            yz: self.yz - o.yz,
            zz: self.zz - o.zz,
        }
    }
}
