//! Doubles are told apart exactly.

use super::*;
use crate::scalar::Real;
use crate::scalar::tests::Random;

#[test]
fn a_sum_of_doubles_is_a_double_only_if_it_is_exact() {
    let (mut graph, [x]) = with_symbols(Simplify::Algebraically, ["x"]);
    graph.enter(|| {
        let lit = Expression::lit;
        assert_eq!(lit(0.5) * x + lit(0.25) * x, lit(0.75) * x);
        assert_ne!(lit(0.1) * x + lit(0.2) * x, lit(0.3) * x);
        assert_ne!(lit(0.1) * x + lit(0.2) * x, lit(0.1 + 0.2) * x);
    });
}

#[test]
fn doubles_are_different() {
    let mut graph = Graph::new(Simplify::Algebraically);
    let mut random = Random(4);
    let mut all: Vec<f64> = (-1022..1024).map(|power| 2f64.powi(power)).collect();
    all.extend((0..52).map(|place| f64::from_bits(1 << place)));
    all.extend([f64::INFINITY, f64::NAN, f64::MAX, 0.0]);
    all.extend((0..2000).map(|_| f64::from_bits(random.bits() >> 1)).filter(|x| x.is_finite()));
    let mut made: Vec<_> = all.iter().flat_map(|x| [*x, -*x]).map(|x| graph.constant(x)).collect();
    let expected = made.len() - 1; // 0 and −0 are one.
    made.sort_unstable();
    made.dedup();
    assert_eq!(made.len(), expected);
}
