//! The tables that expressions look into: their data and the functions that read them, in each language.

mod pieces;

use super::code::Language;
use crate::expression::graph::Graph;
use crate::expression::node::{Id, Operation};
use pieces::Pieces;
use std::collections::BTreeSet;

/// The name of the function of a table.
pub fn name(function: &str, table: u32) -> String {
    format!("{function}_table_{table}")
}

/// The name of the function of a grid.
pub fn grid_name(function: &str, grid: u32) -> String {
    format!("{function}_grid_{grid}")
}

/// The name of the function that finds a piece.
pub fn piece_name(function: &str) -> String {
    format!("{function}_piece")
}

/// The definitions of all tables and grids that `outputs` look into; empty if there are none.
pub fn definitions(graph: &Graph, function: &str, language: Language, outputs: &[Id]) -> String {
    let used: BTreeSet<Operation> = graph.order(outputs).iter().map(|id| graph.node(*id).operation).collect();
    let bodies: Vec<Pieces> = used
        .into_iter()
        .filter_map(|operation| match operation {
            Operation::Lookup(n) => Some(Pieces::of_table(graph, function, n)),
            Operation::Lookup2(n) => Some(Pieces::of_grid(graph, function, n)),
            _ => None,
        })
        .collect();
    if bodies.is_empty() {
        return String::new();
    }
    let mut parts = Vec::new();
    match language {
        Language::C => parts.push(SEARCH_C.replace("NAME", &piece_name(function))),
        Language::CasAdi => parts.push(SEARCH_CASADI.replace("NAME", &piece_name(function))),
        Language::SymPy => parts.push(SEARCH_SYMPY.replace("NAME", &piece_name(function))),
        Language::NumPy | Language::Jax => {}
    }
    parts.extend(bodies.iter().map(|pieces| match language {
        Language::C => pieces.c(function),
        Language::NumPy | Language::Jax => pieces.arrays(language),
        Language::CasAdi | Language::SymPy => pieces.symbolic(function),
    }));
    match language {
        Language::C => parts.concat(),
        _ => parts.join("\n\n"),
    }
}

const SEARCH_C: &str = "
/* How many of the rising numbers are at most x. */
static int NAME(const double *start, int count, double x)
{
    int low = 0, high = count;
    while (low < high) {
        const int middle = low + (high - low)/2;
        if (start[middle] <= x) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}
";

const SEARCH_CASADI: &str = r#"def NAME(x, start, value):
    """value(i), where i is how many of the rising numbers are at most x."""

    def between(low, high):
        if low == high:
            return value(low)
        middle = (low + high + 1)//2
        return ca.if_else(x < start[middle - 1], between(low, middle - 1), between(middle, high))

    return between(0, len(start))
"#;

const SEARCH_SYMPY: &str = r#"def NAME(x, start, value):
    """value(i), where i is how many of the rising numbers are at most x."""
    pieces = [(value(i), x < s) for i, s in enumerate(start)]
    return sp.Piecewise(*pieces, (value(len(start)), True))
"#;
