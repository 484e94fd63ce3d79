//! The trajectories in the lanes, and what the caller sees of them.

use super::controller::GROW;
use super::lu::Lu;
use super::{Lanes, Method, Tolerance};
use crate::scalar::Lane;
use std::marker::PhantomData;

/// What became of a lane's last trial step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The lane was at its limit and did not move.
    Idle,
    /// The error is within the tolerance; the step is taken by [`Stepper::commit`].
    Accepted,
    /// The error is too large; the next trial is shorter.
    Rejected,
    /// The trial met a number that is not finite; the next trial is shorter.
    Diverged,
    /// The lane cannot go on: its step has shrunk to the rounding of its time.
    StepTooSmall,
    /// The lane cannot go on: with a step of this fixed size the iteration for the stages does not come to an end.
    StepTooLarge,
    /// The lane cannot go on: the derivative at its present state is not finite (or, with a method of
    /// fixed step, the trial is not).
    NonFinite,
}

/// The lanes that a trial step decided.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The lanes that will advance.
    pub accepted: Lanes,
    /// The lanes that cannot go on; [`Stepper::verdict`] says why.
    pub stopped: Lanes,
}

/// Integrates one trajectory in each lane of `T` by the method `M`.
#[derive(Debug)]
pub struct Stepper<T, M> {
    pub(super) tolerance: Tolerance,
    /// Number of components.
    pub(super) size: usize,
    /// `+1` or `-1`: the direction of time; step sizes are positive.
    pub(super) direction: T,
    pub(super) t: T,
    /// The size that the next step would have without a limit.
    pub(super) h: T,
    /// By what the next step may grow: not at all after a rejection.
    pub(super) grow: T,
    pub(super) y: Vec<T>,
    /// The stages; then the derivative at the end of the step; then those of the dense output.
    pub(super) k: Vec<T>,
    pub(super) scratch: Vec<T>,
    pub(super) dense: Vec<T>,
    /// What a method keeps from step to step, besides.
    pub(super) memory: Vec<T>,
    pub(super) lu: Lu<T>,
    pub(super) trial: TrialStep<T>,
    pub(super) accepted: T,
    pub(super) tried: T,
    pub(super) evaluations: u64,
    pub(super) verdicts: Vec<Verdict>,
    method: PhantomData<M>,
}

/// A step that is not taken yet.
#[derive(Debug)]
pub(super) struct TrialStep<T> {
    /// Its end.
    pub t: T,
    /// Where `f` is evaluated for its end: just before a limit, where `f` may jump.
    pub t_before: T,
    /// Signed.
    pub h: T,
    /// The step size that a limit cut short, else zero.
    pub kept: T,
    pub y: Vec<T>,
    pub squared_error: T,
    pub end_evaluated: bool,
}

impl<T: Lane, M: Method> Stepper<T, M> {
    /// A stepper without trajectories; [`Stepper::start`] gives it some.
    pub fn new(tolerance: Tolerance) -> Self {
        T::call(
            #[inline(always)]
            || {
                let zero = T::zero();
                let trial = TrialStep {
                    t: zero,
                    t_before: zero,
                    h: zero,
                    kept: zero,
                    y: Vec::new(),
                    squared_error: zero,
                    end_evaluated: false,
                };
                Self {
                    tolerance,
                    size: 0,
                    direction: T::one(),
                    t: zero,
                    h: zero,
                    grow: T::lit(GROW),
                    y: Vec::new(),
                    k: Vec::new(),
                    scratch: Vec::new(),
                    dense: Vec::new(),
                    memory: Vec::new(),
                    lu: Lu::new(),
                    trial,
                    accepted: zero,
                    tried: zero,
                    evaluations: 0,
                    verdicts: vec![Verdict::Idle; T::N],
                    method: PhantomData,
                }
            },
        )
    }

    /// Time of each lane, after the last committed step.
    #[inline(always)]
    pub fn t(&self) -> T {
        self.t
    }
    /// State of all lanes, after the last committed step.
    #[inline(always)]
    pub fn y(&self) -> &[T] {
        &self.y[..self.size]
    }
    /// The derivative at [`Stepper::y`].
    #[inline(always)]
    pub fn derivative(&self) -> &[T] {
        &self.k[..self.size]
    }
    /// Time of each lane at the end of the trial step.
    #[inline(always)]
    pub fn trial_t(&self) -> T {
        self.trial.t
    }
    /// State of all lanes at the end of the trial step.
    #[inline(always)]
    pub fn trial_y(&self) -> &[T] {
        &self.trial.y[..self.size]
    }
    /// The derivative at [`Stepper::trial_y`], after [`Stepper::evaluate_end`].
    #[inline(always)]
    pub fn trial_derivative(&self) -> &[T] {
        &self.k[self.stage(M::STAGES.len())]
    }
    /// The lanes whose trial step ends at its limit: behind it the right-hand side may have jumped.
    #[inline(always)]
    pub fn trial_at_limit(&self) -> Lanes {
        let gap = (self.trial.t - self.trial.t_before).abs();
        Lanes::where_le(T::lit(f64::MIN_POSITIVE), gap)
    }
    /// The size of the next step, before a limit cuts it; positive.
    #[inline(always)]
    pub fn step_size(&self) -> T {
        self.h
    }
    /// The error of the trial step in units of the tolerance: accepted up to one; with a method of fixed step what
    /// an iteration has left over.
    #[inline(always)]
    pub fn error(&self) -> T {
        self.trial.squared_error.sqrt()
    }
    /// How many steps each lane has taken since it started.
    #[inline(always)]
    pub fn steps(&self) -> T {
        self.accepted
    }
    /// How many steps each lane has rejected since it started.
    #[inline(always)]
    pub fn rejected(&self) -> T {
        self.tried - self.accepted
    }
    /// Writes the state of lane `l`; its time, its accepted and its rejected steps.
    pub fn lane(&self, l: usize, state: &mut Vec<f64>) -> (f64, u64, u64) {
        T::call(
            #[inline(always)]
            || {
                write_lane(self.y(), l, state);
                (self.t.get(l), self.accepted.get(l) as u64, self.rejected().get(l) as u64)
            },
        )
    }
    /// How many times the right-hand side was evaluated, each time in all lanes; not for Jacobians.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }
    /// What became of lane `l` in the last trial step.
    pub fn verdict(&self, l: usize) -> Verdict {
        self.verdicts[l]
    }
}

/// Writes one lane of a vector.
#[inline(always)]
pub(crate) fn write_lane<T: Lane>(y: &[T], l: usize, out: &mut Vec<f64>) {
    out.clear();
    for y in y {
        out.push(y.get(l));
    }
}
