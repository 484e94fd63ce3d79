//! f(x, u, t), its Jacobians and the wrench at single states.

use crate::arguments::{number, read, write_out};
use crate::model::Model;
use freebody_core::screw::Screw;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;
type Given<'a, 'py> = (&'a Bound<'py, PyAny>, &'a Bound<'py, PyAny>, Option<&'a Bound<'py, PyAny>>);

/// So many numbers need no room of their own: two states of a quaternion and six inputs.
const ON_STACK: usize = 48;

impl Model {
    /// Hands on time, state and inputs, zero when none are given, and room for a rate.
    fn at<R>(
        &self,
        (t, x, u): Given<'_, '_>,
        f: impl FnOnce(f64, &[f64], &[f64], &mut [f64]) -> PyResult<R>,
    ) -> PyResult<R> {
        let t = number("t", t)?;
        let (mut stack, mut heap) = ([0.0; ON_STACK], Vec::new());
        let size = 2 * self.states + self.inputs;
        let all = if size <= ON_STACK {
            &mut stack[..size]
        } else {
            heap.resize(size, 0.0);
            &mut heap[..]
        };
        let (state, rest) = all.split_at_mut(self.states);
        let (input, rate) = rest.split_at_mut(self.inputs);
        read("x", x, state)?;
        if let Some(u) = u {
            read("u", u, input)?;
        }
        f(t, state, input, rate)
    }
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
    ) -> PyResult<Array1<'py>> {
        self.at((t, x, u), |t, x, u, rate| {
            self.calling(|| self.evaluator.derivative(t, x, u, rate))?;
            if !rate.iter().all(|v| v.is_finite()) || self.is_singular(x) {
                return Err(self.diagnose(py, t, x, u));
            }
            let Some(out) = out else { return Ok(PyArray1::from_slice(py, rate)) };
            write_out(out, rate)
        })
    }

    /// The exact Jacobians A = ∂f/∂x, (n_states, n_states), and B = ∂f/∂u, (n_states, n_inputs). Konoplev (3.2).
    ///
    /// Arguments and errors as of `derivative`.
    #[pyo3(signature = (t, x, u=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        u: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Array2<'py>, Array2<'py>)> {
        self.at((t, x, u), |t, x, u, _| {
            self.refuse_callbacks(py)?;
            let (n, m) = (self.states, self.inputs);
            let (mut a, mut b) = (vec![0.0; n * n], vec![0.0; n * m]);
            self.evaluator.jacobian(t, x, u, &mut a, &mut b);
            if !a.iter().chain(&b).all(|v| v.is_finite()) || self.is_singular(x) {
                return Err(self.diagnose(py, t, x, u));
            }
            Ok((PyArray1::from_vec(py, a).reshape([n, n])?, PyArray1::from_vec(py, b).reshape([n, m])?))
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
        self.at((t, x, u), |t, x, u, _| {
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
