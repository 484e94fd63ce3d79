//! Functions of one number: in lanes where that is faster, else by the library, lane by lane.

use super::arcsine::{acos, asin};
use super::arctangent::atan2;
use super::exponential::{exp, ln};
use super::{Lane, Real};
use serde::{Deserialize, Serialize};

/// The widest register.
const MAX_LANES: usize = 8;

/// A function of one number that is not built from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Elementary {
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// The largest integer that is not larger.
    Floor,
}

impl Elementary {
    /// The function of one number.
    pub fn value(self, x: f64) -> f64 {
        match self {
            Self::Tan => x.tan(),
            Self::Asin => x.asin(),
            Self::Acos => x.acos(),
            Self::Atan => x.atan(),
            Self::Sinh => x.sinh(),
            Self::Cosh => x.cosh(),
            Self::Tanh => x.tanh(),
            Self::Exp => x.exp(),
            Self::Ln => x.ln(),
            Self::Floor => x.floor(),
        }
    }
}

/// A function of one number in every lane.
#[inline(always)]
pub(super) fn of_one<T: Lane>(f: Elementary, x: T) -> T {
    match f {
        Elementary::Exp => exp(x),
        Elementary::Ln => ln(x),
        Elementary::Atan => atan2(x, T::one()),
        Elementary::Asin => asin(x),
        Elementary::Acos => acos(x),
        Elementary::Floor => T::from_lanes(
            #[inline(always)]
            |l| x.get(l).floor(),
        ),
        Elementary::Tan => with_library(x, [x, x], |x, _| Some(x.tan())),
        Elementary::Sinh => with_library(x, [x, x], |x, _| Some(x.sinh())),
        Elementary::Cosh => with_library(x, [x, x], |x, _| Some(x.cosh())),
        Elementary::Tanh => with_library(x, [x, x], |x, _| Some(x.tanh())),
    }
}

/// A power in every lane.
#[inline(always)]
pub(super) fn pow<T: Lane>(x: T, y: T) -> T {
    with_library(x, [x, y], |x, y| Some(x.powf(y)))
}

/// `computed`, with what the library gives in those lanes where it gives anything.
#[inline(always)]
pub(super) fn with_library<T: Lane>(computed: T, args: [T; 2], library: fn(f64, f64) -> Option<f64>) -> T {
    const { assert!(T::N <= MAX_LANES) };
    let [mut out, mut x, mut y] = [[0.0; MAX_LANES]; 3];
    for l in 0..T::N {
        (out[l], x[l], y[l]) = (computed.get(l), args[0].get(l), args[1].get(l));
    }
    replace(&mut out[..T::N], &x, &y, library);
    T::from_lanes(
        #[inline(always)]
        |l| out[l],
    )
}

// Outlined, so it takes memory only: a register would not survive a call without its instruction set.
#[cold]
#[inline(never)]
fn replace(out: &mut [f64], x: &[f64], y: &[f64], library: fn(f64, f64) -> Option<f64>) {
    for ((out, x), y) in out.iter_mut().zip(x).zip(y) {
        if let Some(known) = library(*x, *y) {
            *out = known;
        }
    }
}

/// `a0 + a1 z + a2 z² + ...`, in two chains that a processor runs side by side.
#[inline(always)]
pub(super) fn polynomial<T: Real, const N: usize>(z: T, a: [f64; N]) -> T {
    let square = z * z;
    let (mut high, mut low) = (T::lit(a[N - 1]), T::lit(a[N - 2]));
    let mut i = N - 1;
    while i >= 3 {
        high = high.fma(square, T::lit(a[i - 2]));
        low = low.fma(square, T::lit(a[i - 3]));
        i -= 2;
    }
    let sum = high.fma(z, low);
    if N.is_multiple_of(2) { sum } else { sum.fma(z, T::lit(a[0])) }
}
