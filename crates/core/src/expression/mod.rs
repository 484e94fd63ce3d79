//! Expressions: the fourth scalar, and the tape that runs them over the other three.

mod choose;
mod collect;
mod derivative;
mod execute;
mod fingerprint;
mod fold;
mod graph;
#[cfg(target_arch = "x86_64")]
mod native;
mod node;
mod order;
mod print;
mod program;
mod registers;
mod scalar;
mod schedule;
mod tape;
#[cfg(test)]
mod tests;

pub use choose::Shortest;
pub use graph::{Graph, Simplify, Symbol};
pub use node::{Id, Node, Operation};
pub use order::OperationCount;
pub use print::{Function, Group, Language, Left, Line, Output, latex};
pub use program::{Program, ProgramError};
pub use registers::{Piece, Row, Values};
pub use scalar::Expression;
