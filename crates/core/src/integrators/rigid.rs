//! The stages of explicit methods for the state that most runs have, whose sums are nothing but products then.
//!
//! Its size, and what is summed in each stage, are constants of the code.

use super::stepper::TrialStep;
use super::sums::added;
use super::{Method, RIGID, Row, Solve, Stage, Stepper, System};
use crate::scalar::Lane;
use std::marker::PhantomData;

/// Its position, a quadrature for most forces.
pub(super) const POSITION: usize = 3;
/// What stages are evaluated for.
const READ: usize = RIGID - POSITION;
/// The largest number of stages.
const MOST: usize = 15;

/// Stage `I` of a method, if it has so many.
struct At<M, const I: usize>(PhantomData<M>);

impl<M: Method, const I: usize> At<M, I> {
    const STAGE: Option<&'static Stage> = if I < M::STAGES.len() { Some(&M::STAGES[I]) } else { None };
    /// Whether anything but other stages is made of it: its quadratures count then.
    const COUNTS: bool = counts::<M>(I);
}

const fn counts<M: Method>(stage: usize) -> bool {
    let cubic = match M::DENSE_CUBIC {
        Some([second, third]) => has(second, stage) || has(third, stage),
        None => false,
    };
    let beyond = match M::ERROR_BEYOND_CHANGE {
        Some(row) => has(row, stage),
        None => false,
    };
    let mut dense = false;
    let mut i = 0;
    while i < M::DENSE_STAGES.len() {
        dense = dense || has(M::DENSE_STAGES[i].a, stage);
        i += 1;
    }
    let rows = have(M::ERROR, stage) || have(M::DENSE, stage);
    has(M::WEIGHTS, stage) || rows || beyond || cubic || dense
}

const fn have(rows: &[Row], stage: usize) -> bool {
    let mut i = 0;
    while i < rows.len() {
        if has(rows[i], stage) {
            return true;
        }
        i += 1;
    }
    false
}

const fn has(row: Row, stage: usize) -> bool {
    let mut i = 0;
    while i < row.len() {
        if row[i].0 == stage {
            return true;
        }
        i += 1;
    }
    false
}

/// What a stage is made of.
struct Room<'a, T> {
    t: T,
    h: T,
    t_before: T,
    y: &'a [T; RIGID],
    k: &'a mut [[T; RIGID]],
    at: &'a mut [T; RIGID],
}

impl<T: Lane, M: Method> Stepper<T, M> {
    /// All stages but the first, of a system that does not read the position.
    #[inline(always)]
    pub(super) fn rigid_stages<S: System<T> + ?Sized>(&mut self, system: &S) {
        const { assert!(M::STAGES.len() <= MOST || !matches!(M::SOLVE, Solve::Explicit)) }
        let TrialStep { h, t_before, .. } = self.trial;
        let (Some(y), Some(at)) = (self.y.first_chunk(), self.scratch.first_chunk_mut()) else { return };
        let k = self.k.as_chunks_mut().0;
        let Some(k) = k.get_mut(..M::STAGES.len()) else { return };
        let mut room = Room { t: self.t, h, t_before, y, k, at };
        room.stage::<M, S, 1>(system);
        room.stage::<M, S, 2>(system);
        room.stage::<M, S, 3>(system);
        room.stage::<M, S, 4>(system);
        room.stage::<M, S, 5>(system);
        room.stage::<M, S, 6>(system);
        room.stage::<M, S, 7>(system);
        room.stage::<M, S, 8>(system);
        room.stage::<M, S, 9>(system);
        room.stage::<M, S, 10>(system);
        room.stage::<M, S, 11>(system);
        room.stage::<M, S, 12>(system);
        room.stage::<M, S, 13>(system);
        room.stage::<M, S, 14>(system);
        self.evaluations += M::STAGES.len() as u64 - 1;
    }
}

/// The components behind the position.
#[inline(always)]
fn read<T>(x: &[T; RIGID]) -> &[T; READ] {
    x.last_chunk().expect("no more than all")
}

impl<T: Lane> Room<'_, T> {
    #[inline(always)]
    fn stage<M: Method, S: System<T> + ?Sized, const I: usize>(&mut self, system: &S) {
        let Some(stage) = At::<M, I>::STAGE else { return };
        let sum = added(
            *read(self.y),
            stage.a,
            self.h,
            #[inline(always)]
            |j| read(&self.k[j]),
        );
        self.at[POSITION..].copy_from_slice(&sum);
        let time = if stage.c == 1.0 { self.t_before } else { T::lit(stage.c).fma(self.h, self.t) };
        if At::<M, I>::COUNTS {
            system.derivative(time, &self.at[..], &mut self.k[I]);
        } else {
            system.derivative_read(time, &self.at[..], &mut self.k[I]);
        }
    }
}
