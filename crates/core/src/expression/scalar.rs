//! The fourth scalar: a node of the graph.

use super::graph::Graph;
use super::node::{Id, Operation};
use crate::scalar::{Block, Elementary, Grid, Lattice, MAX_AXES, Real, Table};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static CURRENT: RefCell<Option<Graph>> = const { RefCell::new(None) };
}

/// An expression of the graph that this thread works on.
///
/// The same generic functions that compute with numbers compute with these, inside [`Graph::enter`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Expression(pub Id);

/// Puts the graph back where it came from, also when the work panics.
struct Entered<'a> {
    home: &'a mut Graph,
    before: Option<Graph>,
}

impl Drop for Entered<'_> {
    fn drop(&mut self) {
        let graph = CURRENT.replace(self.before.take());
        if let Some(graph) = graph {
            *self.home = graph;
        }
    }
}

impl Graph {
    /// Runs `f` with [`Expression`]s of this graph.
    pub fn enter<R>(&mut self, f: impl FnOnce() -> R) -> R {
        let empty = Graph::new(self.simplify);
        let graph = std::mem::replace(self, empty);
        let before = CURRENT.replace(Some(graph));
        let _entered = Entered { home: self, before };
        f()
    }
}

fn on_graph<R>(f: impl FnOnce(&mut Graph) -> R) -> R {
    CURRENT.with_borrow_mut(|graph| f(graph.as_mut().expect("expressions are used inside Graph::enter")))
}

fn apply(operation: Operation, operands: &[Id]) -> Expression {
    Expression(on_graph(|g| g.apply(operation, operands)))
}

macro_rules! operator {
    ($trait:ident, $f:ident) => {
        impl $trait for Expression {
            type Output = Self;
            fn $f(self, other: Self) -> Self {
                apply(Operation::$trait, &[self.0, other.0])
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Expression {
    type Output = Self;
    fn neg(self) -> Self {
        apply(Operation::Neg, &[self.0])
    }
}

impl Real for Expression {
    fn lit(x: f64) -> Self {
        Self(on_graph(|g| g.constant(x)))
    }
    fn fma(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    fn sqrt(self) -> Self {
        apply(Operation::Sqrt, &[self.0])
    }
    fn abs(self) -> Self {
        apply(Operation::Abs, &[self.0])
    }
    fn sin_cos(self) -> (Self, Self) {
        (apply(Operation::Sin, &[self.0]), apply(Operation::Cos, &[self.0]))
    }
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
        apply(Operation::SelectLe, &[a.0, b.0, x.0, y.0])
    }
    fn lookup(self, table: &Table) -> Self {
        let number = on_graph(|g| g.table(table));
        apply(Operation::Lookup(number), &[self.0])
    }
    fn lookup_2(self, y: Self, grid: &Grid) -> Self {
        let number = on_graph(|g| g.grid(grid));
        apply(Operation::Lookup2(number), &[self.0, y.0])
    }
    fn lookup_n(at: &[Self], lattice: &Lattice) -> Self {
        let mut operands = [0; MAX_AXES];
        for (o, x) in operands.iter_mut().zip(at) {
            *o = x.0;
        }
        Self(on_graph(|g| g.look_up(lattice, &operands[..at.len()])))
    }
    fn elementary(self, f: Elementary) -> Self {
        apply(Operation::Elementary(f), &[self.0])
    }
    fn atan2(self, x: Self) -> Self {
        apply(Operation::Atan2, &[self.0, x.0])
    }
    fn pow(self, y: Self) -> Self {
        apply(Operation::Pow, &[self.0, y.0])
    }
    fn outside(_: &dyn Block, _: &[Self], _: &mut [Self]) -> bool {
        false
    }
    fn call<R>(f: impl FnOnce() -> R) -> R {
        f()
    }
}
