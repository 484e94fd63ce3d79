//! A graph comes back from where its expressions are made.

use super::*;
use crate::scalar::Real;
use std::panic::{AssertUnwindSafe, catch_unwind};

#[test]
fn after_a_panic() {
    let (mut graph, [x]) = with_symbols(Simplify::Safely, ["x"]);
    let result = catch_unwind(AssertUnwindSafe(|| {
        graph.enter(|| {
            let _ = x + Expression::one();
            std::panic::resume_unwind(Box::new("a fault in a law"));
        });
    }));
    assert!(result.is_err());
    let sum = graph.enter(|| x + Expression::one());
    assert_eq!(values(&graph, &[x], &[sum.0], &[2.0]), [3.0]);
    assert!(catch_unwind(|| Expression::lit(1.0)).is_err(), "no graph is current any more");
}

#[test]
fn one_within_another() {
    let (mut outer, [x]) = with_symbols(Simplify::Safely, ["x"]);
    let (mut inner, [y]) = with_symbols(Simplify::Safely, ["y"]);
    let (before, of_inner, after) = outer.enter(|| {
        let before = x.sqrt();
        let of_inner = inner.enter(|| y * y);
        (before, of_inner, x.sqrt())
    });
    assert_eq!(before, after);
    assert_eq!(values(&outer, &[x], &[after.0], &[9.0]), [3.0]);
    assert_eq!(values(&inner, &[y], &[of_inner.0], &[9.0]), [81.0]);
}
