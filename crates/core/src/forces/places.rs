//! Where laws find what they read.

use super::Situation;
use crate::expression::Values;
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

    /// Where the position is among them.
    pub(super) const POSITION: Range<usize> = 1..4;

    /// How many inputs and states a law can have.
    pub const ROOM: usize = Values::<f64>::ROOM - Self::MOTION;

    /// How many numbers a law with these places is given.
    pub fn given_count(&self) -> usize {
        Self::MOTION + self.inputs.len() + self.states.len()
    }

    /// The place behind the last of its inputs.
    pub fn inputs_end(&self) -> usize {
        let behind = |source: &Source| if let Source::Input(place) = source { place + 1 } else { 0 };
        self.inputs.iter().map(behind).max().unwrap_or(0)
    }

    /// Time, motion and body.
    #[inline(always)]
    pub(super) fn motion<T: Real>(s: &Situation<'_, T>) -> [T; Self::MOTION] {
        let (o, c, m) = (s.position, s.rotation.rows, s.inertia.com);
        let (v, w) = (s.twist.linear, s.twist.angular);
        [
            s.time,
            o.x,
            o.y,
            o.z,
            c[0].x,
            c[0].y,
            c[0].z,
            c[1].x,
            c[1].y,
            c[1].z,
            c[2].x,
            c[2].y,
            c[2].z,
            v.x,
            v.y,
            v.z,
            w.x,
            w.y,
            w.z,
            s.inertia.mass,
            m.x,
            m.y,
            m.z,
        ]
    }

    /// Writes what the law is given: time, motion and body, its inputs, its states.
    #[inline(always)]
    pub(super) fn write<T: Real>(&self, s: &Situation<'_, T>, values: &mut Values<T>) {
        values.start(Self::motion(s));
        for source in &self.inputs {
            values.push(source.read(s));
        }
        for x in &s.states[self.states.clone()] {
            values.push(*x);
        }
    }
}
