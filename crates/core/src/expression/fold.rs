//! The rules that make an expression simpler as it is made.
//!
//! Each gives the same double as what it replaces, but for the sign of a zero, for what is not finite (zero times
//! infinity becomes zero), and for powers: a small whole power is its product, which rounds better than a library.

use super::graph::{Graph, Simplify};
use super::node::{Id, Node, Operation};

/// Sums within sums that are searched for other ways to write them, since a way makes sums of its own; a third
/// level makes none of the paper's forms shorter.
const DEPTH: u8 = 2;

impl Graph {
    /// The expression of an operation on expressions.
    pub fn apply(&mut self, operation: Operation, operands: &[Id]) -> Id {
        if let Some(folded) = self.folded(operation, operands) {
            return folded;
        }
        match *operands {
            [a] => self.unary(operation, a),
            [a, b] => self.binary(operation, a, b),
            [a, b, x, y] if operation == Operation::SelectLe => self.select(a, b, x, y),
            _ => self.intern(Node::new(operation, operands)),
        }
    }

    /// The result if all operands are constants; what is not finite stays as it is written.
    fn folded(&mut self, operation: Operation, operands: &[Id]) -> Option<Id> {
        use Operation::{Lookup, Lookup2, Lookup3, Lookup4};
        if let Lookup(_) | Lookup2(_) | Lookup3(_) | Lookup4(_) = operation {
            let value = self.looked_up(operation, operands)?;
            return Some(self.constant(value));
        }
        let mut x = [0.0; 4];
        for (x, id) in x.iter_mut().zip(operands) {
            *x = self.number(*id)?;
        }
        let value = operation.value(x).filter(|v| v.is_finite())?;
        Some(self.constant(value))
    }

    /// The value of a table at constants, or of one that is a constant itself, as slopes of held values are.
    fn looked_up(&self, operation: Operation, operands: &[Id]) -> Option<f64> {
        match operation {
            Operation::Lookup(n) => {
                let table = &self.tables[n as usize];
                match table.pieces().1 {
                    [only] => Some(only[0]),
                    _ => Some(table.value(self.number(operands[0])?)),
                }
            }
            Operation::Lookup2(n) => {
                let grid = &self.grids[n as usize];
                match grid.patches().2 {
                    [only] => Some(only[0][0]),
                    _ => Some(grid.value(self.number(operands[0])?, self.number(operands[1])?)),
                }
            }
            Operation::Lookup3(n) | Operation::Lookup4(n) => {
                let at: Option<Vec<f64>> = operands.iter().map(|id| self.number(*id)).collect();
                Some(self.lattices[n as usize].value(&at?))
            }
            _ => None,
        }
    }

    fn unary(&mut self, operation: Operation, a: Id) -> Id {
        if operation == Operation::Neg {
            return self.negated(a);
        }
        if (operation.is_odd() || operation.is_even())
            && let Some(positive) = self.negative_of(a)
        {
            let f = self.apply(operation, &[positive]);
            return if operation.is_even() { f } else { self.negated(f) };
        }
        if operation == Operation::Abs && self.node(a).operation == Operation::Abs {
            return a;
        }
        if self.expand_angles && matches!(operation, Operation::Sin | Operation::Cos) {
            let Node { operation: inner, operands: [b, c, ..] } = self.node(a);
            if matches!(inner, Operation::Add | Operation::Sub) {
                return self.of_angle_sum(operation, b, c, inner == Operation::Sub);
            }
            if inner == Operation::Mul && self.is(b, 2.0) {
                return self.of_angle_sum(operation, c, c, false);
            }
        }
        self.intern(Node::new(operation, &[a]))
    }

    /// Sine or cosine of a + b (a − b): sin a cos b ± cos a sin b, cos a cos b ∓ sin a sin b.
    fn of_angle_sum(&mut self, operation: Operation, a: Id, b: Id, minus: bool) -> Id {
        let turns = [(Operation::Sin, a), (Operation::Cos, a), (Operation::Sin, b), (Operation::Cos, b)];
        let [sin_a, cos_a, sin_b, cos_b] = turns.map(|(f, angle)| self.apply(f, &[angle]));
        let (first, second) = match operation {
            Operation::Sin => ([sin_a, cos_b], [cos_a, sin_b]),
            _ => ([cos_a, cos_b], [sin_a, sin_b]),
        };
        let [first, second] = [first, second].map(|factors| self.apply(Operation::Mul, &factors));
        let adds = (operation == Operation::Sin) != minus;
        self.apply(if adds { Operation::Add } else { Operation::Sub }, &[first, second])
    }

    /// −a; of a difference the other one.
    fn negated(&mut self, a: Id) -> Id {
        let Node { operation, operands } = self.node(a);
        match operation {
            Operation::Neg => operands[0],
            Operation::Sub => self.apply(Operation::Sub, &[operands[1], operands[0]]),
            _ if self.is(a, 0.0) => a,
            _ => self.intern(Node::new(Operation::Neg, &[a])),
        }
    }

    /// b, of an expression −b.
    fn negative_of(&self, a: Id) -> Option<Id> {
        let node = self.node(a);
        (node.operation == Operation::Neg).then_some(node.operands[0])
    }

    fn is(&self, a: Id, x: f64) -> bool {
        self.number(a) == Some(x)
    }

    fn binary(&mut self, operation: Operation, a: Id, b: Id) -> Id {
        match operation {
            Operation::Add => self.sum(a, b),
            Operation::Sub => self.difference(a, b),
            Operation::Mul => self.product(a, b),
            Operation::Div => self.quotient(a, b),
            Operation::Pow => self.power(a, b),
            _ => self.intern(Node::new(operation, &[a, b])),
        }
    }

    fn sum(&mut self, a: Id, b: Id) -> Id {
        match (self.negative_of(a), self.negative_of(b)) {
            _ if self.is(a, 0.0) => b,
            _ if self.is(b, 0.0) => a,
            (Some(a), Some(b)) => {
                let sum = self.sum(a, b);
                self.negated(sum)
            }
            (None, Some(b)) => self.difference(a, b),
            (Some(a), None) => self.difference(b, a),
            _ if a == b => {
                let two = self.constant(2.0);
                self.product(two, a)
            }
            _ => {
                let sum = self.commuting(Operation::Add, a, b);
                self.search(|g| g.collect(a, b, false));
                sum
            }
        }
    }

    /// Looks for other ways to write an expression.
    fn search(&mut self, look: impl FnOnce(&mut Self)) {
        if self.simplify == Simplify::Algebraically && self.depth < DEPTH {
            self.depth += 1;
            look(self);
            self.depth -= 1;
        }
    }

    fn difference(&mut self, a: Id, b: Id) -> Id {
        match (self.negative_of(a), self.negative_of(b)) {
            _ if self.is(b, 0.0) => a,
            _ if self.is(a, 0.0) => self.negated(b),
            _ if a == b => self.constant(0.0),
            (_, Some(b)) => self.sum(a, b),
            (Some(a), None) => {
                let sum = self.sum(a, b);
                self.negated(sum)
            }
            _ => {
                let difference = self.intern(Node::new(Operation::Sub, &[a, b]));
                self.search(|g| g.collect(a, b, true));
                difference
            }
        }
    }

    fn product(&mut self, a: Id, b: Id) -> Id {
        match (self.negative_of(a), self.negative_of(b)) {
            _ if self.is(a, 0.0) || self.is(b, 0.0) => self.constant(0.0),
            _ if self.is(a, 1.0) => b,
            _ if self.is(b, 1.0) => a,
            (Some(a), Some(b)) => self.product(a, b),
            (Some(x), None) => {
                let product = self.product(x, b);
                self.negated(product)
            }
            (None, Some(x)) => {
                let product = self.product(a, x);
                self.negated(product)
            }
            _ => {
                let product = self.commuting(Operation::Mul, a, b);
                if [a, b].iter().any(|id| self.node(*id).operation == Operation::Div) {
                    self.search(|g| g.cancel(a, b, false));
                }
                product
            }
        }
    }

    fn quotient(&mut self, a: Id, b: Id) -> Id {
        match (self.negative_of(a), self.negative_of(b)) {
            _ if self.is(a, 0.0) && !self.is(b, 0.0) => a,
            _ if self.is(b, 1.0) => a,
            (Some(a), Some(b)) => self.quotient(a, b),
            (Some(x), None) => {
                let quotient = self.quotient(x, b);
                self.negated(quotient)
            }
            (None, Some(x)) => {
                let quotient = self.quotient(a, x);
                self.negated(quotient)
            }
            _ => {
                let quotient = self.intern(Node::new(Operation::Div, &[a, b]));
                self.search(|g| g.cancel(a, b, true));
                quotient
            }
        }
    }

    /// Small whole powers are products.
    fn power(&mut self, a: Id, b: Id) -> Id {
        match self.number(b) {
            Some(0.0) => self.constant(1.0),
            Some(1.0) => a,
            Some(2.0) => self.product(a, a),
            Some(3.0) => {
                let square = self.product(a, a);
                self.product(square, a)
            }
            Some(4.0) => {
                let square = self.product(a, a);
                self.product(square, square)
            }
            Some(0.5) => self.apply(Operation::Sqrt, &[a]),
            Some(-1.0) => {
                let one = self.constant(1.0);
                self.quotient(one, a)
            }
            _ => self.intern(Node::new(Operation::Pow, &[a, b])),
        }
    }

    /// Operands in one order; constants stand first.
    fn commuting(&mut self, operation: Operation, a: Id, b: Id) -> Id {
        if operation == Operation::Mul
            && a == b
            && self.simplify == Simplify::Algebraically
            && self.node(a).operation == Operation::Sqrt
        {
            return self.node(a).operands[0];
        }
        let rank = |id: Id| (self.number(id).is_none(), id);
        let (a, b) = if rank(a) <= rank(b) { (a, b) } else { (b, a) };
        self.intern(Node::new(operation, &[a, b]))
    }

    fn select(&mut self, a: Id, b: Id, x: Id, y: Id) -> Id {
        match (self.number(a), self.number(b)) {
            _ if x == y => x,
            (Some(a), Some(b)) => {
                if a <= b {
                    x
                } else {
                    y
                }
            }
            _ => self.intern(Node::new(Operation::SelectLe, &[a, b, x, y])),
        }
    }
}
