//! A function in C99 that needs nothing but the C library.

use super::code::{Language, Writer};
use super::layout::{WIDTH, comment, wrapped};
use super::shared::{Shared, symbols_in};
use super::{Function, Group, table};

/// The text of a function.
pub fn function(f: &Function<'_>) -> String {
    let entries = f.entries();
    let shared = Shared::of(f.graph, &entries);
    let writer = Writer { graph: f.graph, language: Language::C, shared: &shared, function: f.name };
    let used = symbols_in(f.graph, &entries);
    let mut out = String::from("#include <math.h>\n");
    out += &table::definitions(f.graph, f.name, Language::C, &entries);
    out += "\n/*\n";
    for line in f.comment {
        out += &format!("{}\n", comment(line, " * "));
    }
    out += " */\n";
    let given = f.groups.iter().map(|g| match g.scalar {
        true => format!("    const double {}", argument(g)),
        false => format!("    const double {}[{}]", argument(g), g.symbols.len()),
    });
    let results = f.outputs.iter().map(|o| format!("    double {}_[{}]", o.name, o.entries.len()));
    let arguments: Vec<String> = given.chain(results).collect();
    out += &format!("void {}(\n{})\n{{\n", f.name, arguments.join(",\n"));
    for group in f.groups {
        let mut unused = true;
        for (i, id) in group.symbols.iter().enumerate() {
            if used.contains(id) {
                unused = false;
                let place = if group.scalar { argument(group) } else { format!("{}[{i}]", argument(group)) };
                out += &statement(&format!("const double {}", writer.expression(*id)), &place);
            }
        }
        if unused {
            out += &format!("    (void){};\n", argument(group));
        }
    }
    for (place, id) in shared.order.iter().enumerate() {
        out += &statement(&format!("const double {}", Writer::name(place)), &writer.definition(*id));
    }
    for o in f.outputs {
        for (i, id) in o.entries.iter().enumerate() {
            out += &statement(&format!("{}_[{i}]", o.name), &writer.expression(*id));
        }
    }
    out + "}\n"
}

fn statement(left: &str, right: &str) -> String {
    let line = format!("    {left} = {right};\n");
    if line.len() <= WIDTH + 1 { line } else { format!("    {left} =\n{};\n", wrapped(right, 8)) }
}

/// The name of an argument: no symbol ends so.
fn argument(group: &Group) -> String {
    format!("{}_", group.name)
}
