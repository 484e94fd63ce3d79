//! The states of the lanes at the wanted times.

use super::setup::Setup;
use crate::integrators::{Lanes, Method, Stepper, System, write_lane};
use crate::scalar::Lane;
use crate::simulate::Motion;

/// What is kept of the runs in the lanes.
pub struct Samples<T> {
    /// The next wanted time of each lane; beyond all times when there is none.
    due: T,
    /// How many each lane has.
    saved: Vec<usize>,
    /// The states of each lane, one after another.
    states: Vec<Vec<f64>>,
    /// The latest state of each lane: the angles of the next one are nearest to its.
    last: Vec<Vec<f64>>,
    inside: Vec<T>,
    /// How many numbers a run keeps.
    size: usize,
}

impl<T: Lane> Samples<T> {
    #[inline(always)]
    pub fn new(setup: &Setup<'_>) -> Self {
        Self {
            due: T::lit(f64::INFINITY),
            saved: vec![0; T::N],
            states: vec![Vec::new(); T::N],
            last: vec![Vec::new(); T::N],
            inside: Vec::new(),
            size: setup.states * setup.batch.save_at.len(),
        }
    }

    /// The latest state of lane `l`.
    pub fn last(&self, l: usize) -> &[f64] {
        &self.last[l]
    }

    /// Begins the run of lane `l` at state `x`.
    pub fn start(&mut self, setup: &Setup<'_>, l: usize, x: &[f64]) {
        self.states[l].clear();
        self.last[l].clear();
        self.last[l].extend_from_slice(x);
        self.saved[l] = 0;
        if setup.batch.save_at.first() == Some(&setup.batch.span[0]) {
            self.states[l].extend_from_slice(x);
            self.saved[l] = 1;
        }
        self.look_ahead(setup, l);
    }

    fn look_ahead(&mut self, setup: &Setup<'_>, l: usize) {
        let due = setup.batch.save_at.get(self.saved[l]).copied().unwrap_or(f64::INFINITY);
        self.due = T::call(
            #[inline(always)]
            || self.due.with(l, due),
        );
    }

    /// Saves the wanted times inside the accepted trial step, in each lane up to its end.
    pub fn save_inside<M: Method>(
        &mut self,
        setup: &Setup<'_>,
        motion: &Motion<'_, T>,
        stepper: &mut Stepper<T, M>,
        accepted: Lanes,
        ends: T,
    ) {
        let mut is_dense = false;
        loop {
            let due = T::call(
                #[inline(always)]
                || Lanes::where_le(self.due, ends),
            );
            let due = due.and(accepted);
            if due.is_empty() {
                return;
            }
            if !is_dense {
                stepper.dense(motion);
                is_dense = true;
            }
            self.inside.resize(stepper.y().len(), self.due);
            stepper.interpolate(self.due, &mut self.inside);
            T::call(
                #[inline(always)]
                || motion.project(&mut self.inside),
            );
            let (mut x, mut y) = (Vec::new(), Vec::new());
            for l in due.iter() {
                T::call(
                    #[inline(always)]
                    || write_lane(&self.inside, l, &mut y),
                );
                setup.write_asked(&y, &self.last[l], &mut x);
                self.states[l].extend_from_slice(&x);
                self.last[l].clone_from(&x);
                self.saved[l] += 1;
                self.look_ahead(setup, l);
            }
        }
    }

    /// Hands over the states of lane `l`; those that it never reached are not numbers.
    pub fn finish(&mut self, l: usize, all: &mut Vec<f64>) {
        let missing = self.size - self.states[l].len();
        all.append(&mut self.states[l]);
        all.extend(std::iter::repeat_n(f64::NAN, missing));
    }
}
