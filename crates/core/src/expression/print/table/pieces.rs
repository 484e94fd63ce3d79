//! A table in pieces, printed.

use super::{grid_name, name, piece_name};
use crate::expression::graph::Graph;
use crate::expression::print::code::Language;
use crate::expression::print::layout::{numbers, rows, wrapped};

const MEANING: &str = "Polynomials of the distance from where each piece starts; constant outside.";

/// A variable of a table: its name, that of the distance into a piece, and that of the number of the piece.
const VARIABLES: [[&str; 3]; 2] = [["x", "d", "i"], ["y", "e", "j"]];

/// A table of one variable or two, ready to print.
pub struct Pieces {
    name: String,
    /// Along each variable: where the pieces after the first start.
    starts: Vec<Vec<f64>>,
    /// Along each variable: how many coefficients a piece has.
    terms: Vec<usize>,
    /// The coefficients of each piece as a list; those of a grid by rows, one row for each piece along x.
    coefficients: Vec<Vec<String>>,
}

impl Pieces {
    pub fn of_table(graph: &Graph, function: &str, n: u32) -> Self {
        let (starts, all) = graph.tables[n as usize].pieces();
        let terms = count(all.iter());
        let lines: Vec<String> = all.iter().map(|row| numbers(&row[..terms])).collect();
        Self {
            name: name(function, n),
            starts: vec![starts[1..].to_vec()],
            terms: vec![terms],
            coefficients: vec![lines],
        }
    }

    pub fn of_grid(graph: &Graph, function: &str, n: u32) -> Self {
        let (x, y, patches) = graph.grids[n as usize].patches();
        let along_y = count(patches.iter().flatten());
        let columns = patches.iter().flat_map(|p| (0..4).map(move |l| [p[0][l], p[1][l], p[2][l], p[3][l]]));
        let columns: Vec<[f64; 4]> = columns.collect();
        let along_x = count(columns.iter());
        let patch = |p: &[[f64; 4]; 4]| {
            let lists: Vec<String> = p[..along_x].iter().map(|row| numbers(&row[..along_y])).collect();
            format!("[{}]", lists.join(", "))
        };
        let strips = patches.chunks(y.len()).map(|strip| strip.iter().map(patch).collect());
        Self {
            name: grid_name(function, n),
            starts: vec![x[1..].to_vec(), y[1..].to_vec()],
            terms: vec![along_x, along_y],
            coefficients: strips.collect(),
        }
    }

    /// All coefficients as nested lists.
    fn lists(&self, indent: usize) -> String {
        if self.terms.len() == 1 {
            return rows(&self.coefficients[0], indent);
        }
        let inner = indent + 4;
        let strips = self.coefficients.iter().map(|lines| format!("\n{:inner$}{},", "", rows(lines, inner)));
        format!("[{}\n{:indent$}]", strips.collect::<String>(), "")
    }

    /// The variables with where their pieces start and how many coefficients they have.
    fn variables(&self) -> impl Iterator<Item = ([&'static str; 3], &[f64], usize)> {
        let both = self.starts.iter().zip(&self.terms);
        VARIABLES.into_iter().zip(both).map(|(names, (starts, terms))| (names, &starts[..], *terms))
    }

    /// The names of the variables with something around each.
    fn each(&self, before: &str, after: &str, between: &str) -> String {
        let all: Vec<String> = self.variables().map(|([x, ..], ..)| format!("{before}{x}{after}")).collect();
        all.join(between)
    }

    fn indices(&self, before: &str, after: &str, between: &str) -> String {
        let all: Vec<String> = self.variables().map(|([.., i], ..)| format!("{before}{i}{after}")).collect();
        all.join(between)
    }

    /// The polynomial, of coefficients c that are written with indices.
    fn polynomial(&self, index: impl Fn(&[usize]) -> String) -> String {
        match self.terms[..] {
            [n, m] => {
                let inner = |k: usize| horner((0..m).map(|l| index(&[k, l])).collect(), "e");
                let wrap = |k: usize| {
                    if m > 1 && k > 0 && k + 1 == n { format!("({})", inner(k)) } else { inner(k) }
                };
                horner((0..n).map(wrap).collect(), "d")
            }
            _ => horner((0..self.terms[0]).map(|k| index(&[k])).collect(), "d"),
        }
    }

    pub fn c(&self, function: &str) -> String {
        let braces = |text: &str| text.replace('[', "{").replace(']', "}");
        let mut out = format!(
            "\n/* {MEANING} */\nstatic double {}({})\n{{\n",
            self.name,
            self.each("double ", "", ", ")
        );
        for ([x, ..], starts, _) in self.variables() {
            let list = wrapped(&braces(&numbers(starts)), 8).replacen("        ", "", 1);
            out += &format!("    static const double {x}_start[{}] = {list};\n", starts.len());
        }
        let pieces: String = self.starts.iter().map(|s| format!("[{}]", s.len() + 1)).collect();
        let terms: String = self.terms.iter().map(|n| format!("[{n}]")).collect();
        let list = braces(&self.lists(4));
        out += &format!("    static const double coefficients{pieces}{terms} = {list};\n");
        for ([x, _, i], starts, _) in self.variables() {
            let search = piece_name(function);
            out += &format!("    const int {i} = {search}({x}_start, {}, {x});\n", starts.len());
        }
        for ([x, d, i], starts, _) in self.variables().filter(|v| v.2 > 1) {
            let last = starts.len();
            out += &format!(
                "    const double {d} = {i} > 0 && {i} < {last} ? {x} - {x}_start[{i} - 1] : 0.0;\n"
            );
        }
        let pointer =
            if self.terms.len() == 1 { "*c".to_owned() } else { format!("(*c)[{}]", self.terms[1]) };
        out += &format!("    const double {pointer} = coefficients{};\n", self.indices("[", "]", ""));
        let polynomial = self.polynomial(|k| format!("c{}", brackets(k)));
        out += &format!("    if ({}) {{\n", self.each("isnan(", ")", " || "));
        out += &format!("        return {};\n    }}\n", self.each("", "", " + "));
        out + &format!("    return {};\n}}\n", wrapped(&polynomial, 8).trim_start())
    }

    pub fn arrays(&self, language: Language) -> String {
        let (name, m) = (&self.name, language.module());
        let mut out = String::new();
        for ([x, ..], starts, _) in self.variables() {
            let list = wrapped(&numbers(starts), 4);
            out += &format!("{name}_{x} = np.array({})\n", list.trim_start());
        }
        out += &format!("{name}_c = np.array({})\n\n\n", self.lists(0));
        out += &format!("def {name}({}):\n    \"\"\"{MEANING}\"\"\"\n", self.each("", "", ", "));
        let array = |array: String| match language {
            Language::Jax => format!("jnp.asarray({array})"),
            _ => array,
        };
        for ([x, _, i], ..) in self.variables() {
            out += &format!("    {i} = {m}searchsorted({name}_{x}, {x}, side=\"right\")\n");
        }
        for ([x, d, i], starts, _) in self.variables().filter(|v| v.2 > 1) {
            let start = array(format!("{name}_{x}"));
            let inside = format!("({i} > 0) & ({i} < {})", starts.len());
            out += &format!("    {d} = {m}where({inside}, {x} - {start}[{i} - 1], 0.0)\n");
        }
        out += &format!("    c = {}[{}]\n", array(format!("{name}_c")), self.indices("", "", ", "));
        let polynomial = self.polynomial(|k| {
            let k: Vec<String> = k.iter().map(usize::to_string).collect();
            format!("c[..., {}]", k.join(", "))
        });
        out += &format!("    value = {}\n", in_parentheses(&polynomial, 4));
        let variables = self.variables();
        let value = variables.fold("value".to_owned(), |value, ([x, ..], ..)| {
            format!("{m}where({m}isnan({x}), {x}, {value})")
        });
        out + &format!("    return {value}\n")
    }

    pub fn symbolic(&self, function: &str) -> String {
        let search = piece_name(function);
        let mut out = format!("def {}({}):\n    \"\"\"{MEANING}\"\"\"\n", self.name, self.each("", "", ", "));
        for ([x, ..], starts, _) in self.variables() {
            out += &format!("    {x}_start = {}\n", wrapped(&numbers(starts), 8).trim_start());
        }
        out += &format!("    coefficients = {}\n\n", self.lists(4));
        out += &format!("    def value({}):\n", self.indices("", "", ", "));
        for ([x, d, i], starts, _) in self.variables().filter(|v| v.2 > 1) {
            let last = starts.len();
            out += &format!("        {d} = {x} - {x}_start[{i} - 1] if 0 < {i} < {last} else 0.0\n");
        }
        out += &format!("        c = coefficients{}\n", self.indices("[", "]", ""));
        let polynomial = self.polynomial(|k| format!("c{}", brackets(k)));
        out += &format!("        return {}\n\n", in_parentheses(&polynomial, 8));
        out + &match self.terms.len() {
            1 => format!("    return {search}(x, x_start, value)\n"),
            _ => format!(
                "    def along_y(i):\n        return {search}(y, y_start, lambda j: value(i, j))\n\n    \
                 return {search}(x, x_start, along_y)\n"
            ),
        }
    }
}

fn brackets(indices: &[usize]) -> String {
    indices.iter().map(|i| format!("[{i}]")).collect()
}

fn in_parentheses(text: &str, indent: usize) -> String {
    if text.len() < 80 {
        return text.to_owned();
    }
    format!("(\n{}\n{:indent$})", wrapped(text, indent + 4), "")
}

/// a + d*(b + d*c)
fn horner(mut coefficients: Vec<String>, variable: &str) -> String {
    let mut out = coefficients.pop().unwrap_or_default();
    let mut lone = true;
    while let Some(c) = coefficients.pop() {
        out = if lone { format!("{c} + {variable}*{out}") } else { format!("{c} + {variable}*({out})") };
        lone = false;
    }
    out
}

/// How many coefficients are needed: those behind the last that is not zero everywhere are not.
fn count<'a>(rows: impl Iterator<Item = &'a [f64; 4]>) -> usize {
    rows.map(|row| row.iter().rposition(|c| *c != 0.0).map_or(1, |last| last + 1)).max().unwrap_or(1)
}
