//! Cubic tables.

use super::{Random, same};
use crate::scalar::{Dual, Interpolation, Real, Table, TableError};
use std::hash::{BuildHasher, RandomState};

fn cubic(x: &[f64], y: &[f64]) -> Table {
    Table::new(x, y, Interpolation::Cubic).unwrap()
}

/// `n` abscissae that start at -1, with gaps from 0.2 to 1.
fn abscissae(n: usize, random: &mut Random) -> Vec<f64> {
    let mut x = vec![-1.0];
    while x.len() < n {
        x.push(x[x.len() - 1] + random.between(0.2, 1.0));
    }
    x
}

#[test]
fn as_many_samples_as_coefficients_give_back_the_polynomial_and_its_slopes() {
    let mut random = Random(20);
    for n in [1, 2, 3, 4, 5, 6, 12] {
        let x = abscissae(n, &mut random);
        let mut c = [0; 4].map(|_| random.between(-1.0, 1.0));
        c[n.min(4)..].fill(0.0);
        let polynomial = |x: f64| c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        let table = cubic(&x, &x.iter().map(|x| polynomial(*x)).collect::<Vec<_>>());
        let end = x[n - 1];
        for _ in 0..100 {
            let at = random.between(-1.0, end);
            if at >= end {
                continue;
            }
            // A value of size `end³` is rounded to 1e-16 of that, and each derivative divides by a gap of 0.2
            // or more.
            let mut tolerance = 1e-14 * (1.0 + end.abs().powi(3));
            let derivatives = [
                polynomial(at),
                c[1] + at * (2.0 * c[2] + at * 3.0 * c[3]),
                2.0 * c[2] + 6.0 * c[3] * at,
                6.0 * c[3],
                0.0,
            ];
            let mut slope = &table;
            for derivative in derivatives {
                let got = slope.value(at);
                assert!((got - derivative).abs() <= tolerance, "{n} samples: {got}, not {derivative}");
                slope = slope.slope();
                tolerance *= 10.0;
            }
        }
    }
}

#[test]
fn two_derivatives_go_on_over_inner_samples_and_the_third_over_those_next_to_the_ends() {
    let mut random = Random(21);
    for n in 4..12 {
        let x = abscissae(n, &mut random);
        let y: Vec<_> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
        let table = cubic(&x, &y);
        for i in 1..n - 1 {
            assert_eq!(table.value(x[i]), y[i]);
            let third_too = i == 1 || i == n - 2;
            let mut derivative = &table;
            for order in 0..if third_too { 4 } else { 3 } {
                let (left, right) = (derivative.value(x[i].next_down()), derivative.value(x[i]));
                // Values of order one; each derivative divides by gaps of 0.2 or more.
                let tolerance = 1e-13 * 10f64.powi(order);
                assert!((left - right).abs() <= tolerance, "order {order} at {i} of {n}: {left}, {right}");
                derivative = derivative.slope();
            }
        }
        assert!((table.value(x[n - 1].next_down()) - y[n - 1]).abs() < 1e-13);
    }
}

#[test]
fn the_figures_of_another_program() {
    // scipy.interpolate.CubicSpline(x, y) of SciPy 1.17, at 0.25, 1.5, 3 and 4.75.
    let table = cubic(&[0.0, 0.5, 2.0, 2.5, 4.0, 5.0], &[1.0, -1.0, 2.0, 0.0, 3.0, -2.0]);
    for (x, y) in [
        (0.25, -0.5198334168336673),
        (1.5, 1.7788577154308616),
        (3.0, -0.0404809619238477),
        (4.75, 0.8045779058116231),
    ] {
        assert!((table.value(x) - y).abs() < 1e-14, "{} at {x}", table.value(x));
    }
}

#[test]
fn outside_the_end_values_hold_with_slope_zero() {
    let (x, y) = ([0.0, 1.0, 1.5, 4.0, 5.0], [1.0, 3.0, -2.0, 0.5, 7.0]);
    let table = cubic(&x, &y);
    for at in [f64::NEG_INFINITY, -f64::MAX, -1.0, 0.0f64.next_down()] {
        assert_eq!((table.value(at), table.slope().value(at)), (1.0, 0.0));
        assert_eq!(table.slope().slope().value(at), 0.0);
    }
    for at in [5.0, 5.5, f64::MAX, f64::INFINITY] {
        assert_eq!((table.value(at), table.slope().value(at)), (7.0, 0.0));
        assert_eq!(table.slope().slope().slope().value(at), 0.0);
    }
    assert!(table.value(f64::NAN).is_nan());
}

#[test]
fn a_dual_takes_the_slope_table() {
    let table = cubic(&[0.0, 1.0, 1.5, 4.0, 5.0], &[1.0, 3.0, -2.0, 0.5, 7.0]);
    let mut random = Random(22);
    for _ in 0..200 {
        let x = random.between(-1.0, 6.0);
        type Two = Dual<Dual<f64, 1>, 1>;
        let v = Two { value: Dual { value: x, slope: [1.0] }, slope: [Dual::one()] };
        let got = v.lookup(&table);
        assert_eq!(got.value.value, table.value(x));
        assert_eq!(got.slope[0].value, table.slope().value(x));
        assert_eq!(got.slope[0].slope[0], table.slope().slope().value(x));
    }
}

#[test]
fn only_where_the_slope_jumps_is_a_break() {
    let table = cubic(&[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 1.0, 0.0, 1.0, 0.0]);
    assert_eq!(table.breaks(), [0.0, 4.0]);
    assert_eq!(table.slope().breaks(), [0.0, 4.0]);
    // The second derivative is made of straight lines.
    assert_eq!(table.slope().slope().breaks(), [0.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(cubic(&[2.0], &[1.0]).breaks(), [2.0]);
}

#[test]
fn the_pieces_say_all() {
    let mut random = Random(23);
    let x = abscissae(6, &mut random);
    for interpolation in [Interpolation::Hold, Interpolation::Linear, Interpolation::Cubic] {
        let y = [0; 6].map(|_| random.between(-1.0, 1.0));
        let table = Table::new(&x, &y, interpolation).unwrap();
        let (starts, rows) = table.pieces();
        assert_eq!((starts.len(), starts[0], &starts[1..]), (rows.len(), f64::NEG_INFINITY, &x[..]));
        assert_eq!((rows[0], rows[6]), ([y[0], 0.0, 0.0, 0.0], [y[5], 0.0, 0.0, 0.0]));
        for _ in 0..100 {
            let at = random.between(-1.0, x[5]);
            let i = starts.iter().rposition(|s| *s <= at).unwrap();
            let d = at - starts[i];
            let value = rows[i][0] + rows[i][1] * d + rows[i][2] * d * d + rows[i][3] * d * d * d;
            // Coefficients up to some tens.
            assert!((table.value(at) - value).abs() < 1e-13);
        }
    }
}

#[test]
fn tables_are_equal_by_content() {
    let (x, y) = ([0.0, 1.0, 2.0, 3.0], [1.0, 3.0, -2.0, 0.5]);
    let (table, hasher) = (cubic(&x, &y), RandomState::new());
    assert_eq!(table, cubic(&x, &y));
    assert_eq!(hasher.hash_one(&table), hasher.hash_one(cubic(&x, &y)));
    assert_ne!(table, Table::new(&x, &y, Interpolation::Linear).unwrap());
    assert_ne!(table, cubic(&x, &[1.0, 3.0, -2.0, 0.5f64.next_up()]));
    assert_ne!(table, table.slope().clone());
    assert_eq!(cubic(&x[..2], &y[..2]), Table::new(&x[..2], &y[..2], Interpolation::Linear).unwrap());
}

#[test]
fn a_repeated_abscissa_or_a_curve_too_steep_is_refused() {
    let error = |x: &[f64], y: &[f64]| Table::new(x, y, Interpolation::Cubic).unwrap_err();
    assert_eq!(error(&[0.0, 1.0, 1.0], &[0.0; 3]), TableError::Order { index: 2 });
    assert_eq!(error(&[0.0, 1.0, 0.5], &[0.0; 3]), TableError::Order { index: 2 });
    assert_eq!(error(&[0.0, 1e-310, 1.0, 2.0], &[0.0, 1.0, 0.0, 0.0]), TableError::NotFinite { index: 1 });
    assert_eq!(error(&[], &[]), TableError::Length { abscissae: 0, values: 0 });
    // Numbers of every size are no fault of their own.
    let huge = cubic(&[0.0, 1.0, 2.0, 3.0], &[1e300, -1e300, 1e300, 0.0]);
    assert!(same(huge.value(1.0), -1e300));
}
