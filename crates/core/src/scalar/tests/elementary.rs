//! Functions of one and two numbers against the library.
//!
//! The library is right to 0.6 units in the last place (glibc) or to one (what the others document). So at most
//! one unit between it and us means at most two from the true value.

use super::{Random, same, ulps};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Elementary, Lane};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

const ALL: [Elementary; 10] = [
    Elementary::Tan,
    Elementary::Asin,
    Elementary::Acos,
    Elementary::Atan,
    Elementary::Sinh,
    Elementary::Cosh,
    Elementary::Tanh,
    Elementary::Exp,
    Elementary::Ln,
    Elementary::Floor,
];

/// All functions of one number, then the angle and the power of two: rows of results, [`Lane::N`] at a time.
fn run<L: Lane>(rows: &[[f64; 2]]) -> Vec<[f64; 12]> {
    let mut out = vec![[0.0; 12]; rows.len()];
    L::call(
        #[inline(always)]
        || {
            for start in (0..rows.len()).step_by(L::N) {
                let [x, y] = [0, 1].map(
                    #[inline(always)]
                    |i| {
                        L::from_lanes(
                            #[inline(always)]
                            |l| rows[(start + l).min(rows.len() - 1)][i],
                        )
                    },
                );
                let mut all = [x; 12];
                for (to, f) in all.iter_mut().zip(ALL) {
                    *to = x.elementary(f);
                }
                (all[10], all[11]) = (x.atan2(y), x.pow(y));
                for (l, out) in out[start..].iter_mut().enumerate().take(L::N) {
                    *out = all.map(
                        #[inline(always)]
                        |value| value.get(l),
                    );
                }
            }
        },
    );
    out
}

fn library([x, y]: [f64; 2]) -> [f64; 12] {
    let mut out = [0.0; 12];
    for (to, f) in out.iter_mut().zip(ALL) {
        *to = f.value(x);
    }
    (out[10], out[11]) = (x.atan2(y), x.powf(y));
    out
}

fn within_one_ulp_of_the_library(rows: &[[f64; 2]]) {
    for isa in Isa::available() {
        let all = with_scalar!(isa, S => run::<S>(rows));
        for (row, got) in rows.iter().zip(all) {
            let known = library(*row);
            for i in 0..12 {
                assert!(ulps(got[i], known[i]) <= 1, "{i} of {row:?}: {:e}, library {:e}", got[i], known[i]);
            }
        }
    }
}

/// Arguments of every size, and those next to which the way of computing changes.
fn arguments() -> Vec<[f64; 2]> {
    let mut x = Vec::new();
    for edge in [0.0, f64::MIN_POSITIVE, 7.0 / 16.0, 0.5, 11.0 / 16.0, 0.5f64.sqrt(), 1.0, 2f64.sqrt(), 708.0]
    {
        x.extend([edge.next_down(), edge, edge.next_up(), -edge, edge + 1.0, 1.0 - edge]);
    }
    x.extend([709.7, 709.9, -708.5, -720.0, -745.2, 1e22, 1e300, 5e-324, 1e-320, f64::MAX, f64::MIN]);
    x.extend([f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -2.0, 3.0, -0.5]);
    let mut rows: Vec<_> = x.iter().flat_map(|a| x.iter().map(|b| [*a, *b])).collect();
    let mut random = Random(40);
    for _ in 0..40_000 {
        let size = 10f64.powf(random.between(-20.0, 3.0));
        rows.push([0; 2].map(|_| size * random.between(-1.0, 1.0)));
        rows.push([0; 2].map(|_| f64::from_bits(random.bits())));
        rows.push([0; 2].map(|_| random.between(-1.5, 1.5)));
        rows.push([1.0 - size.min(1.0), size.min(1.0) - 1.0]);
        rows.push([random.between(-708.0, 708.0), random.between(-10.0, 10.0)]);
    }
    rows
}

#[test]
fn at_arguments_of_every_size() {
    within_one_ulp_of_the_library(&arguments());
}

#[test]
fn every_lane_is_the_number_alone() {
    let rows = arguments();
    for isa in Isa::available() {
        let alone = with_scalar!(isa, S => run::<S>(&rows));
        let lanes = with_lanes!(isa, L => run::<L>(&rows));
        for ((row, lane), alone) in rows.iter().zip(lanes).zip(alone) {
            for i in 0..12 {
                assert!(same(lane[i], alone[i]), "{isa:?}, {i} of {row:?}: {:e}, {:e}", lane[i], alone[i]);
            }
        }
    }
}

/// Calls `check(results)` for a row of arguments, on every instruction set.
fn each(row: [f64; 2], check: impl Fn([f64; 12])) {
    for isa in Isa::available() {
        check(with_scalar!(isa, S => run::<S>(&[row]))[0]);
        check(with_lanes!(isa, L => run::<L>(&[row]))[0]);
    }
}

#[test]
fn special_values_of_one_number() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    use Elementary::{Acos, Asin, Atan, Exp, Floor, Ln};
    let known = [
        (
            Exp,
            vec![(0.0, 1.0), (-0.0, 1.0), (inf, inf), (-inf, 0.0), (710.0, inf), (-746.0, 0.0), (nan, nan)],
        ),
        (Exp, vec![(-745.0, 5e-324), (-740.0, 4.2e-322), (-709.0, 1.216780750623423e-308)]),
        (Ln, vec![(1.0, 0.0), (0.0, -inf), (-0.0, -inf), (-1.0, nan), (-inf, nan), (inf, inf), (nan, nan)]),
        (Ln, vec![(5e-324, -744.4400719213812), (-5e-324, nan), (f64::MAX, 709.782712893384)]),
        (
            Atan,
            vec![
                (0.0, 0.0),
                (-0.0, -0.0),
                (inf, FRAC_PI_2),
                (-inf, -FRAC_PI_2),
                (1.0, FRAC_PI_4),
                (nan, nan),
            ],
        ),
        (
            Asin,
            vec![
                (0.0, 0.0),
                (-0.0, -0.0),
                (1.0, FRAC_PI_2),
                (-1.0, -FRAC_PI_2),
                (5e-324, 5e-324),
                (nan, nan),
            ],
        ),
        (Asin, vec![(1.0f64.next_up(), nan), (-inf, nan), (inf, nan), (-1e308, nan)]),
        (
            Acos,
            vec![
                (0.0, FRAC_PI_2),
                (-0.0, FRAC_PI_2),
                (1.0, 0.0),
                (-1.0, PI),
                (1.5, nan),
                (-inf, nan),
                (nan, nan),
            ],
        ),
        (Floor, vec![(-0.5, -1.0), (-0.0, -0.0), (2.5, 2.0), (1e300, 1e300), (-inf, -inf), (nan, nan)]),
    ];
    for (f, values) in known {
        let i = ALL.iter().position(|g| *g == f).unwrap();
        for (x, value) in values {
            each([x, 1.0], |got| assert!(same(got[i], value), "{f:?}({x:e}) = {:e}, not {value:e}", got[i]));
        }
    }
}

#[test]
fn the_angle_knows_the_signs_of_zeros_and_infinities() {
    let inf = f64::INFINITY;
    for (y, x, angle) in [
        (0.0, 0.0, 0.0),
        (0.0, -0.0, PI),
        (0.0, 1.0, 0.0),
        (0.0, -1.0, PI),
        (0.0, inf, 0.0),
        (0.0, -inf, PI),
        (1.0, 0.0, FRAC_PI_2),
        (1.0, -0.0, FRAC_PI_2),
        (1.0, 1.0, FRAC_PI_4),
        (1.0, -1.0, 3.0 * FRAC_PI_4),
        (1.0, inf, 0.0),
        (1.0, -inf, PI),
        (inf, 1.0, FRAC_PI_2),
        (inf, -0.0, FRAC_PI_2),
        (inf, inf, FRAC_PI_4),
        (inf, -inf, 3.0 * FRAC_PI_4),
        (5e-324, 1.0, 5e-324),
        (5e-324, -5e-324, 3.0 * FRAC_PI_4),
        (5e-324, 1e300, 0.0),
        (f64::MAX, f64::MAX, FRAC_PI_4),
        (1e300, -1e-300, FRAC_PI_2),
    ] {
        for (y, angle) in [(y, angle), (-y, -angle)] {
            each([y, x], |got| assert!(same(got[10], angle), "atan2({y:e}, {x:e}) = {:e}", got[10]));
        }
    }
    for (y, x) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, inf), (0.0, f64::NAN)] {
        each([y, x], |got| assert!(got[10].is_nan()));
    }
}

#[test]
fn whole_and_half_powers_are_exact() {
    let mut random = Random(41);
    for _ in 0..200 {
        // Few enough digits for exact products.
        let x = (random.bits() % 2000) as f64 - 1000.0;
        for (y, power) in [(0.0, 1.0), (1.0, x), (2.0, x * x), (3.0, x * x * x), (4.0, x * x * x * x)] {
            each([x, y], |got| assert!(same(got[11], power), "{x}^{y} = {:e}", got[11]));
        }
        each([x * x, 0.5], |got| assert_eq!(got[11], x.abs()));
    }
}
