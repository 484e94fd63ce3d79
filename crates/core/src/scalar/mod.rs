//! The scalars that every formula is written over.
//!
//! A formula is generic over [`Real`] and is run with numbers ([`f64`], [`Fused`]), with one
//! trajectory per SIMD lane ([`Lane`] types), or with derivatives carried along ([`Dual`]).
//! Formulas never branch on a value: a choice is a [`Real::select_le`].

mod arcsine;
mod arctangent;
mod block;
mod dual;
mod elementary;
mod exponential;
#[cfg(not(target_arch = "x86_64"))]
mod fused;
mod grid;
pub mod isa;
mod lanes;
mod lattice;
mod registers;
mod spline;
mod table;
#[cfg(test)]
pub(crate) mod tests;
mod trigonometry;

pub use block::Block;
pub use dual::Dual;
pub use elementary::Elementary;
pub(crate) use exponential::{exponent, mantissa};
#[cfg(not(target_arch = "x86_64"))]
pub use fused::Fused;
pub use grid::{Grid, Patch};
pub use lanes::Lane;
pub use lattice::{Lattice, MAX_AXES, Rule};
#[cfg(target_arch = "aarch64")]
pub use registers::Neon;
#[cfg(target_arch = "x86_64")]
pub use registers::{Avx2, Avx512, Fused, Fused512, Sse2};
pub use table::{Interpolation, Table, TableError};

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Registers that machine code works on, with fused products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Machine {
    /// Two numbers.
    Xmm,
    /// Four.
    Ymm,
    /// Eight, with the instructions of AVX-512.
    Zmm,
}

impl Machine {
    /// How many kinds there are.
    pub const COUNT: usize = 3;
}

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
    /// The registers of the machine that a value fills as it stands in memory, where programs can be machine code.
    const MACHINE: Option<Machine> = None;

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
    /// The value of a tabulated function of two variables at (`self`, `y`).
    fn lookup_2(self, y: Self, grid: &Grid) -> Self;
    /// The value of a tabulated function of three or four variables at a point.
    fn lookup_n(at: &[Self], lattice: &Lattice) -> Self;
    /// A function of one number.
    fn elementary(self, f: Elementary) -> Self;
    /// The angle of the point (`x`, `self`), in [-π, π]; at -π for a `self` of -0 and a negative `x`.
    fn atan2(self, x: Self) -> Self;
    /// `self` to the power `y`.
    fn pow(self, y: Self) -> Self;
    /// Calls a function that was compiled elsewhere; false, with nothing written, if this scalar is no plain number.
    fn outside(block: &dyn Block, given: &[Self], out: &mut [Self]) -> bool;
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
