//! What expressions are made of: in an order to compute them, and how much it is.

use super::graph::Graph;
use super::node::{Id, Operation};

/// How many operations it takes to compute expressions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperationCount {
    /// If every expression is written out in full.
    pub written_out: f64,
    /// If what occurs several times is computed once.
    pub shared: usize,
}

impl Graph {
    /// Everything that `outputs` are made of, operands before what works on them.
    pub fn order(&self, outputs: &[Id]) -> Vec<Id> {
        self.order_beyond(&vec![false; self.nodes.len()], outputs)
    }

    /// The same without what is there already, and what only that is made of.
    pub(super) fn order_beyond(&self, is_there: &[bool], outputs: &[Id]) -> Vec<Id> {
        let mut done = is_there.to_vec();
        let mut order = Vec::new();
        let mut stack: Vec<(Id, bool)> = outputs.iter().rev().map(|id| (*id, false)).collect();
        while let Some((id, ready)) = stack.pop() {
            if done[id as usize] {
                continue;
            }
            if ready {
                done[id as usize] = true;
                order.push(id);
            } else {
                stack.push((id, true));
                stack.extend(self.node(id).operands().iter().rev().map(|o| (*o, false)));
            }
        }
        order
    }

    /// Whether computing a node takes an operation.
    pub(super) fn is_operation(&self, id: Id) -> bool {
        let operation = self.node(id).operation;
        self.number(id).is_none() && !matches!(operation, Operation::Symbol(_))
    }

    /// How many operations `outputs` take.
    pub fn operation_count(&self, outputs: &[Id]) -> OperationCount {
        let order = self.order(outputs);
        let mut costs = vec![0.0; self.nodes.len()];
        for id in &order {
            if self.is_operation(*id) {
                let operands: f64 = self.node(*id).operands().iter().map(|o| costs[*o as usize]).sum();
                costs[*id as usize] = 1.0 + operands;
            }
        }
        OperationCount {
            written_out: outputs.iter().map(|id| costs[*id as usize]).sum(),
            shared: order.iter().filter(|id| self.is_operation(**id)).count(),
        }
    }
}
