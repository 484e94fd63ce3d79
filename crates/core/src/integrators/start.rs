//! Trajectories put into lanes.

use super::controller::{GROW, power};
use super::sums::{advance, squared_length};
use super::{Lanes, Method, Solve, Stepper, System, collocation};
use crate::scalar::Lane;

impl<T: Lane, M: Method> Stepper<T, M> {
    /// Puts new trajectories into `lanes`, from `(t, y)` towards `end`; the other lanes go on undisturbed.
    ///
    /// `step` is the first step size, and the size of all steps of a method with fixed step; without it
    /// the first step is chosen from two evaluations (Hairer, Nørsett & Wanner, II.4). The size of the
    /// system may change only when all lanes start.
    #[inline(always)]
    pub fn start<S: System<T> + ?Sized>(
        &mut self,
        system: &S,
        lanes: Lanes,
        t: T,
        y: &[T],
        end: T,
        step: Option<f64>,
    ) {
        T::call(
            #[inline(always)]
            || {
                let (zero, one) = (T::zero(), T::one());
                let span = end - t;
                self.direction = lanes.select(T::select_le(zero, span, one, -one), self.direction);
                self.grow = lanes.select(T::lit(GROW), self.grow);
                self.accepted = lanes.select(zero, self.accepted);
                self.tried = lanes.select(zero, self.tried);
                self.put(system, lanes, t, y);
                let h = match step {
                    Some(step) => T::lit(step),
                    None => self.first_step(system, span),
                };
                self.h = lanes.select(h, self.h);
            },
        );
    }

    /// Goes on from another state, or with another system, in `lanes`; the step size is kept.
    ///
    /// To leave a step where an event lies inside it, interpolate there, commit, and restart from there.
    /// The size of the system may change only when all lanes restart.
    #[inline(always)]
    pub fn restart<S: System<T> + ?Sized>(&mut self, system: &S, lanes: Lanes, t: T, y: &[T]) {
        T::call(
            #[inline(always)]
            || self.put(system, lanes, t, y),
        );
    }

    /// Evaluates the right-hand side afresh at the present state of `lanes`: it has jumped.
    #[inline(always)]
    pub fn refresh<S: System<T> + ?Sized>(&mut self, system: &S, lanes: Lanes) {
        T::call(
            #[inline(always)]
            || self.evaluate_start(system, lanes),
        );
    }

    #[inline(always)]
    fn put<S: System<T> + ?Sized>(&mut self, system: &S, lanes: Lanes, t: T, y: &[T]) {
        self.resize(system.size());
        self.t = lanes.select(t, self.t);
        for (old, new) in self.y.iter_mut().zip(y) {
            *old = lanes.select(*new, *old);
        }
        self.evaluate_start(system, lanes);
    }

    #[inline(always)]
    fn resize(&mut self, size: usize) {
        if size == self.size {
            return;
        }
        let stages = M::STAGES.len() + 1 + M::DENSE_STAGES.len();
        self.size = size;
        let vectors =
            [(&mut self.y, 1), (&mut self.trial.y, 1), (&mut self.k, stages), (&mut self.scratch, 2)];
        let memory = match M::SOLVE {
            Solve::Explicit => 0,
            Solve::Iterated(_) => collocation::memory(M::STAGES.len() - 1),
            Solve::Linear(_) => 1,
        };
        let more = [(&mut self.dense, 3 + M::DENSE.len()), (&mut self.memory, memory)];
        for (vector, count) in vectors.into_iter().chain(more) {
            *vector = vec![T::zero(); count * size];
        }
    }

    /// The first stage, in `lanes`.
    #[inline(always)]
    fn evaluate_start<S: System<T> + ?Sized>(&mut self, system: &S, lanes: Lanes) {
        let n = self.size;
        let f = &mut self.scratch[..n];
        system.derivative(self.t, &self.y[..n], f);
        self.evaluations += 1;
        for (k, f) in self.k.iter_mut().zip(f) {
            *k = lanes.select(*f, *k);
        }
        if let Solve::Iterated(method) = &M::SOLVE {
            self.forget_stages(lanes, method);
        }
    }

    /// Hairer's first step, at most as long as `span`.
    #[inline(always)]
    fn first_step<S: System<T> + ?Sized>(&mut self, system: &S, span: T) -> T {
        let (n, stride) = (self.size, self.y.len());
        let span = span.abs();
        let d0 = self.norm(system, &self.y);
        let d1 = self.norm(system, &self.k[..n]);
        let tiny = d0.min(d1);
        let h0 = T::select_le(T::lit(1e-5), tiny, T::lit(0.01) * d0 / d1, T::lit(1e-6)).min(span);

        let step = self.direction * h0;
        let (at, f) = self.scratch.split_at_mut(stride);
        advance(&[(0, 1.0)], step, &self.y, &self.k, at);
        system.derivative(self.t + step, &at[..n], &mut f[..n]);
        self.evaluations += 1;
        for (f, k) in f.iter_mut().zip(&self.k) {
            *f = *f - *k;
        }
        let d2 = self.norm(system, &self.scratch[stride..]) / h0;

        let exponent = 1.0 / M::ORDER as f64;
        let d = d1.max(d2);
        let ratio = T::lit(0.01) / d.max(T::lit(1e-15)).min(T::lit(1e200));
        let curved = power(ratio, exponent);
        let straight = (T::lit(1e-3) * h0).max(T::lit(1e-6));
        let h1 = T::select_le(d, T::lit(1e-15), straight, curved);
        let h = (T::lit(100.0) * h0).min(h1).min(span);
        // With a state or derivative that is not finite, any step will find that out.
        T::select_le(h, span, h, span)
    }

    /// The length of a vector in units of the tolerated error at the present state, quadratures left out: one that
    /// begins at zero, as positions do, tolerates next to nothing there, and would hold back a step that it has no
    /// part in.
    #[inline(always)]
    fn norm<S: System<T> + ?Sized>(&self, system: &S, x: &[T]) -> T {
        let (mut sum, mut count) = (T::zero(), 0u32);
        for block in system.error_blocks() {
            let end = block.start + block.len;
            if end > system.first_read() {
                let length = squared_length(&x[block.start..end]);
                sum = sum + length / self.tolerance.allowed(block, &self.y, &self.y);
                count += 1;
            }
        }
        (sum * T::lit(1.0 / f64::from(count.max(1)))).sqrt()
    }
}
