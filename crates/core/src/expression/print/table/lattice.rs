//! A table of three or four variables, printed: its samples, and what goes on between them.

use super::{between_name, lattice_name, piece_name};
use crate::expression::graph::Graph;
use crate::expression::print::code::Language;
use crate::expression::print::layout::{numbers, wrapped};
use crate::scalar::Rule;

const MEANING: &str = "Between samples on a lattice, variable by variable; constant outside.";

/// A variable of a table: its name, and that of the number of a sample.
const VARIABLES: [[&str; 2]; 4] = [["x", "i"], ["y", "j"], ["z", "k"], ["w", "l"]];

/// A table of three or four variables, ready to print.
pub struct Samples<'a> {
    name: String,
    axes: &'a [Vec<f64>],
    values: &'a [f64],
    rules: &'a [Rule],
}

impl<'a> Samples<'a> {
    pub fn of_lattice(graph: &'a Graph, function: &str, n: u32) -> Self {
        let (axes, values, rules) = graph.lattices[n as usize].samples();
        Self { name: lattice_name(function, n), axes, values, rules }
    }

    fn variables(&self) -> impl Iterator<Item = ([&'static str; 2], &[f64], Rule)> {
        let both = self.axes.iter().zip(self.rules);
        VARIABLES.into_iter().zip(both).map(|(names, (axis, rule))| (names, &axis[..], *rule))
    }

    /// Something for each variable.
    fn each(&self, text: impl Fn(&str) -> String, between: &str) -> String {
        let all: Vec<String> = self.variables().map(|([x, _], ..)| text(x)).collect();
        all.join(between)
    }

    /// The number of a sample within all values; `index` writes that along a variable.
    fn flat(&self, count: usize, index: impl Fn(usize, &str) -> String) -> String {
        let mut out = String::new();
        for (k, ([_, i], axis, _)) in self.variables().take(count).enumerate() {
            let here = index(k, i);
            out = match k {
                0 => here,
                1 => format!("{out}*{} + {here}", axis.len()),
                _ => format!("({out})*{} + {here}", axis.len()),
            };
        }
        out
    }

    /// Names and texts of what is computed one after another from the corners around a point, and the value.
    ///
    /// `path` tells on which side the corners lie along the first variables.
    fn reduced(
        &self,
        path: &mut Vec<u8>,
        read: &impl Fn(&[u8]) -> String,
        out: &mut Vec<[String; 2]>,
    ) -> String {
        let Some(rule) = self.rules.get(path.len()) else { return read(path) };
        let mut side = |bit: u8| {
            path.push(bit);
            let text = self.reduced(path, read, out);
            path.pop();
            text
        };
        let low = side(0);
        if *rule == Rule::Hold {
            return low;
        }
        let high = side(1);
        let [x, _] = VARIABLES[path.len()];
        let text = match rule {
            Rule::Slope => format!("d{x}*({high} - {low})"),
            _ => format!("{low} + d{x}*({high} - {low})"),
        };
        let name: String = std::iter::once("v".to_owned()).chain(path.iter().map(u8::to_string)).collect();
        out.push([name.clone(), text]);
        name
    }

    pub fn c(&self, function: &str) -> String {
        let list = |x: &[f64]| wrapped(&numbers(x).replace('[', "{").replace(']', "}"), 8);
        let arguments = self.each(|x| format!("double {x}"), ", ");
        let mut out = format!("\n/* {MEANING} */\nstatic double {}({arguments})\n{{\n", self.name);
        for ([x, _], axis, _) in self.variables() {
            out += &format!("    static const double {x}_at[{}] =\n{};\n", axis.len(), list(axis));
        }
        out += &format!("    static const double values[{}] =\n{};\n", self.values.len(), list(self.values));
        for ([x, i], axis, rule) in self.variables() {
            let (search, n) = (piece_name(function), axis.len());
            out += &format!("    const int {i} = {search}({x}_at, {n}, {x});\n");
            out += &format!("    const int {i}0 = {i} > 0 ? {i} - 1 : 0;\n");
            if rule != Rule::Hold {
                let rise =
                    if rule == Rule::Slope { "1.0".to_owned() } else { format!("({x} - {x}_at[{i}0])") };
                out += &format!(
                    "    const int {i}1 = {i} < {n} ? {i} : {};\n    const double d{x} =\n        \
                     {i}0 < {i}1 ? {rise}/({x}_at[{i}1] - {x}_at[{i}0]) : 0.0;\n",
                    n - 1
                );
            }
        }
        let read = |path: &[u8]| {
            let place = self.flat(path.len(), |k, i| format!("{i}{}", path[k]));
            format!("values[{place}]")
        };
        let mut steps = Vec::new();
        let value = self.reduced(&mut Vec::new(), &read, &mut steps);
        for [name, text] in steps {
            out += &format!("    const double {name} =\n{};\n", wrapped(&text, 8));
        }
        let nan = self.each(|x| format!("isnan({x})"), " || ");
        out += &format!("    if ({nan}) {{\n        return {};\n    }}\n", self.each(str::to_owned, " + "));
        out + &format!("    return {value};\n}}\n")
    }

    pub fn arrays(&self, language: Language, function: &str) -> String {
        let (name, m) = (&self.name, language.module());
        let list = |x: &[f64]| wrapped(&numbers(x), 4).trim_start().to_owned();
        let mut out = String::new();
        for ([x, _], axis, _) in self.variables() {
            out += &format!("{name}_{x} = np.array({})\n", list(axis));
        }
        let shape: Vec<String> = self.axes.iter().map(|axis| axis.len().to_string()).collect();
        let shape = shape.join(", ");
        out += &format!("{name}_values = np.array({}).reshape({shape})\n\n\n", list(self.values));
        out += &format!("def {name}({}):\n    \"\"\"{MEANING}\"\"\"\n", self.each(str::to_owned, ", "));
        for ([x, i], _, rule) in self.variables() {
            let to = match rule {
                Rule::Hold => format!("{i}0, _, _, _"),
                Rule::Line => format!("{i}0, {i}1, d{x}, _"),
                Rule::Slope => format!("{i}0, {i}1, _, d{x}"),
            };
            out += &format!("    {to} = {}({name}_{x}, {x})\n", between_name(function));
        }
        let values = format!("{name}_values");
        let values = if language == Language::Jax { format!("jnp.asarray({values})") } else { values };
        out += &format!("    values = {values}\n");
        let read = |path: &[u8]| {
            let places: Vec<String> =
                self.variables().zip(path).map(|(([_, i], ..), side)| format!("{i}{side}")).collect();
            format!("values[{}]", places.join(", "))
        };
        let mut steps = Vec::new();
        let value = self.reduced(&mut Vec::new(), &read, &mut steps);
        for [name, text] in steps {
            out += &format!("    {name} = (\n{}\n    )\n", wrapped(&text, 8));
        }
        let value = self
            .variables()
            .fold(value, |value, ([x, _], ..)| format!("{m}where({m}isnan({x}), {x}, {value})"));
        out + &format!("    return {value}\n")
    }

    pub fn symbolic(&self, function: &str) -> String {
        let name = between_name(function);
        let list = |x: &[f64]| wrapped(&numbers(x), 8).trim_start().to_owned();
        let arguments = self.each(str::to_owned, ", ");
        let mut out = format!("def {}({arguments}):\n    \"\"\"{MEANING}\"\"\"\n", self.name);
        for ([x, _], axis, _) in self.variables() {
            out += &format!("    {x}_at = {}\n", list(axis));
        }
        out += &format!("    values = {}\n\n", list(self.values));
        let last = self.axes.len() - 1;
        for (k, ([x, i], axis, rule)) in self.variables().enumerate().collect::<Vec<_>>().into_iter().rev() {
            let n = axis.len();
            let along = if k == last {
                "row".to_owned()
            } else {
                let ([y, _], i_list) = (VARIABLES[k + 1], VARIABLES[..=k].iter().map(|v| v[1]));
                format!("[along_{y}({}) for {i} in range({n})]", i_list.collect::<Vec<_>>().join(", "))
            };
            let rule = format!("{rule:?}").to_lowercase();
            let call = format!("return {name}({x}, {x}_at, {along}, \"{rule}\")\n");
            if k == 0 {
                out += &format!("    {call}");
                continue;
            }
            let fixed: Vec<&str> = VARIABLES[..k].iter().map(|v| v[1]).collect();
            out += &format!("    def along_{x}({}):\n", fixed.join(", "));
            if k == last {
                let row = self.flat(k, |_, i| i.to_owned());
                out += &format!("        row = values[({row})*{n}:({row} + 1)*{n}]\n");
            }
            out += &format!("        {call}\n");
        }
        out
    }
}
