//! The coefficients satisfy the conditions that they were made from.

use crate::integrators::{Dop853, Dp54, Method, Rk4, Row, Vern8, Vern9};

/// Sums of up to 25 products of coefficients up to 50, or as large as they are, each rounded to 1e-16 of its size.
fn rounding<M: Method>() -> f64 {
    let stages = M::STAGES.iter().flat_map(|stage| stage.a);
    let largest = stages.fold(50.0, |largest: f64, (_, w)| largest.max(w.abs()));
    4e-16 * largest
}

fn abscissae<M: Method>() -> Vec<f64> {
    let end = [1.0];
    let stages = M::STAGES.iter().map(|s| s.c);
    stages.chain(end).chain(M::DENSE_STAGES.iter().map(|s| s.c)).collect()
}

/// `Σ w_j c_j^k`.
fn moment(row: Row, c: &[f64], k: usize) -> f64 {
    row.iter().map(|&(j, w)| w * c[j].powi(k as i32)).sum()
}

fn check<M: Method>(error_orders: &[usize]) {
    let (c, rounding) = (abscissae::<M>(), rounding::<M>());
    for stage in M::STAGES.iter().chain(M::DENSE_STAGES) {
        assert!((moment(stage.a, &c, 0) - stage.c).abs() < rounding, "row sum of the stage at {}", stage.c);
    }
    for k in 0..M::ORDER {
        let sum = moment(M::WEIGHTS, &c, k);
        assert!((sum - 1.0 / (k + 1) as f64).abs() < rounding, "quadrature of t^{k}: {sum}");
    }
    // An estimate is the difference of two solutions: it vanishes for what the poorer one has exactly.
    assert_eq!(M::ERROR.len(), error_orders.len());
    for (row, order) in M::ERROR.iter().zip(error_orders) {
        for k in 0..*order {
            assert!(moment(row, &c, k).abs() < rounding, "error estimate of t^{k}");
        }
        // Not zero but for rounding: where stages lie close together, their weights are differences.
        assert!(
            moment(row, &c, *order).abs() > 1e5 * rounding,
            "an estimate of order {order} sees t^{order}"
        );
    }
    // Terms beyond the cubic do not see a cubic solution, whose derivative is quadratic.
    for row in M::DENSE {
        for k in 0..3 {
            assert!(moment(row, &c, k).abs() < 1e3 * rounding, "dense term of t^{k}");
        }
    }
    let used = M::ERROR.iter().flat_map(|row| row.iter()).any(|&(j, _)| j == M::STAGES.len());
    assert_eq!(used, M::FIRST_SAME_AS_LAST);
}

#[test]
fn rk4() {
    check::<Rk4>(&[]);
}

#[test]
fn dp54() {
    check::<Dp54>(&[4]);
}

#[test]
fn dop853() {
    check::<Dop853>(&[5, 3]);
}

#[test]
fn vern8() {
    check::<Vern8>(&[6]);
}

#[test]
fn vern9() {
    check::<Vern9>(&[7]);
}
