//! Sine and cosine against the library.
//!
//! The library is known to be right to one unit in the last place (glibc, musl, macOS and Windows all
//! document or measure less for these two). So at most one unit between it and us means at most two
//! from the true value.

use super::{Random, same, ulps};
use crate::scalar::Lane;
use crate::scalar::isa::{Isa, with_scalar};
use std::f64::consts::FRAC_PI_2;

fn sin_cos<S: Lane>(x: &[f64]) -> Vec<(f64, f64)> {
    let mut out = vec![(0.0, 0.0); x.len()];
    S::call(
        #[inline(always)]
        || {
            for i in 0..x.len() {
                let (s, c) = S::lit(x[i]).sin_cos();
                out[i] = (s.get(0), c.get(0));
            }
        },
    );
    out
}

/// Calls `check(x, sin, cos)` with the results of every instruction set.
fn for_each(x: &[f64], mut check: impl FnMut(f64, f64, f64)) {
    for isa in Isa::available() {
        let all = with_scalar!(isa, S => sin_cos::<S>(x));
        for (x, (s, c)) in x.iter().zip(all) {
            check(*x, s, c);
        }
    }
}

fn within_one_ulp_of_the_library(x: &[f64]) {
    for_each(x, |x, s, c| {
        assert!(ulps(s, x.sin()) <= 1, "sin({x:e}) = {s:e}, library {:e}", x.sin());
        assert!(ulps(c, x.cos()) <= 1, "cos({x:e}) = {c:e}, library {:e}", x.cos());
    });
}

#[test]
fn at_random_angles_of_every_size() {
    let mut random = Random(1);
    for decade in -8..=5 {
        let high = 10f64.powi(decade);
        let x: Vec<_> = (0..20_000).map(|_| random.between(-high, high)).collect();
        within_one_ulp_of_the_library(&x);
    }
    // As many small as large ones: every exponent down to the smallest number.
    let x: Vec<_> = (0..50_000).map(|_| f64::from_bits(random.bits() % 1e5f64.to_bits())).collect();
    within_one_ulp_of_the_library(&x);
}

#[test]
fn next_to_every_multiple_of_a_quarter_turn() {
    // One of these neighbours is the number nearest to k π/2, where the remainder keeps fewest digits.
    for chunk in (0..=63_661).collect::<Vec<_>>().chunks(4096) {
        let mut x = Vec::new();
        for k in chunk {
            let centre = f64::from(*k) * FRAC_PI_2;
            let (below, above) = (centre.next_down(), centre.next_up());
            for near in [below.next_down(), below, centre, above, above.next_up()] {
                x.extend([near, -near]);
            }
        }
        within_one_ulp_of_the_library(&x);
    }
}

#[test]
fn where_the_quarter_changes() {
    let mut x = Vec::new();
    for k in 0..63_661 {
        let edge = (f64::from(k) + 0.5) * FRAC_PI_2;
        x.extend([edge.next_down(), edge, edge.next_up()]);
    }
    within_one_ulp_of_the_library(&x);
}

#[test]
fn beyond_the_limit_it_is_the_library() {
    let mut random = Random(2);
    let mut x = vec![1e5f64.next_up(), -1e5f64.next_up(), 1e22, f64::MAX, f64::MIN];
    for _ in 0..20_000 {
        x.push(10f64.powf(random.between(5.0, 20.0)).next_up());
    }
    for_each(&x, |x, s, c| assert!(same(s, x.sin()) && same(c, x.cos()), "{x:e}"));
    within_one_ulp_of_the_library(&[1e5, -1e5]);
}

#[test]
fn special_arguments() {
    let tiny = [0.0, f64::from_bits(1), f64::MIN_POSITIVE, 1e-300, 1e-20];
    let tiny: Vec<_> = tiny.iter().flat_map(|x| [*x, -x]).collect();
    // The sign of a zero included.
    for_each(&tiny, |x, s, c| assert!(same(s, x) && c == 1.0, "{x:e}"));
    let none = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for_each(&none, |_, s, c| assert!(s.is_nan() && c.is_nan()));
}

#[test]
fn sine_is_odd_and_cosine_even() {
    let mut random = Random(3);
    let x: Vec<_> = (0..20_000).map(|_| random.between(0.0, 2e5)).collect();
    let minus: Vec<_> = x.iter().map(|x| -x).collect();
    for isa in Isa::available() {
        let (there, back) = with_scalar!(isa, S => (sin_cos::<S>(&x), sin_cos::<S>(&minus)));
        for ((s, c), (minus_s, minus_c)) in there.iter().zip(&back) {
            assert!(same(*s, -minus_s) && same(*c, *minus_c));
        }
    }
}
