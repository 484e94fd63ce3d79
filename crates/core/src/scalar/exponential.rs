//! Exponential and logarithm in the same operations on every lane type.

use super::Lane;
use super::elementary::{polynomial, with_library};
use std::f64::consts::{FRAC_1_SQRT_2, LOG2_E};

/// Up to here (as an absolute value) the exponential is a normal number with room to spare.
const LIMIT: f64 = 708.0;
/// Adding and subtracting this rounds to the nearest integer, and leaves it in the low bits.
const ROUND: f64 = 1.5 * TWO_52;
const TWO_52: f64 = (1u64 << MANTISSA) as f64;
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
const EXPONENT_OF_ONE: u64 = 1023;

// ln 2 in two pieces, and the polynomial of the logarithm: fdlibm 5.3 (Sun Microsystems, 1993), e_exp.c and
// e_log.c. The first piece times an exponent is exact, with or without a fused product.
const LN2_1: f64 = 0.693_147_180_369_123_8;
const LN2_2: f64 = 1.908_214_929_270_587_7e-10;
const LN: [f64; 7] = [
    0.666_666_666_666_673_5,
    0.399_999_999_994_094_2,
    0.285_714_287_436_623_9,
    0.222_221_984_321_497_84,
    0.181_835_721_616_180_5,
    0.153_138_376_992_093_73,
    0.147_981_986_051_165_86,
];

/// `1/2!`, `1/3!`, ...: the next one is below 2^-57 of the sum for arguments up to ln √2.
const EXP: [f64; 12] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5_040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
];

/// `e^x`, to two units in the last place; by the library next to overflow and underflow.
#[inline(always)]
pub(super) fn exp<T: Lane>(x: T) -> T {
    // x = k ln 2 + r.
    let n = x.fma(T::lit(LOG2_E), T::lit(ROUND));
    let k = n - T::lit(ROUND);
    let r = (-k).fma(T::lit(LN2_2), (-k).fma(T::lit(LN2_1), x));
    let power = T::one() + (r * r).fma(polynomial(r, EXP), r);
    let scaled = T::from_lanes(
        #[inline(always)]
        |l| f64::from_bits(power.get(l).to_bits().wrapping_add(n.get(l).to_bits() << MANTISSA)),
    );
    if T::all_le(x.abs(), T::lit(LIMIT)) { scaled } else { with_library(scaled, [x, x], exp_beyond) }
}

fn exp_beyond(x: f64, _: f64) -> Option<f64> {
    if x.abs() <= LIMIT { None } else { Some(x.exp()) }
}

/// The natural logarithm, to two units in the last place; by the library where `x` is no positive normal number.
#[inline(always)]
pub(super) fn ln<T: Lane>(x: T) -> T {
    let m = T::from_lanes(
        #[inline(always)]
        |l| mantissa(x.get(l)),
    );
    let k = T::from_lanes(
        #[inline(always)]
        |l| exponent(x.get(l)),
    );
    // ln (1 + f) = f - f²/2 + s (f²/2 + R(s²)) = 2 artanh s.
    let f = m - T::one();
    let s = f / (f + T::lit(2.0));
    let z = s * s;
    let half = T::lit(0.5) * f * f;
    let rest = s * z.fma(polynomial(z, LN), half);
    let ln = k.fma(T::lit(LN2_1), f - (half - k.fma(T::lit(LN2_2), rest)));
    let normal = T::all_le(T::lit(f64::MIN_POSITIVE), x) && T::all_le(x, T::lit(f64::MAX));
    if normal { ln } else { with_library(ln, [x, x], ln_beyond) }
}

fn ln_beyond(x: f64, _: f64) -> Option<f64> {
    if (f64::MIN_POSITIVE..=f64::MAX).contains(&x) { None } else { Some(x.ln()) }
}

/// `e + 1023` of `x = m 2^e` with `m` in `[√½, √2)`.
#[inline(always)]
fn biased_exponent(x: f64) -> u64 {
    x.to_bits().wrapping_add(1f64.to_bits() - FRAC_1_SQRT_2.to_bits()) >> MANTISSA
}

/// The `m` of a positive normal `x = m 2^e`, in `[√½, √2)`.
#[inline(always)]
pub(crate) fn mantissa(x: f64) -> f64 {
    f64::from_bits(x.to_bits().wrapping_sub(biased_exponent(x).wrapping_sub(EXPONENT_OF_ONE) << MANTISSA))
}

/// The `e` of that; an integer becomes a number when it is put into the mantissa of 2^52.
#[inline(always)]
pub(crate) fn exponent(x: f64) -> f64 {
    f64::from_bits(biased_exponent(x) | TWO_52.to_bits()) - (TWO_52 + EXPONENT_OF_ONE as f64)
}
