//! The samples of a run, in the chart asked for.

use super::branch::follow;
use super::run::Driver;
use crate::integrators::{Method, System, write_lane};
use crate::scalar::Lane;
use crate::watch::Occurrence;

impl<T: Lane, M: Method> Driver<'_, T, M> {
    /// Saves the wanted times and events up to `end` inside the accepted trial step, and follows the angles there.
    pub(super) fn save_inside(&mut self, end: f64) {
        let wanted = self.task.save_at.and_then(|all| all.get(self.saved..)).unwrap_or(&[]);
        let due = &wanted[..wanted.partition_point(|t| *t <= end)];
        let events = self.watcher.occurrences(0).len();
        if due.is_empty() && self.run.occurrences.len() == events && self.current == 0 {
            return;
        }
        self.stepper.dense(&self.motions[self.current]);
        for t in due {
            self.record_until(*t);
            let x = self.inside(*t);
            self.save(*t, &x);
        }
        self.saved += due.len();
        self.record_until(end);
        if self.current == 1 {
            self.inside(end);
        }
    }

    /// Records the events up to a time inside the trial step.
    fn record_until(&mut self, t: f64) {
        let seen = |driver: &Self| driver.watcher.occurrences(0).get(driver.run.occurrences.len()).cloned();
        while let Some(next) = seen(self).filter(|next| next.time <= t) {
            let state = self.inside(next.time);
            self.run.occurrences.push(Occurrence { state, ..next });
        }
    }

    /// The state inside the trial step, in the chart asked for; in rising order of time.
    fn inside(&mut self, t: f64) -> Vec<f64> {
        let model = self.models[self.current];
        let motion = &self.motions[self.current];
        let interpolated = |t: f64| {
            let mut x = Vec::new();
            T::call(
                #[inline(always)]
                || {
                    let mut y = vec![T::zero(); motion.size()];
                    self.stepper.interpolate(T::lit(t), &mut y);
                    motion.project(&mut y);
                    write_lane(&y, 0, &mut x);
                },
            );
            x
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
