//! Events and outputs.

use crate::graph::Program;
use crate::laws::{sources, traced};
use freebody_core::forces::Traced;
use freebody_core::watch::{Crossing, Event, Output, Take, Watched};
use pyo3::prelude::*;

/// Program, parameters, sources of its inputs, "rising", "falling" or "both", and whether it ends the run.
pub type EventArguments = (Program, Vec<f64>, Vec<i64>, String, bool);
/// Program, parameters, sources of its inputs, and "final", "min" or "max".
pub type OutputArguments = (Program, Vec<f64>, Vec<i64>, String);

/// What is watched; the sources are those that the model has.
pub fn watched(
    py: Python<'_>,
    events: Vec<EventArguments>,
    outputs: Vec<OutputArguments>,
) -> PyResult<Watched> {
    let law = |program: Program, parameters: Vec<f64>, places: Vec<i64>| -> PyResult<Traced<f64>> {
        let mut law = traced(py, program, parameters, 1, 0)?;
        law.places.inputs = sources(&places);
        Ok(law)
    };
    let event = |(program, parameters, places, direction, terminal): EventArguments| {
        let crossing = match direction.as_str() {
            "rising" => Crossing::Rising,
            "falling" => Crossing::Falling,
            _ => Crossing::Both,
        };
        Ok(Event { law: law(program, parameters, places)?, crossing, terminal })
    };
    let output = |(program, parameters, places, take): OutputArguments| {
        let take = match take.as_str() {
            "min" => Take::Least,
            "max" => Take::Greatest,
            _ => Take::Final,
        };
        Ok(Output { law: law(program, parameters, places)?, take })
    };
    Ok(Watched {
        events: events.into_iter().map(event).collect::<PyResult<_>>()?,
        outputs: outputs.into_iter().map(output).collect::<PyResult<_>>()?,
    })
}
