//! f and its Jacobians at many states at once.

use crate::errors;
use crate::model::Model;
use freebody_core::bulk::Points;
use freebody_core::evaluate::Evaluator;
use numpy::{
    PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::PyFloat;

/// Fewer states are done before another Python thread would be awake.
const FEW: usize = 256;

/// So many zeros stand for inputs without room of their own.
const ZEROS: [f64; 32] = [0.0; 32];

/// Numbers from Python: one, or those of an array that is borrowed.
enum Numbers<'py> {
    One([f64; 1]),
    Array(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> Numbers<'py> {
    /// Of an array of doubles, contiguous, of one of the shapes; others are converted or refused.
    fn of(name: &str, value: &Bound<'py, PyAny>, allowed: &[&[usize]]) -> PyResult<Self> {
        if let Ok(one) = value.cast_exact::<PyFloat>()
            && allowed.contains(&&[][..])
        {
            return Ok(Self::One([one.value()]));
        }
        let array = match value.cast::<PyArrayDyn<f64>>() {
            Ok(array) if array.is_c_contiguous() => array.readonly(),
            _ => {
                let py = value.py();
                let made = py.import("numpy")?.call_method1("ascontiguousarray", (value, "float64"));
                let refusal = |_| errors::input(py, format!("{name}: want numbers"));
                made.map_err(refusal)?.extract::<PyReadonlyArrayDyn<'py, f64>>()?
            }
        };
        if allowed.contains(&array.shape()) {
            return Ok(Self::Array(array));
        }
        let allowed: Vec<String> = allowed.iter().map(|shape| format!("{shape:?}")).collect();
        let message = format!("{name}: got shape {:?}; allowed is {}", array.shape(), allowed.join(" or "));
        Err(errors::input(value.py(), message))
    }

    fn slice(&self) -> PyResult<&[f64]> {
        Ok(match self {
            Self::One(one) => one,
            Self::Array(array) => array.as_slice()?,
        })
    }
}

/// The array that the caller brought for the result: of `shape`, with the points behind it.
fn room<'py>(
    out: &Bound<'py, PyAny>,
    shape: &[usize],
    count: usize,
) -> PyResult<PyReadwriteArrayDyn<'py, f64>> {
    if let Ok(array) = out.cast::<PyArrayDyn<f64>>()
        && array.shape().split_last() == Some((&count, shape))
        && array.is_c_contiguous()
        && let Ok(room) = array.try_readwrite()
    {
        return Ok(room);
    }
    let shape = [shape, &[count]].concat();
    let want = format!("a writeable, contiguous float64 array of shape {shape:?}");
    Err(errors::input(out.py(), format!("out: want {want}")))
}

/// Time, states, inputs, and where the result is wanted.
type Given<'a, 'py> = (
    &'a Bound<'py, PyAny>,
    &'a Bound<'py, PyAny>,
    Option<&'a Bound<'py, PyAny>>,
    Option<&'a Bound<'py, PyAny>>,
);
type Places<'py> = Bound<'py, PyArray1<i64>>;
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
        let x = Numbers::of("x", x, &[&[states, count]])?;
        let t = Numbers::of("t", t, &[&[], &[1], &[count]])?;
        let u = u.map(|u| Numbers::of("u", u, &[&[inputs], &[inputs, count]])).transpose()?;
        let zeros;
        let u = match &u {
            Some(u) => u.slice()?,
            None if inputs <= ZEROS.len() => &ZEROS[..inputs],
            None => {
                zeros = vec![0.0; inputs];
                &zeros
            }
        };
        let points = Points { count, t: t.slice()?, x: x.slice()?, u, inputs };
        // What Python computes is asked on this thread.
        let threads = match threads {
            _ if self.has_callback() => 1,
            0 => std::thread::available_parallelism().map_or(1, usize::from),
            given => given,
        };
        let go = |to: &mut [f64]| self.calling(|| fill(&self.evaluator, &points, to, threads));
        let go = |to: &mut [f64]| if count < FEW { go(to) } else { py.detach(|| go(to)) };
        if let Some(out) = out {
            go(room(out, shape, count)?.as_slice_mut()?)?;
            return Ok(out.clone());
        }
        let made = PyArrayDyn::<f64>::zeros(py, [shape, &[count]].concat(), false);
        go(made.readwrite().as_slice_mut()?)?;
        Ok(made.into_any())
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
    /// Arguments as of `derivative_batch`; `out` has the shape of the result. With `sparse` only the entries that
    /// `jacobian_entries` names are computed, in that order: (n_entries, n).
    #[pyo3(signature = (t, x, u=None, out=None, threads=1, sparse=false))]
    fn jacobian_batch<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
        threads: usize,
        sparse: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.refuse_callbacks(x.py())?;
        let (n, m) = (self.states, self.inputs);
        if sparse {
            let count = self.evaluator.jacobian_entries().map_or(n * (n + m), <[_]>::len);
            return self.at_points(Evaluator::sparse_jacobians, &[count], (t, x, u, out), threads);
        }
        self.at_points(Evaluator::jacobians, &[n, n + m], (t, x, u, out), threads)
    }

    /// Rows and columns, (n_entries,) each, of the entries of (∂f/∂x ∂f/∂u) that can be other than zero, by rows.
    ///
    /// All entries, unless the model is known to have others: with a quaternion and quasi-velocities, under uniform
    /// gravity, diagonal linear damping, and a constant wrench and inputs in body axes, one of each at most.
    #[getter]
    fn jacobian_entries<'py>(&self, py: Python<'py>) -> (Places<'py>, Places<'py>) {
        let width = self.states + self.inputs;
        let all = || (0..self.states * width).map(|place| (place / width, place % width)).collect();
        let entries = self.evaluator.jacobian_entries().map_or_else(all, <[_]>::to_vec);
        let (rows, columns): (Vec<_>, Vec<_>) =
            entries.into_iter().map(|(row, column)| (row as i64, column as i64)).unzip();
        (PyArray1::from_vec(py, rows), PyArray1::from_vec(py, columns))
    }
}
