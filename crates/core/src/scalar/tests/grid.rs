//! Grids.

use super::Random;
use crate::scalar::{Dual, Grid, Interpolation, Real, Table, TableError};
use std::hash::{BuildHasher, RandomState};

const X: [f64; 5] = [-1.0, 0.0, 0.5, 2.0, 3.0];
const Y: [f64; 4] = [0.0, 1.0, 1.5, 4.0];

/// Samples of a function, by rows.
fn sampled(f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    X.iter().flat_map(|x| Y.iter().map(|y| f(*x, *y)).collect::<Vec<_>>()).collect()
}

fn random_grid(interpolation: Interpolation, random: &mut Random) -> (Vec<f64>, Grid) {
    let values: Vec<_> = (0..X.len() * Y.len()).map(|_| random.between(-1.0, 1.0)).collect();
    let grid = Grid::new(&X, &Y, &values, interpolation).unwrap();
    (values, grid)
}

#[test]
fn bicubic_grids_give_back_products_of_cubics_and_all_their_derivatives() {
    let p =
        |x: f64| [1.0 + x * (-0.5 + x * (0.25 - 0.125 * x)), -0.5 + x * (0.5 - 0.375 * x), 0.5 - 0.75 * x];
    let q = |y: f64| [-2.0 + y * (1.0 + y * (0.5 + 0.25 * y)), 1.0 + y * (1.0 + 0.75 * y), 1.0 + 1.5 * y];
    let grid = Grid::new(&X, &Y, &sampled(|x, y| p(x)[0] * q(y)[0]), Interpolation::Cubic).unwrap();
    let mut random = Random(30);
    for _ in 0..300 {
        let (x, y) = (random.between(-1.0, 3.0), random.between(0.0, 4.0));
        let mut along_x = &grid;
        for by_x in 0..3 {
            let mut slope = along_x;
            for by_y in 0..3 {
                let (got, expected) = (slope.value(x, y), p(x)[by_x] * q(y)[by_y]);
                // Samples up to 50 with rounding of 1e-14, divided by gaps of a half as often as differentiated.
                assert!((got - expected).abs() < 1e-11, "{by_x} {by_y} at {x} {y}: {got}, not {expected}");
                slope = slope.slope_y();
            }
            along_x = along_x.slope_x();
        }
    }
}

#[test]
fn bilinear_grids_are_lines_of_lines() {
    let mut random = Random(31);
    let (values, grid) = random_grid(Interpolation::Linear, &mut random);
    for _ in 0..300 {
        let (x, y) = (random.between(-2.0, 4.0), random.between(-1.0, 5.0));
        // Along y first, then along x: the other way round than the grid does it.
        let line = |v: &[f64]| Table::new(&Y, v, Interpolation::Linear).unwrap().value(y);
        let column: Vec<_> = values.chunks(Y.len()).map(line).collect();
        let across = Table::new(&X, &column, Interpolation::Linear).unwrap();
        assert!((grid.value(x, y) - across.value(x)).abs() < 1e-14);
        assert!((grid.slope_x().value(x, y) - across.slope().value(x)).abs() < 1e-14);
    }
}

#[test]
fn a_grid_goes_through_its_samples_and_is_a_table_along_each_sampled_line() {
    let mut random = Random(32);
    for interpolation in [Interpolation::Hold, Interpolation::Linear, Interpolation::Cubic] {
        let (values, grid) = random_grid(interpolation, &mut random);
        for (i, x) in X.iter().enumerate() {
            let row = Table::new(&Y, &values[Y.len() * i..Y.len() * (i + 1)], interpolation).unwrap();
            for (j, y) in Y.iter().enumerate() {
                assert_eq!(grid.value(*x, *y), values[Y.len() * i + j]);
            }
            for _ in 0..50 {
                let y = random.between(-1.0, 5.0);
                // The last row is on the border, where the grid ends and holds.
                assert!((grid.value(*x, y) - row.value(y)).abs() < 1e-13);
                assert!((grid.slope_y().value(*x, y) - row.slope().value(y)).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn outside_the_border_values_hold() {
    let mut random = Random(33);
    for interpolation in [Interpolation::Linear, Interpolation::Cubic] {
        let (_, grid) = random_grid(interpolation, &mut random);
        for _ in 0..300 {
            let (x, y) = (random.between(-3.0, 5.0), random.between(-2.0, 6.0));
            let (inner_x, inner_y) = (x.clamp(-1.0, 3.0), y.clamp(0.0, 4.0));
            assert_eq!(grid.value(x, y), grid.value(inner_x, inner_y));
            if x != inner_x {
                assert_eq!(grid.slope_x().value(x, y), 0.0);
                assert_eq!(grid.slope_y().value(x, y), grid.slope_y().value(inner_x, y));
            }
            if y != inner_y {
                assert_eq!(grid.slope_y().value(x, y), 0.0);
            }
        }
        let far = f64::INFINITY;
        assert_eq!(grid.value(-far, -f64::MAX), grid.value(-1.0, 0.0));
        assert_eq!(grid.value(far, 0.25), grid.value(3.0, 0.25));
        assert_eq!(grid.slope_x().value(far, 0.25), 0.0);
        assert!(grid.value(f64::NAN, 0.0).is_nan() && grid.value(0.0, f64::NAN).is_nan());
    }
}

#[test]
fn bicubic_grids_have_continuous_slopes() {
    let mut random = Random(34);
    let (_, grid) = random_grid(Interpolation::Cubic, &mut random);
    let mixed = grid.slope_x().slope_y();
    for _ in 0..100 {
        let y = random.between(0.0, 4.0);
        for x in &X[1..4] {
            for f in [&grid, grid.slope_x(), grid.slope_y(), mixed, grid.slope_x().slope_x()] {
                // Second derivatives up to some tens.
                assert!((f.value(*x, y) - f.value(x.next_down(), y)).abs() < 1e-12);
            }
        }
    }
    assert_eq!(mixed, grid.slope_y().slope_x());
}

#[test]
fn a_dual_takes_the_slope_grids() {
    type Two = Dual<Dual<f64, 2>, 2>;
    let mut random = Random(35);
    let (_, grid) = random_grid(Interpolation::Cubic, &mut random);
    for _ in 0..200 {
        let (x, y) = (random.between(-2.0, 4.0), random.between(-1.0, 5.0));
        let variable = |v: f64, i: usize| Two {
            value: Dual { value: v, slope: [f64::from(i == 0), f64::from(i == 1)] },
            slope: [Dual::lit(f64::from(i == 0)), Dual::lit(f64::from(i == 1))],
        };
        // At (2u, u - v): the slopes by u and v follow by the chain rule.
        let u = variable(0.5 * x, 0);
        let v = variable(0.5 * x - y, 1);
        let f = (u + u).lookup_2(u - v, &grid);
        let at = |g: &Grid| g.value(x, 0.5 * x - (0.5 * x - y));
        let (by_x, by_y) = (grid.slope_x(), grid.slope_y());
        let (xx, xy, yy) = (by_x.slope_x(), by_x.slope_y(), by_y.slope_y());
        let expected = [
            (f.value.value, at(&grid)),
            (f.slope[0].value, 2.0 * at(by_x) + at(by_y)),
            (f.slope[1].value, -at(by_y)),
            (f.slope[0].slope[0], 4.0 * at(xx) + 4.0 * at(xy) + at(yy)),
            (f.slope[0].slope[1], -2.0 * at(xy) - at(yy)),
            (f.slope[1].slope[1], at(yy)),
        ];
        for (got, expected) in expected {
            // Second derivatives up to a hundred.
            assert!((got - expected).abs() < 1e-12, "{got} is not {expected}");
        }
    }
}

#[test]
fn the_patches_say_all() {
    let mut random = Random(36);
    let (_, grid) = random_grid(Interpolation::Cubic, &mut random);
    let (x_starts, y_starts, patches) = grid.patches();
    assert_eq!((x_starts[0], y_starts[0]), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    assert_eq!((&x_starts[1..], &y_starts[1..]), (&X[..], &Y[..]));
    for _ in 0..100 {
        let (x, y) = (random.between(-1.0, 3.0), random.between(0.0, 4.0));
        let i = x_starts.iter().rposition(|s| *s <= x).unwrap();
        let j = y_starts.iter().rposition(|s| *s <= y).unwrap();
        let (d, e) = (x - x_starts[i], y - y_starts[j]);
        let mut value = 0.0;
        for (k, row) in patches[y_starts.len() * i + j].iter().enumerate() {
            for (l, c) in row.iter().enumerate() {
                value += c * d.powi(k as i32) * e.powi(l as i32);
            }
        }
        // Coefficients up to some tens.
        assert!((grid.value(x, y) - value).abs() < 1e-13);
    }
}

#[test]
fn grids_are_equal_by_content() {
    let values = sampled(|x, y| (x - y).abs());
    let grid = |values: &[f64], kind| Grid::new(&X, &Y, values, kind).unwrap();
    let (one, hasher) = (grid(&values, Interpolation::Cubic), RandomState::new());
    assert_eq!(one, grid(&values, Interpolation::Cubic));
    assert_eq!(hasher.hash_one(&one), hasher.hash_one(grid(&values, Interpolation::Cubic)));
    assert_ne!(one, grid(&values, Interpolation::Linear));
    assert_ne!(one, one.slope_x().clone());
}

#[test]
fn jumps_and_single_lines_are_grids_too() {
    let jump = Grid::new(&[0.0, 1.0, 1.0], &[5.0], &[1.0, 2.0, 7.0], Interpolation::Linear).unwrap();
    for (x, value) in [(-1.0, 1.0), (0.5, 1.5), (1.0, 7.0), (2.0, 7.0)] {
        for y in [-9.0, 5.0, 6.0] {
            assert_eq!(jump.value(x, y), value);
        }
    }
    assert_eq!(jump.slope_y().value(0.5, 5.0), 0.0);
}

#[test]
fn samples_that_are_no_grid_are_refused() {
    let error = |x: &[f64], y: &[f64], v: &[f64], kind| Grid::new(x, y, v, kind).unwrap_err();
    let (linear, cubic, line) = (Interpolation::Linear, Interpolation::Cubic, [0.0, 1.0, 2.0]);
    assert_eq!(error(&[], &line, &[], linear), TableError::Length { abscissae: 0, values: 0 });
    assert_eq!(error(&line, &line, &[0.0; 8], linear), TableError::Length { abscissae: 9, values: 8 });
    assert_eq!(error(&[0.0, 2.0, 1.0], &line, &[0.0; 9], linear), TableError::Order { index: 6 });
    assert_eq!(error(&line, &[0.0, 1.0, 1.0], &[0.0; 9], cubic), TableError::Order { index: 2 });
    assert_eq!(error(&[0.0, f64::NAN, 1.0], &line, &[0.0; 9], linear), TableError::NotFinite { index: 3 });
    let mut values = [0.0; 9];
    values[5] = f64::INFINITY;
    assert_eq!(error(&line, &line, &values, linear), TableError::NotFinite { index: 5 });
    values[5] = 1.0;
    let steep = [0.0, 1.0, 1.0f64.next_up()];
    assert!(Grid::new(&line, &steep, &values, linear).is_ok());
    assert_eq!(
        error(&line, &[0.0, 1e-310, 1.0], &[1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], linear),
        TableError::NotFinite { index: 1 }
    );
}
