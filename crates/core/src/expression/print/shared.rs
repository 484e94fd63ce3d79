//! Which expressions get a name because they occur several times.

use crate::expression::graph::Graph;
use crate::expression::node::Id;
use std::collections::HashMap;

/// Named expressions in an order to compute them.
pub struct Shared {
    /// The expressions, operands first.
    pub order: Vec<Id>,
    /// The place of each in `order`.
    pub place: HashMap<Id, usize>,
}

impl Shared {
    /// Everything that is worked on more than once within `outputs`.
    pub fn of(graph: &Graph, outputs: &[Id]) -> Self {
        let order = graph.order(outputs);
        let mut uses: HashMap<Id, usize> = HashMap::new();
        for id in &order {
            for operand in graph.node(*id).operands() {
                *uses.entry(*operand).or_default() += 1;
            }
        }
        for id in outputs {
            *uses.entry(*id).or_default() += 1;
        }
        let several = |id: &Id| graph.is_operation(*id) && uses.get(id).is_some_and(|n| *n > 1);
        let order: Vec<Id> = order.into_iter().filter(several).collect();
        let place = order.iter().enumerate().map(|(i, id)| (*id, i)).collect();
        Self { order, place }
    }

    /// Nothing: every expression is written out.
    pub fn nothing() -> Self {
        Self { order: Vec::new(), place: HashMap::new() }
    }
}

/// The symbols that `outputs` are made of.
pub fn symbols_in(graph: &Graph, outputs: &[Id]) -> Vec<Id> {
    graph.order(outputs).into_iter().filter(|id| graph.symbol_of(*id).is_some()).collect()
}
