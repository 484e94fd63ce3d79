//! What came to pass in each lane.

use super::Crossing;
use super::crossings::Crossings;
use super::inside::Inside;
use crate::integrators::{Lanes, Method};
use crate::scalar::Lane;

/// An event that came to pass.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Its place among the events.
    pub event: usize,
    /// When, s: the law has reached zero or its new side, and had not as long before as times are resolved.
    pub time: f64,
    /// The state then, in chart and form of the motion.
    pub state: Vec<f64>,
}

/// The events of one lane.
#[derive(Clone, Debug, Default)]
pub struct Record {
    pub occurrences: Vec<Occurrence>,
    /// How often each event came to pass.
    pub counts: Vec<u32>,
    /// The place of the occurrence that ended the run.
    pub stop: Option<usize>,
}

impl Record {
    /// Of nothing yet.
    pub fn clear(&mut self, events: usize) {
        self.occurrences.clear();
        self.counts.clear();
        self.counts.resize(events, 0);
        self.stop = None;
    }
}

/// A crossing within a step.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    lane: usize,
    time: f64,
    is_last: bool,
    event: usize,
}

/// Notes the crossings of an event that are wanted, `from` the sides where they began.
#[inline(always)]
pub fn note<T: Lane>(
    found: &mut Vec<Found>,
    event: usize,
    (wanted, is_last): (Crossing, bool),
    from: T,
    crossings: &Crossings<T>,
) {
    let Crossings { first, first_time, second, second_time } = *crossings;
    for (lanes, time, from) in [(first, first_time, from), (second, second_time, -from)] {
        for lane in lanes.iter() {
            let way = if from.get(lane) > 0.0 { Crossing::Falling } else { Crossing::Rising };
            if wanted == way || wanted == Crossing::Both {
                found.push(Found { lane, time: time.get(lane), is_last, event });
            }
        }
    }
}

/// Records in their order what was found in a step, up to the event that ends a lane's run: those lanes are the
/// result, and `end` is when.
#[inline(always)]
pub fn record<T: Lane, M: Method>(
    found: &mut Vec<Found>,
    records: &mut [Record],
    first_only: bool,
    inside: &mut Inside<'_, '_, T, M>,
    end: &mut T,
) -> Lanes {
    let mut stopped = Lanes::NONE;
    if found.is_empty() {
        return stopped;
    }
    found.sort_unstable_by(|a, b| {
        let times = a.lane.cmp(&b.lane).then(a.time.total_cmp(&b.time));
        times.then((a.is_last, a.event).cmp(&(b.is_last, b.event)))
    });
    for Found { lane, time, is_last, event } in found.drain(..) {
        if stopped.contains(lane) {
            continue;
        }
        let record = &mut records[lane];
        record.counts[event] = record.counts[event].saturating_add(1);
        if is_last {
            record.stop = Some(record.occurrences.len());
            stopped = stopped.with(Lanes::one(lane));
            *end = end.with(lane, time);
        }
        if !first_only || record.counts[event] == 1 {
            let state = inside.state(lane, time);
            record.occurrences.push(Occurrence { event, time, state });
        }
    }
    stopped
}
