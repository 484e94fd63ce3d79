//! Arrays of numbers from Python: at once when they are what is wanted, else checked and converted there.

use numpy::npyffi::NPY_ARRAY_WRITEABLE;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
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

/// Copies a contiguous array of as many doubles as there is room for; anything else goes through
/// `freebody._check.vector`, which converts it or raises the error that says what is allowed.
///
/// They are copied, so that nothing of Python's is borrowed while laws run.
pub fn read(name: &str, value: &Bound<'_, PyAny>, to: &mut [f64]) -> PyResult<()> {
    // A subclass may mean more than its numbers: a masked array does.
    if value.is_exact_instance_of::<PyUntypedArray>()
        && let Ok(array) = value.cast::<PyArray1<f64>>()
        && array.len() == to.len()
        // SAFETY: the interpreter is held, and nothing but a copy happens while the slice lives.
        && let Ok(numbers) = unsafe { array.as_slice() }
    {
        to.copy_from_slice(numbers);
        if to.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
    }
    let checked = value.py().import("freebody._check")?.call_method1("vector", (name, value, to.len()))?;
    to.copy_from_slice(checked.cast::<PyArray1<f64>>()?.readonly().as_slice()?);
    Ok(())
}

/// Writes numbers to the array that the caller brought.
pub fn write_out<'py>(out: &Bound<'py, PyAny>, numbers: &[f64]) -> PyResult<Bound<'py, PyArray1<f64>>> {
    if let Ok(array) = out.cast::<PyArray1<f64>>()
        && array.len() == numbers.len()
        && is_writeable(array)
        // SAFETY: the interpreter is held, nothing but a copy happens while the slice lives, and the numbers are not
        // the array's.
        && let Ok(to) = unsafe { array.as_slice_mut() }
    {
        to.copy_from_slice(numbers);
        return Ok(array.clone());
    }
    let refusal = out.py().import("freebody._check")?.call_method1("out_refusal", (out, numbers.len()))?;
    Err(PyErr::from_value(refusal))
}

fn is_writeable(array: &Bound<'_, PyArray1<f64>>) -> bool {
    // SAFETY: it points to a live array.
    unsafe { (*array.as_array_ptr()).fields.flags & NPY_ARRAY_WRITEABLE != 0 }
}
