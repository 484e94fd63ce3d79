//! Looks inside the trial step of a stepper.

use super::bracket::Bracket;
use super::seer::{Reading, Seer};
use crate::integrators::{Lanes, Method, Stepper, System};
use crate::scalar::Lane;
use crate::simulate::Motion;

/// A trial step, with its continuous output as soon as it is asked for.
pub struct Inside<'a, 'm, T, M> {
    seer: &'a mut Seer<T>,
    motion: &'a Motion<'m, T>,
    pub stepper: &'a mut Stepper<T, M>,
    is_dense: bool,
    y: Vec<T>,
    dy: Vec<T>,
}

impl<'a, 'm, T: Lane, M: Method> Inside<'a, 'm, T, M> {
    #[inline(always)]
    pub fn new(seer: &'a mut Seer<T>, motion: &'a Motion<'m, T>, stepper: &'a mut Stepper<T, M>) -> Self {
        Self { seer, motion, stepper, is_dense: false, y: Vec::new(), dy: Vec::new() }
    }

    #[inline(always)]
    fn go(&mut self, t: T) {
        if !self.is_dense {
            self.stepper.dense(self.motion);
            self.y.resize(self.motion.size(), T::zero());
            self.dy.resize(self.motion.size(), T::zero());
            self.is_dense = true;
        }
        self.stepper.interpolate(t, &mut self.y);
        self.motion.project(&mut self.y);
    }

    /// The value of a law.
    #[inline(always)]
    pub fn value(&mut self, law: usize, t: T) -> T {
        self.go(t);
        // Of the rate nothing is wanted.
        self.seer.read_one(self.motion, t, &self.y, &self.y, law).value
    }

    /// A law with its rate.
    #[inline(always)]
    pub fn reading(&mut self, law: usize, t: T) -> Reading<T> {
        self.go(t);
        self.motion.derivative(t, &self.y, &mut self.dy);
        self.seer.read_one(self.motion, t, &self.y, &self.dy, law)
    }

    /// The state of lane `l`.
    #[inline(always)]
    pub fn state(&mut self, l: usize, t: f64) -> Vec<f64> {
        self.go(T::lit(t));
        let mut state = Vec::with_capacity(self.y.len());
        for y in &self.y {
            state.push(y.get(l));
        }
        state
    }

    /// When `factor` times a law has left the positive numbers.
    #[inline(always)]
    pub fn crossing(&mut self, law: usize, lanes: Lanes, factor: T, bracket: Bracket<T>) -> T {
        let closed = bracket.close(
            lanes,
            #[inline(always)]
            |t| factor * self.value(law, t),
        );
        closed.b
    }

    /// Where `factor` times a law is least, and what it is there: its rate passes zero between its values at both ends.
    #[inline(always)]
    pub fn lowest(
        &mut self,
        law: usize,
        lanes: Lanes,
        factor: T,
        [a, b]: [T; 2],
        [q0, q1]: [T; 2],
    ) -> (T, T) {
        let bracket = Bracket { a, b, at_a: -q0, at_b: -q1 };
        let closed = bracket.close(
            lanes,
            #[inline(always)]
            |t| -(factor * self.reading(law, t).slope[0]),
        );
        (closed.b, factor * self.value(law, closed.b))
    }
}
