//! Which nodes stand for an expression changes neither its value nor what it is made of.

use super::recipe::{Kind, Recipe, point, scale};
use super::*;
use crate::expression::Shortest;
use crate::scalar::Real;
use crate::scalar::tests::Random;

/// Panics if an expression is made of itself.
fn assert_no_cycle(graph: &Graph, all: &[Id]) {
    let mut state = std::collections::HashMap::new();
    let mut stack: Vec<(Id, bool)> = all.iter().map(|id| (*id, false)).collect();
    while let Some((id, done)) = stack.pop() {
        if done {
            state.insert(id, true);
            continue;
        }
        match state.get(&id) {
            Some(true) => continue,
            Some(false) => panic!("expression {id} is made of itself"),
            None => {}
        }
        state.insert(id, false);
        stack.push((id, true));
        let new = graph.node(id).operands().to_vec();
        stack.extend(new.into_iter().filter(|o| state.get(o) != Some(&true)).map(|o| (o, false)));
    }
}

#[test]
fn values_stay() {
    let mut random = Random(10);
    for _ in 0..80 {
        let (mut graph, given) = with_symbols(Simplify::Algebraically, ["a", "b", "c"]);
        let at = point(&mut random, 3);
        let mut all: Vec<Id> = Vec::new();
        // Expressions are made between the choices too, of what the choices left.
        for shortest in [Shortest::Shared, Shortest::WrittenOut, Shortest::Shared, Shortest::WrittenOut] {
            let recipe = Recipe::new(&mut random, Kind::Rational, 3, 12);
            all.extend(graph.enter(|| ids(&recipe.run(&given))));
            let before = values(&graph, &given, &all, &at);
            let size = scale(&before);
            graph.settle(&all, shortest);
            assert_no_cycle(&graph, &(0..graph.nodes.len() as Id).collect::<Vec<_>>());
            for (x, y) in values(&graph, &given, &all, &at).iter().zip(&before) {
                // Other orders of a dozen sums and products.
                assert!((x - y).abs() <= 1e-11 * size * size, "{x} {y}");
            }
        }
    }
}

#[test]
fn each_choice_is_short_in_its_own_sense() {
    let (mut graph, [a, b, c, d]) = with_symbols(Simplify::Algebraically, ["a", "b", "c", "d"]);
    let sum = graph.enter(|| (a * b + a * c + a * d).0);
    graph.settle(&[sum], Shortest::WrittenOut);
    assert_eq!(graph.operation_count(&[sum]).written_out, 3.0, "a (b + c + d)");
    // b + c is there already.
    let two = graph.enter(|| ids(&[a * b + a * c, b + c]));
    graph.settle(&two, Shortest::Shared);
    assert_eq!(graph.operation_count(&two).shared, 2);
}

#[test]
fn operations_are_counted() {
    let (mut graph, [a, b]) = with_symbols(Simplify::Safely, ["a", "b"]);
    let outputs = graph.enter(|| {
        let sum = a + b;
        ids(&[sum * sum, -(sum * sum), a, Expression::lit(-2.0), a * Expression::lit(-2.0)])
    });
    let count = graph.operation_count(&outputs);
    // 3 and 4, and a product with its sign; symbols and numbers take none.
    assert_eq!((count.written_out, count.shared), (3.0 + 4.0 + 2.0, 5));
}
