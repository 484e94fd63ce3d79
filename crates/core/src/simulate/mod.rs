//! One trajectory from start to end: samples, jumps in time, changes of chart, and how it ended.

mod branch;
mod inputs;
mod motion;
mod run;
mod samples;

pub use inputs::Inputs;

use crate::integrators::{Dop853, Dp54, Rk4, Tolerance};
use crate::phase_space::FreeBody;
use crate::scalar::isa::{Isa, with_scalar};

/// The methods of integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodName {
    /// Classical Runge–Kutta of order 4, fixed step.
    Rk4,
    /// Dormand–Prince 5(4), adaptive.
    Dp54,
    /// Dormand–Prince 8(5, 3), adaptive.
    Dop853,
}

/// What a run is asked for.
#[derive(Clone, Debug)]
pub struct Task<'a> {
    /// The state at the start, in the chart and form of the model.
    pub x0: &'a [f64],
    /// Start and end, s; the end lies behind the start.
    pub span: [f64; 2],
    /// The control over time.
    pub inputs: &'a Inputs,
    /// Rising times inside the span at which the state is wanted; none for every accepted step.
    pub save_at: Option<&'a [f64]>,
    /// The method.
    pub method: MethodName,
    /// The error allowed to one step.
    pub tolerance: Tolerance,
    /// The step of a fixed-step method, the first step of an adaptive one, s.
    pub step: Option<f64>,
    /// The largest number of accepted and rejected steps.
    pub max_steps: u64,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// At the end of its span.
    ReachedEnd,
    /// The step shrank to the rounding of time.
    StepTooSmall,
    /// `max_steps` were done.
    StepLimit,
    /// The derivative is not finite; the force that made it so, by its place in the model, if one did.
    NonFinite {
        /// See [`FreeBody::culprit`].
        force: Option<usize>,
    },
    /// The caller asked to stop.
    Interrupted,
}

/// A change from one chart to another within a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChartChange {
    /// When, s.
    pub time: f64,
    /// Whether the run left the chart that the model asks for (or came back to it).
    pub left: bool,
    /// The distance to the singularity of the chart that the model asks for, rad.
    pub distance: f64,
}

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Run {
    /// Times of the samples, s.
    pub times: Vec<f64>,
    /// States of the samples, one after another, in the chart and form of the model.
    pub states: Vec<f64>,
    /// How it ended.
    pub ending: Ending,
    /// When it ended, s.
    pub end_time: f64,
    /// The last state that it reached.
    pub end_state: Vec<f64>,
    /// When it changed its chart.
    pub chart_changes: Vec<ChartChange>,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the derivative.
    pub evaluations: u64,
}

/// Simulates a free body; `progress` hears the time now and then, and stops the run by `false`.
pub fn simulate(body: &FreeBody<f64>, task: &Task<'_>, progress: &mut dyn FnMut(f64) -> bool) -> Run {
    with_scalar!(Isa::detect(), T => match task.method {
        MethodName::Rk4 => run::run::<T, Rk4>(body, task, progress),
        MethodName::Dp54 => run::run::<T, Dp54>(body, task, progress),
        MethodName::Dop853 => run::run::<T, Dop853>(body, task, progress),
    })
}
