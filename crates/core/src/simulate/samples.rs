//! The samples of a run, in the chart asked for.

use super::branch::follow;
use super::run::Driver;
use crate::integrators::Method;
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::Lane;

impl<T: Lane, M: Method> Driver<'_, T, M> {
    /// Saves the wanted times inside the accepted trial step, and follows the angles to its end.
    pub(super) fn save_inside(&mut self) {
        let end = self.stepper.trial_t().get(0);
        let wanted = self.task.save_at.and_then(|all| all.get(self.saved..)).unwrap_or(&[]);
        let due = &wanted[..wanted.partition_point(|t| *t <= end)];
        if due.is_empty() && self.current == 0 {
            return;
        }
        self.stepper.dense(&self.motions[self.current]);
        for t in due {
            let x = self.inside(*t);
            self.save(*t, &x);
        }
        self.saved += due.len();
        if self.current == 1 {
            self.inside(end);
        }
    }

    /// The state inside the trial step, in the chart asked for; in rising order of time.
    fn inside(&mut self, t: f64) -> Vec<f64> {
        let model = self.models[self.current];
        let interpolated = |t: f64| {
            let mut y = vec![0.0; <FreeBody<f64> as Dynamics<f64>>::state_size(model)];
            self.stepper.interpolate_lane(0, t, &mut y);
            Dynamics::<f64>::project(model, &mut y);
            y
        };
        if self.current == 0 {
            return interpolated(t);
        }
        let way = [self.last_time, t];
        let y = interpolated(t);
        follow(self.models[0], &mut self.last, way, |t| model.rigid_state(&interpolated(t)));
        let asked = self.models[0].rigid_size();
        self.last[asked..].copy_from_slice(&y[model.rigid_size()..]);
        self.last_time = t;
        self.last.clone()
    }

    /// Adds a sample.
    pub(super) fn save(&mut self, t: f64, x: &[f64]) {
        self.run.times.push(t);
        self.run.states.extend_from_slice(x);
    }
}
