//! A function in C99 over many columns at once: what is compiled and loaded.

use super::code::{Language, Writer};
use super::shared::{Shared, symbols_in};
use super::{Function, table};
use std::fmt::Write;

/// The text of a function `void name(size_t n, const double *given, double *out)`.
///
/// `given` holds `n` columns of each symbol, one symbol after another, and `out` of each entry. One column is
/// computed by code of its own, so that a compiler can put several into the lanes of its registers otherwise.
pub fn function(f: &Function<'_>) -> String {
    let entries = f.entries();
    let shared = Shared::of(f.graph, &entries);
    let writer = Writer { graph: f.graph, language: Language::C, shared: &shared, function: f.name };
    let used = symbols_in(f.graph, &entries);
    let mut out = String::from("#include <math.h>\n#include <stddef.h>\n\n");
    out += &table::definitions(f.graph, f.name, Language::C, &entries);
    let arguments = "const double *restrict given, double *restrict out";
    _ = writeln!(out, "static inline void column(size_t n, size_t l, {arguments})\n{{");
    let symbols = f.groups.iter().flat_map(|g| &g.symbols);
    for (i, id) in symbols.enumerate().filter(|(_, id)| used.contains(id)) {
        _ = writeln!(out, "    const double {} = given[{i} * n + l];", writer.expression(*id));
    }
    for (place, id) in shared.order.iter().enumerate() {
        _ = writeln!(out, "    const double {} = {};", Writer::name(place), writer.definition(*id));
    }
    for (i, id) in entries.iter().enumerate() {
        _ = writeln!(out, "    out[{i} * n + l] = {};", writer.expression(*id));
    }
    if used.is_empty() {
        out += "    (void)given;\n";
    }
    _ = write!(
        out,
        "}}\n\nvoid {}(size_t n, {arguments});\nvoid {0}(size_t n, {arguments})\n{{\n    if (n == 1) {{\n        \
         column(1, 0, given, out);\n        return;\n    }}\n    for (size_t l = 0; l < n; ++l)\n        \
         column(n, l, given, out);\n}}\n",
        f.name
    );
    out
}
