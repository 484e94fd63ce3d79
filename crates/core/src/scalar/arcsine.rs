//! Inverse sine and cosine in the same operations on every lane type.

use super::Lane;
use super::elementary::polynomial;
use super::trigonometry::{PIO2_1, PIO2_REST};

/// Adding and subtracting this rounds to a multiple of 2^-26.
const ROUND: f64 = 1.5 * (1u64 << 26) as f64;

// asin s = s + s R(s²) up to s = ½, with a rational R: fdlibm 5.3 (Sun Microsystems, 1993), e_asin.c.
const TOP: [f64; 6] = [
    0.166_666_666_666_666_66,
    -0.325_565_818_622_400_9,
    0.201_212_532_134_862_93,
    -0.040_055_534_500_679_41,
    7.915_349_942_898_145e-4,
    3.479_331_075_960_212e-5,
];
const BOTTOM: [f64; 5] = [
    1.0,
    -2.403_394_911_734_414,
    2.020_945_760_233_505_7,
    -0.688_283_971_605_453_3,
    0.077_038_150_555_901_94,
];

/// The angle in [-π/2, π/2], to two units in the last place; NaN where `|x| > 1`.
#[inline(always)]
pub(super) fn asin<T: Lane>(x: T) -> T {
    let (size, half) = (x.abs(), T::lit(0.5));
    // asin x = π/2 - 2 asin √((1 - x)/2).
    let quarters = T::select_le(size, half, T::zero(), T::one());
    let times = T::select_le(size, half, T::one(), T::lit(-2.0));
    let angle = sum(quarters, times, reduced(size));
    T::from_lanes(
        #[inline(always)]
        |l| angle.get(l).copysign(x.get(l)),
    )
}

/// The angle in [0, π], to two units in the last place; NaN where `|x| > 1`.
#[inline(always)]
pub(super) fn acos<T: Lane>(x: T) -> T {
    let (size, half, zero, two) = (x.abs(), T::lit(0.5), T::zero(), T::lit(2.0));
    // acos x = π/2 - asin x = 2 asin √((1 - x)/2) = π - acos(-x).
    let quarters = T::select_le(size, half, T::one(), T::select_le(zero, x, zero, two));
    let times = T::select_le(size, half, -T::one(), two);
    let times = T::select_le(zero, x, times, -times);
    sum(quarters, times, reduced(size))
}

/// `asin s` in two parts, the first a multiple of 2^-26, for `s = x` up to ½ and `s = √((1 - x)/2)` from there on.
#[inline(always)]
fn reduced<T: Lane>(x: T) -> (T, T) {
    let (one, half, round) = (T::one(), T::lit(0.5), T::lit(ROUND));
    let square = T::select_le(x, half, x * x, half * (one - x));
    let s = T::select_le(x, half, x, square.sqrt());
    let head = s + round - round;
    // What the root leaves behind the head: the square of the head is exact.
    let lost = (square - head * head) / (s + head).max(T::lit(f64::MIN_POSITIVE));
    let lost = T::select_le(x, half, x - head, lost);
    let series = square * polynomial(square, TOP) / polynomial(square, BOTTOM);
    (head, s.fma(series, lost))
}

/// `quarters π/2 + times (head + tail)`; the first pieces add up without rounding.
#[inline(always)]
fn sum<T: Lane>(quarters: T, times: T, (head, tail): (T, T)) -> T {
    quarters.fma(T::lit(PIO2_1), times * head) + quarters.fma(T::lit(PIO2_REST), times * tail)
}
