//! Arrays of numbers from Python: at once when they are what is wanted, else checked and converted there.

use numpy::ndarray::ArrayView2;
use numpy::npyffi::{
    NPY_ARRAY_ALIGNED, NPY_ARRAY_C_CONTIGUOUS, NPY_ARRAY_WRITEABLE, NPY_ORDER, PY_ARRAY_API, PyArrayObject,
    npy_intp,
};
use numpy::{
    PyArray1, PyArray2, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray,
    PyUntypedArrayMethods, dtype,
};
use pyo3::PyTypeInfo;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt};
use std::borrow::Cow;

/// One finite number. A truth value, an int to Python, is none.
#[inline]
pub fn number(name: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    match plain_number(value) {
        Some(x) => Ok(x),
        None => other_number(name, value),
    }
}

/// The same of what is a float and nothing else.
#[inline]
pub fn plain_number(value: &Bound<'_, PyAny>) -> Option<f64> {
    if !value.is_exact_instance_of::<PyFloat>() {
        return None;
    }
    value.extract::<f64>().ok().filter(|x| x.is_finite())
}

#[cold]
fn other_number(name: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    let plain = value.is_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>();
    if plain
        && let Ok(x) = value.extract::<f64>()
        && x.is_finite()
    {
        return Ok(x);
    }
    value.py().import("freebody._check")?.call_method1("number", (name, value))?.extract()
}

/// Whether numbers are finite; few are best taken by four, many by sixteen.
#[inline]
pub fn are_finite<const WIDTH: usize>(numbers: &[f64]) -> bool {
    // By their sums, for what is not, is not zero times zero either; the parts are registers.
    let (parts, rest) = numbers.as_chunks::<WIDTH>();
    let mut sums = [0.0; WIDTH];
    for part in parts {
        for (sum, v) in sums.iter_mut().zip(part) {
            *sum += v * 0.0;
        }
    }
    let sum: f64 = sums.iter().chain(rest).map(|v| v * 0.0).sum();
    sum == 0.0
}

/// The addresses of NumPy's type of arrays and of its type of doubles in the order of this machine.
static OWN: PyOnceLock<(usize, usize)> = PyOnceLock::new();

/// The numbers of an array, to be read before anything of Python's runs.
#[derive(Clone, Copy)]
struct Numbers<'a> {
    first: *mut f64,
    shape: &'a [npy_intp],
    flags: i32,
}

impl<'a> Numbers<'a> {
    fn count(self) -> usize {
        self.shape.iter().product::<npy_intp>().unsigned_abs()
    }

    fn has_shape(self, shape: &[usize]) -> bool {
        self.shape.len() == shape.len() && self.shape.iter().zip(shape).all(|(a, b)| a.unsigned_abs() == *b)
    }

    fn slice(self) -> &'a [f64] {
        if self.count() == 0 {
            return &[];
        }
        // SAFETY: as many aligned doubles follow one another there; the interpreter is held, and nothing of Python's
        // runs while the slice is read.
        unsafe { std::slice::from_raw_parts(self.first, self.count()) }
    }
}

/// The numbers of an array of doubles, contiguous, that has an axis; not of a subclass, which may mean more than its
/// numbers: a masked array does.
#[inline]
fn plain<'a>(value: &'a Bound<'_, PyAny>) -> Option<Numbers<'a>> {
    let own = || {
        let py = value.py();
        (PyUntypedArray::type_object_raw(py) as usize, dtype::<f64>(py).as_dtype_ptr() as usize)
    };
    let (array, double) = *OWN.get_or_init(value.py(), own);
    if value.get_type_ptr() as usize != array {
        return None;
    }
    // SAFETY: it is an array, and lives.
    let fields = unsafe { &(*value.as_ptr().cast::<PyArrayObject>()).fields };
    let wanted = NPY_ARRAY_C_CONTIGUOUS | NPY_ARRAY_ALIGNED;
    if fields.descr as usize != double || fields.flags & wanted != wanted || fields.nd == 0 {
        return None;
    }
    // SAFETY: an array has as many dimensions, and they do not change while nothing else runs.
    let shape = unsafe { std::slice::from_raw_parts(fields.dimensions, fields.nd.unsigned_abs() as usize) };
    Some(Numbers { first: fields.data.cast(), shape, flags: fields.flags })
}

/// The `n` numbers of a plain array, finite or not.
#[inline]
pub fn plain_vector<'a>(value: &'a Bound<'_, PyAny>, n: usize) -> Option<&'a [f64]> {
    plain(value).filter(|numbers| numbers.has_shape(&[n])).map(Numbers::slice)
}

/// The `n` finite numbers of a contiguous array of doubles; anything else goes through `freebody._check.vector`, which
/// converts it or raises the error that says what is allowed.
///
/// What is borrowed must be copied before anything of Python's runs.
#[inline]
pub fn read<'a>(name: &str, value: &'a Bound<'_, PyAny>, n: usize) -> PyResult<Cow<'a, [f64]>> {
    if let Some(numbers) = plain(value)
        && numbers.has_shape(&[n])
        && are_finite::<4>(numbers.slice())
    {
        return Ok(Cow::Borrowed(numbers.slice()));
    }
    convert(name, value, n).map(Cow::Owned)
}

#[cold]
fn convert(name: &str, value: &Bound<'_, PyAny>, n: usize) -> PyResult<Vec<f64>> {
    let checked = value.py().import("freebody._check")?.call_method1("vector", (name, value, n))?;
    copied(&checked)
}

/// A copy of an array (n,) of doubles.
pub fn copied(value: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    match plain(value) {
        Some(numbers) if numbers.shape.len() == 1 => Ok(numbers.slice().to_vec()),
        _ => Ok(value.cast::<PyArray1<f64>>()?.readonly().as_slice()?.to_vec()),
    }
}

/// A matrix as a new array.
pub fn matrix<'py>(
    py: Python<'py>,
    numbers: &[f64],
    [rows, columns]: [usize; 2],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let shaped = ArrayView2::from_shape([rows, columns], numbers);
    shaped.map(|view| PyArray2::from_array(py, &view)).map_err(|e| PyValueError::new_err(e.to_string()))
}

/// Room for results in an array that the caller brought, to be filled before anything else runs.
pub struct Room {
    first: *mut f64,
    count: usize,
}

impl Room {
    /// In a writeable contiguous array of doubles of this shape.
    #[inline]
    pub fn of(name: &str, out: &Bound<'_, PyAny>, shape: &[usize]) -> PyResult<Self> {
        if let Some(numbers) = plain(out)
            && numbers.has_shape(shape)
            && numbers.flags & NPY_ARRAY_WRITEABLE != 0
        {
            return Ok(Self { first: numbers.first, count: numbers.count() });
        }
        Self::of_another(name, out, shape)
    }

    /// In an array of a kind of its own.
    #[cold]
    fn of_another(name: &str, out: &Bound<'_, PyAny>, shape: &[usize]) -> PyResult<Self> {
        let wanted = NPY_ARRAY_WRITEABLE | NPY_ARRAY_ALIGNED | NPY_ARRAY_C_CONTIGUOUS;
        if let Ok(array) = out.cast::<PyArrayDyn<f64>>()
            && array.shape() == shape
            && flags(array) & wanted == wanted
        {
            return Ok(Self { first: array.data(), count: array.len() });
        }
        Err(refusal(name, out, Some(shape)))
    }

    /// Has a plain array (n,) filled by `f` from numbers with which it shares nothing; none of anything else.
    #[inline]
    pub fn fill<R>(
        out: &Bound<'_, PyAny>,
        n: usize,
        from: [&[f64]; 2],
        f: impl FnOnce([&[f64]; 2], &mut [f64]) -> R,
    ) -> Option<R> {
        let Numbers { first, flags, .. } = plain(out).filter(|numbers| numbers.has_shape(&[n]))?;
        let (start, end) = (first.cast_const(), first.wrapping_add(n).cast_const());
        let shared = from.iter().any(|from| from.as_ptr() < end && start < from.as_ptr_range().end);
        if shared || flags & NPY_ARRAY_WRITEABLE == 0 {
            return None;
        }
        // SAFETY: as many aligned doubles have room there, none of which is read; the interpreter is held, and nothing
        // of Python's runs while they are written.
        Some(f(from, unsafe { std::slice::from_raw_parts_mut(first, n) }))
    }

    /// Fills it.
    pub fn write(self, numbers: &[f64]) {
        assert_eq!(numbers.len(), self.count);
        // SAFETY: as many doubles have room there, and the interpreter has been held since; `numbers` are not the
        // array's, for no other borrows them than this file does.
        unsafe { self.first.copy_from_nonoverlapping(numbers.as_ptr(), self.count) }
    }
}

/// Why results cannot be written to `out`: it is no such array, or, without a shape, no pair of arrays.
pub fn refusal(name: &str, out: &Bound<'_, PyAny>, shape: Option<&[usize]>) -> PyErr {
    let check = out.py().import("freebody._check");
    match check.and_then(|check| check.call_method1("out_refusal", (name, out, shape.map(<[_]>::to_vec)))) {
        Ok(error) => PyErr::from_value(error),
        Err(error) => error,
    }
}

fn flags(array: &Bound<'_, PyArrayDyn<f64>>) -> i32 {
    // SAFETY: it points to a live array.
    unsafe { (*array.as_array_ptr()).fields.flags }
}

/// A copy, that nobody can change, of a contiguous array of doubles, one at least, all of them finite; none of anything
/// else.
#[pyfunction]
pub fn frozen<'py>(value: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyAny>>> {
    let usual = plain(value).is_some_and(|numbers| numbers.count() > 0 && are_finite::<16>(numbers.slice()));
    usual.then(|| frozen_copy(value)).transpose()
}

/// The same of times (n,) that rise, from `first` to `last` at most.
#[pyfunction]
pub fn rising<'py>(times: &Bound<'py, PyAny>, first: f64, last: f64) -> PyResult<Option<Bound<'py, PyAny>>> {
    let rise = |times: &[f64]| {
        let ends = times.first().zip(times.last());
        ends.is_some_and(|(a, b)| *a >= first && *b <= last) && times.is_sorted_by(|a, b| a < b)
    };
    let usual = plain(times).is_some_and(|numbers| numbers.shape.len() == 1 && rise(numbers.slice()));
    usual.then(|| frozen_copy(times)).transpose()
}

fn frozen_copy<'py>(array: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = array.py();
    // SAFETY: it is an array; what comes is a new one that nobody else has, or an error.
    unsafe {
        let copy = PY_ARRAY_API.PyArray_NewCopy(py, array.as_ptr().cast(), NPY_ORDER::NPY_CORDER);
        let copy = Bound::from_owned_ptr_or_err(py, copy)?;
        (*copy.as_ptr().cast::<PyArrayObject>()).fields.flags &= !NPY_ARRAY_WRITEABLE;
        Ok(copy)
    }
}
