//! Arrays of numbers from Python: at once when they are what is wanted, else checked and converted there.

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// A contiguous array of `n` doubles; anything else goes through `freebody._check.vector`, which converts
/// it or raises the error that says what is allowed.
pub fn vector<'py>(name: &str, value: &Bound<'py, PyAny>, n: usize) -> PyResult<PyReadonlyArray1<'py, f64>> {
    if let Ok(array) = value.cast::<PyArray1<f64>>()
        && array.len() == n
        && let Ok(read) = array.try_readonly()
        && read.as_slice().is_ok_and(|s| s.iter().all(|v| v.is_finite()))
    {
        return Ok(read);
    }
    let checked = value.py().import("freebody._check")?.call_method1("vector", (name, value, n))?;
    Ok(checked.cast::<PyArray1<f64>>()?.readonly())
}
