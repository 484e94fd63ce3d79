//! Arrays of numbers from Python: at once when they are what is wanted, else checked and converted there.

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt};

/// One finite number. A truth value, an int to Python, is none.
pub fn number(name: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    let plain = value.is_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>();
    if plain
        && let Ok(x) = value.extract::<f64>()
        && x.is_finite()
    {
        return Ok(x);
    }
    value.py().import("freebody._check")?.call_method1("number", (name, value))?.extract()
}

/// A contiguous array of `n` doubles; anything else goes through `freebody._check.vector`, which converts
/// it or raises the error that says what is allowed.
pub fn vector<'py>(name: &str, value: &Bound<'py, PyAny>, n: usize) -> PyResult<PyReadonlyArray1<'py, f64>> {
    // A subclass may mean more than its numbers: a masked array does.
    if value.is_exact_instance_of::<PyUntypedArray>()
        && let Ok(array) = value.cast::<PyArray1<f64>>()
        && array.len() == n
        && let Ok(read) = array.try_readonly()
        && read.as_slice().is_ok_and(|s| s.iter().all(|v| v.is_finite()))
    {
        return Ok(read);
    }
    let checked = value.py().import("freebody._check")?.call_method1("vector", (name, value, n))?;
    Ok(checked.cast::<PyArray1<f64>>()?.readonly())
}

/// Writes numbers to the array that the caller brought.
pub fn write_out<'py>(out: &Bound<'py, PyAny>, numbers: &[f64]) -> PyResult<Bound<'py, PyArray1<f64>>> {
    if let Ok(array) = out.cast::<PyArray1<f64>>()
        && array.len() == numbers.len()
        && let Ok(mut write) = array.try_readwrite()
        && let Ok(to) = write.as_slice_mut()
    {
        to.copy_from_slice(numbers);
        return Ok(array.clone());
    }
    let refusal = out.py().import("freebody._check")?.call_method1("out_refusal", (out, numbers.len()))?;
    Err(PyErr::from_value(refusal))
}
