//! What is known when an expression is made is folded, and every double stays the same.

use super::recipe::{Kind, Recipe, point};
use super::*;
use crate::scalar::tests::Random;
use crate::scalar::{Elementary, Real};

#[test]
fn each_rule_gives_the_shorter_expression() {
    for simplify in [Simplify::Safely, Simplify::Algebraically] {
        let (mut graph, [a, b]) = with_symbols(simplify, ["a", "b"]);
        graph.enter(|| {
            let lit = Expression::lit;
            let (zero, one, two) = (lit(0.0), lit(1.0), lit(2.0));
            let sine = |x: Expression| x.sin_cos().0;
            let cosine = |x: Expression| x.sin_cos().1;
            for (made, expected) in [
                (a + zero, a),
                (zero + a, a),
                (a - zero, a),
                (zero - a, -a),
                (a - a, zero),
                (a + a, two * a),
                (a * zero, zero),
                (a * one, a),
                (a / one, a),
                (zero / a, zero),
                (-(-a), a),
                (-zero, zero),
                (-(a - b), b - a),
                (a + -b, a - b),
                (-a + b, b - a),
                (a - -b, a + b),
                (-a - b, -(a + b)),
                (-a + -b, -(a + b)),
                (-a * b, -(a * b)),
                (-a * -b, a * b),
                (-a / b, -(a / b)),
                (a / -b, -(a / b)),
                (-a / -b, a / b),
                (a * lit(-1.0), -a),
                (a + b, b + a),
                (a * b, b * a),
                (sine(-a), -sine(a)),
                (cosine(-a), cosine(a)),
                ((-a).abs(), a.abs()),
                (a.abs().abs(), a.abs()),
                ((-a).elementary(Elementary::Atan), -a.elementary(Elementary::Atan)),
                ((-a).elementary(Elementary::Cosh), a.elementary(Elementary::Cosh)),
                (a.pow(zero), one),
                (a.pow(one), a),
                (a.pow(two), a * a),
                (a.pow(lit(3.0)), a * a * a),
                (a.pow(lit(4.0)), (a * a) * (a * a)),
                (a.pow(lit(0.5)), a.sqrt()),
                (a.pow(lit(-1.0)), one / a),
                (Expression::select_le(a, b, a, a), a),
                (Expression::select_le(one, two, a, b), a),
                (Expression::select_le(two, one, a, b), b),
                (lit(0.1) + lit(0.2), lit(0.1 + 0.2)),
            ] {
                assert_eq!(made, expected);
            }
        });
    }
}

#[test]
fn constants_are_what_numbers_give() {
    use Elementary::*;
    let mut graph = Graph::new(Simplify::Safely);
    let x = 0.3_f64;
    for f in [Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Exp, Ln, Floor] {
        let id = graph.enter(|| Expression::lit(x).elementary(f).0);
        assert_eq!(graph.number(id), Some(Real::elementary(x, f)), "{f:?}");
    }
    let id = graph.enter(|| Expression::lit(x).atan2(Expression::lit(-2.0)).pow(Expression::lit(1.7)).0);
    assert_eq!(graph.number(id), Some(Real::pow(Real::atan2(x, -2.0), 1.7)));
}

#[test]
fn what_is_not_finite_is_left_to_the_run() {
    let mut graph = Graph::new(Simplify::Safely);
    let id = graph.enter(|| (Expression::one() / Expression::zero()).0);
    assert_eq!(graph.number(id), None);
    assert_eq!(values(&graph, &[], &[id], &[]), [f64::INFINITY]);
}

#[test]
fn folded_expressions_have_the_values_of_the_unfolded() {
    let mut random = Random(1);
    for _ in 0..400 {
        let recipe = Recipe::new(&mut random, Kind::Any, 3, 25);
        let (mut graph, given) = with_symbols(Simplify::Safely, ["a", "b", "c"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        for _ in 0..3 {
            let at = point(&mut random, 3);
            let direct = recipe.run(&at);
            if direct.iter().all(|x| x.is_finite()) {
                // Zeros of both signs are equal here, everything else is bit for bit.
                assert_eq!(values(&graph, &given, &all, &at), direct);
            }
        }
    }
}
