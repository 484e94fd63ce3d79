//! The Python face of freebody-core: converts and calls, no formula.

mod arguments;
mod body;
mod bulk;
mod compiled;
mod diagnosis;
mod ensemble;
mod equations;
mod errors;
mod evaluate;
mod forces;
mod forms;
mod graph;
mod laws;
mod left;
mod model;
mod simulate;
mod tables;
mod toml_spans;
mod watch;

use pyo3::prelude::*;

/// The compiled part of freebody.
#[pymodule]
fn _core(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add_class::<body::RigidBody>()?;
    m.add_class::<forces::Force>()?;
    m.add_class::<compiled::Compiled>()?;
    m.add_class::<graph::Graph>()?;
    m.add_class::<graph::Program>()?;
    m.add_class::<laws::Control>()?;
    m.add_class::<model::Model>()?;
    m.add_class::<simulate::RunResult>()?;
    m.add_class::<ensemble::EnsembleResult>()?;
    m.add_class::<tables::Table>()?;
    m.add_class::<tables::Grid>()?;
    m.add_class::<tables::Lattice>()?;
    m.add_function(wrap_pyfunction!(arguments::frozen, m)?)?;
    m.add_function(wrap_pyfunction!(arguments::rising, m)?)?;
    m.add_function(wrap_pyfunction!(forms::form, m)?)?;
    m.add_function(wrap_pyfunction!(simulate::simulate, m)?)?;
    m.add_function(wrap_pyfunction!(ensemble::run_ensemble, m)?)?;
    m.add_function(wrap_pyfunction!(toml_spans::toml_parse, m)?)?;
    Ok(())
}
