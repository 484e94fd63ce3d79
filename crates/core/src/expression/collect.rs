//! Other ways to write a sum and a fraction: a factor that terms share stands before them once, and one above and
//! below the line nowhere.

use super::graph::Graph;
use super::node::{Id, Operation};

/// A term of a sum: whether it is subtracted, and its factors in order.
type Term = (bool, Vec<Id>);

/// Sums of more terms are left as they are: each new term is tried with all before it, so a long sum would take
/// the square of its length. None of the paper's forms gets shorter with more.
const TERMS: usize = 12;

impl Graph {
    /// Other ways to write a + b (a − b): the last term put together with one that shares factors with it.
    ///
    /// A way becomes known as one as it is made, by its value; where constants are rounded on it, it is none.
    pub(super) fn collect(&mut self, a: Id, b: Id, minus: bool) {
        let mut terms = Vec::new();
        self.terms(a, false, &mut terms);
        let (negative, last) = self.term(b, minus);
        if terms.len() > TERMS || matches!(self.node(b).operation, Operation::Add | Operation::Sub) {
            return;
        }
        for i in 0..terms.len() {
            let (common, own, others) = split(&terms[i].1, &last);
            if common.is_empty() {
                continue;
            }
            let (own, others) = (self.multiplied(&own), self.multiplied(&others));
            let together = match terms[i].0 == negative {
                true => self.apply(Operation::Add, &[own, others]),
                false => self.apply(Operation::Sub, &[own, others]),
            };
            let common = self.multiplied(&common);
            let together = self.apply(Operation::Mul, &[common, together]);
            let mut whole = if terms[i].0 { self.apply(Operation::Neg, &[together]) } else { together };
            for (j, (negative, factors)) in terms.iter().enumerate() {
                if j != i {
                    let term = self.multiplied(factors);
                    let operation = if *negative { Operation::Sub } else { Operation::Add };
                    whole = self.apply(operation, &[whole, term]);
                }
            }
        }
    }

    /// Another way to write a b (a / b) if there is a fraction in it: what stands above and below is left out.
    pub(super) fn cancel(&mut self, a: Id, b: Id, divided: bool) {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        self.fraction(a, &mut above, &mut below);
        if divided {
            self.fraction(b, &mut below, &mut above);
        } else {
            self.fraction(b, &mut above, &mut below);
        }
        let (common, above, below) = split(&above, &below);
        if !common.is_empty() {
            let (above, below) = (self.multiplied(&above), self.multiplied(&below));
            self.apply(Operation::Div, &[above, below]);
        }
    }

    fn fraction(&self, id: Id, above: &mut Vec<Id>, below: &mut Vec<Id>) {
        let node = self.node(id);
        let [a, b, ..] = node.operands;
        match node.operation {
            Operation::Mul => {
                self.fraction(a, above, below);
                self.fraction(b, above, below);
            }
            Operation::Div => {
                self.fraction(a, above, below);
                self.fraction(b, below, above);
            }
            _ => above.push(id),
        }
    }

    fn terms(&self, id: Id, negative: bool, out: &mut Vec<Term>) {
        let node = self.node(id);
        let [a, b, ..] = node.operands;
        match node.operation {
            _ if out.len() > TERMS => {}
            Operation::Add | Operation::Sub => {
                self.terms(a, negative, out);
                self.terms(b, negative ^ (node.operation == Operation::Sub), out);
            }
            Operation::Neg => self.terms(node.operands[0], !negative, out),
            _ => out.push(self.term(id, negative)),
        }
    }

    fn term(&self, id: Id, negative: bool) -> Term {
        let node = self.node(id);
        if node.operation == Operation::Neg {
            return self.term(node.operands[0], !negative);
        }
        let mut factors = Vec::new();
        self.factors(id, &mut factors);
        factors.sort_unstable();
        (negative, factors)
    }

    fn factors(&self, id: Id, out: &mut Vec<Id>) {
        let node = self.node(id);
        if node.operation == Operation::Mul {
            self.factors(node.operands[0], out);
            self.factors(node.operands[1], out);
        } else {
            out.push(id);
        }
    }

    fn multiplied(&mut self, factors: &[Id]) -> Id {
        let one = self.constant(1.0);
        factors.iter().fold(one, |product, f| self.apply(Operation::Mul, &[product, *f]))
    }
}

/// The factors that two products share, and what each has besides; all in order.
fn split(a: &[Id], b: &[Id]) -> (Vec<Id>, Vec<Id>, Vec<Id>) {
    let (mut common, mut rest) = (Vec::new(), Vec::new());
    let mut others = b.to_vec();
    for id in a {
        match others.iter().position(|o| o == id) {
            Some(place) => {
                others.remove(place);
                common.push(*id);
            }
            None => rest.push(*id),
        }
    }
    (common, rest, others)
}
