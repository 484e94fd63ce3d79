//! `simulate`: one run, with the interpreter free while it goes.

use crate::arguments::{copied, matrix, read};
use crate::forces::tables;
use crate::model::Model;
use crate::watch::{EventArguments, OutputArguments, watched};
use freebody_core::integrators::Tolerance;
use freebody_core::simulate::{Ending, Inputs, MethodName, Run, Task, simulate as run};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::mem::take;
use std::time::Instant;

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;

type Samples = (Py<PyArray1<f64>>, Py<PyArray2<f64>>, u64, u64, u64, f64);

/// What came of a run.
#[pyclass(frozen, module = "freebody._core")]
pub struct RunResult {
    /// Without its samples.
    run: Run,
    t: Py<PyArray1<f64>>,
    x: Py<PyArray2<f64>>,
    /// To which a table adds.
    inputs: Vec<f64>,
    wall_time: f64,
}

impl RunResult {
    fn new(py: Python<'_>, mut run: Run, inputs: Vec<f64>, wall_time: f64) -> PyResult<Self> {
        let (times, states) = (take(&mut run.times), take(&mut run.states));
        let t = PyArray1::from_slice(py, &times).unbind();
        let x = matrix(py, &states, [times.len(), run.end_state.len()])?.unbind();
        Ok(Self { run, t, x, inputs, wall_time })
    }
}

#[pymethods]
impl RunResult {
    /// Times (n,) and states (n, n_states) of the samples; accepted steps, rejected steps, evaluations; wall time, s.
    fn samples(&self, py: Python<'_>) -> Samples {
        let Run { steps, rejected, evaluations, .. } = self.run;
        (self.t.clone_ref(py), self.x.clone_ref(py), steps, rejected, evaluations, self.wall_time)
    }

    /// The constant part of the inputs, (n_inputs,).
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> Array1<'py> {
        PyArray1::from_slice(py, &self.inputs)
    }

    /// One word for how the run ended.
    #[getter]
    fn status(&self) -> &'static str {
        match self.run.ending {
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
        if let Ending::NonFinite { force } = self.run.ending { force } else { None }
    }

    /// Place of the event that ended the run.
    #[getter]
    fn event(&self) -> Option<usize> {
        if let Ending::Event(event) = self.run.ending { Some(event) } else { None }
    }

    /// Places, times (n,) and states (n, n_states) of the events.
    fn occurrences<'py>(&self, py: Python<'py>) -> PyResult<(Vec<usize>, Array1<'py>, Array2<'py>)> {
        let all = &self.run.occurrences;
        let times: Vec<f64> = all.iter().map(|o| o.time).collect();
        let states: Vec<f64> = all.iter().flat_map(|o| o.state.iter().copied()).collect();
        let states = PyArray1::from_vec(py, states).reshape([all.len(), self.run.end_state.len()])?;
        Ok((all.iter().map(|o| o.event).collect(), PyArray1::from_vec(py, times), states))
    }

    #[getter]
    fn outputs(&self) -> Vec<f64> {
        self.run.outputs.clone()
    }

    #[getter]
    fn end_time(&self) -> f64 {
        self.run.end_time
    }

    #[getter]
    fn end_state<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.run.end_state)
    }

    /// Time, whether the chart was left, and the distance to its singularity, of each change.
    #[getter]
    fn chart_changes(&self) -> Vec<(f64, bool, f64)> {
        self.run.chart_changes.iter().map(|c| (c.time, c.left, c.distance)).collect()
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
        "vern8" => MethodName::Vern8,
        "vern9" => MethodName::Vern9,
        "rodas5p" => MethodName::Rodas,
        "gauss6" => MethodName::Gauss,
        _ => MethodName::Dop853,
    }
}

/// `freebody.simulation.Settings`: span, method, tolerance, step, times of samples, most steps.
type Settings<'py> =
    ((f64, f64), Bound<'py, PyString>, (f64, f64), Option<f64>, Option<Bound<'py, PyAny>>, u64);

/// Simulates; what is no start and no settings is checked by `freebody.simulation`.
#[pyfunction]
#[pyo3(signature = (model, x0, settings, constant, table, progress, events, outputs))]
pub fn simulate(
    model: &Bound<'_, Model>,
    x0: &Bound<'_, PyAny>,
    settings: Settings<'_>,
    constant: Option<&Bound<'_, PyAny>>,
    table: Option<(PyReadonlyArray1<'_, f64>, PyReadonlyArray2<'_, f64>, bool)>,
    progress: Option<Py<PyAny>>,
    events: Vec<EventArguments>,
    outputs: Vec<OutputArguments>,
) -> PyResult<RunResult> {
    let (py, model) = (model.py(), model.get());
    let ((t0, t1), method, (relative, absolute), step, times, max_steps) = settings;
    let start = read("x0", x0, model.states)?.into_owned();
    let constants = match constant {
        Some(constant) => read("inputs", constant, model.inputs)?.into_owned(),
        None => vec![0.0; model.inputs],
    };
    let method = method_name(method.to_str()?);
    if method == MethodName::Rodas {
        model.refuse_callbacks(py)?;
    }
    let save_at = times.as_ref().map(copied).transpose()?;
    let inputs = inputs(py, constants, table)?;
    let watched = watched(py, events, outputs)?;
    let task = Task {
        x0: &start,
        span: [t0, t1],
        inputs: &inputs,
        save_at: save_at.as_deref(),
        method,
        tolerance: Tolerance { relative, absolute },
        step,
        max_steps,
        watched: Some(&watched),
    };
    let mut failed = None;
    let began = Instant::now();
    let run = py.detach(|| {
        let mut report = |t: f64| {
            Python::attach(|py| {
                let told = match &progress {
                    Some(f) => f.call1(py, ((t - t0) / (t1 - t0),)).map(drop),
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
    let wall_time = began.elapsed().as_secs_f64();
    match failed {
        Some(error) => Err(error),
        None => Ok(RunResult::new(py, run, inputs.constants, wall_time)?),
    }
}
