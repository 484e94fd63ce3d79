//! Expressions as text: formulas, and functions in several languages. The same expressions give the same text.

mod block;
mod c;
mod code;
mod latex;
mod layout;
mod python;
mod shared;
mod table;

pub use code::Language;
pub use latex::{Left, Line, latex};

use super::graph::Graph;
use super::node::Id;

/// Arguments that belong together: a vector, or one number.
#[derive(Clone, Debug)]
pub struct Group {
    /// The name of the argument.
    pub name: String,
    /// Its symbols in their order.
    pub symbols: Vec<Id>,
    /// Whether it is one number rather than a vector of one.
    pub scalar: bool,
}

/// A result: a vector, or a matrix by rows.
#[derive(Clone, Debug)]
pub struct Output {
    /// The name of the result.
    pub name: String,
    /// Its entries.
    pub entries: Vec<Id>,
    /// How many columns it has; none for a vector.
    pub columns: Option<usize>,
}

/// A function to print.
#[derive(Debug)]
pub struct Function<'a> {
    /// Where the expressions stand.
    pub graph: &'a Graph,
    /// Its name, an identifier.
    pub name: &'a str,
    /// What it computes, of what, in which order, frames and units; line by line.
    pub comment: &'a [String],
    /// Its arguments.
    pub groups: &'a [Group],
    /// Its results.
    pub outputs: &'a [Output],
}

impl Function<'_> {
    /// The function in a language.
    pub fn print(&self, language: Language) -> String {
        match language {
            Language::C => c::function(self),
            _ => python::function(self, language),
        }
    }

    /// The function in C over many columns at once, to be compiled and loaded.
    pub fn print_block(&self) -> String {
        block::function(self)
    }

    fn entries(&self) -> Vec<Id> {
        self.outputs.iter().flat_map(|o| o.entries.iter().copied()).collect()
    }
}
