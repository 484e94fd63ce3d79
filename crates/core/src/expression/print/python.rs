//! A function in Python, over NumPy, JAX, CasADi or SymPy.

use super::code::{Language, Writer};
use super::layout::{WIDTH, comment, wrapped};
use super::shared::Shared;
use super::{Function, table};

/// The text of a function.
pub fn function(f: &Function<'_>, language: Language) -> String {
    let entries = f.entries();
    let shared = Shared::of(f.graph, &entries);
    let writer = Writer { graph: f.graph, language, shared: &shared, function: f.name };
    let tables = table::definitions(f.graph, f.name, language, &entries);
    let import = match language {
        // The data of tables.
        Language::Jax if !tables.is_empty() => "import jax.numpy as jnp\nimport numpy as np",
        Language::Jax => "import jax.numpy as jnp",
        Language::CasAdi => "import casadi as ca",
        Language::SymPy => "import sympy as sp",
        _ => "import numpy as np",
    };
    let mut out = match (tables.is_empty(), language) {
        (true, _) => format!("{import}\n\n\n"),
        // Data follows, not a function.
        (false, Language::NumPy | Language::Jax) => format!("{import}\n\n{tables}\n\n"),
        (false, _) => format!("{import}\n\n\n{tables}\n\n"),
    };
    let names: Vec<&str> = f.groups.iter().map(|g| g.name.as_str()).collect();
    out += &format!("def {}({}):\n    \"\"\"", f.name, names.join(", "));
    for (i, line) in f.comment.iter().enumerate() {
        let text = comment(line, "    ");
        out += if i == 0 { text.trim_start() } else { &text };
        out.push('\n');
    }
    out += "    \"\"\"\n";
    for group in f.groups {
        let symbols: Vec<String> = group.symbols.iter().map(|id| writer.expression(*id)).collect();
        let values = match language {
            Language::CasAdi if !group.scalar => format!("ca.vertsplit({})", group.name),
            _ => group.name.clone(),
        };
        let comma = if symbols.len() == 1 && !group.scalar { "," } else { "" };
        let to = format!("{}{comma}", symbols.join(", "));
        if to.len() + values.len() + 7 > WIDTH {
            out += &format!("    (\n{},\n    ) = {values}\n", wrapped(&to, 8));
        } else if to != values && !symbols.is_empty() {
            out += &format!("    {to} = {values}\n");
        }
    }
    for (place, id) in shared.order.iter().enumerate() {
        let (name, text) = (Writer::name(place), writer.definition(*id));
        if name.len() + text.len() + 7 > WIDTH {
            out += &format!("    {name} = (\n{}\n    )\n", wrapped(&text, 8));
        } else {
            out += &format!("    {name} = {text}\n");
        }
    }
    for o in f.outputs {
        let entries: Vec<String> = o.entries.iter().map(|id| writer.expression(*id)).collect();
        out += &array(language, &o.name, &entries, o.columns);
    }
    let results: Vec<&str> = f.outputs.iter().map(|o| o.name.as_str()).collect();
    out + &format!("    return {}\n", results.join(", "))
}

/// Entries as a vector, or as a matrix by rows; numbers may have trailing dimensions.
fn array(language: Language, name: &str, entries: &[String], columns: Option<usize>) -> String {
    let rows = columns.map_or(0, |c| entries.len() / c);
    let lines = lines(entries, columns);
    match (language, columns) {
        (Language::SymPy, None) => format!("    {name} = sp.Matrix([{lines}])\n"),
        (Language::SymPy, Some(c)) => format!("    {name} = sp.Matrix({rows}, {c}, [{lines}])\n"),
        (Language::CasAdi, None) => format!("    {name} = ca.vertcat({lines})\n"),
        // By columns, as CasADi keeps matrices.
        (Language::CasAdi, Some(c)) => {
            format!("    {name} = ca.reshape(ca.vertcat({lines}), {c}, {rows}).T\n")
        }
        (_, columns) => {
            let module = language.module();
            let stack = format!("    {name} = {module}stack({module}broadcast_arrays({lines}))\n");
            match columns {
                None => stack,
                // The trailing dimensions stay.
                Some(c) => {
                    format!("{stack}    {name} = {name}.reshape({rows}, {c}, *{name}.shape[1:])\n")
                }
            }
        }
    }
}

/// The entries one a line; short rows of a matrix one a line.
fn lines(entries: &[String], columns: Option<usize>) -> String {
    let mut out = String::from("\n");
    for row in entries.chunks(columns.unwrap_or(1)) {
        let line = row.join(", ");
        if line.len() + 9 <= WIDTH {
            out += &format!("        {line},\n");
        } else {
            for e in row {
                out += &format!("{},\n", wrapped(e, 8));
            }
        }
    }
    out + "    "
}
