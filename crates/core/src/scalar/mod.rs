//! The scalars that every formula is written over.
//!
//! A formula is generic over [`Real`] and is run with numbers ([`f64`], [`Fused`]), with one
//! trajectory per SIMD lane ([`Lane`] types), or with derivatives carried along ([`Dual`]).
//! Formulas never branch on a value: a choice is a [`Real::select_le`].

mod dual;
mod fused;
pub mod isa;
mod lanes;
mod registers;
mod table;
#[cfg(test)]
pub(crate) mod tests;
mod trigonometry;

pub use dual::Dual;
pub use fused::Fused;
pub use lanes::Lane;
#[cfg(target_arch = "aarch64")]
pub use registers::Neon;
#[cfg(target_arch = "x86_64")]
pub use registers::{Avx2, Avx512, Sse2};
pub use table::{Interpolation, Table, TableError};

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or anything that obeys the same algebra.
pub trait Real:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A constant: the same in all lanes, with zero derivative.
    fn lit(x: f64) -> Self;
    /// `self * a + b`, fused to one rounding where the instruction set has it.
    fn fma(self, a: Self, b: Self) -> Self;
    /// The square root.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// `x` where `a <= b`, else `y` (also where `a` or `b` is not a number).
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self;
    /// The value of a tabulated function at `self`.
    fn lookup(self, table: &Table) -> Self;
    /// Runs `f` in code compiled for the instruction set of this type.
    ///
    /// This is the only place where the kernel is outlined: one copy per caller and instruction set.
    fn call<R>(f: impl FnOnce() -> R) -> R;

    /// The square.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
    /// The smaller of two numbers.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select_le(self, other, self, other)
    }
    /// The larger of two numbers.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select_le(self, other, other, self)
    }
    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::lit(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::lit(1.0)
    }
}
