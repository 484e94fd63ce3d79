//! The loop that drives one trajectory.

use super::{ChartChange, Ending, Motion, Run, TOO_LARGE, Task, limits};
use crate::integrators::{Lanes, Method, Stepper, Verdict, write_lane};
use crate::phase_space::{Chart, FreeBody};
use crate::scalar::Lane;
use crate::watch::{Watched, Watcher};

/// A run in angles goes on in quaternions when it comes this near to the singularity of its angles, rad:
/// there the rates of the angles are about seven times those of the body.
const LEAVE: f64 = 0.15;
/// A fixed step cannot grow short there, so it leaves while the body turns less than this part of the distance.
const PART: f64 = 0.1;
/// It comes back to its angles at this many times the distance; the gap keeps it from going to and fro.
const COME_BACK: f64 = 2.0;
/// Steps between two reports of progress.
const REPORT: u64 = 1024;

/// Simulates over the one-number type `T` by the method `M`.
pub fn run<T: Lane, M: Method>(
    body: &FreeBody<f64>,
    task: &Task<'_>,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Run {
    let free = (body.chart != Chart::Quaternion).then(|| body.in_quaternions());
    let models: Vec<_> = std::iter::once(body).chain(&free).collect();
    let mut driver = Driver::<T, M> {
        task,
        motions: models.iter().map(|model| Motion::new(model, task.inputs)).collect(),
        models,
        stepper: Stepper::new(task.tolerance),
        watcher: Watcher::new(task.watched.unwrap_or(&Watched::default())),
        current: 0,
        last: task.x0.to_vec(),
        last_time: task.span[0],
        run: Run {
            times: Vec::new(),
            states: Vec::new(),
            ending: Ending::ReachedEnd,
            end_time: task.span[0],
            end_state: Vec::new(),
            chart_changes: Vec::new(),
            occurrences: Vec::new(),
            outputs: Vec::new(),
            steps: 0,
            rejected: 0,
            evaluations: 0,
        },
        saved: 0,
    };
    driver.start();
    driver.run.ending = driver.go(progress);
    driver.finish()
}

/// A run on its way: the model as asked for and, unless it is that, the same in quaternions, one of them at work.
pub(super) struct Driver<'a, T, M> {
    pub(super) task: &'a Task<'a>,
    pub(super) models: Vec<&'a FreeBody<f64>>,
    pub(super) motions: Vec<Motion<'a, T>>,
    pub(super) stepper: Stepper<T, M>,
    pub(super) watcher: Watcher<T>,
    /// Which of the two is at work: 0 as asked for, 1 in quaternions.
    pub(super) current: usize,
    /// The state in the chart asked for, after the last step or sample.
    pub(super) last: Vec<f64>,
    /// When that was, s.
    pub(super) last_time: f64,
    pub(super) run: Run,
    /// How many of the wanted times are done.
    pub(super) saved: usize,
}

const ONE: Lanes = Lanes::one(0);

impl<T: Lane, M: Method> Driver<'_, T, M> {
    fn start(&mut self) {
        let [t0, t1] = self.task.span;
        let near = self.asked_distance() < self.leave();
        self.current = usize::from(near);
        let y = self.state_for(self.current);
        let (motion, t) = (&self.motions[self.current], T::lit(t0));
        self.stepper.start(motion, ONE, t, &y, T::lit(t1), self.task.step);
        self.watcher.start(ONE, motion, t, &y);
        if near {
            self.note_change(t0, true);
        }
        let wanted = self.task.save_at.is_none_or(|s| s.first() == Some(&t0));
        if wanted {
            let x = self.last.clone();
            self.save(t0, &x);
            self.saved = 1;
        }
    }

    fn go(&mut self, progress: &mut dyn FnMut(f64) -> bool) -> Ending {
        let t1 = self.task.span[1];
        for limit in limits(self.models[0], self.task.inputs, self.task.span) {
            while self.time() < limit {
                let done = self.run.steps + self.run.rejected;
                if done >= self.task.max_steps {
                    return Ending::StepLimit;
                }
                if done % REPORT == REPORT - 1 && !progress(self.time()) {
                    return Ending::Interrupted;
                }
                if let Some(ending) = self.step(limit) {
                    return ending;
                }
            }
            if limit < t1 {
                self.stepper.refresh(&self.motions[self.current], ONE);
            }
        }
        Ending::ReachedEnd
    }

    /// One trial step; how the run ended if it cannot go on.
    fn step(&mut self, limit: f64) -> Option<Ending> {
        let angles = self.current == 0;
        let limit = if angles { self.before_singularity(limit) } else { limit };
        let trial = self.stepper.attempt(&self.motions[self.current], T::lit(limit));
        if !trial.stopped.is_empty() {
            if angles && self.asked_distance() < COME_BACK * self.leave() {
                self.change_chart(true);
                return None;
            }
            return Some(match self.stepper.verdict(0) {
                Verdict::StepTooSmall => Ending::StepTooSmall,
                Verdict::StepTooLarge => Ending::StepTooLarge,
                _ => Ending::NonFinite { force: self.culprit() },
            });
        }
        if trial.accepted.is_empty() {
            self.run.rejected += 1;
            self.stepper.commit(&self.motions[self.current]);
        } else if angles && self.trial_goes_too_far() {
            // The step is not taken: it is tried again in quaternions.
            self.run.rejected += 1;
            self.change_chart(true);
        } else {
            if let Some(event) = self.take_step() {
                return Some(Ending::Event(event));
            }
            if !M::ERROR.is_empty() && self.last.iter().any(|v| v.abs() > TOO_LARGE) {
                return Some(Ending::NonFinite { force: self.culprit() });
            }
        }
        None
    }

    /// Commits the accepted trial step and changes the chart where that is due; or goes to the event that ends the
    /// run within it.
    fn take_step(&mut self) -> Option<usize> {
        self.run.steps += 1;
        let before = self.asked_distance();
        self.watcher.look(&self.motions[self.current], &mut self.stepper, ONE);
        let stop = self.watcher.stop(0).map(|stop| (stop.event, stop.time));
        let end = stop.map_or(self.stepper.trial_t().get(0), |(_, time)| time);
        self.save_inside(end);
        if let (Some((event, time)), Some(last)) = (stop, self.run.occurrences.last()) {
            (self.last, self.last_time) = (last.state.clone(), time);
            if self.task.save_at.is_none() {
                let x = self.last.clone();
                self.save(time, &x);
            }
            return Some(event);
        }
        self.stepper.commit(&self.motions[self.current]);
        let mut y = Vec::with_capacity(self.last.len() + 1);
        T::call(
            #[inline(always)]
            || write_lane(self.stepper.y(), 0, &mut y),
        );
        self.last = if self.current == 0 { y } else { self.as_asked(&y) };
        self.last_time = self.time();
        if self.task.save_at.is_none() {
            let x = self.last.clone();
            self.save(self.time(), &x);
        }
        let (distance, leave) = (self.asked_distance(), self.leave());
        if self.current == 0 && distance < leave {
            self.change_chart(true);
        } else if self.current == 1 && distance.is_finite() && distance > COME_BACK * leave {
            // While it still approaches, it would only have to leave again.
            if distance > before || distance > 2.0 * COME_BACK * leave {
                self.change_chart(false);
            }
        }
        None
    }

    fn time(&self) -> f64 {
        self.stepper.t().get(0)
    }

    /// Distance of the last state to the singularity of the chart asked for; far where it has none.
    fn asked_distance(&self) -> f64 {
        self.models[0].singularity_distance(&self.last).unwrap_or(f64::INFINITY)
    }

    /// The distance to the singularity at which the angles are to be left, rad.
    fn leave(&self) -> f64 {
        if !M::ERROR.is_empty() {
            return LEAVE;
        }
        let step = self.task.step.unwrap_or(0.0);
        LEAVE.max(step * self.models[0].rigid_state(&self.last).twist.angular.norm() / PART)
    }

    /// When the second angle will be near its singularity if it goes on as now, or the limit if that is sooner:
    /// a long step must not leap over it. Fixed steps stay as they are.
    fn before_singularity(&self, limit: f64) -> f64 {
        let distance = self.asked_distance();
        if M::ERROR.is_empty() || distance.is_infinite() {
            return limit;
        }
        let rate = self.stepper.derivative()[4].get(0).abs();
        let soon = self.time() + (distance - 0.5 * LEAVE).max(0.5 * LEAVE) / rate;
        if soon < limit { soon } else { limit }
    }

    /// Whether the trial step in angles ends too near to the singularity, or may have passed it.
    fn trial_goes_too_far(&self) -> bool {
        if self.models[0].chart == Chart::Quaternion {
            return false;
        }
        let y: Vec<f64> = self.stepper.trial_y().iter().map(|v| v.get(0)).collect();
        let Some(distance) = self.models[0].singularity_distance(&y) else { return false };
        // The error of a fixed step is not watched: it keeps away altogether.
        let allowed = if M::ERROR.is_empty() { self.leave() } else { 0.25 * LEAVE };
        // The second angle cannot pass the singularity without moving by both distances.
        distance < allowed || (y[4] - self.last[4]).abs() >= distance + self.asked_distance()
    }

    /// The last state in the chart of either model.
    fn state_for(&self, which: usize) -> Vec<T> {
        let model = self.models[which];
        if which == 0 {
            return self.last.iter().map(|v| T::lit(*v)).collect();
        }
        let y = change(self.models[0], &self.last, model, &vec![0.0; model.rigid_size()]);
        y.iter().map(|v| T::lit(*v)).collect()
    }

    /// A state in quaternions in the chart asked for; of its angle triples the one nearest to the last.
    fn as_asked(&self, y: &[f64]) -> Vec<f64> {
        change(self.models[1], y, self.models[0], &self.last)
    }

    fn change_chart(&mut self, left: bool) {
        self.current = usize::from(left);
        let (t, y) = (self.stepper.t(), self.state_for(self.current));
        self.stepper.restart(&self.motions[self.current], ONE, t, &y);
        self.note_change(t.get(0), left);
    }

    fn note_change(&mut self, time: f64, left: bool) {
        let changes = &mut self.run.chart_changes;
        // A change at the moment of the one before takes it back.
        if changes.last().is_some_and(|c| c.time == time) {
            changes.pop();
            return;
        }
        let distance = self.asked_distance();
        self.run.chart_changes.push(ChartChange { time, left, distance });
    }

    /// The law that is not finite at the last state, if there is one.
    fn culprit(&self) -> Option<usize> {
        let t = self.time();
        self.models[0].culprit(t, &self.last, &self.task.inputs.at(t))
    }

    fn finish(mut self) -> Run {
        self.run.end_time = self.last_time;
        self.run.outputs = self.watcher.outputs(0);
        self.run.evaluations = self.stepper.evaluations();
        self.run.end_state = self.last;
        self.run
    }
}

/// A state of one model as that of the same model in another chart, nearest to `like`.
fn change(from: &FreeBody<f64>, x: &[f64], to: &FreeBody<f64>, like: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; to.rigid_size()];
    to.write_state(&from.rigid_state(x), like, &mut y);
    y.extend_from_slice(&x[from.rigid_size()..]);
    y
}
