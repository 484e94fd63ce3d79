//! Which of the nodes that are one expression stands for it.

use super::graph::Graph;
use super::node::{Id, Node};

/// What a choice makes small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shortest {
    /// Equations that are written out.
    WrittenOut,
    /// Programs that compute what occurs several times once.
    Shared,
}

/// Rounds of improvement at most: a choice made late in one may let an early one be made better in the next. The
/// paper's forms need one.
const ROUNDS: usize = 4;

impl Graph {
    /// Lets the nodes stand for `outputs` and all that they are made of that make them short.
    pub fn settle(&mut self, outputs: &[Id], shortest: Shortest) {
        if self.others.is_empty() {
            return;
        }
        self.settle_first();
        self.settle_written_out();
        if shortest == Shortest::WrittenOut {
            return;
        }
        let mut best = (self.count(outputs), self.nodes.clone());
        self.improve(outputs);
        best = best.min_by_count((self.count(outputs), self.nodes.clone()));
        self.settle_first();
        self.improve(outputs);
        best = best.min_by_count((self.count(outputs), self.nodes.clone()));
        self.nodes = best.1;
        self.count_costs();
    }

    /// The costs of the nodes as they now stand: a cheaper node that comes later must not be made of what it
    /// replaces, and only true costs tell.
    fn count_costs(&mut self) {
        let all: Vec<Id> = (0..self.nodes.len() as Id).collect();
        for id in self.order(&all) {
            self.costs[id as usize] = self.cost(self.node(id));
        }
    }

    /// The nodes that came first: those of the way in which the expressions were made.
    fn settle_first(&mut self) {
        for (id, nodes) in &self.others {
            self.nodes[*id as usize] = nodes[0];
        }
    }

    /// The nodes with the fewest operations, each written out, starting from the first. (Bellman 1958: repeat until nothing gets shorter.)
    fn settle_written_out(&mut self) {
        for id in 0..self.nodes.len() {
            self.costs[id] = if self.node(id as Id).operands().is_empty() { 0.0 } else { f64::INFINITY };
        }
        loop {
            let mut changed = false;
            for id in 0..self.nodes.len() as Id {
                let nodes = match self.others.get(&id) {
                    Some(nodes) => nodes.clone(),
                    None => vec![self.node(id)],
                };
                for node in nodes {
                    let cost = self.cost(node);
                    if cost < self.costs[id as usize] {
                        self.costs[id as usize] = cost;
                        self.nodes[id as usize] = node;
                        changed = true;
                    }
                }
            }
            if !changed {
                return;
            }
        }
    }

    /// Takes another node for an expression wherever that makes the whole shorter.
    fn improve(&mut self, outputs: &[Id]) {
        let mut count = self.count(outputs);
        for _ in 0..ROUNDS {
            let before = count;
            for id in self.order(outputs) {
                let Some(nodes) = self.others.get(&id).cloned() else { continue };
                for node in nodes {
                    let old = std::mem::replace(&mut self.nodes[id as usize], node);
                    let now = self.count(outputs);
                    if now < count {
                        count = now;
                    } else {
                        self.nodes[id as usize] = old;
                    }
                }
            }
            if count == before {
                return;
            }
        }
    }

    /// How many operations `outputs` take, shared; none of it may be made of itself.
    fn count(&self, outputs: &[Id]) -> usize {
        const NEW: u8 = 0;
        const OPEN: u8 = 1;
        const DONE: u8 = 2;
        let mut state = vec![NEW; self.nodes.len()];
        let mut stack: Vec<Id> = outputs.to_vec();
        let mut count = 0;
        while let Some(id) = stack.last().copied() {
            match state[id as usize] {
                NEW => {
                    state[id as usize] = OPEN;
                    for operand in self.node(id).operands() {
                        match state[*operand as usize] {
                            NEW => stack.push(*operand),
                            OPEN => return usize::MAX,
                            _ => {}
                        }
                    }
                }
                OPEN => {
                    state[id as usize] = DONE;
                    count += usize::from(self.is_operation(id));
                    stack.pop();
                }
                _ => {
                    stack.pop();
                }
            }
        }
        count
    }
}

trait ByCount: Sized {
    fn min_by_count(self, other: Self) -> Self;
}

impl ByCount for (usize, Vec<Node>) {
    fn min_by_count(self, other: Self) -> Self {
        if other.0 < self.0 { other } else { self }
    }
}
