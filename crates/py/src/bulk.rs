//! f and its Jacobians at many states at once.

use crate::errors;
use crate::model::Model;
use freebody_core::bulk::Points;
use freebody_core::evaluate::Evaluator;
use numpy::{
    PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

/// An array of doubles, contiguous, of one of the shapes; others are converted or refused.
fn numbers<'py>(
    name: &str,
    value: &Bound<'py, PyAny>,
    allowed: &[&[usize]],
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let array = match value.extract::<PyReadonlyArrayDyn<'py, f64>>() {
        Ok(array) if array.is_c_contiguous() => array,
        _ => {
            let py = value.py();
            let made = py.import("numpy")?.call_method1("ascontiguousarray", (value, "float64"));
            let refusal = |_| errors::input(py, format!("{name}: want numbers"));
            made.map_err(refusal)?.extract::<PyReadonlyArrayDyn<'py, f64>>()?
        }
    };
    if allowed.contains(&array.shape()) {
        return Ok(array);
    }
    let allowed: Vec<String> = allowed.iter().map(|shape| format!("{shape:?}")).collect();
    let message = format!("{name}: got shape {:?}; allowed is {}", array.shape(), allowed.join(" or "));
    Err(errors::input(value.py(), message))
}

/// The array that the caller brought for the result.
fn room<'py>(out: &Bound<'py, PyAny>, shape: &[usize]) -> PyResult<PyReadwriteArrayDyn<'py, f64>> {
    let message = || {
        let want = format!("a writeable, contiguous float64 array of shape {shape:?}");
        errors::input(out.py(), format!("out: want {want}"))
    };
    let array: PyReadwriteArrayDyn<'py, f64> = out.extract().map_err(|_| message())?;
    if array.shape() == shape && array.is_c_contiguous() { Ok(array) } else { Err(message()) }
}

/// Time, states, inputs, and where the result is wanted.
type Given<'a, 'py> = (
    &'a Bound<'py, PyAny>,
    &'a Bound<'py, PyAny>,
    Option<&'a Bound<'py, PyAny>>,
    Option<&'a Bound<'py, PyAny>>,
);
type Fill = fn(&Evaluator, &Points<'_>, &mut [f64], usize);

impl Model {
    /// Fills `out`, or a new array, of `shape` but for its last axis, the points.
    fn at_points<'py>(
        &self,
        fill: Fill,
        shape: &[usize],
        (t, x, u, out): Given<'_, 'py>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = x.py();
        let (states, inputs) = (self.states, self.inputs);
        let count = x.cast::<PyUntypedArray>().ok().and_then(|x| x.shape().get(1).copied());
        let Some(count) = count else {
            return Err(errors::input(py, format!("x: want an array ({states}, n), a state a column")));
        };
        let x = numbers("x", x, &[&[states, count]])?;
        let t = numbers("t", t, &[&[], &[1], &[count]])?;
        let u = u.map(|u| numbers("u", u, &[&[inputs], &[inputs, count]])).transpose()?;
        let zeros = vec![0.0; inputs];
        let points = Points {
            count,
            t: t.as_slice()?,
            x: x.as_slice()?,
            u: match &u {
                Some(u) => u.as_slice()?,
                None => &zeros,
            },
            inputs,
        };
        let threads =
            if threads > 0 { threads } else { std::thread::available_parallelism().map_or(1, usize::from) };
        let shape = [shape, &[count]].concat();
        // What Python computes is asked on this thread.
        let threads = if self.has_callback() { 1 } else { threads };
        let go = |to: &mut [f64]| py.detach(|| self.calling(|| fill(&self.evaluator, &points, to, threads)));
        if let Some(out) = out {
            go(room(out, &shape)?.as_slice_mut()?)?;
            return Ok(out.clone());
        }
        let mut made = vec![0.0; shape.iter().product()];
        go(&mut made)?;
        let flat = PyArray1::from_vec(py, made);
        Ok(match shape[..] {
            [a, b] => flat.reshape([a, b])?.into_any(),
            _ => flat.reshape([shape[0], shape[1], count])?.into_any(),
        })
    }
}

#[pymethods]
impl Model {
    /// f(x, u, t) at many states, a state a column. Konoplev (3.2).
    ///
    /// Nothing is checked but shapes: where f does not exist its values are not finite.
    ///
    /// Parameters
    /// ----------
    /// t
    ///     Time, s: one for all or (n,).
    /// x
    ///     States, (n_states, n).
    /// u
    ///     Inputs, (n_inputs,) for all or (n_inputs, n); zero when omitted.
    /// out
    ///     Where to write the result, (n_states, n) float64, contiguous; a new array when omitted.
    /// threads
    ///     How many; 0 for all.
    #[pyo3(signature = (t, x, u=None, out=None, threads=1))]
    fn derivative_batch<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.at_points(Evaluator::derivatives, &[self.states], (t, x, u, out), threads)
    }

    /// The exact Jacobians (∂f/∂x ∂f/∂u) at many states, (n_states, n_states + n_inputs, n). Konoplev (3.2).
    ///
    /// Arguments as of `derivative_batch`; `out` has the shape of the result.
    #[pyo3(signature = (t, x, u=None, out=None, threads=1))]
    fn jacobian_batch<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.refuse_callbacks(x.py())?;
        let (n, m) = (self.states, self.inputs);
        self.at_points(Evaluator::jacobians, &[n, n + m], (t, x, u, out), threads)
    }
}
