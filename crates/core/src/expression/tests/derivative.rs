//! Derivatives are exact.

use super::recipe::{Kind, Recipe, point, scale};
use super::*;
use crate::scalar::tests::Random;
use crate::scalar::{Dual, Elementary, Real};

#[test]
fn by_hand() {
    for simplify in [Simplify::Safely, Simplify::Algebraically] {
        let (mut graph, [x, y]) = with_symbols(simplify, ["x", "y"]);
        let (f, expected) = graph.enter(|| {
            let (s, c) = (x * y).sin_cos();
            let e = (x * y).elementary(Elementary::Exp);
            let root = (x * x + y * y).sqrt();
            let two = Expression::lit(2.0);
            let f = [s, e, root, x / y, x * x * x, x.abs()];
            let sign = Expression::select_le(Expression::zero(), x, Expression::one(), -Expression::one());
            let expected = [
                [c * y, c * x],
                [e * y, e * x],
                [x / root, y / root],
                [Expression::one() / y, -(x / (y * y))],
                [two * x * x + x * x, Expression::zero()],
                [sign, Expression::zero()],
            ];
            (ids(&f), ids(expected.as_flattened()))
        });
        let made = graph.jacobian(&f, &ids(&[x, y])).unwrap();
        let mut random = Random(5);
        for _ in 0..20 {
            let at = point(&mut random, 2);
            let (made, expected) =
                (values(&graph, &[x, y], &made, &at), values(&graph, &[x, y], &expected, &at));
            for (a, b) in made.iter().zip(&expected) {
                // A few roundings.
                assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{a} {b}");
            }
        }
    }
}

#[test]
fn of_random_expressions() {
    let mut random = Random(6);
    for round in 0..100 {
        let simplify = if round % 2 == 0 { Simplify::Safely } else { Simplify::Algebraically };
        let recipe = Recipe::new(&mut random, Kind::Smooth, 2, 14);
        let (mut graph, given) = with_symbols(simplify, ["x", "y"]);
        let last = graph.enter(|| recipe.run(&given)[13].0);
        let made = graph.jacobian(&[last], &ids(&given)).unwrap();
        let at = point(&mut random, 2);
        let slopes = values(&graph, &given, &made, &at);
        let duals: Vec<Dual<f64, 2>> =
            recipe.run(&[Dual { value: at[0], slope: [1.0, 0.0] }, Dual { value: at[1], slope: [0.0, 1.0] }]);
        let size = duals.iter().fold(1.0, |m: f64, d| m.max(scale(&d.slope)).max(d.value.abs()));
        for (i, slope) in slopes.iter().enumerate() {
            // Roundings of values up to `size`, in another order.
            assert!((slope - duals[13].slope[i]).abs() <= 1e-11 * size * size, "{slope} {:?}", duals[13]);
            let h = 1e-5;
            let moved = |by: f64| {
                let mut at = at.clone();
                at[i] += by;
                recipe.run(&at)[13]
            };
            let difference = (moved(h) - moved(-h)) / (2.0 * h);
            // h² times third derivatives, and roundings divided by h.
            if size < 10.0 {
                assert!((slope - difference).abs() < 1e-4, "{slope} {difference}");
            }
        }
    }
}
