//! The solution inside a step.
//!
//! Over the step, with x from 0 to 1, it is the polynomial of Hairer, Nørsett & Wanner, II.6:
//! `y0 + x (r0 + (1 - x) (r1 + x (r2 + (1 - x) (r3 + ...))))`. The first three terms fit the values and
//! derivatives at both ends, unless the method has its own; the rest are weighted sums of the stages. Since `r0` is the difference of
//! the ends, it meets a projected end too.

use super::sums::{advance, change};
use super::{Method, Stepper, System};
use crate::scalar::Lane;

impl<T: Lane, M: Method> Stepper<T, M> {
    /// Prepares [`Stepper::interpolate`] for the present trial step; to be called before it is committed.
    #[inline(always)]
    pub fn dense<S: System<T> + ?Sized>(&mut self, system: &S) {
        T::call(
            #[inline(always)]
            || {
                self.evaluate_end(system);
                self.dense_stages(system);
                self.dense_terms();
            },
        );
    }

    #[inline(always)]
    fn dense_stages<S: System<T> + ?Sized>(&mut self, system: &S) {
        let (n, stride, h) = (self.size, self.y.len(), self.trial.h);
        for (s, stage) in M::DENSE_STAGES.iter().enumerate() {
            let time = T::lit(stage.c).fma(h, self.t);
            let k = self.stage(s + M::STAGES.len() + 1);
            advance(stage.a, h, &self.y, &self.k, &mut self.scratch[..stride]);
            system.derivative(time, &self.scratch[..n], &mut self.k[k]);
        }
        self.evaluations += M::DENSE_STAGES.len() as u64;
    }

    #[inline(always)]
    fn dense_terms(&mut self) {
        let (n, h) = (self.y.len(), self.trial.h);
        let (f0, f1) = (&self.k[..n], &self.k[M::STAGES.len() * n..]);
        let (r0, rest) = self.dense.split_at_mut(n);
        let (r1, rest) = rest.split_at_mut(n);
        let (r2, rest) = rest.split_at_mut(n);
        for i in 0..n {
            let change = self.trial.y[i] - self.y[i];
            r0[i] = change;
            if M::DENSE_CUBIC.is_none() {
                r1[i] = h * f0[i] - change;
                r2[i] = change + change - h * (f0[i] + f1[i]);
            }
        }
        if let Some([second, third]) = M::DENSE_CUBIC {
            change(second, h, &self.k, r1);
            change(third, h, &self.k, r2);
        }
        for (row, term) in M::DENSE.iter().zip(rest.chunks_exact_mut(n)) {
            change(row, h, &self.k, term);
        }
    }

    /// The state inside the trial step, each lane at its own time `t`.
    #[inline(always)]
    pub fn interpolate(&self, t: T, out: &mut [T]) {
        T::call(
            #[inline(always)]
            || {
                let x = (t - self.t) / self.trial.h;
                for (i, out) in out.iter_mut().enumerate() {
                    *out = self.component_at(x, i);
                }
            },
        );
    }

    #[inline(always)]
    fn component_at(&self, x: T, i: usize) -> T {
        let n = self.y.len();
        let factors = [x, T::one() - x];
        let last = 2 + M::DENSE.len();
        let mut y = self.dense[last * n + i];
        for r in (0..last).rev() {
            y = factors[(r + 1) % 2].fma(y, self.dense[r * n + i]);
        }
        x.fma(y, self.y[i])
    }
}
