//! Machine code computes what the tape says, bit for bit.

use super::recipe::{Kind, Recipe};
use super::*;
use crate::expression::{Piece, Values};
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::tests::{Random, same};
use crate::scalar::{Grid, Interpolation, Lane, Real, Table};

/// Numbers of all kinds.
fn number(random: &mut Random) -> f64 {
    const SPECIAL: [f64; 8] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 0.0, 1e308, -5e-324, 1.0];
    let chosen = random.bits() as usize % 40;
    SPECIAL.get(chosen).copied().unwrap_or_else(|| random.between(-2.0, 2.0))
}

/// Compares over lanes of `L` where the given numbers come in two pieces.
fn compare<L: Lane>(random: &mut Random, program: &Program, split: usize) {
    L::call(|| {
        let n = program.given_count();
        let mut numbers =
            |n: usize| -> Vec<L> { (0..n).map(|_| L::from_lanes(|_| number(random))).collect() };
        let (given, parameters) = (numbers(n), numbers(program.parameter_count()));
        let prepared = program.prepare(&parameters);
        let mut expected = vec![L::zero(); program.output_count()];
        program.run(&prepared, &given, &mut expected);
        let lengths = [split, n - split];
        assert!(program.is_native::<L, 2>(lengths), "there is machine code");
        let pieces: [&[L]; 2] = given.split_at(split).into();
        let mut values = Values::empty();
        program.run_in(&mut values, pieces.map(Piece::of), || lengths, &prepared);
        assert_eq!(values.results().len(), expected.len());
        for (a, b) in values.results().iter().zip(&expected) {
            for l in 0..L::N {
                assert!(same(a.get(l), b.get(l)), "{a:?} {b:?}");
            }
        }
    });
}

/// Over all registers of this machine that machine code works on.
fn compare_all(random: &mut Random, program: &Program, split: usize) {
    for isa in Isa::available().into_iter().filter(|isa| *isa != Isa::Baseline) {
        with_lanes!(isa, L => {
            compare::<L>(random, program, split);
            compare::<<L as Lane>::Single>(random, program, split);
        });
    }
}

#[test]
fn of_random_programs() {
    let mut random = Random(31);
    // Up to hundreds of values, more than there are registers, and more than the stack holds.
    for round in 0..300 {
        let kind = [Kind::Rational, Kind::Smooth, Kind::Any][round % 3];
        let recipe = Recipe::new(&mut random, kind, 6, 10 + round);
        let (mut graph, given) = with_symbols(Simplify::Safely, ["a", "b", "c", "p", "q", "r"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        let (given, parameters) = given.split_at(3);
        let outputs: Vec<Id> = all.iter().rev().step_by(1 + round % 7).copied().collect();
        let program = Program::new(&graph, &ids(parameters), &ids(given), &outputs).unwrap();
        compare_all(&mut random, &program, round % 4);
    }
}

#[test]
fn of_each_operation_on_numbers_of_all_kinds() {
    let mut random = Random(32);
    let (mut graph, [a, b, c, p]) = with_symbols(Simplify::Safely, ["a", "b", "c", "p"]);
    let outputs = graph.enter(|| {
        let choose = |a, b| Expression::select_le(a, b, c, p);
        ids(&[
            -a,
            a.abs(),
            (b * c).abs(),
            a.sqrt(),
            a / b,
            p / a,
            a / p,
            a - p,
            p - a,
            a * b + c,
            a * a - c,
            c - a * b,
            p - a * c,
            a * b + b * c,
            a * p - b * b,
            a * b * c,
            a + b + p,
            choose(a, b),
            choose(p, a),
            choose(a * b, a + b),
            Expression::select_le(a, a, -a, a),
            Expression::select_le(c, p, a * b, b),
        ])
    });
    let program = Program::new(&graph, &[p.0], &ids(&[a, b, c]), &outputs).unwrap();
    for _ in 0..400 {
        compare_all(&mut random, &program, 2);
    }
}

#[test]
fn of_more_values_at_a_time_than_registers() {
    let mut random = Random(33);
    let (mut graph, [a, b]) = with_symbols(Simplify::Safely, ["a", "b"]);
    let outputs = graph.enter(|| {
        let terms: Vec<Expression> = (0..60).map(|k| a * b + Expression::lit(f64::from(k))).collect();
        let roots: Vec<Expression> = terms.iter().map(|x| x.abs().sqrt()).collect();
        // Each term is needed again after all of them, in the same and in the other order.
        let forth = roots.iter().zip(&terms).fold(a, |s, (x, y)| s * b + *x * *y);
        let back = roots.iter().rev().fold(forth, |s, x| Expression::select_le(s, *x, s - *x, *x * *x - s));
        let [s, t] = [forth, back].map(|x| x.sin_cos().0);
        let again = terms.iter().fold(s, |s, x| *x - s * t);
        ids(&[forth, back, again, terms[7], roots[3]])
    });
    for split in 0..3 {
        let program = Program::new(&graph, &[], &ids(&[a, b]), &outputs).unwrap();
        assert!(program.instruction_count() > 160, "more than the stack holds");
        compare_all(&mut random, &program, split);
    }
}

#[test]
fn with_results_of_every_origin() {
    let mut random = Random(34);
    let (mut graph, [a, b, p]) = with_symbols(Simplify::Safely, ["a", "b", "p"]);
    let table = Table::new(&[-1.0, 0.0, 1.5, 4.0], &[1.0, 3.0, -2.0, 0.5], Interpolation::Linear).unwrap();
    let grid = Grid::new(&[0.0, 1.0], &[0.0, 2.0], &[1.0, 2.0, 4.0, -3.0], Interpolation::Linear).unwrap();
    let outputs = graph.enter(|| {
        let sum = a * b + p;
        let (s, c) = sum.sin_cos();
        let found = (s * b).lookup(&table) + s.lookup_2(p, &grid);
        let power = (a.abs() + Expression::one()).pow(p);
        let seven = Expression::lit(7.0);
        // Sines of sines and of what is given; the same result twice.
        let deep = (s.sin_cos().0 + b.sin_cos().1).sin_cos().0;
        ids(&[a, p, seven, sum, s, c, found, power, sum, a, seven, deep * sum - power, found, deep])
    });
    for split in 0..3 {
        let program = Program::new(&graph, &[p.0], &ids(&[a, b]), &outputs).unwrap();
        compare_all(&mut random, &program, split);
    }
}

#[test]
fn of_nothing() {
    let mut random = Random(35);
    let (graph, [a]) = with_symbols(Simplify::Safely, ["a"]);
    for outputs in [&[][..], &[a.0]] {
        let program = Program::new(&graph, &[], &[a.0], outputs).unwrap();
        compare_all(&mut random, &program, 1);
    }
}

#[test]
fn one_room_serves_long_and_short_programs() {
    let mut values = Values::empty();
    for length in [3, 300, 3, 200, 400, 3] {
        let (mut graph, [a]) = with_symbols(Simplify::Safely, ["a"]);
        let outputs = graph.enter(|| {
            let powers = (0..length).scan(a, |x, _| {
                *x = *x * a;
                Some(*x)
            });
            ids(&powers.collect::<Vec<_>>())
        });
        let program = Program::new(&graph, &[], &[a.0], &outputs).unwrap();
        program.run_in(&mut values, [Piece::of(&[-1.0])], || [1], &[]);
        let expected: Vec<f64> = (0..length).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert_eq!(values.results(), expected);
    }
}

#[test]
fn a_copy_of_a_program_is_the_same() {
    let mut random = Random(36);
    let (mut graph, [a]) = with_symbols(Simplify::Safely, ["a"]);
    let outputs = graph.enter(|| ids(&[a * a]));
    let program = Program::new(&graph, &[], &[a.0], &outputs).unwrap();
    let copy = program.clone();
    compare_all(&mut random, &program, 0);
    assert_eq!(program, copy);
    compare_all(&mut random, &program.clone(), 0);
}
