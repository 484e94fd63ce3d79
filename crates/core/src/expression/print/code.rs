//! One expression in a programming language.

use super::shared::Shared;
use super::table;
use crate::expression::graph::Graph;
use crate::expression::node::{Id, Operation};
use crate::scalar::Elementary;

/// A language that functions are printed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C99.
    C,
    /// Python with NumPy.
    NumPy,
    /// Python with JAX.
    Jax,
    /// Python with CasADi.
    CasAdi,
    /// Python with SymPy.
    SymPy,
}

impl Language {
    /// What stands before the functions of its library.
    pub fn module(self) -> &'static str {
        match self {
            Self::C => "",
            Self::NumPy => "np.",
            Self::Jax => "jnp.",
            Self::CasAdi => "ca.",
            Self::SymPy => "sp.",
        }
    }

    /// The name of a function; none for what is an operator.
    fn function(self, operation: Operation) -> Option<&'static str> {
        use Elementary::{Acos, Asin, Atan, Cosh, Exp, Floor, Ln, Sinh, Tan, Tanh};
        let short = !matches!(self, Self::NumPy | Self::Jax);
        let pick = |a: &'static str, b: &'static str| if short { a } else { b };
        Some(match operation {
            Operation::Sqrt => "sqrt",
            Operation::Sin => "sin",
            Operation::Cos => "cos",
            Operation::Abs => match self {
                Self::SymPy => "Abs",
                Self::NumPy | Self::Jax => "abs",
                _ => "fabs",
            },
            Operation::Atan2 => pick("atan2", "arctan2"),
            Operation::Pow => match self {
                Self::SymPy => "Pow",
                Self::NumPy | Self::Jax => "power",
                _ => "pow",
            },
            Operation::Elementary(f) => match f {
                Tan => "tan",
                Asin => pick("asin", "arcsin"),
                Acos => pick("acos", "arccos"),
                Atan => pick("atan", "arctan"),
                Sinh => "sinh",
                Cosh => "cosh",
                Tanh => "tanh",
                Exp => "exp",
                Ln => "log",
                Floor => "floor",
            },
            _ => return None,
        })
    }

    /// A number that reads back as the same double.
    pub fn number(self, x: f64) -> String {
        if self != Self::SymPy {
            return format!("{x:?}");
        }
        // Exact where it is a fraction that people write.
        let scaled = x * 1024.0;
        if x.fract() == 0.0 && x.abs() < 1e15 {
            format!("{x:.0}")
        } else if scaled.fract() == 0.0 && scaled.abs() < 1e6 {
            format!("sp.Rational({scaled:.0}, 1024)")
        } else {
            format!("{x:?}")
        }
    }
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Factor,
}

/// Writes expressions in a language.
pub struct Writer<'a> {
    pub graph: &'a Graph,
    pub language: Language,
    pub shared: &'a Shared,
    /// The name of the function: what belongs to it has a name that starts with it.
    pub function: &'a str,
}

impl Writer<'_> {
    /// The expression, or its name if it has one.
    pub fn expression(&self, id: Id) -> String {
        self.at(id, Level::Sum)
    }

    /// The expression even if it has a name: what the name stands for.
    pub fn definition(&self, id: Id) -> String {
        self.written(id).0
    }

    /// The name of a shared expression.
    pub fn name(place: usize) -> String {
        format!("t{place}")
    }

    /// The expression as an operand that must hold together at a level.
    fn at(&self, id: Id, level: Level) -> String {
        match self.shared.place.get(&id) {
            Some(place) => Self::name(*place),
            None => held(self.written(id), level),
        }
    }

    fn written(&self, id: Id) -> (String, Level) {
        match self.graph.node(id).operation {
            Operation::Add | Operation::Sub => (self.sum(id), Level::Sum),
            _ => match self.defined_product(id) {
                (true, text) => (format!("-{}", held(text, Level::Product)), Level::Product),
                (false, text) => text,
            },
        }
    }

    /// A sum of two; no sign stands before a minus, and a positive term before a negative one.
    fn sum(&self, id: Id) -> String {
        let node = self.graph.node(id);
        let [a, b, ..] = node.operands;
        let ((a_negative, a_text), (b_negative, b_text)) = (self.product(a), self.product(b));
        let b_negative = b_negative ^ (node.operation == Operation::Sub);
        // The operand on the right holds together more tightly, so that the order of rounding stays.
        let right = |text| held(text, Level::Product);
        match (a_negative, b_negative) {
            (true, false) => format!("{} - {}", b_text.0, right(a_text)),
            (true, true) => format!("-{} - {}", right(a_text), right(b_text)),
            (false, true) => format!("{} - {}", a_text.0, right(b_text)),
            // Of two positive terms the sum comes first: it needs no parentheses there.
            (false, false) if b_text.1 < a_text.1 && b_text.1 == Level::Sum => {
                format!("{} + {}", b_text.0, a_text.0)
            }
            (false, false) => format!("{} + {}", a_text.0, right(b_text)),
        }
    }

    /// The expression, or its name, without its sign; and whether that is a minus.
    fn product(&self, id: Id) -> (bool, (String, Level)) {
        match self.shared.place.get(&id) {
            Some(place) => (false, (Self::name(*place), Level::Factor)),
            None => self.defined_product(id),
        }
    }

    fn defined_product(&self, id: Id) -> (bool, (String, Level)) {
        if let Some(x) = self.graph.number(id) {
            return (x < 0.0, (self.language.number(x.abs()), Level::Factor));
        }
        let node = self.graph.node(id);
        let [a, b, ..] = node.operands;
        let operator = match node.operation {
            Operation::Neg => {
                let (negative, text) = self.product(a);
                return (!negative, text);
            }
            Operation::Add | Operation::Sub => return (false, (self.sum(id), Level::Sum)),
            Operation::Mul => "*",
            Operation::Div => "/",
            _ => return (false, (self.factor(id), Level::Factor)),
        };
        let ((a_negative, mut a), (b_negative, mut b)) = (self.product(a), self.product(b));
        if operator == "*" && a.1 == Level::Factor && b.1 == Level::Product {
            // A product that comes first needs no parentheses.
            std::mem::swap(&mut a, &mut b);
        }
        let text = format!("{}{operator}{}", held(a, Level::Product), held(b, Level::Factor));
        (a_negative ^ b_negative, (text, Level::Product))
    }

    /// A symbol or a call.
    fn factor(&self, id: Id) -> String {
        if let Some(symbol) = self.graph.symbol_of(id) {
            return symbol.name.clone();
        }
        let node = self.graph.node(id);
        let name = match node.operation {
            Operation::SelectLe => return self.choice(node.operands),
            Operation::Lookup(n) => table::name(self.function, n),
            Operation::Lookup2(n) => table::grid_name(self.function, n),
            Operation::Lookup3(n) | Operation::Lookup4(n) => table::lattice_name(self.function, n),
            other => {
                let name = self.language.function(other).unwrap_or_default();
                format!("{}{name}", self.language.module())
            }
        };
        let operands: Vec<String> = node.operands().iter().map(|o| self.expression(*o)).collect();
        format!("{name}({})", operands.join(", "))
    }

    /// c where a ≤ b, else d.
    fn choice(&self, [a, b, c, d]: [Id; 4]) -> String {
        let [x, y] = [c, d].map(|id| self.expression(id));
        let condition = format!("{} <= {}", self.expression(a), self.expression(b));
        match self.language {
            Language::C => {
                let [x, y] = [c, d].map(|id| self.at(id, Level::Factor));
                format!("({condition} ? {x} : {y})")
            }
            Language::NumPy => format!("np.where({condition}, {x}, {y})"),
            Language::Jax => format!("jnp.where({condition}, {x}, {y})"),
            Language::CasAdi => format!("ca.if_else({condition}, {x}, {y})"),
            Language::SymPy => format!("sp.Piecewise(({x}, {condition}), ({y}, True))"),
        }
    }
}

/// A text that holds together at a level.
fn held((text, own): (String, Level), level: Level) -> String {
    if own < level { format!("({text})") } else { text }
}
