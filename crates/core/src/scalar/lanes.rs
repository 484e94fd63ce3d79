//! Numbers with one independent value a lane: a SIMD register, or a single number.
//!
//! A register may be used only inside [`Real::call`], which enters code compiled for its instruction
//! set; everything generic between that call and the operations is `#[inline(always)]`. A function
//! that is not inlined there stays right but silently loses the instruction set, and with it a factor
//! of 3 to 80 in speed; `make check` looks for such functions in the built library.

use super::{Grid, Lattice, MAX_AXES, Real, Table};

/// A [`Real`] that holds [`Lane::N`] independent numbers.
pub trait Lane: Real {
    /// How many numbers one value holds.
    const N: usize;
    /// The one-number type that rounds like each of these lanes, bit for bit.
    type Single: Lane;
    /// The number in lane `l`.
    fn get(self, l: usize) -> f64;
    /// The same value with lane `l` replaced.
    fn with(self, l: usize, x: f64) -> Self;
    /// The lanes where `a <= b` as bits, the first the lowest; none where one of them is not a number.
    fn le(a: Self, b: Self) -> u32;
    /// Whether `a <= b` in every lane.
    #[inline(always)]
    fn all_le(a: Self, b: Self) -> bool {
        Self::le(a, b) == (1 << Self::N) - 1
    }
    /// The value whose lanes are given by `f`.
    fn from_lanes(f: impl FnMut(usize) -> f64) -> Self;
    /// The first [`Lane::N`] numbers of a slice.
    fn load(numbers: &[f64]) -> Self;
    /// Writes the lanes to the first places of a slice.
    fn store(self, numbers: &mut [f64]);
    /// The same past the caches, where the register is a cache line and the places are one. Others may read them only
    /// behind [`Lane::settle`].
    #[inline(always)]
    fn stream(self, numbers: &mut [f64]) {
        self.store(numbers);
    }
    /// Ends what [`Lane::stream`] has begun.
    #[inline(always)]
    fn settle() {}
}

/// What every lane type does in the same way: the functions of [`Real`] that are written over [`Lane`].
macro_rules! functions {
    () => {
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            $crate::scalar::trigonometry::sin_cos(self)
        }
        #[inline(always)]
        fn elementary(self, f: $crate::scalar::Elementary) -> Self {
            $crate::scalar::elementary::of_one(f, self)
        }
        #[inline(always)]
        fn atan2(self, x: Self) -> Self {
            $crate::scalar::arctangent::atan2(self, x)
        }
        #[inline(always)]
        fn pow(self, y: Self) -> Self {
            $crate::scalar::elementary::pow(self, y)
        }
        #[inline(always)]
        fn lookup_n(at: &[Self], lattice: &$crate::scalar::Lattice) -> Self {
            $crate::scalar::lanes::lookup_n(at, lattice)
        }
        #[inline(always)]
        fn outside(block: &dyn $crate::scalar::Block, given: &[Self], out: &mut [Self]) -> bool {
            $crate::scalar::block::call(block, given, out);
            true
        }
    };
}
pub(super) use functions;

/// The value of a lattice in every lane.
#[inline(always)]
pub(super) fn lookup_n<T: Lane>(at: &[T], lattice: &Lattice) -> T {
    T::from_lanes(
        #[inline(always)]
        |l| {
            let mut point = [0.0; MAX_AXES];
            for (p, x) in point.iter_mut().zip(at) {
                *p = x.get(l);
            }
            lattice.value(&point[..at.len()])
        },
    )
}

impl Lane for f64 {
    const N: usize = 1;
    type Single = Self;
    #[inline(always)]
    fn get(self, _: usize) -> f64 {
        self
    }
    #[inline(always)]
    fn with(self, _: usize, x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn le(a: Self, b: Self) -> u32 {
        u32::from(a <= b)
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        f(0)
    }
    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        numbers[0]
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self;
    }
}

impl Real for f64 {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        x
    }
    // Two roundings: without the instruction, a fused product is a slow library call.
    #[inline(always)]
    fn fma(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
        if a <= b { x } else { y }
    }
    #[inline(always)]
    fn lookup(self, table: &Table) -> Self {
        table.value(self)
    }
    #[inline(always)]
    fn lookup_2(self, y: Self, grid: &Grid) -> Self {
        grid.value(self, y)
    }
    functions!();
    #[inline(never)]
    fn call<R>(f: impl FnOnce() -> R) -> R {
        f()
    }
}
