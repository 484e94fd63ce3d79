//! Stages that are solutions of linear systems.

use super::stepper::TrialStep;
use super::sums::{advance, change};
use super::{Linear, Method, Stepper, System};
use crate::scalar::Lane;

impl<T: Lane, M: Method> Stepper<T, M> {
    /// The stages of a Rosenbrock-Wanner method.
    ///
    /// Hairer & Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., (IV.7.25), multiplied by the step size:
    /// `(1/γ - h ∂f/∂y) k_i = f(t + c_i h, y + h Σ a_ij k_j) + Σ c_ij k_j + h d_i ∂f/∂t`.
    #[inline(always)]
    pub(super) fn linear_stages<S: System<T> + ?Sized>(&mut self, system: &S, method: &Linear) {
        let (n, stride) = (self.size, self.y.len());
        let TrialStep { h, t_before, .. } = self.trial;
        self.lu.matrix.resize(n * n, T::zero());
        system.jacobian(self.t, &self.y[..n], &mut self.memory[..n], &mut self.lu.matrix);
        for x in &mut self.lu.matrix {
            *x = -(h * *x);
        }
        for x in self.lu.matrix.iter_mut().step_by(n + 1) {
            *x = *x + T::lit(1.0 / method.gamma);
        }
        self.lu.factor(n);

        for (s, stage) in M::STAGES.iter().enumerate().skip(1) {
            let range = self.stage(s);
            if stage.a.is_empty() {
                self.k.copy_within(..n, range.start);
            } else {
                advance(stage.a, h, &self.y, &self.k, &mut self.scratch[..stride]);
                let time = if stage.c == 1.0 { t_before } else { T::lit(stage.c).fma(h, self.t) };
                system.derivative(time, &self.scratch[..n], &mut self.k[range.clone()]);
                self.evaluations += 1;
                change(method.rows[s], T::one(), &self.k, &mut self.scratch[..stride]);
                for (k, sum) in self.k[range.clone()].iter_mut().zip(&self.scratch) {
                    *k = *k + *sum;
                }
            }
            let k = &mut self.k[range];
            let by_time = T::lit(method.by_time[s]) * h;
            for (k, f) in k.iter_mut().zip(&self.memory) {
                *k = by_time.fma(*f, *k);
            }
            self.lu.solve(k);
        }
    }
}
