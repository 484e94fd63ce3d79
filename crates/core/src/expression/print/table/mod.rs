//! The tables that expressions look into: their data and the functions that read them, in each language.

mod lattice;
mod pieces;

use super::code::Language;
use crate::expression::graph::Graph;
use crate::expression::node::{Id, Operation};
use lattice::Samples;
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

/// The name of the function of a lattice.
pub fn lattice_name(function: &str, lattice: u32) -> String {
    format!("{function}_lattice_{lattice}")
}

/// The name of the function that goes between the samples along one variable of a lattice.
pub fn between_name(function: &str) -> String {
    format!("{function}_between")
}

/// The name of the function that finds a piece.
pub fn piece_name(function: &str) -> String {
    format!("{function}_piece")
}

/// The definitions of all tables, grids and lattices that `outputs` look into; empty if there are none.
pub fn definitions(graph: &Graph, function: &str, language: Language, outputs: &[Id]) -> String {
    let used: BTreeSet<Operation> = graph.order(outputs).iter().map(|id| graph.node(*id).operation).collect();
    let in_pieces = |pieces: Pieces| match language {
        Language::C => pieces.c(function),
        Language::NumPy | Language::Jax => pieces.arrays(language),
        Language::CasAdi | Language::SymPy => pieces.symbolic(function),
    };
    let on_lattice = |samples: Samples<'_>| match language {
        Language::C => samples.c(function),
        Language::NumPy | Language::Jax => samples.arrays(language, function),
        Language::CasAdi | Language::SymPy => samples.symbolic(function),
    };
    let mut any_lattice = false;
    let bodies: Vec<String> = used
        .into_iter()
        .filter_map(|operation| match operation {
            Operation::Lookup(n) => Some(in_pieces(Pieces::of_table(graph, function, n))),
            Operation::Lookup2(n) => Some(in_pieces(Pieces::of_grid(graph, function, n))),
            Operation::Lookup3(n) | Operation::Lookup4(n) => {
                any_lattice = true;
                Some(on_lattice(Samples::of_lattice(graph, function, n)))
            }
            _ => None,
        })
        .collect();
    if bodies.is_empty() {
        return String::new();
    }
    let searches: &[&str] = match language {
        Language::C => &[SEARCH_C],
        Language::CasAdi if any_lattice => &[SEARCH_CASADI, BETWEEN_SYMBOLIC],
        Language::CasAdi => &[SEARCH_CASADI],
        Language::SymPy if any_lattice => &[SEARCH_SYMPY, BETWEEN_SYMBOLIC],
        Language::SymPy => &[SEARCH_SYMPY],
        Language::NumPy | Language::Jax if any_lattice => &[BETWEEN_ARRAYS],
        Language::NumPy | Language::Jax => &[],
    };
    let named = |text: &str| {
        let text = text.replace("NAME", &piece_name(function)).replace("BETWEEN", &between_name(function));
        if language == Language::Jax { text.replace("np.", "jnp.") } else { text }
    };
    let searches = searches.iter().map(|text| named(text));
    match language {
        Language::C => searches.chain(bodies).collect(),
        // Their data comes first.
        Language::NumPy | Language::Jax => {
            bodies.into_iter().chain(searches).collect::<Vec<_>>().join("\n\n")
        }
        Language::CasAdi | Language::SymPy => searches.chain(bodies).collect::<Vec<_>>().join("\n\n"),
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

const BETWEEN_SYMBOLIC: &str = r#"def BETWEEN(x, at, values, rule):
    """From the values at samples along one variable to that at x; constant outside."""

    def value(i):
        low, high = max(i - 1, 0), min(i, len(at) - 1)
        width = at[high] - at[low]
        if rule == "slope":
            return (values[high] - values[low])/width if width else 0.0
        if rule == "hold" or not width:
            return values[low]
        return values[low] + (x - at[low])/width*(values[high] - values[low])

    return NAME(x, at, value)
"#;

const BETWEEN_ARRAYS: &str = r#"def BETWEEN(at, x):
    """The samples around x, the share of the way that x has gone, and the share per unit; none outside."""
    at = np.asarray(at)
    after = np.searchsorted(at, x, side="right")
    low, high = np.maximum(after - 1, 0), np.minimum(after, len(at) - 1)
    inside = low < high
    width = np.where(inside, at[high] - at[low], 1.0)
    return low, high, np.where(inside, (x - at[low])/width, 0.0), np.where(inside, 1.0/width, 0.0)
"#;
