//! Lines that people can read.

/// How long a line is at most, where it can be broken.
pub const WIDTH: usize = 100;

/// What cannot be broken goes into lines, of which the first and the others start as given.
///
/// A full line is broken where the fewest brackets are open.
fn filled(pieces: Vec<String>, first: &str, next: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = &pieces[..];
    let mut start = first;
    while !rest.is_empty() {
        let (mut length, mut depth) = (start.len(), 0);
        let (mut end, mut shallowest) = (rest.len(), i32::MAX);
        for (i, piece) in rest.iter().enumerate() {
            if i > 0 && depth <= shallowest {
                (end, shallowest) = (i, depth);
            }
            length += piece.len() + usize::from(i > 0);
            if i > 0 && length > WIDTH {
                break;
            }
            if i + 1 == rest.len() {
                end = rest.len();
            }
            depth +=
                piece.chars().map(|c| i32::from("([".contains(c)) - i32::from(")]".contains(c))).sum::<i32>();
        }
        lines.push(format!("{start}{}", rest[..end].join(" ")));
        rest = &rest[end..];
        start = next;
    }
    lines
}

/// An expression, broken at spaces and before operators.
pub fn wrapped(text: &str, indent: usize) -> String {
    let mut pieces: Vec<String> = Vec::new();
    let mut operator = String::new();
    for word in text.split(' ') {
        if matches!(word, "+" | "-" | "<=" | "?" | ":") {
            operator = format!("{word} ");
        } else {
            pieces.push(std::mem::take(&mut operator) + word);
        }
    }
    let indent = " ".repeat(indent);
    filled(pieces, &indent, &indent).join("\n")
}

/// A line of a comment; a symbol stays with its unit, which stands in brackets.
pub fn comment(line: &str, before: &str) -> String {
    let text = line.trim_start();
    let mut pieces: Vec<String> = Vec::new();
    let mut open = false;
    for word in text.split(' ') {
        match pieces.last_mut() {
            Some(piece) if open || word.starts_with('[') => *piece += &format!(" {word}"),
            _ => pieces.push(word.to_owned()),
        }
        open = (open || word.contains('[')) && !word.contains(']');
    }
    let first = format!("{before}{}", &line[..line.len() - text.len()]);
    let lines = filled(pieces, &first, &format!("{first}  "));
    let ends: Vec<&str> = lines.iter().map(|l| l.trim_end()).collect();
    ends.join("\n")
}

/// Rows in brackets, one a line; long ones are broken.
pub fn rows(rows: &[String], indent: usize) -> String {
    let lines: String =
        rows.iter().map(|row| format!("\n{}", wrapped(&format!("{row},"), indent + 4))).collect();
    format!("[{lines}\n{:indent$}]", "")
}

/// Numbers in brackets that read back as the same doubles.
pub fn numbers(x: &[f64]) -> String {
    let all: Vec<String> = x.iter().map(|x| format!("{x:?}")).collect();
    format!("[{}]", all.join(", "))
}
