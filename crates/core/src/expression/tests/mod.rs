//! Laws of expressions and of the programs that compute them.

mod algebra;
mod choice;
mod derivative;
mod enter;
mod fingerprint;
mod folding;
mod forms;
#[cfg(target_arch = "x86_64")]
mod native;
mod print;
mod program;
mod recipe;
mod tables;

use super::{Expression, Graph, Id, Program, Simplify};

/// An empty graph with symbols of these names.
fn with_symbols<const N: usize>(simplify: Simplify, names: [&str; N]) -> (Graph, [Expression; N]) {
    let mut graph = Graph::new(simplify);
    let symbols = names.map(|n| Expression(graph.symbol(n, n)));
    (graph, symbols)
}

fn ids(expressions: &[Expression]) -> Vec<Id> {
    expressions.iter().map(|e| e.0).collect()
}

/// The values of `outputs` where the symbols `given` have the values `at`.
fn values(graph: &Graph, given: &[Expression], outputs: &[Id], at: &[f64]) -> Vec<f64> {
    let program = Program::new(graph, &[], &ids(given), outputs).unwrap();
    let mut out = vec![0.0; outputs.len()];
    program.run(&program.prepare::<f64>(&[]), at, &mut out);
    out
}
