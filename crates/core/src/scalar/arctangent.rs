//! The inverse tangent of two numbers in the same operations on every lane type.

use super::elementary::{polynomial, with_library};
use super::trigonometry::{PIO2_1, PIO2_REST};
use super::{Lane, Real};

/// Up to here (as a sum of absolute values) no sum overflows.
const HUGE: f64 = 1e300;

// The polynomial of s_atan.c, good up to 7/16: fdlibm 5.3 (Sun Microsystems, 1993).
const ATAN: [f64; 11] = [
    0.333_333_333_333_329_3,
    -0.199_999_999_998_764_83,
    0.142_857_142_725_034_66,
    -0.111_111_104_054_623_56,
    0.090_908_871_334_365_07,
    -0.076_918_762_050_448_3,
    0.066_610_731_373_875_31,
    -0.058_335_701_337_905_735,
    0.049_768_779_946_159_324,
    -0.036_531_572_744_216_916,
    0.016_285_820_115_365_782,
];
/// atan ½ in two pieces, the first of 33 bits.
const ATAN_HALF_1: f64 = 0.463_647_608_994_506_3;
const ATAN_HALF_2: f64 = 6.299_816_718_559_21e-12;

/// The angle of the point (`x`, `y`) in [-π, π], to two units in the last place.
///
/// By the library at the origin, far away and where a coordinate is not finite.
#[inline(always)]
pub(super) fn atan2<T: Lane>(y: T, x: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let (along, across) = (x.abs(), y.abs());
    let small = T::select_le(across, along, across, along);
    let large = T::select_le(across, along, along, across);

    // In the first octant: atan t = atan c + atan((t - c) / (1 + c t)) with c = 0, ½ or 1.
    let edges = [T::lit(7.0 / 16.0) * large, T::lit(11.0 / 16.0) * large];
    let c = choose(small, edges, [0.0, 0.5, 1.0]);
    let head = choose(small, edges, [0.0, ATAN_HALF_1, 0.5 * PIO2_1]);
    let rest = choose(small, edges, [0.0, ATAN_HALF_2, 0.5 * PIO2_REST]);
    let z = (-c).fma(large, small) / c.fma(small, large);
    let z2 = z * z;
    let tail = (-z).fma(z2 * polynomial(z2, ATAN), z) + rest;

    // Mirrored at the diagonal, then at the second axis.
    let quarters = T::select_le(across, along, zero, one);
    let sign = T::select_le(across, along, one, -one);
    let quarters = T::select_le(zero, x, quarters, T::lit(2.0) - quarters);
    let sign = T::select_le(zero, x, sign, -sign);
    let angle = quarters.fma(T::lit(PIO2_1), sign * head) + quarters.fma(T::lit(PIO2_REST), sign * tail);
    let signed = T::from_lanes(
        #[inline(always)]
        |l| angle.get(l).copysign(y.get(l)),
    );
    let size = along + across;
    let plain = T::all_le(T::lit(f64::MIN_POSITIVE), size) && T::all_le(size, T::lit(HUGE));
    if plain { signed } else { with_library(signed, [y, x], atan2_beyond) }
}

/// The first value up to the first edge, the second up to the second, then the third.
#[inline(always)]
fn choose<T: Real>(x: T, [low, high]: [T; 2], [a, b, c]: [f64; 3]) -> T {
    T::select_le(x, low, T::lit(a), T::select_le(x, high, T::lit(b), T::lit(c)))
}

fn atan2_beyond(y: f64, x: f64) -> Option<f64> {
    if (f64::MIN_POSITIVE..=HUGE).contains(&(x.abs() + y.abs())) { None } else { Some(y.atan2(x)) }
}
