//! Events and outputs: scalar laws of a motion that are watched while it is integrated, in lanes.
//!
//! At the end of every accepted step each law gives its value and its rate along the motion. A change of sign is a
//! crossing; rates that lead to zero and away from it may mean two. Both are found inside the step on its
//! continuous output, as are the extremes of outputs. What turns more often within one step can be missed.

mod bracket;
mod crossings;
mod extremes;
mod inside;
mod record;
mod seer;
#[cfg(test)]
mod tests;
mod watcher;

pub use record::Occurrence;
pub use watcher::Watcher;

use crate::forces::Traced;

/// Which crossings of zero are an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// Any.
    Both,
}

/// What happens when a law crosses zero.
#[derive(Clone, Debug)]
pub struct Event {
    /// Of one result, without states.
    pub law: Traced<f64>,
    /// Which way.
    pub crossing: Crossing,
    /// Whether it ends the run.
    pub terminal: bool,
}

/// What an output takes of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Take {
    /// The value at its end.
    Final,
    /// The least value.
    Least,
    /// The greatest value.
    Greatest,
}

/// A number that a run yields.
#[derive(Clone, Debug)]
pub struct Output {
    /// Of one result, without states.
    pub law: Traced<f64>,
    /// What is taken of it.
    pub take: Take,
}

/// What is watched in a run.
#[derive(Clone, Debug, Default)]
pub struct Watched {
    /// In the order of their numbers.
    pub events: Vec<Event>,
    /// In the order of their numbers.
    pub outputs: Vec<Output>,
}
