//! `simulate`: one run, with the interpreter free while it goes.

use crate::forces::tables;
use crate::model::Model;
use crate::watch::{EventArguments, OutputArguments, watched};
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
            Ending::Event(_) => "event",
            Ending::StepTooSmall => "step_too_small",
            Ending::StepTooLarge => "step_too_large",
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

    /// Place of the event that ended the run.
    #[getter]
    fn event(&self) -> Option<usize> {
        if let Ending::Event(event) = self.0.ending { Some(event) } else { None }
    }

    /// Places, times (n,) and states (n, n_states) of the events.
    fn occurrences<'py>(&self, py: Python<'py>) -> PyResult<(Vec<usize>, Array1<'py>, Array2<'py>)> {
        let all = &self.0.occurrences;
        let times: Vec<f64> = all.iter().map(|o| o.time).collect();
        let states: Vec<f64> = all.iter().flat_map(|o| o.state.iter().copied()).collect();
        let states = PyArray1::from_vec(py, states).reshape([all.len(), self.0.end_state.len()])?;
        Ok((all.iter().map(|o| o.event).collect(), PyArray1::from_vec(py, times), states))
    }

    #[getter]
    fn outputs(&self) -> Vec<f64> {
        self.0.outputs.clone()
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

/// Constant inputs, and what a table adds to them: times, columns (n_inputs, n), whether rows hold.
pub fn inputs(
    py: Python<'_>,
    constants: Vec<f64>,
    table: Option<(PyReadonlyArray1<'_, f64>, PyReadonlyArray2<'_, f64>, bool)>,
) -> PyResult<Inputs> {
    let tables = match table {
        None => Vec::new(),
        Some((times, columns, hold)) => {
            tables(py, times, columns, hold)?.into_iter().map(|(table, _)| table).collect()
        }
    };
    Ok(Inputs { constants, tables })
}

/// The method of a name that was checked.
pub fn method_name(name: &str) -> MethodName {
    match name {
        "rk4" => MethodName::Rk4,
        "dp54" => MethodName::Dp54,
        "rodas5p" => MethodName::Rodas,
        "gauss6" => MethodName::Gauss,
        _ => MethodName::Dop853,
    }
}

/// Simulates; arguments are checked by `freebody.simulation`.
#[pyfunction]
#[pyo3(signature = (model, x0, span, *, constant, table, save_at, method, tolerance, step, max_steps, progress,
                    events, outputs))]
pub fn simulate(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    x0: PyReadonlyArray1<'_, f64>,
    span: [f64; 2],
    constant: PyReadonlyArray1<'_, f64>,
    table: Option<(PyReadonlyArray1<'_, f64>, PyReadonlyArray2<'_, f64>, bool)>,
    save_at: Option<PyReadonlyArray1<'_, f64>>,
    method: &str,
    tolerance: [f64; 2],
    step: Option<f64>,
    max_steps: u64,
    progress: Option<Py<PyAny>>,
    events: Vec<EventArguments>,
    outputs: Vec<OutputArguments>,
) -> PyResult<RunResult> {
    let watched = watched(py, events, outputs)?;
    let inputs = inputs(py, constant.as_slice()?.to_vec(), table)?;
    let save_at = save_at.as_ref().map(|times| times.as_slice()).transpose()?;
    let model = model.get();
    if method == "rodas5p" {
        model.refuse_callbacks(py)?;
    }
    let task = Task {
        x0: x0.as_slice()?,
        span,
        inputs: &inputs,
        save_at,
        method: method_name(method),
        tolerance: Tolerance { relative: tolerance[0], absolute: tolerance[1] },
        step,
        max_steps,
        watched: Some(&watched),
    };
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
