//! f(x, u, t), its Jacobians and the wrench at single states.

use crate::arguments::{Room, are_finite, matrix, number, plain_number, plain_vector, read, refusal};
use crate::model::Model;
use freebody_core::buffer::Buffer;
use freebody_core::phase_space::STATES;
use freebody_core::screw::Screw;
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use std::borrow::Cow;
use std::cell::RefCell;

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Given<'a, 'py> = (&'a Bound<'py, PyAny>, &'a Bound<'py, PyAny>, Option<&'a Bound<'py, PyAny>>);

/// A rate of so many numbers needs no room of its own.
const ON_STACK: usize = 16;
/// Inputs that are left out, up to this many without room of their own.
static ZEROS: [f64; 64] = [0.0; 64];

thread_local! {
    /// Room for the matrices of a Jacobian, kept for the next one.
    static MATRICES: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

impl Model {
    /// Hands on time, state and inputs, zero when none are given.
    #[inline]
    fn at<R>(
        &self,
        (t, x, u): Given<'_, '_>,
        f: impl FnOnce(f64, &[f64], &[f64]) -> PyResult<R>,
    ) -> PyResult<R> {
        let t = number("t", t)?;
        let mut state = read("x", x, self.states)?;
        let mut input = match u {
            Some(u) => read("u", u, self.inputs)?,
            None => ZEROS.get(..self.inputs).map_or_else(|| vec![0.0; self.inputs].into(), Cow::Borrowed),
        };
        if matches!(input, Cow::Owned(_)) {
            // Python may have run, and moved what was borrowed.
            state = read("x", x, self.states)?;
        }
        if self.has_callback() {
            (state, input) = (state.into_owned().into(), input.into_owned().into());
        }
        f(t, &state, &input)
    }
}

impl Model {
    /// The derivative of a plain body at plain arrays, if all is as it should be: the questions that `Model::at` asks
    /// first are asked with the answer. None otherwise.
    #[inline]
    fn plain_derivative<'py>(
        &self,
        (t, x, u): Given<'_, 'py>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Option<Bound<'py, PyAny>> {
        plain_number(t)?;
        let x = plain_vector(x, self.states)?;
        let u = match u {
            Some(u) => plain_vector(u, self.inputs)?,
            None => &[],
        };
        if let Some(out) = out {
            let f = |[x, u]: [&[f64]; 2], rate: &mut [f64]| self.evaluator.plain_derivative(x, u, rate);
            return Room::fill(out, self.states, [x, u], f)?.then(|| out.clone());
        }
        let mut rate = [0.0; STATES];
        let done = self.evaluator.plain_derivative(x, u, &mut rate);
        done.then(|| PyArray1::from_slice(t.py(), &rate).into_any())
    }
}

type Matrix<'a> = (&'a [f64], [usize; 2]);

/// Writes two matrices to the pair of arrays that the caller brought.
fn fill<'py>(out: &Bound<'py, PyAny>, a: Matrix<'_>, b: Matrix<'_>) -> PyResult<Bound<'py, PyAny>> {
    let Ok((to_a, to_b)) = out.extract::<(Bound<'py, PyAny>, Bound<'py, PyAny>)>() else {
        return Err(refusal("out", out, None));
    };
    let rooms = (Room::of("out[0]", &to_a, &a.1)?, Room::of("out[1]", &to_b, &b.1)?);
    rooms.0.write(a.0);
    rooms.1.write(b.0);
    Ok(out.clone())
}

#[pymethods]
impl Model {
    /// The state derivative f(x, u, t). Konoplev (3.2).
    ///
    /// Parameters
    /// ----------
    /// t
    ///     Time, s.
    /// x
    ///     State, (n_states,), as named by `state_names`.
    /// u
    ///     Inputs, (n_inputs,), as named by `input_names`; zero when omitted.
    /// out
    ///     Where to write the result, (n_states,) float64, contiguous; a new array when omitted.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     A wrong argument.
    /// SingularChartError, NonFiniteError
    ///     The derivative does not exist there.
    #[pyo3(signature = (t, x, u=None, out=None))]
    fn derivative<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let Some(rate) = self.plain_derivative((t, x, u), out) {
            return Ok(rate);
        }
        self.at((t, x, u), |t, x, u| {
            let mut room = Buffer::<f64, ON_STACK>::new(self.states);
            let rate = room.slice();
            self.calling(|| self.evaluator.derivative(t, x, u, rate))?;
            if !are_finite::<4>(rate) || self.is_singular(x) {
                return Err(self.diagnose(py, t, x, u));
            }
            let Some(out) = out else { return Ok(PyArray1::from_slice(py, rate).into_any()) };
            Room::of("out", out, &[rate.len()])?.write(rate);
            Ok(out.clone())
        })
    }

    /// The exact Jacobians A = ∂f/∂x, (n_states, n_states), and B = ∂f/∂u, (n_states, n_inputs). Konoplev (3.2).
    ///
    /// Arguments and errors as of `derivative`; `out` is the pair of arrays to write A and B to, which is then returned.
    #[pyo3(signature = (t, x, u=None, out=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.refuse_callbacks(py)?;
        let (n, m) = (self.states, self.inputs);
        self.at((t, x, u), |t, x, u| {
            let mut all = MATRICES.take();
            all.resize(n * (n + m), 0.0);
            let (a, b) = all.split_at_mut(n * n);
            self.evaluator.jacobian(t, x, u, a, b);
            if !(are_finite::<16>(a) && are_finite::<16>(b)) || self.is_singular(x) {
                return Err(self.diagnose(py, t, x, u));
            }
            let result = match out {
                Some(out) => fill(out, (a, [n, n]), (b, [n, m]))?,
                None => (matrix(py, a, [n, n])?, matrix(py, b, [n, m])?).into_bound_py_any(py)?,
            };
            MATRICES.set(all);
            Ok(result)
        })
    }

    /// The sum of all wrenches, (6,) N and N m, in body axes about the body origin.
    ///
    /// Arguments as of `derivative`.
    #[pyo3(signature = (t, x, u=None))]
    fn wrench<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Array1<'py>> {
        self.at((t, x, u), |t, x, u| {
            let wrenches = self.calling(|| self.free_body.wrenches(t, x, u))?;
            let sum = wrenches.into_iter().fold(Screw::zero(), |a, b| a + b);
            let mut six = [0.0; 6];
            sum.store(&mut six);
            if !six.iter().all(|v| v.is_finite()) {
                return Err(self.diagnose(py, t, x, u));
            }
            Ok(PyArray1::from_slice(py, &six))
        })
    }
}
