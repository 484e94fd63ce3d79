//! What came of the runs.

use super::setup::Setup;
use crate::simulate::Ending;

/// How one run ended.
#[derive(Clone, Debug)]
pub struct Ended {
    /// Which run.
    pub run: usize,
    /// How.
    pub ending: Ending,
    /// When, s.
    pub time: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
}

/// The rows of some runs; states and samples are as the model has its state.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    /// How each run ended.
    pub ended: Vec<Ended>,
    /// The last state of each run.
    pub states: Vec<f64>,
    /// The states of each run at the wanted times; not a number after its end.
    pub samples: Vec<f64>,
    /// The outputs of each run.
    pub outputs: Vec<f64>,
    /// How often each event came to pass in each run.
    pub event_counts: Vec<u32>,
    /// When it first did; not a number if it never did.
    pub event_times: Vec<f64>,
    /// The states then.
    pub event_states: Vec<f64>,
}

impl Rows {
    /// The rows of all threads by the number of the run.
    pub(super) fn merged(parts: Vec<Self>, setup: &Setup<'_>, times: usize) -> Self {
        let (n, runs) = (setup.states, setup.runs);
        let nobody = Ended { run: 0, ending: Ending::Interrupted, time: f64::NAN, steps: 0, rejected: 0 };
        let mut all = Self { ended: vec![nobody; runs], ..Self::default() };
        let watched = setup.batch.watched;
        let (events, outputs) = (watched.events.len(), watched.outputs.len());
        for part in &parts {
            let places: Vec<usize> = part.ended.iter().map(|e| e.run).collect();
            let put = |from: &[f64], to: &mut Vec<f64>, size: usize| spread(from, to, &places, size, runs);
            put(&part.states, &mut all.states, n);
            put(&part.samples, &mut all.samples, n * times);
            put(&part.outputs, &mut all.outputs, outputs);
            put(&part.event_times, &mut all.event_times, events);
            put(&part.event_states, &mut all.event_states, n * events);
            spread(&part.event_counts, &mut all.event_counts, &places, events, runs);
            for (place, ended) in places.iter().zip(&part.ended) {
                all.ended[*place] = ended.clone();
            }
        }
        all
    }
}

/// Copies rows of `size` numbers to their places among all.
fn spread<N: Copy + Default>(from: &[N], to: &mut Vec<N>, places: &[usize], size: usize, runs: usize) {
    to.resize(runs * size, N::default());
    for (i, place) in places.iter().enumerate() {
        to[place * size..][..size].copy_from_slice(&from[i * size..][..size]);
    }
}
