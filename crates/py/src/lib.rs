//! The Python face of freebody-core: converts and calls, no formula.

mod arguments;
mod body;
mod diagnosis;
mod errors;
mod forces;
mod forms;
mod model;
mod simulate;
mod toml_spans;

use pyo3::prelude::*;

/// The compiled part of freebody.
#[pymodule]
fn _core(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add_class::<body::RigidBody>()?;
    m.add_class::<forces::Force>()?;
    m.add_class::<model::Model>()?;
    m.add_class::<simulate::RunResult>()?;
    m.add_function(wrap_pyfunction!(forms::form, m)?)?;
    m.add_function(wrap_pyfunction!(simulate::simulate, m)?)?;
    m.add_function(wrap_pyfunction!(toml_spans::toml_parse, m)?)?;
    Ok(())
}
