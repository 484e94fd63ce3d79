//! `run_ensemble`: many runs at once, with the interpreter free while they go.

use crate::errors;
use crate::laws::raising;
use crate::model::Model;
use crate::simulate::{inputs, method_name};
use crate::watch::{EventArguments, OutputArguments, watched};
use freebody_core::ensemble::{Batch, Caller, Rows, run};
use freebody_core::integrators::Tolerance;
use freebody_core::phase_space::BODY_PARAMETERS;
use freebody_core::simulate::Ending;
use numpy::{
    PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use std::sync::Mutex;

type Table<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>, bool);
type Bodies<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>, PyReadonlyArray3<'py, f64>);
type Parameters<'py> = (PyReadonlyArray1<'py, i64>, PyReadonlyArray2<'py, f64>);

/// What came of many runs: one row a run.
#[pyclass(frozen, module = "freebody._core")]
pub struct EnsembleResult {
    rows: Rows,
    states: usize,
    samples: usize,
}

#[pymethods]
impl EnsembleResult {
    /// How each run ended (n,): 0 at its end, 1 at an event, 2 step too small, 3 step limit, 4 not finite,
    /// 5 step too large.
    #[getter]
    fn outcomes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u8>> {
        let code = |ending: &Ending| match ending {
            Ending::ReachedEnd => 0,
            Ending::Event(_) => 1,
            Ending::StepTooSmall => 2,
            Ending::StepLimit => 3,
            Ending::NonFinite { .. } => 4,
            Ending::StepTooLarge => 5,
            Ending::Interrupted => 6,
        };
        PyArray1::from_iter(py, self.rows.ended.iter().map(|e| code(&e.ending)))
    }

    /// Places of the laws that were not finite (n,); -1 where there is none.
    #[getter]
    fn culprits<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i16>> {
        let place = |ending: &Ending| match ending {
            Ending::NonFinite { force: Some(place) } => *place as i16,
            _ => -1,
        };
        PyArray1::from_iter(py, self.rows.ended.iter().map(|e| place(&e.ending)))
    }

    /// Places of the events that ended the runs (n,); -1 where there is none.
    #[getter]
    fn stopped_by<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i16>> {
        let place = |ending: &Ending| if let Ending::Event(place) = ending { *place as i16 } else { -1 };
        PyArray1::from_iter(py, self.rows.ended.iter().map(|e| place(&e.ending)))
    }

    /// The outputs (n, n_outputs).
    #[getter]
    fn outputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        PyArray1::from_slice(py, &self.rows.outputs).reshape(self.by_run(self.rows.outputs.len()))
    }

    /// How often each event came to pass (n, n_events).
    #[getter]
    fn event_counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        PyArray1::from_slice(py, &self.rows.event_counts).reshape(self.by_run(self.rows.event_counts.len()))
    }

    /// When each event first came to pass (n, n_events), s; not a number where it never did.
    #[getter]
    fn event_times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        PyArray1::from_slice(py, &self.rows.event_times).reshape(self.by_run(self.rows.event_times.len()))
    }

    /// The states then (n, n_events, n_states).
    #[getter]
    fn event_states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let [runs, events] = self.by_run(self.rows.event_times.len());
        PyArray1::from_slice(py, &self.rows.event_states).reshape([runs, events, self.states])
    }

    /// Times of the ends (n,), s.
    #[getter]
    fn end_times<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.rows.ended.iter().map(|e| e.time))
    }

    /// Last states (n, n_states).
    #[getter]
    fn end_states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        PyArray1::from_slice(py, &self.rows.states).reshape([self.rows.ended.len(), self.states])
    }

    /// States at the wanted times (n, times, n_states), not numbers behind the end of a run.
    #[getter]
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        PyArray1::from_slice(py, &self.rows.samples).reshape([
            self.rows.ended.len(),
            self.samples,
            self.states,
        ])
    }

    /// Accepted and rejected steps (n, 2).
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u64>>> {
        let counts = self.rows.ended.iter().flat_map(|e| [e.steps, e.rejected]);
        PyArray1::from_iter(py, counts).reshape([self.rows.ended.len(), 2])
    }
}

impl EnsembleResult {
    /// The shape of so many numbers, as many for each run.
    fn by_run(&self, count: usize) -> [usize; 2] {
        let runs = self.rows.ended.len();
        [runs, count / runs.max(1)]
    }
}

/// Runs many; arguments are checked by `freebody.ensembles`.
#[pyfunction]
#[pyo3(signature = (model, x0, span, *, bodies, parameters, constants, table, save_at, events, outputs, method,
                    tolerance, step, max_steps, threads, progress))]
pub fn run_ensemble(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    x0: PyReadonlyArray2<'_, f64>,
    span: [f64; 2],
    bodies: Option<Bodies<'_>>,
    parameters: Option<Parameters<'_>>,
    constants: PyReadonlyArray2<'_, f64>,
    table: Option<Table<'_>>,
    save_at: Option<PyReadonlyArray1<'_, f64>>,
    events: Vec<EventArguments>,
    outputs: Vec<OutputArguments>,
    method: &str,
    tolerance: [f64; 2],
    step: Option<f64>,
    max_steps: u64,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<EnsembleResult> {
    let runs = x0.shape()[0];
    let (places, values) = dispersed(py, runs, bodies, parameters)?;
    let model = model.get();
    if method == "rodas5p" {
        model.refuse_callbacks(py)?;
    }
    let rows = constants.as_slice()?;
    let one_for_all = constants.shape()[0] == 1;
    let first = if one_for_all { rows.to_vec() } else { vec![0.0; constants.shape()[1]] };
    let inputs = inputs(py, first, table)?;
    let watched = watched(py, events, outputs)?;
    let save_at = save_at.as_ref().map(|times| times.as_slice()).transpose()?.unwrap_or(&[]);
    let batch = Batch {
        body: &model.free_body,
        starts: x0.as_slice()?,
        places: &places,
        values: &values,
        inputs: &inputs,
        constants: if one_for_all { &[] } else { rows },
        span,
        save_at,
        watched: &watched,
        method: method_name(method),
        tolerance: Tolerance { relative: tolerance[0], absolute: tolerance[1] },
        step,
        max_steps,
    };
    let threads =
        if threads > 0 { threads } else { std::thread::available_parallelism().map_or(1, usize::from) };
    let (mut failed, raised) = (None, Mutex::new(None));
    let result = py.detach(|| {
        let mut report = |done: usize| {
            Python::attach(|py| {
                let told = progress.as_ref().map_or(Ok(()), |f| f.call1(py, (done,)).map(drop));
                failed = told.and_then(|()| py.check_signals()).err();
                failed.is_none()
            })
        };
        let around = |work: &mut dyn FnMut()| {
            if let Err(error) = raising(work)
                && let Ok(mut first) = raised.lock()
            {
                first.get_or_insert(error);
            }
        };
        run(&batch, Caller { threads, around: &around, progress: &mut report })
    });
    if let Some(error) = failed.or_else(|| raised.into_inner().ok().flatten()) {
        return Err(error);
    }
    match result {
        Some(rows) => {
            let samples = batch.save_at.len();
            Ok(EnsembleResult { rows, states: x0.shape()[1], samples })
        }
        None => Err(errors::input(py, "the ensemble was stopped".to_owned())),
    }
}

/// The places and values (by runs) of all parameters that differ.
fn dispersed(
    py: Python<'_>,
    runs: usize,
    bodies: Option<Bodies<'_>>,
    parameters: Option<Parameters<'_>>,
) -> PyResult<(Vec<usize>, Vec<f64>)> {
    let mut places: Vec<usize> = Vec::new();
    let (mut body_rows, mut law_rows) = (Vec::new(), Vec::new());
    if let Some((mass, com, inertia)) = &bodies {
        if mass.shape() != [runs] || com.shape() != [runs, 3] || inertia.shape() != [runs, 3, 3] {
            return Err(errors::input(py, format!("bodies: want ({runs},), ({runs}, 3) and ({runs}, 3, 3)")));
        }
        places.extend(0..BODY_PARAMETERS);
        let rows = mass.as_slice()?.iter().zip(com.as_slice()?.chunks(3)).zip(inertia.as_slice()?.chunks(9));
        body_rows =
            rows.map(|((m, r), j)| [*m, r[0], r[1], r[2], j[0], j[1], j[2], j[4], j[5], j[8]]).collect();
    }
    let mut width = 0;
    if let Some((own, values)) = &parameters {
        width = own.len();
        if values.shape() != [runs, width] {
            return Err(errors::input(py, format!("parameters: want values ({runs}, {width})")));
        }
        places.extend(own.as_slice()?.iter().map(|p| *p as usize));
        law_rows = values.as_slice()?.to_vec();
    }
    let mut all = Vec::with_capacity(runs * places.len());
    for run in 0..runs {
        all.extend(body_rows.get(run).into_iter().flatten());
        all.extend_from_slice(&law_rows[run * width..(run + 1) * width]);
    }
    Ok((places, all))
}
