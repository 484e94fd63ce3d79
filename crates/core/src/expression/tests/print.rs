//! Text of expressions.

use super::recipe::{Kind, Recipe};
use super::*;
use crate::expression::{Function, Group, Language, Left, Line, Output, Shortest, latex};
use crate::scalar::tests::Random;
use crate::scalar::{Interpolation, Real, Table};

const LANGUAGES: [Language; 5] =
    [Language::C, Language::NumPy, Language::Jax, Language::CasAdi, Language::SymPy];

fn printed(graph: &Graph, given: &[Expression], outputs: &[Id], language: Language) -> String {
    let comment = ["Laws".to_owned(), String::new(), format!("  {}", "a [kg m^2], ".repeat(20))];
    let groups = [Group { name: "given".to_owned(), symbols: ids(given), scalar: false }];
    let outputs = [Output { name: "out".to_owned(), entries: outputs.to_vec(), columns: None }];
    Function { graph, name: "f", comment: &comment, groups: &groups, outputs: &outputs }.print(language)
}

/// How one expression is written in C, and in LaTeX.
fn written(make: impl FnOnce([Expression; 4]) -> Expression) -> (String, String) {
    let mut graph = Graph::new(Simplify::Safely);
    let names = [("v", r"\dot{x}"), ("a", r"\ddot{x}"), ("m", "m"), ("k", "k")];
    let given = names.map(|(n, l)| Expression(graph.symbol(n, l)));
    let id = graph.enter(|| make(given)).0;
    let code = printed(&graph, &given, &[id], Language::C);
    let line = code.lines().find_map(|l| l.trim().strip_prefix("out_[0] = ")).unwrap().trim_end_matches(';');
    let formula = latex(&graph, &[Line { left: Left::Name("y".to_owned()), right: id }], false);
    let formula = formula.lines().nth(1).unwrap().strip_prefix("y &= ").unwrap();
    (line.to_owned(), formula.to_owned())
}

#[test]
fn as_people_write() {
    let lit = Expression::lit;
    for (made, code, formula) in [
        (written(|[_, a, m, _]| a * m), "a*m", r"m \ddot{x}"),
        (written(|[v, ..]| v * v), "v*v", r"\dot{x}^2"),
        (written(|[v, ..]| v.pow(lit(3.0))), "v*v*v", r"\dot{x}^3"),
        (written(|[v, ..]| v * lit(-0.5)), "-0.5*v", r"-\tfrac{1}{2} \dot{x}"),
        (written(|[v, a, ..]| lit(-2.0) * v + a), "a - 2.0*v", r"\ddot{x} - 2 \dot{x}"),
        (written(|[v, a, ..]| a - lit(-2.0) * v), "a + 2.0*v", r"\ddot{x} + 2 \dot{x}"),
        (written(|[v, a, ..]| -(v * a)), "-v*a", r"-\dot{x} \ddot{x}"),
        (written(|[v, a, m, k]| m - (v + a) - k), "m - (v + a) - k", r"m - \dot{x} - \ddot{x} - k"),
        (written(|[v, _, m, k]| (v + m) * k), "k*(v + m)", r"k \left(\dot{x} + m\right)"),
        (written(|[v, _, m, k]| (m + k) * v), "v*(m + k)", r"\left(m + k\right) \dot{x}"),
        (written(|[v, _, m, _]| lit(0.5) * v / m), "0.5*v/m", r"\frac{\dot{x}}{2 m}"),
        (written(|[v, _, m, k]| v / (m / k)), "v/(m/k)", r"\frac{k \dot{x}}{m}"),
        (written(|[_, _, m, k]| (m * k).sin_cos().1), "cos(m*k)", r"\cos\left(m k\right)"),
        (written(|[.., k]| k.sin_cos().0 * k.sin_cos().0), "t0*t0", r"\sin^2 k"),
        (written(|[.., m, k]| m.min(k)), "(m <= k ? m : k)", r"\min\left(m, k\right)"),
        (written(|[.., m, k]| m.max(k)), "(m <= k ? k : m)", r"\max\left(m, k\right)"),
    ] {
        assert_eq!(made, (code.to_owned(), formula.to_owned()));
    }
}

#[test]
fn the_same_expressions_give_the_same_text() {
    let build = || {
        let mut random = Random(11);
        let recipe = Recipe::new(&mut random, Kind::Any, 3, 60);
        let (mut graph, given) = with_symbols(Simplify::Algebraically, ["a", "b", "c"]);
        let all = graph.enter(|| ids(&recipe.run(&given)));
        graph.settle(&all, Shortest::Shared);
        let mut text: Vec<String> = LANGUAGES.map(|l| printed(&graph, &given, &all, l)).to_vec();
        let lines: Vec<Line> =
            all.iter().map(|id| Line { left: Left::Name("y".to_owned()), right: *id }).collect();
        text.push(latex(&graph, &lines, true));
        text
    };
    assert_eq!(build(), build());
}

#[test]
fn lines_are_short_and_signs_do_not_meet() {
    let mut random = Random(12);
    for _ in 0..20 {
        let recipe = Recipe::new(&mut random, Kind::Any, 3, 80);
        let (mut graph, given) = with_symbols(Simplify::Safely, ["a", "b", "c"]);
        let last = graph.enter(|| ids(&recipe.run(&given)))[79];
        for language in LANGUAGES {
            let text = printed(&graph, &given, &[last], language);
            for line in text.lines() {
                assert!(line.len() <= 100 || !line.trim().contains(' '), "{line}");
                assert!(!["--", "- -", "+ -", "*-", "/-"].iter().any(|s| line.contains(s)), "{line}");
                assert_eq!(line, line.trim_end());
            }
        }
    }
}

#[test]
fn only_the_tables_that_are_used_are_defined() {
    let (mut graph, [x]) = with_symbols(Simplify::Safely, ["x"]);
    let tables = [1.0, 2.0].map(|y| Table::new(&[0.0, 1.0], &[0.0, y], Interpolation::Linear).unwrap());
    let both = graph.enter(|| ids(&[x.lookup(&tables[0]), x.lookup(&tables[1])]));
    for language in LANGUAGES {
        let text = printed(&graph, &[x], &both[1..], language);
        assert!(text.contains("f_table_1(x)") && !text.contains("f_table_0"), "{text}");
    }
}
