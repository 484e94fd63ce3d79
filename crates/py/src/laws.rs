//! Laws of users: traced ones, control, and forces that Python computes.

use crate::errors;
use crate::graph::Program;
use crate::model::Model;
use freebody_core::forces::{Callback, Force as Element, Places, Source, Traced};
use freebody_core::scalar::Block;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::cell::RefCell;
use std::sync::Arc;

/// A control law of the core.
#[pyclass(frozen, from_py_object, module = "freebody._core")]
#[derive(Clone)]
pub struct Control(pub Traced<f64>);

#[pymethods]
impl Control {
    #[new]
    fn new(
        py: Python<'_>,
        program: Program,
        parameters: Vec<f64>,
        n_commands: usize,
        n_states: usize,
    ) -> PyResult<Self> {
        Ok(Self(traced(py, program, parameters, n_commands, n_states)?))
    }
}

/// A law whose inputs and states have no places yet.
pub fn traced(
    py: Python<'_>,
    program: Program,
    parameters: Vec<f64>,
    results: usize,
    states: usize,
) -> PyResult<Traced<f64>> {
    let program = program.0;
    let inputs = program.given_count().checked_sub(Places::MOTION + states);
    let (Some(inputs), true, true) =
        (inputs, program.parameter_count() == parameters.len(), program.output_count() == results + states)
    else {
        let message = format!(
            "a program of {} parameters, {} given numbers and {} outputs is no law of {} parameters, {results} \
             results and {states} states",
            program.parameter_count(),
            program.given_count(),
            program.output_count(),
            parameters.len()
        );
        return Err(errors::input(py, message));
    };
    if inputs + states > Places::ROOM {
        let message = format!(
            "a law of {inputs} inputs and {states} states has no room for them; the most are {} together: make \
             several laws of it",
            Places::ROOM
        );
        return Err(errors::input(py, message));
    }
    Ok(Traced::new(program, parameters, Places::new(&vec![0; inputs], 0..states)))
}

/// A force that calls a function from (23 + inputs, n) given numbers to (6, n) wrenches.
pub fn callback(function: Py<PyAny>, inputs: usize) -> Callback {
    let places = Places::new(&vec![0; inputs], 0..0);
    Callback { block: Arc::new(PythonBlock(function)), places }
}

/// Sources as Python numbers them: from zero on inputs, below it auxiliary states, of which -1 is the first.
pub fn sources(numbers: &[i64]) -> Vec<Source> {
    let source = |n: &i64| if *n < 0 { Source::State(!*n as usize) } else { Source::Input(*n as usize) };
    numbers.iter().map(source).collect()
}

/// Gives the laws the places of their inputs and, one after another, those of their states.
pub fn place(
    forces: &mut [Element<f64>],
    input_places: Vec<Vec<i64>>,
    control: Option<(&mut Traced<f64>, Vec<i64>)>,
) {
    let mut next = 0;
    let mut own = |n: usize| {
        next += n;
        next - n..next
    };
    for (force, numbers) in forces.iter_mut().zip(input_places) {
        let inputs = sources(&numbers);
        match force {
            Element::InputWrench(f) => {
                for (place, number) in f.places.iter_mut().zip(numbers) {
                    *place = number as usize;
                }
            }
            Element::Traced(f) => f.places = Places { inputs, states: own(f.places.states.len()) },
            Element::Callback(f) => f.places.inputs = inputs,
            _ => {}
        }
    }
    if let Some((law, numbers)) = control {
        law.places = Places { inputs: sources(&numbers), states: own(law.places.states.len()) };
    }
}

thread_local! {
    /// What a callback raised in the call that this thread is in.
    static RAISED: RefCell<Option<PyErr>> = const { RefCell::new(None) };
}

/// Runs what may call callbacks on this thread; what one of them raised is the error.
pub fn raising<R>(f: impl FnOnce() -> R) -> PyResult<R> {
    let before = RAISED.take();
    let result = f();
    match RAISED.replace(before) {
        Some(error) => Err(error),
        None => Ok(result),
    }
}

impl Model {
    /// Whether Python computes a force.
    pub fn has_callback(&self) -> bool {
        self.callback.is_some()
    }

    /// Runs what may call callbacks.
    pub fn calling<R>(&self, f: impl FnOnce() -> R) -> PyResult<R> {
        if self.has_callback() { raising(f) } else { Ok(f()) }
    }

    /// Refuses a Jacobian of what has none.
    pub fn refuse_callbacks(&self, py: Python<'_>) -> PyResult<()> {
        let Some(place) = self.callback else { return Ok(()) };
        let name = &self.law_names[place];
        let message = format!(
            "force '{name}' is a callback: a Python function that is called with numbers has no exact derivative; \
             trace it with @fb.force"
        );
        Err(errors::input(py, message))
    }
}

/// A Python function as numbers in, numbers out.
#[derive(Debug)]
struct PythonBlock(Py<PyAny>);

impl PythonBlock {
    fn write(&self, py: Python<'_>, lanes: usize, given: &[f64], out: &mut [f64]) -> PyResult<()> {
        let array = PyArray1::from_slice(py, given).reshape([given.len() / lanes, lanes])?;
        let returned = self.0.call1(py, (array,))?;
        let wrenches: PyReadonlyArray2<'_, f64> = returned.extract(py)?;
        if wrenches.shape() != [out.len() / lanes, lanes] {
            let came = wrenches.shape();
            return Err(errors::input(py, format!("a callback gave shape {came:?}, not (6, {lanes})")));
        }
        for (to, x) in out.iter_mut().zip(wrenches.as_array()) {
            *to = *x;
        }
        Ok(())
    }
}

impl Block for PythonBlock {
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]) {
        // Once a callback has raised, nothing is asked any more: not a number ends whatever goes on.
        let raised = RAISED.with_borrow(Option::is_some)
            || Python::attach(|py| match self.write(py, lanes, given, out) {
                Ok(()) => false,
                Err(error) => {
                    RAISED.set(Some(error));
                    true
                }
            });
        if raised {
            out.fill(f64::NAN);
        }
    }
}
