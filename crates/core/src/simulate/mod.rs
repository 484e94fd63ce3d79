//! One trajectory from start to end: samples, jumps in time, changes of chart, and how it ended.

mod branch;
mod inputs;
mod motion;
mod run;
mod samples;

pub use inputs::Inputs;
pub use motion::Motion;

use crate::integrators::{Dop853, Dp54, Gauss6, Rk4, Rodas5P, Tolerance, Vern8, Vern9};
use crate::phase_space::FreeBody;
use crate::scalar::isa::{Isa, with_scalar};
use crate::watch::{Occurrence, Watched};

/// The square of a larger number is none, and with it the error of a step.
pub(crate) const TOO_LARGE: f64 = 1e150;

/// The times within a span where a force or an input jumps, and its end: steps end there.
pub(crate) fn limits(body: &FreeBody<f64>, inputs: &Inputs, [t0, t1]: [f64; 2]) -> Vec<f64> {
    let forces = body.forces.iter().flat_map(|f| f.breaks());
    let mut limits: Vec<f64> = forces.chain(inputs.breaks()).filter(|t| *t > t0 && *t < t1).collect();
    limits.push(t1);
    limits.sort_by(f64::total_cmp);
    limits.dedup();
    limits
}

/// The methods of integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodName {
    /// Classical Runge–Kutta of order 4, fixed step.
    Rk4,
    /// Dormand–Prince 5(4), adaptive.
    Dp54,
    /// Dormand–Prince 8(5, 3), adaptive.
    Dop853,
    /// Verner 8(7), adaptive.
    Vern8,
    /// Verner 9(8), adaptive.
    Vern9,
    /// Rosenbrock–Wanner of order 5(4) for stiff systems, adaptive.
    Rodas,
    /// Gauss collocation of order 6, fixed step.
    Gauss,
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
    /// Events and outputs.
    pub watched: Option<&'a Watched>,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// At the end of its span.
    ReachedEnd,
    /// At an event, by its place among them.
    Event(usize),
    /// The step shrank to the rounding of time.
    StepTooSmall,
    /// The fixed step is too large for the iteration of an implicit method.
    StepTooLarge,
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
    /// The events in the order of their times, their states in the chart and form of the model.
    pub occurrences: Vec<Occurrence>,
    /// The outputs.
    pub outputs: Vec<f64>,
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
        MethodName::Vern8 => run::run::<T, Vern8>(body, task, progress),
        MethodName::Vern9 => run::run::<T, Vern9>(body, task, progress),
        MethodName::Rodas => run::run::<T, Rodas5P>(body, task, progress),
        MethodName::Gauss => run::run::<T, Gauss6>(body, task, progress),
    })
}
