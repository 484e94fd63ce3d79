//! Many runs of one model, in lanes and on threads: each with a start, parameters and inputs of its own.
//!
//! A lane whose run is finished takes the next one. What comes of a run depends on its own data alone, to the last
//! bit: not on its neighbours, nor on the number of threads or the order. All runs go in quaternions and
//! quasi-velocities, which have no singularity; their samples are written as the model has its state.

mod queue;
mod rows;
mod samples;
mod setup;
mod worker;

pub use rows::{Ended, Rows};

use crate::integrators::{Dop853, Dp54, Gauss6, Rk4, Rodas5P, Tolerance, Vern8, Vern9};
use crate::phase_space::FreeBody;
use crate::scalar::isa::{Isa, with_lanes};
use crate::simulate::{Inputs, MethodName};
use crate::watch::Watched;
use queue::Queue;
use setup::Setup;
use worker::Worker;

/// The runs of an ensemble; numbers of one run stand together.
#[derive(Clone, Debug)]
pub struct Batch<'a> {
    /// The nominal model.
    pub body: &'a FreeBody<f64>,
    /// The state of each run at the start, as the model has its state.
    pub starts: &'a [f64],
    /// Which parameters differ from the model's, by their places in [`FreeBody::parameters`].
    pub places: &'a [usize],
    /// Their values.
    pub values: &'a [f64],
    /// The inputs.
    pub inputs: &'a Inputs,
    /// Constants of each run in place of those of the inputs, or none.
    pub constants: &'a [f64],
    /// Start and end, s.
    pub span: [f64; 2],
    /// Rising times inside the span at which the state is kept.
    pub save_at: &'a [f64],
    /// Events and outputs.
    pub watched: &'a Watched,
    /// The method.
    pub method: MethodName,
    /// The error allowed to one step.
    pub tolerance: Tolerance,
    /// The step of a fixed-step method, the first step of an adaptive one, s.
    pub step: Option<f64>,
    /// The largest number of accepted and rejected steps of one run.
    pub max_steps: u64,
}

/// How the caller follows and steers the work.
pub struct Caller<'a> {
    /// How many threads, the calling one among them.
    pub threads: usize,
    /// Runs the work of one thread.
    pub around: &'a (dyn Fn(&mut dyn FnMut()) + Sync),
    /// Hears on the calling thread how many runs are done, now and then; false stops all.
    pub progress: &'a mut dyn FnMut(usize) -> bool,
}

/// Runs all; none if the caller stopped it.
pub fn run(batch: &Batch<'_>, caller: Caller<'_>) -> Option<Rows> {
    run_on(Isa::detect(), batch, caller)
}

/// Runs all on one of the instruction sets that this machine has, [`Isa::available`].
pub fn run_on(isa: Isa, batch: &Batch<'_>, caller: Caller<'_>) -> Option<Rows> {
    let setup = Setup::new(batch);
    let queue = Queue::new(setup.runs, caller.threads.max(1));
    let work = |report: &mut dyn FnMut() -> bool| -> Rows {
        with_lanes!(isa, T => match batch.method {
            MethodName::Rk4 => Worker::<T, Rk4>::new(&setup, &queue).work(report),
            MethodName::Dp54 => Worker::<T, Dp54>::new(&setup, &queue).work(report),
            MethodName::Dop853 => Worker::<T, Dop853>::new(&setup, &queue).work(report),
            MethodName::Vern8 => Worker::<T, Vern8>::new(&setup, &queue).work(report),
            MethodName::Vern9 => Worker::<T, Vern9>::new(&setup, &queue).work(report),
            MethodName::Rodas => Worker::<T, Rodas5P>::new(&setup, &queue).work(report),
            MethodName::Gauss => Worker::<T, Gauss6>::new(&setup, &queue).work(report),
        })
    };
    let parts = queue.share(caller, &work);
    (!queue.is_stopped()).then(|| Rows::merged(parts, &setup, batch.save_at.len()))
}
