//! Sine and cosine in the same operations on every lane type.
//!
//! The operations are only those of [`Real`], so a fused type gives one result in every width, and
//! a type without fused products another one, the same in every width.

use super::{Lane, Real};

/// Up to here (as an absolute value) the argument is reduced in lanes; beyond it, by the library.
const LIMIT: f64 = 1e5;
/// Below this the sine is its argument to 2^-56, and keeps the sign of a zero.
const TINY: f64 = 1.0 / (1u64 << 27) as f64;
/// Adding and subtracting this rounds to the nearest integer.
const ROUND: f64 = 1.5 * (1u64 << 52) as f64;
/// The widest register.
const MAX_LANES: usize = 8;

// π/2 in pieces, and the polynomials below: fdlibm 5.3 (Sun Microsystems, 1993), e_rem_pio2.c,
// k_sin.c, k_cos.c. A piece of 33 bits times k < 2^20 is exact, with or without a fused product.
pub(super) const PIO2_1: f64 = 1.570_796_326_734_125_6;
/// All of π/2 that the first piece leaves.
pub(super) const PIO2_REST: f64 = 6.077_100_506_506_192e-11;
const PIO2_2: f64 = 6.077_100_506_303_966e-11;
const PIO2_3: f64 = 2.022_266_248_711_166_5e-21;
const PIO2_3_REST: f64 = 8.478_427_660_368_9e-32;

const SIN: [f64; 6] = [
    -0.166_666_666_666_666_32,
    0.008_333_333_333_322_49,
    -0.000_198_412_698_298_579_5,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COS: [f64; 6] = [
    0.041_666_666_666_666_6,
    -0.001_388_888_888_887_411,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of `x` in radians, to two units in the last place.
///
/// What is not finite gives NaN. A lane does not depend on its neighbours.
#[inline(always)]
pub fn sin_cos<T: Lane>(x: T) -> (T, T) {
    let (quarter, r, rest) = reduce(x);
    let (s, c) = (sin_kernel(r, rest), cos_kernel(r, rest));

    // quarter² - 1 is -1 or 3 for even quarters.
    let half = T::lit(0.5);
    let odd = quarter.fma(quarter, -T::one()).abs();
    let (s, c) = (T::select_le(odd, half, c, s), T::select_le(odd, half, s, c));
    let sin = T::select_le(T::zero(), quarter, s, -s);
    let cos = T::select_le((quarter + half).abs(), T::one(), c, -c);

    let size = x.abs();
    let sin = T::select_le(size, T::lit(TINY), x, sin);
    if T::all_le(size, T::lit(LIMIT)) { (sin, cos) } else { with_library(x, sin, cos) }
}

/// `x = k π/2 + r + rest`: `k` modulo 4 in -2..=1, and the remainder in two parts.
///
/// Next to a multiple of π/2 almost all of `x` cancels, so each difference keeps its rounding error.
#[inline(always)]
fn reduce<T: Lane>(x: T) -> (T, T, T) {
    let round = T::lit(ROUND);
    let k = x.fma(T::lit(std::f64::consts::FRAC_2_PI), round) - round;
    // The eighth keeps k/4 off the ties.
    let turns = k.fma(T::lit(0.25), T::lit(0.125)) + round - round;
    let quarter = turns.fma(T::lit(-4.0), k);

    let first = (-k).fma(T::lit(PIO2_1), x);
    let (second, error_2) = two_difference(first, k * T::lit(PIO2_2));
    let (third, error_3) = two_difference(second, k * T::lit(PIO2_3));
    (quarter, third, (-k).fma(T::lit(PIO2_3_REST), error_2 + error_3))
}

/// `a - b`, and what its rounding lost (Knuth, TAOCP 2, 4.2.2, theorem B).
#[inline(always)]
fn two_difference<T: Real>(a: T, b: T) -> (T, T) {
    let d = a - b;
    let a_part = d + b;
    let b_part = a_part - d;
    (d, (a - a_part) - (b - b_part))
}

/// `sin(r + rest)` for `|r| <= π/4`.
#[inline(always)]
fn sin_kernel<T: Real>(r: T, rest: T) -> T {
    let z = r * r;
    let series = polynomial(z, SIN);
    let cube = z * r;
    r + cube.fma(series, (T::lit(-0.5) * z).fma(rest, rest))
}

/// `cos(r + rest)` for `|r| <= π/4`.
#[inline(always)]
fn cos_kernel<T: Real>(r: T, rest: T) -> T {
    let z = r * r;
    let half = T::lit(0.5) * z;
    let head = T::one() - half;
    let lost = (T::one() - head) - half;
    head + (z * z).fma(polynomial(z, COS), (-r).fma(rest, lost))
}

/// `a0 + a1 z + ... + a5 z^5`, in two chains that a processor runs side by side.
#[inline(always)]
fn polynomial<T: Real>(z: T, a: [f64; 6]) -> T {
    let low = z.fma(T::lit(a[2]), T::lit(a[1])).fma(z, T::lit(a[0]));
    let high = z.fma(T::lit(a[5]), T::lit(a[4])).fma(z, T::lit(a[3]));
    (z * z * z).fma(high, low)
}

/// `sin` and `cos`, replaced in the lanes whose argument is beyond the limit.
#[inline(always)]
fn with_library<T: Lane>(x: T, sin: T, cos: T) -> (T, T) {
    const { assert!(T::N <= MAX_LANES) };
    let (mut args, mut s, mut c) = ([0.0; MAX_LANES], [0.0; MAX_LANES], [0.0; MAX_LANES]);
    for l in 0..T::N {
        (args[l], s[l], c[l]) = (x.get(l), sin.get(l), cos.get(l));
    }
    library(&args[..T::N], &mut s, &mut c);
    (T::from_lanes(|l| s[l]), T::from_lanes(|l| c[l]))
}

// Outlined, so it takes memory only: a register would not survive a call without its instruction set.
#[cold]
#[inline(never)]
fn library(x: &[f64], sin: &mut [f64], cos: &mut [f64]) {
    for ((x, s), c) in x.iter().zip(sin).zip(cos) {
        if x.abs() > LIMIT {
            (*s, *c) = x.sin_cos();
        }
    }
}
