//! Tables.

use super::{Random, same};
use crate::scalar::{Interpolation, Table, TableError};

const X: [f64; 4] = [-1.0, 0.0, 0.0, 2.0];
const Y: [f64; 4] = [3.0, 1.0, -1.0, 0.5];

fn linear() -> Table {
    Table::new(&X, &Y, Interpolation::Linear).unwrap()
}

fn assert_values(table: &Table, expected: &[(f64, f64)]) {
    for (x, y) in expected {
        // The numbers of these tests are exact in binary.
        assert_eq!(table.value(*x), *y, "at {x}");
    }
}

#[test]
fn hold_keeps_each_value_until_the_next_sample() {
    let table = Table::new(&[0.0, 1.0, 4.0], &[2.0, -3.0, 5.0], Interpolation::Hold).unwrap();
    let before = 1.0f64.next_down();
    assert_values(&table, &[(-9.0, 2.0), (0.0, 2.0), (before, 2.0), (1.0, -3.0), (3.9, -3.0), (4.0, 5.0)]);
    assert_values(table.slope(), &[(-9.0, 0.0), (0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (4.0, 0.0), (9.0, 0.0)]);
}

#[test]
fn linear_goes_through_its_samples_and_jumps_where_two_share_an_abscissa() {
    assert_values(&linear(), &[(-1.0, 3.0), (-0.5, 2.0), (0.0, -1.0), (1.0, -0.25), (2.0, 0.5)]);
    // The left-hand value is met to the rounding of one step of x.
    assert!((linear().value(-f64::EPSILON) - 1.0).abs() < 4.0 * f64::EPSILON);
    assert_values(linear().slope(), &[(-0.5, -2.0), (0.0, 0.75), (1.0, 0.75)]);
}

#[test]
fn outside_the_samples_the_end_values_hold() {
    let far = [f64::NEG_INFINITY, -f64::MAX, -2.0, 2.5, f64::MAX, f64::INFINITY];
    for (x, y) in far.into_iter().zip([3.0, 3.0, 3.0, 0.5, 0.5, 0.5]) {
        assert_values(&linear(), &[(x, y)]);
        assert_values(linear().slope(), &[(x, 0.0)]);
        assert_values(linear().slope().slope(), &[(x, 0.0)]);
    }
    let single = Table::new(&[1.0], &[7.0], Interpolation::Linear).unwrap();
    assert_values(&single, &[(f64::NEG_INFINITY, 7.0), (1.0, 7.0), (f64::INFINITY, 7.0)]);
}

#[test]
fn a_jump_may_be_at_either_end() {
    let table = Table::new(&[0.0, 0.0, 1.0, 1.0], &[5.0, 1.0, 2.0, 9.0], Interpolation::Linear).unwrap();
    assert_values(&table, &[(-1.0, 5.0), (0.0, 1.0), (0.5, 1.5), (1.0, 9.0), (3.0, 9.0)]);
}

#[test]
fn the_slope_is_the_difference_quotient() {
    let (x, y) = ([0.0, 0.7, 1.1, 5.0], [1.0, -2.0, 0.3, 4.0]);
    let table = Table::new(&x, &y, Interpolation::Linear).unwrap();
    let mut random = Random(6);
    for i in 0..3 {
        let (a, b) = (random.between(x[i], x[i + 1]), random.between(x[i], x[i + 1]));
        let quotient = (table.value(a) - table.value(b)) / (a - b);
        // Values of size 4 rounded to 1e-15, over distances of at least 0.01.
        assert!((a - b).abs() > 0.01 && (table.slope().value(a) - quotient).abs() < 1e-12);
        assert_eq!(table.slope().slope().value(a), 0.0);
    }
}

#[test]
fn breaks_are_the_distinct_abscissae() {
    assert_eq!(linear().breaks(), [-1.0, 0.0, 2.0]);
}

#[test]
fn what_is_not_a_number_stays_so() {
    let hold = Table::new(&X, &Y, Interpolation::Hold).unwrap();
    for table in [&linear(), &hold] {
        assert!(same(table.value(f64::NAN), f64::NAN));
        assert!(same(table.slope().value(f64::NAN), f64::NAN));
    }
}

#[test]
fn samples_that_are_no_table_are_refused() {
    let error = |x: &[f64], y: &[f64]| Table::new(x, y, Interpolation::Linear).unwrap_err();
    assert_eq!(error(&[], &[]), TableError::Length { abscissae: 0, values: 0 });
    assert_eq!(error(&[0.0, 1.0], &[0.0]), TableError::Length { abscissae: 2, values: 1 });
    assert_eq!(error(&[0.0, 2.0, 1.0], &[0.0; 3]), TableError::Order { index: 2 });
    assert_eq!(error(&[0.0, 1.0, 1.0, 1.0], &[0.0; 4]), TableError::Order { index: 3 });
    assert_eq!(error(&[0.0, f64::NAN], &[0.0; 2]), TableError::NotFinite { index: 1 });
    assert_eq!(error(&[0.0, f64::INFINITY], &[0.0; 2]), TableError::NotFinite { index: 1 });
    assert_eq!(error(&[0.0, 1.0], &[f64::NAN, 0.0]), TableError::NotFinite { index: 0 });
    assert_eq!(error(&[0.0, f64::from_bits(1)], &[0.0, 1.0]), TableError::NotFinite { index: 1 });
}
