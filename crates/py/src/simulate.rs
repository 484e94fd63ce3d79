//! `simulate`: one run, with the interpreter free while it goes.

use crate::forces::tables;
use crate::model::Model;
use freebody_core::integrators::Tolerance;
use freebody_core::simulate::{Ending, Inputs, MethodName, Run, Task, simulate as run};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;

/// What came of a run.
#[pyclass(frozen, module = "freebody._core")]
pub struct RunResult(Run);

#[pymethods]
impl RunResult {
    /// Times (n,) and states (n, n_states) of the samples.
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<(Array1<'py>, Array2<'py>)> {
        let n = self.0.times.len();
        let states = PyArray1::from_slice(py, &self.0.states);
        Ok((PyArray1::from_slice(py, &self.0.times), states.reshape([n, self.0.end_state.len()])?))
    }

    /// One word for how the run ended.
    #[getter]
    fn status(&self) -> &'static str {
        match self.0.ending {
            Ending::ReachedEnd => "reached_end",
            Ending::StepTooSmall => "step_too_small",
            Ending::StepLimit => "step_limit",
            Ending::NonFinite { .. } => "non_finite",
            Ending::Interrupted => "interrupted",
        }
    }

    /// Place of the force that was not finite; one place behind them all stands the control law.
    #[getter]
    fn force(&self) -> Option<usize> {
        if let Ending::NonFinite { force } = self.0.ending { force } else { None }
    }

    #[getter]
    fn end_time(&self) -> f64 {
        self.0.end_time
    }

    #[getter]
    fn end_state<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.0.end_state)
    }

    /// Time, whether the chart was left, and the distance to its singularity, of each change.
    #[getter]
    fn chart_changes(&self) -> Vec<(f64, bool, f64)> {
        self.0.chart_changes.iter().map(|c| (c.time, c.left, c.distance)).collect()
    }

    /// Accepted steps, rejected steps, evaluations.
    #[getter]
    fn counts(&self) -> (u64, u64, u64) {
        (self.0.steps, self.0.rejected, self.0.evaluations)
    }
}

/// Simulates; arguments are checked by `freebody.simulation`.
#[pyfunction]
#[pyo3(signature = (model, x0, span, *, constant, table, save_at, method, tolerance, step, max_steps, progress))]
pub fn simulate(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    x0: Vec<f64>,
    span: [f64; 2],
    constant: Vec<f64>,
    table: Option<(PyReadonlyArray1<'_, f64>, PyReadonlyArray2<'_, f64>, bool)>,
    save_at: Option<Vec<f64>>,
    method: &str,
    tolerance: [f64; 2],
    step: Option<f64>,
    max_steps: u64,
    progress: Option<Py<PyAny>>,
) -> PyResult<RunResult> {
    let inputs = match table {
        None => Inputs::Constant(constant),
        Some((times, columns, hold)) => {
            Inputs::Tables(tables(py, times, columns, hold)?.into_iter().map(|(t, _)| t).collect())
        }
    };
    let task = Task {
        x0: &x0,
        span,
        inputs: &inputs,
        save_at: save_at.as_deref(),
        method: match method {
            "rk4" => MethodName::Rk4,
            "dp54" => MethodName::Dp54,
            _ => MethodName::Dop853,
        },
        tolerance: Tolerance { relative: tolerance[0], absolute: tolerance[1] },
        step,
        max_steps,
    };
    let model = model.get();
    let mut failed = None;
    let result = py.detach(|| {
        let mut report = |t: f64| {
            Python::attach(|py| {
                let fraction = (t - span[0]) / (span[1] - span[0]);
                let told = match &progress {
                    Some(f) => f.call1(py, (fraction,)).map(drop),
                    None => Ok(()),
                };
                match told.and_then(|()| py.check_signals()) {
                    Ok(()) => true,
                    Err(error) => {
                        failed = Some(error);
                        false
                    }
                }
            })
        };
        model.calling(|| run(&model.free_body, &task, &mut report))
    })?;
    match failed {
        Some(error) => Err(error),
        None => Ok(RunResult(result)),
    }
}
