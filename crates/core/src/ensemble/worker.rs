//! The loop that drives the lanes of one thread.

use super::queue::Queue;
use super::rows::{Ended, Rows};
use super::samples::Samples;
use super::setup::Setup;
use crate::integrators::{Lanes, Method, Stepper, System, Verdict};
use crate::scalar::Lane;
use crate::simulate::{Ending, Inputs, Motion, TOO_LARGE};
use crate::watch::Watcher;

/// Trial steps between two reports.
const REPORT: u64 = 2048;

/// The lanes of one thread.
pub struct Worker<'a, T, M> {
    setup: &'a Setup<'a>,
    queue: &'a Queue,
    motion: Motion<'a, T>,
    stepper: Stepper<T, M>,
    /// The lanes that have a run.
    busy: Lanes,
    /// Which run a lane has.
    run: Vec<usize>,
    /// Up to where a lane steps next: where something jumps, or the end.
    limit: T,
    limits_passed: Vec<usize>,
    /// The largest number of trial steps.
    most: T,
    watcher: Watcher<T>,
    samples: Samples<T>,
    rows: Rows,
    /// The states that the lanes started from.
    starts: Vec<T>,
    /// Room for a state as it runs, as the model has it, and for parameters.
    running: Vec<f64>,
    asked: Vec<f64>,
    parameters: Vec<f64>,
}

impl<'a, T: Lane, M: Method> Worker<'a, T, M> {
    pub fn new(setup: &'a Setup<'a>, queue: &'a Queue) -> Self {
        let batch = setup.batch;
        T::call(
            #[inline(always)]
            || Self {
                setup,
                queue,
                motion: Motion::new(&setup.body, batch.inputs),
                stepper: Stepper::new(batch.tolerance),
                busy: Lanes::NONE,
                run: vec![0; T::N],
                limit: T::lit(batch.span[0]),
                limits_passed: vec![0; T::N],
                most: T::lit(batch.max_steps as f64),
                watcher: Watcher::new(batch.watched).keeping_first(),
                samples: Samples::new(setup),
                rows: Rows::default(),
                starts: Vec::new(),
                running: Vec::new(),
                asked: Vec::new(),
                parameters: Vec::new(),
            },
        )
    }

    /// Works until no run is left, or a report is answered by false.
    pub fn work(mut self, report: &mut dyn FnMut() -> bool) -> Rows {
        self.fill(Lanes::all::<T>());
        let mut trials = 0;
        while !self.busy.is_empty() {
            trials += 1;
            if trials % REPORT == 0 && !report() {
                break;
            }
            let free = self.step();
            if !free.is_empty() {
                self.fill(free);
            }
        }
        self.rows
    }

    /// Gives free lanes the next runs.
    fn fill(&mut self, free: Lanes) {
        let mut filled = Lanes::NONE;
        let mut y = std::mem::take(&mut self.starts);
        y.resize(self.motion.size(), T::call(T::zero));
        for l in free.iter() {
            self.busy = self.busy.without(Lanes::one(l));
            let Some(run) = self.queue.take() else { continue };
            filled = filled.with(Lanes::one(l));
            self.run[l] = run;
            self.limits_passed[l] = 0;
            let x = self.setup.start(run);
            self.setup.write_running(x, &mut self.running);
            T::call(
                #[inline(always)]
                || {
                    for (all, own) in y.iter_mut().zip(&self.running) {
                        *all = all.with(l, *own);
                    }
                    self.limit = self.limit.with(l, self.setup.limits[0]);
                },
            );
            self.motion.set_inputs(l, self.setup.constants(run));
            if !self.setup.batch.places.is_empty() {
                self.setup.write_parameters(run, &mut self.parameters);
                self.motion.set_parameters(l, &self.parameters);
            }
            self.samples.start(self.setup, l, x);
        }
        if filled.is_empty() {
            self.starts = y;
            return;
        }
        self.motion.renew();
        self.busy = self.busy.with(filled);
        let [t0, t1] = self.setup.batch.span;
        T::call(
            #[inline(always)]
            || {
                let (t0, t1) = (T::lit(t0), T::lit(t1));
                self.stepper.start(&self.motion, filled, t0, &y, t1, self.setup.batch.step);
                self.watcher.start(filled, &self.motion, t0, &y);
            },
        );
        self.starts = y;
    }

    /// One trial step in all lanes; the lanes that are free afterwards.
    fn step(&mut self) -> Lanes {
        let trial = self.stepper.attempt(&self.motion, self.limit);
        let accepted = trial.accepted;
        let ended = self.watcher.look(&self.motion, &mut self.stepper, accepted);
        if !accepted.is_empty() {
            let ends = self.ends_of_step(ended);
            self.samples.save_inside(self.setup, &self.motion, &mut self.stepper, accepted, ends);
        }
        self.stepper.commit(&self.motion);
        let (at_limit, lost) = T::call(
            #[inline(always)]
            || self.look(),
        );
        let mut free = Lanes::NONE;
        // Most steps end here.
        if trial.stopped.with(ended).is_empty() && at_limit.is_empty() && lost.is_empty() {
            return free;
        }
        for l in self.busy.iter() {
            let one = Lanes::one(l);
            let ending = if let Some(stop) = self.watcher.stop(l) {
                Some(Ending::Event(stop.event))
            } else if trial.stopped.contains(l) {
                Some(match self.stepper.verdict(l) {
                    Verdict::StepTooSmall => Ending::StepTooSmall,
                    Verdict::StepTooLarge => Ending::StepTooLarge,
                    _ => self.not_finite(l),
                })
            } else if at_limit.contains(l) {
                self.pass_limit(l)
            } else if lost.contains(l) {
                self.stepper.lane(l, &mut self.running);
                let large = self.running.iter().any(|v| v.abs() > TOO_LARGE);
                Some(if large { self.not_finite(l) } else { Ending::StepLimit })
            } else {
                None
            };
            if let Some(ending) = ending {
                self.finish(l, ending);
                free = free.with(one);
            }
        }
        free
    }

    /// Up to where the trial step counts: to its end, or to the event that ended a run.
    fn ends_of_step(&self, ended: Lanes) -> T {
        T::call(
            #[inline(always)]
            || {
                let mut ends = self.stepper.trial_t();
                for l in ended.iter() {
                    if let Some(stop) = self.watcher.stop(l) {
                        ends = ends.with(l, stop.time);
                    }
                }
                ends
            },
        )
    }

    /// The lanes that are at their limits, and those that have done too many steps or grown too large.
    #[inline(always)]
    fn look(&self) -> (Lanes, Lanes) {
        let zero = T::zero();
        let mut size = zero;
        for y in self.stepper.y() {
            size = size.max(y.abs());
        }
        let tried = self.stepper.steps() + self.stepper.rejected();
        let at_limit = Lanes::where_le(self.limit, self.stepper.t());
        let too_many = Lanes::where_le(self.most, tried);
        let large = if M::ERROR.is_empty() { Lanes::NONE } else { Lanes::where_le(T::lit(TOO_LARGE), size) };
        (at_limit.and(self.busy), too_many.with(large).and(self.busy))
    }

    /// Goes on to the next limit of lane `l`; how its run ended if there is none.
    fn pass_limit(&mut self, l: usize) -> Option<Ending> {
        self.limits_passed[l] += 1;
        let Some(next) = self.setup.limits.get(self.limits_passed[l]) else {
            return Some(Ending::ReachedEnd);
        };
        self.limit = T::call(
            #[inline(always)]
            || self.limit.with(l, *next),
        );
        self.stepper.refresh(&self.motion, Lanes::one(l));
        None
    }

    /// Writes the row of the run of lane `l`, which then stands still.
    fn finish(&mut self, l: usize, ending: Ending) {
        let (stepped_to, steps, rejected) = self.stepper.lane(l, &mut self.running);
        let mut time = stepped_to;
        if let Some(stop) = self.watcher.stop(l) {
            time = stop.time;
            self.running.clone_from(&stop.state);
        }
        self.setup.write_asked(&self.running, self.samples.last(l), &mut self.asked);
        self.rows.states.extend_from_slice(&self.asked);
        self.samples.finish(l, &mut self.rows.samples);
        self.note_watched(l);
        self.rows.ended.push(Ended { run: self.run[l], ending, time, steps, rejected });
        self.limit = T::call(
            #[inline(always)]
            || self.limit.with(l, stepped_to),
        );
        self.queue.note_done();
    }

    /// Writes what the run of lane `l` was watched for.
    fn note_watched(&mut self, l: usize) {
        let (n, watched) = (self.setup.states, self.setup.batch.watched);
        self.rows.outputs.extend(self.watcher.outputs(l));
        for event in 0..watched.events.len() {
            self.rows.event_counts.push(self.watcher.count(l, event));
            match self.watcher.occurrences(l).iter().find(|o| o.event == event) {
                Some(first) => {
                    self.setup.write_asked(&first.state, self.samples.last(l), &mut self.asked);
                    self.rows.event_times.push(first.time);
                    self.rows.event_states.extend_from_slice(&self.asked);
                }
                None => {
                    self.rows.event_times.push(f64::NAN);
                    self.rows.event_states.extend(std::iter::repeat_n(f64::NAN, n));
                }
            }
        }
    }

    /// The ending of a run whose derivative is not finite, and the law that made it so.
    fn not_finite(&self, l: usize) -> Ending {
        let (run, mut y) = (self.run[l], Vec::new());
        let (t, ..) = self.stepper.lane(l, &mut y);
        let mut parameters = Vec::new();
        self.setup.write_parameters(run, &mut parameters);
        let body = self.setup.body.with_parameters(&parameters);
        let tables = self.setup.batch.inputs.tables.clone();
        let u = Inputs { constants: self.setup.constants(run).to_vec(), tables }.at(t);
        Ending::NonFinite { force: body.culprit(t, &y, &u) }
    }
}
