//! A program computes what the expressions say, over every scalar.

use super::recipe::{Kind, Recipe, point, scale};
use super::*;
use crate::expression::ProgramError;
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::tests::{Random, same};
use crate::scalar::{Dual, Lane, Real};

#[test]
fn over_numbers_it_is_the_direct_evaluation() {
    let mut random = Random(7);
    for _ in 0..200 {
        let recipe = Recipe::new(&mut random, Kind::Any, 3, 60);
        let (mut graph, given) = with_symbols(Simplify::Algebraically, ["a", "b", "c"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        let at = point(&mut random, 3);
        let direct = recipe.run(&at);
        let size = scale(&direct);
        if size < 10.0 && !near_a_choice(&recipe, &at) {
            for (x, y) in values(&graph, &given, &all, &at).iter().zip(&direct) {
                // Sums are taken in another order, up to sixty of them one on another.
                assert!((x - y).abs() <= 1e-9 * size, "{x} {y}");
            }
        }
    }
}

/// Whether a choice may fall otherwise after other rounding.
fn near_a_choice(recipe: &Recipe, at: &[f64]) -> bool {
    let moved: Vec<f64> = at.iter().map(|x| x * (1.0 + 1e-11) + 1e-12).collect();
    let (a, b) = (recipe.run(at), recipe.run(&moved));
    a.iter().zip(&b).any(|(a, b)| (a - b).abs() > 1e-6)
}

fn run_lanes<L: Lane>(program: &Program, rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut out = vec![Vec::new(); rows.len()];
    L::call(|| {
        let prepared = program.prepare::<L>(&[]);
        for start in (0..rows.len()).step_by(L::N) {
            let given: Vec<L> = (0..program.given_count())
                .map(|i| L::from_lanes(|l| rows[(start + l).min(rows.len() - 1)][i]))
                .collect();
            let mut results = vec![L::zero(); program.output_count()];
            program.run(&prepared, &given, &mut results);
            for l in 0..L::N.min(rows.len() - start) {
                out[start + l] = results.iter().map(|x| x.get(l)).collect();
            }
        }
    });
    out
}

#[test]
fn a_lane_is_the_number_that_runs_alone() {
    let mut random = Random(8);
    for _ in 0..40 {
        let recipe = Recipe::new(&mut random, Kind::Any, 3, 40);
        let (mut graph, given) = with_symbols(Simplify::Safely, ["a", "b", "c"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        let program = Program::new(&graph, &[], &ids(&given), &all).unwrap();
        let rows: Vec<Vec<f64>> = (0..19).map(|_| point(&mut random, 3)).collect();
        for isa in Isa::available() {
            let (lanes, single) = with_lanes!(isa, L => {
                (run_lanes::<L>(&program, &rows), run_lanes::<<L as Lane>::Single>(&program, &rows))
            });
            for (a, b) in lanes.as_flattened_rows().zip(single.as_flattened_rows()) {
                assert!(same(a, b), "{isa:?}: {a} {b}");
            }
        }
    }
}

trait Rows {
    fn as_flattened_rows(&self) -> impl Iterator<Item = f64>;
}
impl Rows for Vec<Vec<f64>> {
    fn as_flattened_rows(&self) -> impl Iterator<Item = f64> {
        self.iter().flatten().copied()
    }
}

#[test]
fn over_duals_it_has_the_slopes() {
    let mut random = Random(9);
    for _ in 0..100 {
        let recipe = Recipe::new(&mut random, Kind::Smooth, 2, 30);
        let (mut graph, given) = with_symbols(Simplify::Safely, ["a", "b"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        let program = Program::new(&graph, &[], &ids(&given), &all).unwrap();
        let at = point(&mut random, 2);
        let at = [Dual { value: at[0], slope: [1.0, 0.0] }, Dual { value: at[1], slope: [0.0, 1.0] }];
        let direct = recipe.run(&at);
        let mut out = vec![Dual::lit(0.0); all.len()];
        program.run(&program.prepare(&[]), &at, &mut out);
        for (a, b) in out.iter().zip(&direct) {
            let size = 1.0 + scale(&b.slope) + b.value.abs();
            // −(a b) has the slopes of (−a) b in another order of rounding.
            if size < 1e3 {
                assert!((a.value - b.value).abs() <= 1e-12 * size, "{a:?} {b:?}");
                assert!((a.slope[0] - b.slope[0]).abs() <= 1e-10 * size, "{a:?} {b:?}");
                assert!((a.slope[1] - b.slope[1]).abs() <= 1e-10 * size, "{a:?} {b:?}");
            }
        }
    }
}

#[test]
fn parameters_and_constants_are_prepared() {
    let (mut graph, [p, x]) = with_symbols(Simplify::Safely, ["p", "x"]);
    let outputs = graph.enter(|| {
        let root = (p * p + Expression::lit(3.0)).sqrt();
        ids(&[root * x, root, x, p, Expression::lit(7.0)])
    });
    let program = Program::new(&graph, &[p.0], &[x.0], &outputs).unwrap();
    assert_eq!((program.parameter_count(), program.given_count(), program.output_count()), (1, 1, 5));
    assert_eq!(program.instruction_count(), 1, "the root is prepared");
    let mut out = [0.0; 5];
    for p in [1.0, -1.0] {
        program.run(&program.prepare(&[p]), &[5.0], &mut out);
        assert_eq!(out, [10.0, 2.0, 5.0, p, 7.0]);
    }
}

#[test]
fn a_symbol_needs_a_value() {
    let (graph, [p, x]) = with_symbols(Simplify::Safely, ["p", "x"]);
    assert_eq!(Program::new(&graph, &[p.0], &[], &[p.0, x.0]), Err(ProgramError::NoValue("x".to_owned())));
}

/// x + √x + √√x + …
fn roots(length: usize) -> (Graph, Expression, Id) {
    let (mut graph, [x]) = with_symbols(Simplify::Safely, ["x"]);
    let sum = graph.enter(|| {
        let (mut sum, mut root) = (x, x);
        for _ in 0..length {
            root = (root + Expression::lit(0.25)).sqrt();
            sum = sum + root;
        }
        sum.0
    });
    (graph, x, sum)
}

#[test]
fn long_programs() {
    for length in [10, 79, 80, 81, 500] {
        let (graph, x, sum) = roots(length);
        let (mut expected, mut root) = (2.0_f64, 2.0_f64);
        for _ in 0..length {
            root = (root + 0.25).sqrt();
            expected += root;
        }
        // Three terms may be summed in one instruction, in their order.
        assert_eq!(values(&graph, &[x], &[sum], &[2.0]), [expected]);
    }
    let (graph, x, sum) = roots(40_000);
    assert_eq!(Program::new(&graph, &[], &[x.0], &[sum]), Err(ProgramError::TooLong));
}
