//! TOML with the line of every key, so that an error in a model file can say where it stands.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Parses a TOML text.
///
/// Returns (data, lines): the nested dict, and the 1-based line of every key path such as `body.mass` or
/// `forces[0].moment[2]`. Raises `ValueError(message, line)` for a syntax error.
#[pyfunction]
pub fn toml_parse<'py>(py: Python<'py>, text: &str) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
    let table = DeTable::parse(text).map_err(|error| {
        let line = line_at(text, error.span().map_or(0, |span| span.start));
        PyValueError::new_err((error.message().to_owned(), line))
    })?;
    let reader = Reader { py, text, lines: PyDict::new(py) };
    let data = reader.table(table.get_ref(), "")?;
    Ok((data, reader.lines))
}

fn line_at(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

struct Reader<'a, 'py> {
    py: Python<'py>,
    text: &'a str,
    lines: Bound<'py, PyDict>,
}

impl<'py> Reader<'_, 'py> {
    fn mark(&self, path: &str, offset: usize) -> PyResult<()> {
        self.lines.set_item(path, line_at(self.text, offset))
    }

    fn table(&self, table: &DeTable<'_>, path: &str) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(self.py);
        for (key, value) in table.iter() {
            let name = key.get_ref().as_ref();
            let path = if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
            self.mark(&path, key.span().start)?;
            dict.set_item(name, self.value(value, &path)?)?;
        }
        Ok(dict)
    }

    fn value(&self, value: &Spanned<DeValue<'_>>, path: &str) -> PyResult<Bound<'py, PyAny>> {
        let py = self.py;
        Ok(match value.get_ref() {
            DeValue::String(text) => text.into_pyobject(py)?.into_any(),
            DeValue::Boolean(truth) => truth.into_pyobject(py)?.to_owned().into_any(),
            DeValue::Datetime(moment) => moment.to_string().into_pyobject(py)?.into_any(),
            // Python's own readers: integers of any length, and one rounding of decimal text to double.
            DeValue::Integer(number) => {
                py.import("builtins")?.getattr("int")?.call1((number.as_str(), number.radix()))?
            }
            DeValue::Float(number) => py.import("builtins")?.getattr("float")?.call1((number.as_str(),))?,
            DeValue::Array(array) => {
                let list = PyList::empty(py);
                for (index, element) in array.iter().enumerate() {
                    let path = format!("{path}[{index}]");
                    self.mark(&path, element.span().start)?;
                    list.append(self.value(element, &path)?)?;
                }
                list.into_any()
            }
            DeValue::Table(table) => self.table(table, path)?.into_any(),
        })
    }
}
