//! The error of a step and the size of the next.

use super::sums::squared_length;
use super::{Block, ErrorScale, Method, Tolerance};
use crate::scalar::{Lane, exponent, mantissa};
use std::f64::consts::{LN_2, LOG2_E};

/// What stands for an error that is not finite: far above any that is accepted.
pub(super) const HUGE: f64 = 1e200;

/// The usual 0.9 lets methods of high order try every fourth step in vain where a motion quickens, as Kepler's does. For
/// the same error at the end a lower one costs no more.
const SAFETY: f64 = 0.85;
const SHRINK: f64 = 0.2;
/// By how much a step may grow.
pub(super) const GROW: f64 = 10.0;

impl Tolerance {
    /// `s²` of a block.
    #[inline(always)]
    pub(super) fn allowed<T: Lane>(&self, block: &Block, y0: &[T], y1: &[T]) -> T {
        let relative = self.relative * self.relative;
        match block.scale {
            ErrorScale::Fixed(size) => T::lit(relative * size * size),
            ErrorScale::Relative => {
                let range = block.start..block.start + block.len;
                let (y0, y1) = (squared_length(&y0[range.clone()]), squared_length(&y1[range]));
                // The floor keeps a block that is zero, with a zero error, from 0 / 0.
                T::lit(relative).fma(y0.max(y1), T::lit(self.absolute * self.absolute + f64::MIN_POSITIVE))
            }
        }
    }

    /// The square of the error of a step, relative to what is allowed; `rows` are the error estimates of
    /// the method.
    #[inline(always)]
    pub(super) fn squared_error<T: Lane, M: Method>(
        &self,
        blocks: &[Block],
        y0: &[T],
        y1: &[T],
        rows: [&[T]; 2],
    ) -> T {
        let (mut largest, mut poison) = (T::zero(), T::zero());
        for block in blocks {
            let allowed = self.allowed(block, y0, y1);
            let range = block.start..block.start + block.len;
            // Written out: a map over the array is not always inlined.
            let high = squared_length(&rows[0][range.clone()]);
            let low = squared_length(&rows[1][range]);
            let error = if M::LARGER_ERROR {
                high.max(low) / allowed
            } else if M::ERROR.len() == 2 {
                // Two ratios: the squares of what they are made of may be beyond all doubles.
                let steadied = T::lit(0.01).fma(low, high).max(T::lit(f64::MIN_POSITIVE));
                high / allowed * (high / steadied)
            } else {
                high / allowed
            };
            largest = largest.max(error);
            poison = error.fma(T::zero(), poison);
        }
        // A comparison forgets an error that is not finite, a sum does not.
        largest + poison
    }
}

/// By what the size of a step is to be multiplied, given the square of its error; at most `grow`.
#[inline(always)]
pub(super) fn step_factor<T: Lane, M: Method>(squared_error: T, grow: T) -> T {
    let exponent = -0.5 / (M::ERROR_ORDER + 1) as f64;
    let error = squared_error.max(T::lit(1.0 / HUGE));
    let power = power(error, exponent);
    (T::lit(SAFETY) * power).max(T::lit(SHRINK)).min(grow)
}

/// `x^p` of positive normal numbers, to `1e-5`; the same bits on every platform.
///
/// Only what handles bits goes lane by lane.
#[inline(always)]
pub(super) fn power<T: Lane>(x: T, p: f64) -> T {
    let one = T::one();
    let m = T::from_lanes(
        #[inline(always)]
        |l| mantissa(x.get(l)),
    );
    let e = T::from_lanes(
        #[inline(always)]
        |l| exponent(x.get(l)),
    );
    // ln m = 2 artanh s, |s| < 0.172.
    let s = (m - one) / (m + one);
    let s2 = s * s;
    let artanh = s + s * s2 * (T::lit(1.0 / 3.0) + s2 * T::lit(1.0 / 5.0));
    let log2 = e + T::lit(2.0 * LOG2_E) * artanh;

    // 2^z = 2^n exp f, |f| < 0.347; the sum with 1.5 2^52 rounds to an integer and leaves it in the low bits.
    let z = T::lit(p) * log2;
    let n = z + T::lit(1.5 * TWO_52);
    let f = T::lit(LN_2) * (z - (n - T::lit(1.5 * TWO_52)));
    let f2 = f * f;
    let cubic = T::lit(1.0 / 6.0) + f * T::lit(1.0 / 24.0) + f2 * T::lit(1.0 / 120.0);
    let exp = one + f + f2 * (T::lit(0.5) + f * cubic);
    T::from_lanes(
        #[inline(always)]
        |l| f64::from_bits(exp.get(l).to_bits().wrapping_add(n.get(l).to_bits() << MANTISSA)),
    )
}

const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
const TWO_52: f64 = (1u64 << MANTISSA) as f64;
