//! Derivatives carried along, each rule against another exact way to the same derivative.
//!
//! A tolerance of `ROUNDING` is a few roundings of numbers of order one.

use super::{Random, same};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Dual, Interpolation, Lane, Real, Table};

const ROUNDING: f64 = 4e-15;

type One = Dual<f64, 1>;
type Two = Dual<Dual<f64, 1>, 1>;

fn variable(x: f64) -> One {
    Dual { value: x, slope: [1.0] }
}

fn twice(x: f64) -> Two {
    Dual { value: variable(x), slope: [One::one()] }
}

fn points() -> Vec<f64> {
    let mut random = Random(7);
    (0..200).map(|_| random.between(0.2, 3.0)).collect()
}

#[track_caller]
fn assert_close(got: f64, expected: f64) {
    assert!((got - expected).abs() <= ROUNDING * expected.abs().max(1.0), "{got} is not {expected}");
}

#[test]
fn rational_functions() {
    for x in points() {
        let v = variable(x);
        let (top, bottom) = (v * v - One::lit(2.0) * v + One::lit(5.0), v * v + One::one());
        assert_close((top * bottom).slope[0], 4.0 * x.powi(3) - 6.0 * x * x + 12.0 * x - 2.0);
        let quotient = (2.0 * x * x - 8.0 * x - 2.0) / (x * x + 1.0).powi(2);
        assert_close((top / bottom).slope[0], quotient);
        assert_close((-(top / bottom)).slope[0], -quotient);
        assert_close((top / bottom).value, (x * x - 2.0 * x + 5.0) / (x * x + 1.0));
        assert_close(bottom.squared().slope[0], 4.0 * x * (x * x + 1.0));
        assert_close(top.fma(bottom, v).slope[0], (top * bottom + v).slope[0]);
    }
}

#[test]
fn roots_and_absolute_values() {
    for x in points() {
        let inner = variable(x).squared() + variable(x);
        let root = inner.sqrt();
        assert_close(root.squared().value, x * x + x);
        assert_close(root.squared().slope[0], 2.0 * x + 1.0);
        for v in [variable(x), -variable(x)] {
            let size = v.squared().sqrt();
            assert_close(v.abs().value, size.value);
            assert_close(v.abs().slope[0], size.slope[0]);
        }
    }
}

#[test]
fn sines_and_cosines() {
    for x in points() {
        let inner = variable(x).squared();
        let (s, c) = inner.sin_cos();
        assert_close((s.squared() + c.squared()).slope[0], 0.0);
        let double = (inner + inner).sin_cos();
        // Slopes up to 2 · 2x, and a sine of an argument up to 18 rounded to 2e-15.
        let tolerance = 4.0 * x * ROUNDING;
        assert!((double.0.slope[0] - (One::lit(2.0) * s * c).slope[0]).abs() < tolerance);
        assert!((double.1.slope[0] - (c.squared() - s.squared()).slope[0]).abs() < tolerance);
        assert_close(s.slope[0], 2.0 * x * (x * x).cos());
    }
}

#[test]
fn a_choice_takes_the_slopes_of_what_it_chose() {
    let (low, high) = (Dual { value: 1.0, slope: [3.0] }, Dual { value: 2.0, slope: [5.0] });
    let slope = |x: One| x.slope[0];
    assert_eq!(slope(One::select_le(low, high, low, high)), 3.0);
    assert_eq!(slope(One::select_le(high, low, low, high)), 5.0);
    assert_eq!(slope(One::select_le(low, variable(f64::NAN), low, high)), 5.0);
    assert_eq!((slope(low.min(high)), slope(high.min(low))), (3.0, 3.0));
    assert_eq!((slope(low.max(high)), slope(high.max(low))), (5.0, 5.0));
}

#[test]
fn a_table_has_the_slopes_of_its_pieces() {
    let table = Table::new(&[0.0, 1.0, 1.0, 3.0], &[0.0, 2.0, 5.0, 4.0], Interpolation::Linear).unwrap();
    for (x, value, slope) in [(-1.0, 0.0, 0.0), (0.5, 1.0, 2.0), (1.0, 5.0, -0.5), (2.0, 4.5, -0.5)] {
        // The inner function doubles the slope.
        let got = (One::lit(2.0) * variable(x / 2.0)).lookup(&table);
        assert_eq!((got.value, got.slope[0]), (value, 2.0 * slope));
        let second = (twice(x) * twice(x)).lookup(&table).slope[0].slope[0];
        assert_eq!(second, 2.0 * table.slope().value(x * x));
    }
}

#[test]
fn each_direction_is_its_own_partial_derivative() {
    let mut random = Random(8);
    for _ in 0..100 {
        let (x, y) = (random.between(0.5, 2.0), random.between(0.5, 2.0));
        let (u, v) = (Dual { value: x, slope: [1.0, 0.0, 1.0] }, Dual { value: y, slope: [0.0, 1.0, -2.0] });
        let f = u * v / (u + v);
        let (by_x, by_y) = ((y / (x + y)).powi(2), (x / (x + y)).powi(2));
        assert_close(f.slope[0], by_x);
        assert_close(f.slope[1], by_y);
        assert_close(f.slope[2], by_x - 2.0 * by_y);
    }
}

#[test]
fn a_dual_of_a_dual_has_second_derivatives() {
    for x in points() {
        let v = twice(x);
        let second = |f: Two| f.slope[0].slope[0];
        let bottom = v * v + Two::one();
        assert_close(second(Two::one() / bottom), (6.0 * x * x - 2.0) / (x * x + 1.0).powi(3));
        assert_close(second(v * v * v), 6.0 * x);
        assert_close(second(v.fma(v, v * v * v)), 2.0 + 6.0 * x);
        // -1/4 x^-1.5 is up to 3 here.
        assert_close(second(v.sqrt()), -0.25 * x.powf(-1.5));
        let (s, c) = v.sin_cos();
        assert_close(second(s), -x.sin());
        assert_close(second(c), -x.cos());
        assert_close(second((-v * v * v).abs()), 6.0 * x);
    }
}

/// A function of three variables with every rule in it.
#[inline(always)]
fn mixed<T: Real>([x, y, z]: [T; 3], table: &Table) -> T {
    let (s, c) = (x * y).sin_cos();
    let f = s.fma(z, c / (y.squared() + T::one())) - (x - z).abs().sqrt();
    T::select_le(f, z, f * y, -f + z).max(T::lit(-0.5)) + (f * z).lookup(table)
}

fn table() -> Table {
    Table::new(&[-1.0, 0.2, 0.2, 1.0], &[0.0, 1.0, -0.5, 2.0], Interpolation::Linear).unwrap()
}

/// Value and three slopes at one point.
fn gradient<S: Lane>(p: [f64; 3]) -> [f64; 4] {
    S::call(
        #[inline(always)]
        || {
            let mut v = [Dual::<S, 3>::zero(); 3];
            for i in 0..3 {
                v[i].value = S::lit(p[i]);
                v[i].slope[i] = S::one();
            }
            let f = mixed(v, &table());
            [f.value.get(0), f.slope[0].get(0), f.slope[1].get(0), f.slope[2].get(0)]
        },
    )
}

#[test]
fn lanes_of_duals_are_the_duals_of_numbers() {
    fn check<S: Lane, L: Lane>() {
        let mut random = Random(9);
        for _ in 0..200 {
            let points: Vec<_> = (0..L::N).map(|_| [0; 3].map(|_| random.between(-2.0, 2.0))).collect();
            let mut out = vec![[0.0; 4]; L::N];
            L::call(
                #[inline(always)]
                || {
                    let mut v = [Dual::<L, 3>::zero(); 3];
                    for i in 0..3 {
                        v[i].value = L::from_lanes(|l| points[l][i]);
                        v[i].slope[i] = L::one();
                    }
                    let f = mixed(v, &table());
                    for (l, out) in out.iter_mut().enumerate() {
                        *out = [f.value.get(l), f.slope[0].get(l), f.slope[1].get(l), f.slope[2].get(l)];
                    }
                },
            );
            for (got, p) in out.iter().zip(points) {
                let alone = gradient::<S>(p);
                assert!(got.iter().zip(alone).all(|(g, a)| same(*g, a)), "{got:?} is not {alone:?}");
            }
        }
    }
    for isa in Isa::available() {
        with_scalar!(isa, S => with_lanes!(isa, L => check::<S, L>()));
    }
}

#[test]
fn directions_in_lanes_give_the_same_slopes() {
    fn check<S: Lane, L: Lane>() {
        let mut random = Random(10);
        for _ in 0..200 {
            let p = [0; 3].map(|_| random.between(-2.0, 2.0));
            let alone = gradient::<S>(p);
            // Lane l is direction l mod 3.
            let slopes: [f64; 8] = L::call(
                #[inline(always)]
                || {
                    let mut v = [Dual::<L, 1>::zero(); 3];
                    for i in 0..3 {
                        let seed = L::from_lanes(|l| f64::from(l % 3 == i));
                        v[i] = Dual { value: L::lit(p[i]), slope: [seed] };
                    }
                    let f = mixed(v, &table());
                    let mut out = [0.0; 8];
                    for (l, out) in out.iter_mut().enumerate().take(L::N) {
                        *out = f.slope[0].get(l);
                    }
                    out
                },
            );
            for l in 0..L::N {
                assert!(same(slopes[l], alone[1 + l % 3]), "direction {}: {slopes:?}, {alone:?}", l % 3);
            }
        }
    }
    for isa in Isa::available() {
        with_scalar!(isa, S => with_lanes!(isa, L => check::<S, L>()));
    }
}
