//! Stages that depend on each other, by iteration.

use super::controller::HUGE;
use super::sums::{advance, change, squared_length};
use super::{Iterated, Lanes, Method, Stepper, System};
use crate::scalar::Lane;

/// Iterations that contract by less than a factor of one and a half need more than this to come to rounding.
const MOST: usize = 100;
/// So many iterations in a row without improvement, and a lane is given up.
const PATIENCE: f64 = 5.0;
/// A square of a change is smaller than another if it is by this factor: rounding alone comes and goes.
const SMALLER: f64 = 0.9;
/// What is left over in a lane that has not come to its end.
const MUCH: f64 = 1e100;

/// How many vectors are kept: the guesses of the stages, what summation rounded off, before and after the trial
/// step, and of each block its smallest change yet and its last.
pub(super) const fn memory(stages: usize) -> usize {
    stages + 4
}

impl<T: Lane, M: Method> Stepper<T, M> {
    /// Iterates the stages until rounding alone moves them, and writes the end of the trial step.
    ///
    /// Each lane stops on its own: when no block of the state changes less than ever before. Gives the square of
    /// the last change in units of the tolerance where that is no more than one, else something larger, or not a
    /// number where the stages were none from the first.
    ///
    /// E. Hairer, R. I. McLachlan, A. Razakarivony, BIT 48 (2008), on the end of the iteration and the sum.
    #[inline(always)]
    pub(super) fn iterated_stages<S: System<T> + ?Sized>(&mut self, system: &S, method: &Iterated) -> T {
        let (zero, one) = (T::zero(), T::one());
        let (stride, h) = (self.y.len(), self.trial.h);
        let guesses = (M::STAGES.len() - 1) * stride;
        self.k[stride..][..guesses].copy_from_slice(&self.memory[..guesses]);
        self.least_changes().fill(T::lit(HUGE));
        let (mut moving, mut wasted, mut left) = (one, zero, T::lit(MUCH));
        let mut finite = zero;
        for round in 0..MOST {
            self.iterate(system, method, moving);
            let improved = self.note_changes(system);
            if round == 0 {
                finite = T::select_le(self.last_change(system), T::lit(HUGE), one, zero);
            }
            wasted = T::select_le(one, improved, zero, wasted + one);
            if T::all_le(one, improved) {
                continue;
            }
            let now = self.last_change(system);
            left = T::select_le(one, moving, now, left);
            let patient = T::select_le(wasted, T::lit(PATIENCE), one, zero);
            let hopeful = T::select_le(now, one, zero, T::select_le(now, T::lit(HUGE), patient, zero));
            moving = moving * improved.max(hopeful);
            if T::all_le(moving, zero) {
                break;
            }
        }
        change(M::WEIGHTS, h, &self.k, &mut self.scratch[..stride]);
        self.sum();
        let left = T::select_le(one, moving, T::lit(MUCH), left);
        let ended = T::select_le(left, T::lit(MUCH), left, T::lit(MUCH));
        T::select_le(one, finite, ended, left)
    }

    /// One round of all stages, each from the newest of the others, in the lanes where `moving` is one.
    #[inline(always)]
    fn iterate<S: System<T> + ?Sized>(&mut self, system: &S, method: &Iterated, moving: T) {
        let (n, stride, h) = (self.size, self.y.len(), self.trial.h);
        self.last_changes().fill(T::zero());
        for (s, stage) in M::STAGES.iter().enumerate().skip(1) {
            let (at, f) = self.scratch.split_at_mut(stride);
            advance(stage.a, h, &self.y, &self.k, at);
            system.derivative(T::lit(stage.c).fma(h, self.t), &at[..n], &mut f[..n]);
            let weight = T::lit(method.weights[s]);
            for ((f, k), change) in f[..n].iter().zip(&mut self.k[s * stride..]).zip(at) {
                let new = weight * *f;
                *change = h * (new - *k);
                *k = T::select_le(T::one(), moving, new, *k);
            }
            let changes = &mut self.memory[(M::STAGES.len() + 2) * stride..];
            for (sum, block) in changes.iter_mut().zip(system.error_blocks()) {
                *sum = *sum + squared_length(&self.scratch[block.start..block.start + block.len]);
            }
        }
        self.evaluations += M::STAGES.len() as u64 - 1;
    }

    /// One in the lanes where a block changed less than ever before in this step.
    #[inline(always)]
    fn note_changes<S: System<T> + ?Sized>(&mut self, system: &S) -> T {
        let (zero, one) = (T::zero(), T::one());
        let stride = self.y.len();
        let (least, last) = self.memory[(M::STAGES.len() + 1) * stride..].split_at_mut(stride);
        let mut improved = zero;
        for ((least, last), _) in least.iter_mut().zip(last).zip(system.error_blocks()) {
            let better = T::select_le(T::lit(SMALLER) * *least, *last, zero, one);
            // Not a number is no improvement, and neither is nothing.
            let better = T::select_le(*last, zero, zero, T::select_le(*last, T::lit(HUGE), better, zero));
            *least = T::select_le(one, better, *last, *least);
            improved = improved.max(better);
        }
        improved
    }

    /// The square of the last change in units of the tolerance.
    #[inline(always)]
    fn last_change<S: System<T> + ?Sized>(&mut self, system: &S) -> T {
        let stride = self.y.len();
        let changes = &self.memory[(M::STAGES.len() + 2) * stride..];
        let mut sum = T::zero();
        for (change, block) in changes.iter().zip(system.error_blocks()) {
            sum = sum + *change / self.tolerance.allowed(block, &self.y, &self.y);
        }
        sum
    }

    /// The end of the trial step: `y` and the change in `scratch`, with what earlier sums rounded off.
    ///
    /// D. Knuth's exact sum of two numbers: Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., 4.3.
    #[inline(always)]
    fn sum(&mut self) {
        let stride = self.y.len();
        let (lost, rest) = self.memory[(M::STAGES.len() - 1) * stride..].split_at_mut(stride);
        for i in 0..stride {
            let (y, change) = (self.y[i], self.scratch[i] + lost[i]);
            let sum = y + change;
            let part = sum - y;
            rest[i] = (y - (sum - part)) + (change - part);
            self.trial.y[i] = sum;
        }
    }

    /// The first guess in `lanes`: the derivative that the step begins with.
    #[inline(always)]
    pub(super) fn forget_stages(&mut self, lanes: Lanes, method: &Iterated) {
        let stride = self.y.len();
        let stages = M::STAGES.len() - 1;
        let (guesses, rest) = self.memory.split_at_mut(stages * stride);
        for (guess, weight) in guesses.chunks_exact_mut(stride).zip(&method.weights[1..]) {
            for (guess, f) in guess.iter_mut().zip(&self.k) {
                *guess = lanes.select(T::lit(*weight) * *f, *guess);
            }
        }
        for lost in &mut rest[..stride] {
            *lost = lanes.select(T::zero(), *lost);
        }
    }

    /// The guesses for the next step, and what was rounded off, where the square of the error allows the step.
    #[inline(always)]
    pub(super) fn remember_stages(&mut self, error: T, method: &Iterated) {
        let (one, stride) = (T::one(), self.y.len());
        let (guesses, rest) = self.memory.split_at_mut((M::STAGES.len() - 1) * stride);
        for (row, guess) in method.guess.iter().zip(guesses.chunks_exact_mut(stride)) {
            let scratch = &mut self.scratch[..stride];
            change(row, one, &self.k, scratch);
            for (guess, new) in guess.iter_mut().zip(scratch) {
                *guess = T::select_le(error, one, *new, *guess);
            }
        }
        let (lost, after) = rest.split_at_mut(stride);
        for (lost, after) in lost.iter_mut().zip(after) {
            *lost = T::select_le(error, one, *after, *lost);
        }
    }

    #[inline(always)]
    fn least_changes(&mut self) -> &mut [T] {
        let stride = self.y.len();
        &mut self.memory[(M::STAGES.len() + 1) * stride..][..stride]
    }

    #[inline(always)]
    fn last_changes(&mut self) -> &mut [T] {
        let stride = self.y.len();
        &mut self.memory[(M::STAGES.len() + 2) * stride..][..stride]
    }
}
