//! Equations for people to read.

mod factor;

use super::shared::Shared;
use crate::expression::graph::Graph;
use crate::expression::node::{Id, Operation};
use factor::number;

/// What stands left of the sign of equality.
#[derive(Clone, Debug)]
pub enum Left {
    /// A name, in LaTeX.
    Name(String),
    /// An expression.
    Expression(Id),
}

/// One equation.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its left side.
    pub left: Left,
    /// Its right side.
    pub right: Id,
}

/// Equations one a line, aligned at the sign of equality; `common` lists what occurs several times before them.
pub fn latex(graph: &Graph, lines: &[Line], common: bool) -> String {
    let ids: Vec<Id> = lines
        .iter()
        .flat_map(|l| match l.left {
            Left::Expression(id) => vec![id, l.right],
            Left::Name(_) => vec![l.right],
        })
        .collect();
    let shared = if common { Shared::of(graph, &ids) } else { Shared::nothing() };
    let mut rows = Vec::new();
    for (place, id) in shared.order.iter().enumerate() {
        let writer = Writer { graph, shared: &shared, defined: Some(*id) };
        rows.push(format!("{} &= {}", name(place), writer.sum(*id)));
    }
    let writer = Writer { graph, shared: &shared, defined: None };
    for line in lines {
        let left = match &line.left {
            Left::Name(name) => name.clone(),
            Left::Expression(id) => writer.sum(*id),
        };
        rows.push(format!("{left} &= {}", writer.sum(line.right)));
    }
    format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", rows.join(" \\\\\n"))
}

fn name(place: usize) -> String {
    format!("\\sigma_{{{}}}", place + 1)
}

/// A product by its sign, its number, and its factors with their powers; the number may be a quotient.
struct Product {
    negative: bool,
    coefficient: f64,
    divisor: f64,
    factors: Vec<(Id, i32)>,
}

struct Writer<'a> {
    graph: &'a Graph,
    shared: &'a Shared,
    /// The expression whose name is being defined: it is written out.
    defined: Option<Id>,
}

impl Writer<'_> {
    /// The place of an expression that goes by its name.
    fn named(&self, id: Id) -> Option<usize> {
        self.shared.place.get(&id).copied().filter(|_| self.defined != Some(id))
    }

    /// An expression as a sum of all its terms with their signs.
    fn sum(&self, id: Id) -> String {
        let mut terms = Vec::new();
        self.terms(id, false, &mut terms);
        // No minus at the start where another term can stand there.
        let first = terms.iter().position(|(negative, _)| !negative).unwrap_or(0);
        terms[..=first].rotate_right(1);
        let mut out = String::new();
        for (i, (negative, text)) in terms.into_iter().enumerate() {
            out += match (i, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            out += &text;
        }
        out
    }

    /// Collects the terms of a sum.
    fn terms(&self, id: Id, negative: bool, out: &mut Vec<(bool, String)>) {
        let node = self.graph.node(id);
        let [a, b, ..] = node.operands;
        match node.operation {
            Operation::Add | Operation::Sub if self.named(id).is_none() => {
                self.terms(a, negative, out);
                self.terms(b, negative ^ (node.operation == Operation::Sub), out);
            }
            Operation::Neg if self.named(id).is_none() => self.terms(a, !negative, out),
            _ => {
                let mut product =
                    Product { negative: false, coefficient: 1.0, divisor: 1.0, factors: Vec::new() };
                self.factors(id, 1, &mut product);
                let text = self.product(&product);
                out.push((negative ^ product.negative, text));
            }
        }
    }

    /// Collects the factors of a product.
    fn factors(&self, id: Id, power: i32, out: &mut Product) {
        if let Some(x) = self.graph.number(id) {
            out.negative ^= x < 0.0;
            *if power > 0 { &mut out.coefficient } else { &mut out.divisor } *= x.abs();
            return;
        }
        let node = self.graph.node(id);
        let [a, b, ..] = node.operands;
        let named = self.named(id).is_some();
        match node.operation {
            Operation::Mul if !named => {
                self.factors(a, power, out);
                self.factors(b, power, out);
            }
            Operation::Div if !named => {
                self.factors(a, power, out);
                self.factors(b, -power, out);
            }
            Operation::Neg if !named => {
                out.negative ^= true;
                self.factors(a, power, out);
            }
            _ => match out.factors.iter_mut().find(|(known, p)| *known == id && p.signum() == power) {
                Some((_, p)) => *p += power,
                None => out.factors.push((id, power)),
            },
        }
    }

    /// A product: its number, then symbols, sums of symbols, symbols with dots, then functions and sums.
    fn product(&self, product: &Product) -> String {
        let mut factors = product.factors.clone();
        let rank = |id: Id| match self.graph.node(id).operation {
            Operation::Symbol(n) if self.dots(id) == 0 => (0, n),
            Operation::Symbol(n) => (1 + self.dots(id), n),
            _ if self.named(id).is_some() => (4, 0),
            Operation::Add | Operation::Sub if self.is_parameter(id) => (1, 0),
            Operation::Add | Operation::Sub => (6, 0),
            // Functions of one angle together.
            _ => (5, self.graph.node(id).operands[0]),
        };
        factors.sort_by_key(|(id, _)| rank(*id));
        let (above, below): (Vec<_>, Vec<_>) = factors.into_iter().partition(|(_, p)| *p > 0);
        let (mut coefficient, mut divisor) = (product.coefficient, product.divisor);
        let fraction = !below.is_empty() || divisor != 1.0;
        if fraction && coefficient < 1.0 && (1.0 / coefficient).fract() == 0.0 {
            (coefficient, divisor) = (1.0, divisor / coefficient);
        }
        let write = |coefficient: f64, factors: &[(Id, i32)]| {
            let one = coefficient == 1.0;
            let number = (!one || factors.is_empty()).then(|| number(coefficient));
            let alone = one && factors.len() == 1;
            let each = factors.iter().map(|(id, p)| self.factor(*id, p.abs(), alone));
            number.into_iter().chain(each).collect::<Vec<_>>().join(" ")
        };
        let top = write(coefficient, &above);
        if fraction { format!("\\frac{{{top}}}{{{}}}", write(divisor, &below)) } else { top }
    }

    /// Whether an expression is made of symbols without dots by sums and products alone.
    fn is_parameter(&self, id: Id) -> bool {
        self.graph.order(&[id]).into_iter().all(|id| match self.graph.node(id).operation {
            Operation::Symbol(_) => self.dots(id) == 0,
            Operation::Constant(_) => true,
            Operation::Add | Operation::Sub | Operation::Mul | Operation::Neg => self.named(id).is_none(),
            _ => false,
        })
    }

    /// How many dots a symbol has.
    fn dots(&self, id: Id) -> u32 {
        match self.graph.symbol_of(id) {
            Some(s) if s.latex.starts_with("\\ddot") => 2,
            Some(s) if s.latex.starts_with("\\dot") => 1,
            _ => 0,
        }
    }
}
