//! One step: tried in all lanes at once, then taken or not, lane by lane.

use super::controller::{GROW, HUGE, step_factor};
use super::rigid::POSITION;
use super::stepper::TrialStep;
use super::sums::{advance, change};
use super::{Lanes, Method, RIGID, Solve, Stepper, System, Trial, Verdict};
use crate::scalar::Lane;

impl<T: Lane, M: Method> Stepper<T, M> {
    /// Tries one step in every lane.
    ///
    /// A step ends at `limit` exactly when it would reach or nearly reach it, and the step size for
    /// afterwards is kept. A lane that is at or past its limit stays where it is.
    ///
    /// A right-hand side may jump at a limit: within the step its stages are evaluated before the limit.
    /// Afterwards call [`Stepper::refresh`].
    #[inline(always)]
    pub fn attempt<S: System<T> + ?Sized>(&mut self, system: &S, limit: T) -> Trial {
        T::call(
            #[inline(always)]
            || self.attempt_inline(system, limit),
        )
    }

    #[inline(always)]
    fn attempt_inline<S: System<T> + ?Sized>(&mut self, system: &S, limit: T) -> Trial {
        let active = self.choose_step(limit);
        let left = self.stages(system);
        let raw = self.trial_error(system, left);
        // Not finite is not smaller than anything.
        let error = T::select_le(raw, T::lit(HUGE), raw, T::lit(HUGE));
        self.trial.squared_error = T::select_le(T::one(), active, error, T::lit(HUGE));
        self.tried = self.tried + active;

        let accepted = Lanes::where_le(self.trial.squared_error, T::one());
        let mut stopped = Lanes::NONE;
        self.verdicts.fill(Verdict::Accepted);
        if accepted != Lanes::all::<T>() {
            let remaining = (limit - self.t) * self.direction;
            let start_finite = self.start_finite();
            for l in 0..T::N {
                let verdict = if accepted.contains(l) {
                    Verdict::Accepted
                } else if remaining.get(l) <= 0.0 {
                    Verdict::Idle
                } else if active.get(l) == 0.0 {
                    Verdict::StepTooSmall
                } else if error.get(l) < HUGE {
                    if M::ERROR.is_empty() { Verdict::StepTooLarge } else { Verdict::Rejected }
                } else if start_finite.contains(l) && !M::ERROR.is_empty() {
                    Verdict::Diverged
                } else {
                    Verdict::NonFinite
                };
                self.verdicts[l] = verdict;
                if matches!(verdict, Verdict::StepTooSmall | Verdict::StepTooLarge | Verdict::NonFinite) {
                    stopped = stopped.with(Lanes::one(l));
                }
            }
        }
        Trial { accepted, stopped }
    }

    /// Sets size and end of the trial step; one in the lanes that move, zero in the others.
    #[inline(always)]
    fn choose_step(&mut self, limit: T) -> T {
        let (t, h, zero, one) = (self.t, self.h, T::zero(), T::one());
        let remaining = (limit - t) * self.direction;
        let adaptive = !M::ERROR.is_empty();
        // A step is stretched a little to its limit, and what is shorter than two steps is halved, so
        // that no sliver is left. A fixed step only absorbs the rounding of its times.
        let reach = h * T::lit(if adaptive { 1.01 } else { 1.001 });
        let near = h * T::lit(if adaptive { 2.0 } else { 1.0 });
        let free = if adaptive { T::select_le(remaining, near, T::lit(0.5) * remaining, h) } else { h };
        let smallest = T::lit(16.0 * f64::EPSILON) * t.abs() + T::lit(f64::MIN_POSITIVE);
        let too_small = T::select_le(remaining, reach, zero, T::select_le(smallest, free, zero, one));
        let active = T::select_le(remaining, zero, zero, one - too_small);

        // The double before the limit: the product is exact, the difference rounds to it.
        let gap = (limit.abs() * T::lit(0.5 * f64::EPSILON)).max(T::lit(f64::MIN_POSITIVE));
        let before = limit - self.direction * gap;
        let ahead = t + self.direction * free;
        let t1 = T::select_le(remaining, reach, limit, ahead);
        let t1 = T::select_le(one, active, t1, t);
        let trial = &mut self.trial;
        trial.t = t1;
        trial.t_before = T::select_le(one, active, T::select_le(remaining, reach, before, ahead), t);
        trial.h = t1 - t;
        trial.kept = T::select_le(remaining, near, h, zero);
        trial.end_evaluated = false;
        active
    }

    /// The stages and the end of the trial step; gives the square of the error that an iteration has left over.
    #[inline(always)]
    fn stages<S: System<T> + ?Sized>(&mut self, system: &S) -> T {
        let mut left = T::zero();
        let rigid = self.size == RIGID && system.first_read() == POSITION;
        match &M::SOLVE {
            Solve::Explicit if rigid => self.rigid_stages(system),
            Solve::Explicit => self.explicit_stages(system),
            Solve::Iterated(method) => left = self.iterated_stages(system, method),
            Solve::Linear(method) => self.linear_stages(system, method),
        }
        if !matches!(M::SOLVE, Solve::Iterated(_)) {
            advance(M::WEIGHTS, self.trial.h, &self.y, &self.k, &mut self.trial.y);
        }
        system.project(&mut self.trial.y[..self.size]);
        if M::FIRST_SAME_AS_LAST {
            self.evaluate_end(system);
        }
        left
    }

    #[inline(always)]
    fn explicit_stages<S: System<T> + ?Sized>(&mut self, system: &S) {
        let (n, stride) = (self.size, self.y.len());
        let TrialStep { h, t_before, .. } = self.trial;
        for (s, stage) in M::STAGES.iter().enumerate().skip(1) {
            advance(stage.a, h, &self.y, &self.k, &mut self.scratch[..stride]);
            let time = if stage.c == 1.0 { t_before } else { T::lit(stage.c).fma(h, self.t) };
            let k = self.stage(s);
            system.derivative(time, &self.scratch[..n], &mut self.k[k]);
        }
        self.evaluations += M::STAGES.len() as u64 - 1;
    }

    /// Where stage `s` lies in `k`.
    #[inline(always)]
    pub(super) fn stage(&self, s: usize) -> std::ops::Range<usize> {
        let start = s * self.y.len();
        start..start + self.size
    }

    /// Evaluates the derivative at the end of the trial step, once: [`Stepper::trial_derivative`].
    #[inline(always)]
    pub fn evaluate_end<S: System<T> + ?Sized>(&mut self, system: &S) {
        if self.trial.end_evaluated {
            return;
        }
        let end = self.stage(M::STAGES.len());
        system.derivative(self.trial.t_before, &self.trial.y[..self.size], &mut self.k[end]);
        self.trial.end_evaluated = true;
        self.evaluations += 1;
    }

    /// The square of the error, or what is `left` of it by a method of fixed step; not finite where the trial is not.
    #[inline(always)]
    fn trial_error<S: System<T> + ?Sized>(&mut self, system: &S, left: T) -> T {
        let h = self.trial.h;
        if M::ERROR.is_empty() {
            // An iteration that came to no end leaves no number in particular.
            return T::select_le(left, T::one(), not_finite(&self.trial.y) + left, left);
        }
        let (first, second) = self.scratch.split_at_mut(self.y.len());
        let (y0, y1) = (&self.y, &self.trial.y);
        if let Some(row) = M::ERROR.first() {
            change(row, h, &self.k, first);
        }
        if let Some(row) = M::ERROR_BEYOND_CHANGE {
            advance(row, h, y1, &self.k, second);
            for (second, y0) in second.iter_mut().zip(y0) {
                *second = *second - *y0;
            }
        } else if let Some(row) = M::ERROR.get(1) {
            change(row, h, &self.k, second);
        }
        self.tolerance.squared_error::<T, M>(system.error_blocks(), y0, y1, [&*first, &*second])
    }

    /// The lanes where the present state and its derivative are finite.
    #[inline(always)]
    fn start_finite(&self) -> Lanes {
        let sum = not_finite(&self.y) + not_finite(self.derivative());
        Lanes::where_le(sum, T::zero())
    }

    /// Takes the trial step in the lanes that accepted it, and sets the size of the next step in all.
    #[inline(always)]
    pub fn commit<S: System<T> + ?Sized>(&mut self, system: &S) {
        T::call(
            #[inline(always)]
            || self.commit_inline(system),
        );
    }

    #[inline(always)]
    fn commit_inline<S: System<T> + ?Sized>(&mut self, system: &S) {
        let (error, one) = (self.trial.squared_error, T::one());
        if !M::ERROR.is_empty() {
            let size = self.trial.h.abs();
            let scaled = step_factor::<T, M>(error, self.grow) * size;
            let next = T::select_le(error, one, scaled.max(self.trial.kept), scaled);
            // A lane that was not tried keeps its step.
            self.h = T::select_le(size, T::zero(), self.h, next);
            let grow = T::select_le(error, one, T::lit(GROW), one);
            self.grow = T::select_le(size, T::zero(), self.grow, grow);
        }
        self.accepted = self.accepted + T::select_le(error, one, one, T::zero());
        let taken = Lanes::where_le(error, one);
        if taken.is_empty() {
            return;
        }
        let n = self.y.len();
        let (start, later) = self.k.split_at_mut(n);
        if taken == Lanes::all::<T>() && !matches!(M::SOLVE, Solve::Iterated(_)) {
            // What most steps do, without a choice in every component.
            self.t = self.trial.t;
            std::mem::swap(&mut self.y, &mut self.trial.y);
            if self.trial.end_evaluated {
                start.copy_from_slice(&later[(M::STAGES.len() - 1) * n..][..n]);
            } else {
                system.derivative(self.trial.t_before, &self.y, start);
                self.evaluations += 1;
            }
            return;
        }
        self.evaluate_end(system);
        if let Solve::Iterated(method) = &M::SOLVE {
            self.remember_stages(error, method);
        }
        self.t = T::select_le(error, one, self.trial.t, self.t);
        let (start, later) = self.k.split_at_mut(n);
        let end = &later[(M::STAGES.len() - 1) * n..];
        let pairs = [(&mut self.y[..], &self.trial.y[..]), (start, &end[..n])];
        for (old, new) in pairs {
            for (old, new) in old.iter_mut().zip(new) {
                *old = T::select_le(error, one, *new, *old);
            }
        }
    }
}

/// Zero, or NaN where a component is not finite.
#[inline(always)]
fn not_finite<T: Lane>(x: &[T]) -> T {
    let mut sum = T::zero();
    for x in x {
        sum = x.fma(T::zero(), sum);
    }
    sum
}
