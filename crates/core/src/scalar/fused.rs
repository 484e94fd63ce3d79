//! One number with fused products, where every processor has them.

use super::lanes::functions;
use super::{Grid, Lane, Real, Table};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An `f64` whose [`Real::fma`] rounds once.
///
/// A single run on this type is bit for bit the same run as in one lane of a register with fused products.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused(pub f64);

macro_rules! operator {
    ($trait:ident, $f:ident, $op:tt) => {
        impl $trait for Fused {
            type Output = Self;
            #[inline(always)]
            fn $f(self, other: Self) -> Self {
                Self(self.0 $op other.0)
            }
        }
    };
}
operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Fused {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn fma(self, a: Self, b: Self) -> Self {
        Self(self.0.mul_add(a.0, b.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
        if a.0 <= b.0 { x } else { y }
    }
    #[inline(always)]
    fn lookup(self, table: &Table) -> Self {
        Self(table.value(self.0))
    }
    #[inline(always)]
    fn lookup_2(self, y: Self, grid: &Grid) -> Self {
        Self(grid.value(self.0, y.0))
    }
    functions!();
    #[inline(never)]
    fn call<R>(f: impl FnOnce() -> R) -> R {
        f()
    }
}

impl Lane for Fused {
    const N: usize = 1;
    type Single = Self;
    #[inline(always)]
    fn get(self, _: usize) -> f64 {
        self.0
    }
    #[inline(always)]
    fn with(self, _: usize, x: f64) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn le(a: Self, b: Self) -> u32 {
        u32::from(a.0 <= b.0)
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self(f(0))
    }
    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        Self(numbers[0])
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self.0;
    }
}
