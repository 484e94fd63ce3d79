//! Watches the trajectories in the lanes of a stepper.

use super::crossings::{find, next_side, side};
use super::extremes::follow;
use super::inside::Inside;
use super::record::{Found, Occurrence, Record, note, record};
use super::seer::{Reading, Seer};
use super::{Crossing, Take, Watched};
use crate::integrators::{Lanes, Method, Stepper};
use crate::scalar::{Lane, Real};
use crate::simulate::Motion;

/// The events and outputs of one trajectory in each lane.
pub struct Watcher<T> {
    seer: Seer<T>,
    /// Of each event: which way, and whether it ends the run.
    wanted: Vec<(Crossing, bool)>,
    takes: Vec<Take>,
    /// Whether only the first occurrence of each event is kept.
    first_only: bool,
    /// Of all laws, events first, at the end of the last accepted step.
    last: Vec<Reading<T>>,
    /// Of all laws at the end of the trial step.
    next: Vec<Reading<T>>,
    /// Of each event: the side of zero that it is on, -1 or 1, or 0 as long as it is not known.
    sides: Vec<T>,
    /// What each output has taken.
    kept: Vec<T>,
    /// Lanes whose last readings are not those that the next step begins with.
    stale: Lanes,
    found: Vec<Found>,
    records: Vec<Record>,
}

impl<T: Lane> Watcher<T> {
    /// Ready to watch.
    pub fn new(watched: &Watched) -> Self {
        let (events, outputs) = (&watched.events, &watched.outputs);
        let laws = events.iter().map(|e| &e.law).chain(outputs.iter().map(|o| &o.law));
        let count = events.len() + outputs.len();
        T::call(
            #[inline(always)]
            || Self {
                seer: Seer::new(laws),
                wanted: events.iter().map(|e| (e.crossing, e.terminal)).collect(),
                takes: outputs.iter().map(|o| o.take).collect(),
                first_only: false,
                last: vec![Reading::zero(); count],
                next: vec![Reading::zero(); count],
                sides: vec![T::zero(); events.len()],
                kept: vec![T::zero(); outputs.len()],
                stale: Lanes::NONE,
                found: Vec::new(),
                records: vec![Record::default(); T::N],
            },
        )
    }

    /// The same, keeping the first occurrence of each event alone; all of them are counted.
    pub fn keeping_first(self) -> Self {
        Self { first_only: true, ..self }
    }

    /// Whether there is nothing to watch.
    #[inline(always)]
    pub fn is_idle(&self) -> bool {
        self.last.is_empty()
    }

    /// Begins anew in `lanes`, where the stepper starts at (t, y); takes over the parameters of all lanes.
    #[inline(always)]
    pub fn start(&mut self, lanes: Lanes, motion: &Motion<'_, T>, t: T, y: &[T]) {
        if self.is_idle() {
            return;
        }
        for l in lanes.iter() {
            self.records[l].clear(self.wanted.len());
        }
        T::call(
            #[inline(always)]
            || {
                self.seer.renew(motion);
                // Rates come with the first step; outputs begin with values alone.
                self.seer.read(motion, t, y, y, &mut self.next);
                for side in &mut self.sides {
                    *side = lanes.select(T::zero(), *side);
                }
                for (kept, begin) in self.kept.iter_mut().zip(&self.next[self.wanted.len()..]) {
                    *kept = lanes.select(begin.value, *kept);
                }
                self.stale = self.stale.with(lanes);
            },
        );
    }

    /// Looks into the trial step in the lanes that accepted it, before it is committed; gives the lanes where an event
    /// within it ends the run.
    #[inline(always)]
    pub fn look<M: Method>(
        &mut self,
        motion: &Motion<'_, T>,
        stepper: &mut Stepper<T, M>,
        accepted: Lanes,
    ) -> Lanes {
        if self.is_idle() || accepted.is_empty() {
            return Lanes::NONE;
        }
        T::call(
            #[inline(always)]
            || {
                self.refresh(motion, stepper);
                stepper.evaluate_end(motion);
                let (t, y, dy) = (stepper.trial_t(), stepper.trial_y(), stepper.trial_derivative());
                self.seer.read(motion, t, y, dy, &mut self.next);
                self.stale = self.stale.with(stepper.trial_at_limit().and(accepted));
                let mut inside = Inside::new(&mut self.seer, motion, stepper);

                let events = self.wanted.len();
                let mut end = t;
                for e in 0..events {
                    let ends = [self.last[e], self.next[e]];
                    let found = find(&mut inside, e, accepted, self.sides[e], ends);
                    note(&mut self.found, e, self.wanted[e], self.sides[e], &found);
                    self.sides[e] = accepted.select(next_side(self.sides[e], self.next[e]), self.sides[e]);
                }
                let stopped =
                    record(&mut self.found, &mut self.records, self.first_only, &mut inside, &mut end);
                for (o, take) in self.takes.iter().enumerate() {
                    let law = events + o;
                    let mut ends = [self.last[law], self.next[law]];
                    if !stopped.is_empty() {
                        let earlier = inside.reading(law, end);
                        ends[1] = select(stopped, earlier, ends[1]);
                    }
                    let taken = follow(&mut inside, law, accepted, (*take, self.kept[o]), end, ends);
                    self.kept[o] = accepted.select(taken, self.kept[o]);
                }
                for (last, next) in self.last.iter_mut().zip(&self.next) {
                    *last = select(accepted, *next, *last);
                }
                stopped
            },
        )
    }

    /// Reads the laws where the stepper is, in lanes that have just started or may have jumped.
    #[inline(always)]
    fn refresh<M: Method>(&mut self, motion: &Motion<'_, T>, stepper: &Stepper<T, M>) {
        if self.stale.is_empty() {
            return;
        }
        self.seer.read(motion, stepper.t(), stepper.y(), stepper.derivative(), &mut self.next);
        for (last, now) in self.last.iter_mut().zip(&self.next) {
            *last = select(self.stale, *now, *last);
        }
        for (before, now) in self.sides.iter_mut().zip(&self.last) {
            let known = Lanes::where_le(T::one(), before.abs());
            *before = known.select(*before, side(*now));
        }
        self.stale = Lanes::NONE;
    }

    /// The occurrence that ended the run in lane `l`.
    pub fn stop(&self, l: usize) -> Option<&Occurrence> {
        let record = &self.records[l];
        record.stop.map(|place| &record.occurrences[place])
    }

    /// The events in lane `l` in the order of their times, with that which ended the run.
    pub fn occurrences(&self, l: usize) -> &[Occurrence] {
        &self.records[l].occurrences
    }

    /// How often an event came to pass in lane `l`.
    pub fn count(&self, l: usize, event: usize) -> u32 {
        self.records[l].counts[event]
    }

    /// The outputs of lane `l`.
    pub fn outputs(&self, l: usize) -> Vec<f64> {
        let mut outputs = Vec::with_capacity(self.kept.len());
        T::call(
            #[inline(always)]
            || {
                for kept in &self.kept {
                    outputs.push(kept.get(l));
                }
            },
        );
        outputs
    }
}

/// `x` in `lanes`, `y` in the others.
#[inline(always)]
fn select<T: Lane>(lanes: Lanes, x: Reading<T>, y: Reading<T>) -> Reading<T> {
    Reading { value: lanes.select(x.value, y.value), slope: [lanes.select(x.slope[0], y.slope[0])] }
}
