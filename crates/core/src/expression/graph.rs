//! The graph of all expressions: each exists once.

use super::fingerprint::{self, Fingerprint};
use super::node::{Id, Node, Operation};
use crate::scalar::{Grid, Lattice, Table};
use std::collections::{BTreeMap, HashMap};

/// A symbol by its names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// In code: an identifier.
    pub name: String,
    /// In formulas.
    pub latex: String,
}

/// How far expressions are simplified as they are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Simplify {
    /// Only where every finite double stays the same, zeros of both signs being one: constants, neutral and
    /// absorbing elements, signs; small whole powers are products.
    Safely,
    /// Wherever two expressions are equal: sums in any order, sin² + cos² = 1, whatever cancels.
    Algebraically,
}

/// How many ways to write an expression are kept.
const WAYS: usize = 24;

/// Expressions with everything that they are made of.
#[derive(Clone, Debug)]
pub struct Graph {
    pub(super) simplify: Simplify,
    /// Whether sine and cosine of a sum are written in those of its terms.
    pub expand_angles: bool,
    pub(super) nodes: Vec<Node>,
    by_node: HashMap<Node, Id>,
    fingerprints: Vec<Fingerprint>,
    by_fingerprint: HashMap<Fingerprint, Id>,
    /// How many operations each node is made of, without sharing.
    pub(super) costs: Vec<f64>,
    /// All nodes of the expressions that can be written in several ways; the first stands where it came first.
    pub(super) others: BTreeMap<Id, Vec<Node>>,
    /// How deep the search for other ways to write sums is.
    pub(super) depth: u8,
    pub(super) symbols: Vec<Symbol>,
    pub(super) tables: Vec<Table>,
    pub(super) grids: Vec<Grid>,
    pub(super) lattices: Vec<Lattice>,
}

impl Graph {
    /// An empty graph.
    pub fn new(simplify: Simplify) -> Self {
        let mut graph = Self {
            simplify,
            expand_angles: false,
            nodes: Vec::new(),
            by_node: HashMap::new(),
            fingerprints: Vec::new(),
            by_fingerprint: HashMap::new(),
            costs: Vec::new(),
            others: BTreeMap::new(),
            depth: 0,
            symbols: Vec::new(),
            tables: Vec::new(),
            grids: Vec::new(),
            lattices: Vec::new(),
        };
        if simplify == Simplify::Algebraically {
            // So that what is equal to one of them becomes it.
            for x in [0.0, 1.0, 2.0, 0.5, 3.0, 4.0, 0.25] {
                graph.constant(x);
            }
        }
        graph
    }

    /// A constant.
    pub fn constant(&mut self, x: f64) -> Id {
        if x < 0.0 || x == 0.0 && x.is_sign_negative() {
            let size = self.constant(-x);
            if x == 0.0 {
                return size;
            }
            return self.intern(Node::new(Operation::Neg, &[size]));
        }
        self.intern(Node::new(Operation::Constant(x.to_bits()), &[]))
    }

    /// A new symbol; its name must be new to this graph.
    pub fn symbol(&mut self, name: &str, latex: &str) -> Id {
        debug_assert!(self.symbols.iter().all(|s| s.name != name), "{name} is taken");
        let number = self.symbols.len() as u32;
        self.symbols.push(Symbol { name: name.to_owned(), latex: latex.to_owned() });
        self.intern(Node::new(Operation::Symbol(number), &[]))
    }

    /// The number of a table that expressions look into.
    pub fn table(&mut self, table: &Table) -> u32 {
        number(&mut self.tables, table)
    }

    /// The number of a grid that expressions look into.
    pub fn grid(&mut self, grid: &Grid) -> u32 {
        number(&mut self.grids, grid)
    }

    /// A lattice at expressions, as many as it has axes.
    pub fn look_up(&mut self, lattice: &Lattice, at: &[Id]) -> Id {
        let number = number(&mut self.lattices, lattice);
        let lookup = if at.len() == 3 { Operation::Lookup3 } else { Operation::Lookup4 };
        self.apply(lookup(number), at)
    }

    /// Whether there is a node of this number.
    pub fn contains(&self, id: Id) -> bool {
        (id as usize) < self.nodes.len()
    }

    /// The node of an expression.
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id as usize]
    }

    /// The symbol that an expression is.
    pub fn symbol_of(&self, id: Id) -> Option<&Symbol> {
        match self.node(id).operation {
            Operation::Symbol(n) => self.symbols.get(n as usize),
            _ => None,
        }
    }

    /// All symbols in the order in which they were made.
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// The value of an expression that is a constant.
    pub fn number(&self, id: Id) -> Option<f64> {
        let node = self.node(id);
        match node.operation {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            // A negative constant is the negative of one.
            Operation::Neg => match self.node(node.operands[0]).operation {
                Operation::Constant(bits) => Some(-f64::from_bits(bits)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The one expression that is this node.
    pub(super) fn intern(&mut self, node: Node) -> Id {
        match self.simplify {
            Simplify::Safely => self.by_node.get(&node).copied().unwrap_or_else(|| {
                let id = self.push(node);
                self.by_node.insert(node, id);
                id
            }),
            Simplify::Algebraically => self.intern_value(node),
        }
    }

    /// Of expressions with one value the cheapest is kept.
    fn intern_value(&mut self, node: Node) -> Id {
        let mut known = [[0; 2]; 4];
        for (k, id) in known.iter_mut().zip(node.operands()) {
            *k = self.fingerprints[*id as usize];
        }
        let value = fingerprint::of(node.operation, &known[..node.operation.arity()]);
        if let Some(id) = self.by_fingerprint.get(&value).copied() {
            let first = self.nodes[id as usize];
            if node != first && !matches!(first.operation, Operation::Constant(_) | Operation::Symbol(_)) {
                let known = self.others.entry(id).or_insert_with(|| vec![first]);
                if known.len() < WAYS && !known.contains(&node) {
                    known.push(node);
                }
            }
            let cost = self.cost(node);
            // What is strictly shorter cannot contain what it replaces.
            if cost < self.costs[id as usize] {
                self.nodes[id as usize] = node;
                self.costs[id as usize] = cost;
            }
            return id;
        }
        if node.operation != Operation::Neg
            && let Some(id) = self.by_fingerprint.get(&fingerprint::negative(value)).copied()
        {
            return self.intern_value(Node::new(Operation::Neg, &[id]));
        }
        let id = self.push(node);
        self.fingerprints.push(value);
        self.by_fingerprint.insert(value, id);
        id
    }

    fn push(&mut self, node: Node) -> Id {
        let cost = self.cost(node);
        self.nodes.push(node);
        self.costs.push(cost);
        (self.nodes.len() - 1) as Id
    }

    /// How many operations a node is made of, without sharing. A negative constant is one number.
    pub(super) fn cost(&self, node: Node) -> f64 {
        match node.operation {
            Operation::Constant(_) | Operation::Symbol(_) => 0.0,
            Operation::Neg if self.number(node.operands[0]).is_some() => 0.0,
            _ => 1.0 + node.operands().iter().map(|id| self.costs[*id as usize]).sum::<f64>(),
        }
    }
}

/// The place of what is equal to `wanted`, put behind the others where it is new.
fn number<T: Clone + PartialEq>(known: &mut Vec<T>, wanted: &T) -> u32 {
    let place = known.iter().position(|k| k == wanted);
    place.unwrap_or_else(|| {
        known.push(wanted.clone());
        known.len() - 1
    }) as u32
}
