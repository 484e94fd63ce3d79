//! Factors of products: symbols, functions and what stands in parentheses.

use super::{Writer, name};
use crate::expression::node::{Id, Operation};
use crate::scalar::Elementary;

impl Writer<'_> {
    /// One factor with its power; a lone one needs no parentheses.
    pub fn factor(&self, id: Id, power: i32, alone: bool) -> String {
        let raised = |text: String| text + &exponent(power);
        if let Some(place) = self.named(id) {
            return raised(name(place));
        }
        let node = self.graph.node(id);
        let [a, b, c, d] = node.operands;
        match node.operation {
            Operation::Symbol(_) => {
                let text = self.graph.symbol_of(id).map_or_else(String::new, |s| s.latex.clone());
                if power > 1 && text.contains('^') { raised(format!("{{{text}}}")) } else { raised(text) }
            }
            Operation::Add | Operation::Sub if alone && power == 1 => self.sum(id),
            Operation::Add | Operation::Sub => raised(format!("\\left({}\\right)", self.sum(id))),
            Operation::Sin => self.function("\\sin", a, power),
            Operation::Cos => self.function("\\cos", a, power),
            Operation::Elementary(f) => match f {
                Elementary::Exp if power == 1 => format!("e^{{{}}}", self.sum(a)),
                Elementary::Exp => raised(format!("\\left(e^{{{}}}\\right)", self.sum(a))),
                Elementary::Floor => raised(format!("\\left\\lfloor {}\\right\\rfloor", self.sum(a))),
                Elementary::Asin => self.function("\\arcsin", a, power),
                Elementary::Acos => self.function("\\arccos", a, power),
                Elementary::Atan => self.function("\\arctan", a, power),
                Elementary::Sinh => self.function("\\sinh", a, power),
                Elementary::Cosh => self.function("\\cosh", a, power),
                Elementary::Tanh => self.function("\\tanh", a, power),
                Elementary::Tan => self.function("\\tan", a, power),
                Elementary::Ln => self.function("\\ln", a, power),
            },
            Operation::Sqrt => raised(format!("\\sqrt{{{}}}", self.sum(a))),
            Operation::Abs => raised(format!("\\left|{}\\right|", self.sum(a))),
            Operation::Atan2 => raised(self.call("\\operatorname{atan2}", &[a, b])),
            Operation::Pow => {
                let text = format!("\\left({}\\right)^{{{}}}", self.sum(a), self.sum(b));
                if power == 1 { text } else { raised(format!("\\left({text}\\right)")) }
            }
            Operation::SelectLe if [a, b] == [c, d] => raised(self.call("\\min", &[a, b])),
            Operation::SelectLe if [a, b] == [d, c] => raised(self.call("\\max", &[a, b])),
            Operation::SelectLe => {
                let [a, b, x, y] = [a, b, c, d].map(|id| self.sum(id));
                let text = format!(
                    "\\begin{{cases}} {x} & {a} \\le {b} \\\\ {y} & \\text{{otherwise}} \\end{{cases}}"
                );
                if alone && power == 1 { text } else { raised(format!("\\left({text}\\right)")) }
            }
            Operation::Lookup(n) => raised(self.call(&format!("f_{{{n}}}"), &[a])),
            Operation::Lookup2(n) => raised(self.call(&format!("g_{{{n}}}"), &[a, b])),
            Operation::Lookup3(n) => raised(self.call(&format!("h_{{{n}}}"), &[a, b, c])),
            Operation::Lookup4(n) => raised(self.call(&format!("h_{{{n}}}"), &[a, b, c, d])),
            // Products and numbers are opened by `factors`.
            _ => raised(format!("\\left({}\\right)", self.sum(id))),
        }
    }

    fn function(&self, name: &str, argument: Id, power: i32) -> String {
        let power = exponent(power);
        let text = self.sum(argument);
        if self.graph.symbol_of(argument).is_some() {
            format!("{name}{power} {text}")
        } else {
            format!("{name}{power}\\left({text}\\right)")
        }
    }

    fn call(&self, name: &str, arguments: &[Id]) -> String {
        let all: Vec<String> = arguments.iter().map(|a| self.sum(*a)).collect();
        format!("{name}\\left({}\\right)", all.join(", "))
    }
}

fn exponent(power: i32) -> String {
    match power {
        1 => String::new(),
        2..10 => format!("^{power}"),
        _ => format!("^{{{power}}}"),
    }
}

/// A number as people write it.
pub fn number(x: f64) -> String {
    if x == 0.5 {
        return "\\tfrac{1}{2}".to_owned();
    }
    let text = format!("{x:?}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        None => text.strip_suffix(".0").unwrap_or(&text).to_owned(),
    }
}
