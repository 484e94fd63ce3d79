//! Where laws find what they read.

use super::Situation;
use crate::algebra::Mat3;
use crate::expression::Row;
use crate::scalar::Real;
use std::ops::Range;

/// Where a law finds one of its inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// Among all inputs, by its place.
    Input(usize),
    /// Among all auxiliary states: one that another law publishes.
    State(usize),
}

impl Source {
    /// What is there.
    #[inline(always)]
    pub fn read<T: Real>(self, s: &Situation<'_, T>) -> T {
        match self {
            Self::Input(place) => s.inputs[place],
            Self::State(place) => s.states[place],
        }
    }
}

impl From<usize> for Source {
    fn from(place: usize) -> Self {
        Self::Input(place)
    }
}

/// What a law reads besides the motion, by the places in all inputs and in all auxiliary states.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// Its inputs.
    pub inputs: Vec<Source>,
    /// Its own states.
    pub states: Range<usize>,
}

impl Places {
    /// Of inputs, by their places or sources, and of states.
    pub fn new<S: Copy + Into<Source>>(inputs: &[S], states: Range<usize>) -> Self {
        Self { inputs: inputs.iter().map(|source| (*source).into()).collect(), states }
    }

    /// How many numbers tell of time, motion and body: time 1, position 3, rotation 9 by rows, twist 6, mass 1,
    /// mass centre 3.
    pub const MOTION: usize = 23;

    /// How many inputs and states a law can have.
    pub const ROOM: usize = 73;

    /// How many numbers a law with these places is given.
    pub fn given_count(&self) -> usize {
        Self::MOTION + self.inputs.len() + self.states.len()
    }

    /// The lengths of the pieces in which it is given them: time, position, rotation, twist, mass with mass centre,
    /// inputs, states.
    #[inline(always)]
    pub(super) fn lengths(&self) -> [usize; 7] {
        [1, 3, 9, 6, 4, self.inputs.len(), self.states.len()]
    }

    /// The place behind the last of its inputs.
    pub fn inputs_end(&self) -> usize {
        let behind = |source: &Source| if let Source::Input(place) = source { place + 1 } else { 0 };
        self.inputs.iter().map(behind).max().unwrap_or(0)
    }
}

/// What a law is given as numbers side by side: of each kind no more than it reads, for it costs as much to write them
/// as to compute with them.
///
/// It is filled where it stands: to move so much room would take longer than a law.
pub struct Seen<'a, T> {
    time: Row<T, 1>,
    position: Row<T, 3>,
    rotation: Row<T, 9>,
    twist: Row<T, 6>,
    body: Row<T, 4>,
    inputs: Row<T, { Places::ROOM }>,
    /// Position and twist where they stood already.
    there: [&'a [T]; 2],
}

/// Which of time, position, rotation, twist and mass with mass centre a law reads.
pub(super) type Reads = [bool; 5];

impl<'a, T: Real> Seen<'a, T> {
    /// Nothing yet; or position and twist where they stand already.
    #[inline(always)]
    pub fn new(there: Option<[&'a [T]; 2]>) -> Self {
        Self {
            time: Row::empty(),
            position: Row::empty(),
            rotation: Row::empty(),
            twist: Row::empty(),
            body: Row::empty(),
            inputs: Row::empty(),
            there: there.unwrap_or_default(),
        }
    }

    /// Writes what is read.
    #[inline(always)]
    pub(super) fn write(
        &mut self,
        s: &Situation<'_, T>,
        [time, position, rotation, twist, body]: Reads,
        inputs: &[Source],
    ) {
        let (o, [a, b, c], m) = (s.position, s.rotation.rows, s.inertia.com);
        let (v, w, apart) = (s.twist.linear, s.twist.angular, self.there[0].is_empty());
        if time {
            self.time.fill([s.time]);
        }
        if position && apart {
            self.position.fill([o.x, o.y, o.z]);
        }
        if rotation {
            self.rotation.fill([a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z]);
        }
        if twist && apart {
            self.twist.fill([v.x, v.y, v.z, w.x, w.y, w.z]);
        }
        if body {
            self.body.fill([s.inertia.mass, m.x, m.y, m.z]);
        }
        for source in inputs {
            self.inputs.push(source.read(s));
        }
    }

    /// The pieces but for the states, with nothing in those that are not read.
    #[inline(always)]
    pub(super) fn pieces(&self) -> [&[T]; 6] {
        let [position, twist] = self.there;
        [
            self.time.slice(),
            if position.is_empty() { self.position.slice() } else { position },
            self.rotation.slice(),
            if twist.is_empty() { self.twist.slice() } else { twist },
            self.body.slice(),
            self.inputs.slice(),
        ]
    }

    /// The rotation, if it is read.
    #[inline(always)]
    pub fn rotation(&self) -> Option<Mat3<T>> {
        let rotation = self.rotation.slice();
        if rotation.is_empty() { None } else { Some(Mat3::from_slice(rotation)) }
    }
}
