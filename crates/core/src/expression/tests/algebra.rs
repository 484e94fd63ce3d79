//! Equal expressions are one, different ones are not.

use super::recipe::{Kind, Recipe, point, scale};
use super::*;
use crate::scalar::Real;
use crate::scalar::tests::Random;

#[test]
fn identities_hold() {
    let (mut graph, [a, b, c]) = with_symbols(Simplify::Algebraically, ["a", "b", "c"]);
    graph.enter(|| {
        let (s, k) = a.sin_cos();
        assert_eq!(s * s + k * k, Expression::one());
        assert_eq!((Expression::one() - s * s) - k * k, Expression::zero());
        assert_eq!((a - b) + b, a);
        assert_eq!(a * b / b, a);
        assert_eq!((a + b) * c, a * c + c * b);
        assert_eq!((a + b) * (a - b), a * a - b * b);
        assert_eq!(a.sqrt() * a.sqrt(), a);
        assert_eq!((a - b).sin_cos().0, -(b - a).sin_cos().0);
        assert_eq!(s / k, a.elementary(crate::scalar::Elementary::Tan));
    });
}

#[test]
fn order_does_not_matter() {
    let mut random = Random(2);
    let (mut graph, given) = with_symbols(Simplify::Algebraically, ["a", "b", "c", "d"]);
    graph.enter(|| {
        for _ in 0..60 {
            let recipe = Recipe::new(&mut random, Kind::Rational, 4, 6);
            let mut leaves = recipe.run(&given);
            let sum = leaves.iter().fold(Expression::zero(), |s, x| s + *x);
            let product = leaves.iter().fold(Expression::one(), |p, x| p * *x);
            for i in (1..leaves.len()).rev() {
                leaves.swap(i, random.bits() as usize % (i + 1));
            }
            let (left, right) = leaves.split_at(3);
            let add = |x: &[Expression]| x.iter().fold(Expression::zero(), |s, x| s + *x);
            let multiply = |x: &[Expression]| x.iter().fold(Expression::one(), |p, x| p * *x);
            assert_eq!(add(right) + add(left), sum);
            assert_eq!(multiply(right) * multiply(left), product);
        }
    });
}

#[test]
fn different_expressions_stay_different() {
    let mut random = Random(3);
    let (mut graph, given) = with_symbols(Simplify::Algebraically, ["a", "b", "c"]);
    let mut pairs = 0;
    while pairs < 1000 {
        let recipes = [(); 2].map(|()| Recipe::new(&mut random, Kind::Any, 3, 8));
        let at = point(&mut random, 3);
        let [a, b] = [0, 1].map(|i| recipes[i].run(&at));
        let (x, y) = (a[7], b[7]);
        // Further apart than rounding can bring equal expressions.
        if (x - y).abs() > 1e-9 * scale(&a).max(scale(&b)) {
            let [x, y] = [0, 1].map(|i| graph.enter(|| recipes[i].run(&given)[7]));
            assert_ne!(x, y);
            pairs += 1;
        }
    }
}

#[test]
fn angle_sums_are_expanded_when_asked_only() {
    for asked in [false, true] {
        let mut graph = Graph::new(Simplify::Algebraically);
        graph.expand_angles = asked;
        let [a, b] = ["a", "b"].map(|n| Expression(graph.symbol(n, n)));
        let same = graph.enter(|| {
            let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
            let (sum, difference, double) = ((a + b).sin_cos(), (a - b).sin_cos(), (a + a).sin_cos());
            [
                sum.0 == sa * cb + ca * sb,
                sum.1 == ca * cb - sa * sb,
                difference.0 == sa * cb - ca * sb,
                difference.1 == ca * cb + sa * sb,
                double.0 == Expression::lit(2.0) * sa * ca,
                double.1 == Expression::one() - Expression::lit(2.0) * sa * sa,
            ]
        });
        assert_eq!(same, [asked; 6]);
    }
}
