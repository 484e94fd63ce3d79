//! Raises the typed exceptions that `freebody.errors` defines.

use pyo3::prelude::*;
use pyo3::types::PyType;

/// An exception of `freebody.errors` by its name.
fn raise(py: Python<'_>, class: &str, message: String) -> PyErr {
    let found = py.import("freebody.errors").and_then(|m| m.getattr(class));
    match found.and_then(|c| Ok(c.cast_into::<PyType>()?)) {
        Ok(class) => PyErr::from_type(class, message),
        Err(error) => error,
    }
}

/// A wrong argument.
pub fn input(py: Python<'_>, message: String) -> PyErr {
    raise(py, "InputError", message)
}

/// A body that cannot exist.
pub fn body(py: Python<'_>, message: String) -> PyErr {
    raise(py, "BodyError", message)
}

/// Angles asked for where they do not exist.
pub fn singular_chart(py: Python<'_>, message: String) -> PyErr {
    raise(py, "SingularChartError", message)
}

/// A derivative that is not finite.
pub fn non_finite(py: Python<'_>, message: String) -> PyErr {
    raise(py, "NonFiniteError", message)
}
