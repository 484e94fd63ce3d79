//! Functions that were compiled elsewhere.

use super::Lane;
use std::fmt::Debug;

/// A function of many numbers that knows nothing of [`super::Real`]: compiled C, or a callback.
pub trait Block: Debug + Send + Sync {
    /// Computes `lanes` columns at once: `given` holds all lanes of the first argument, then all of the second,
    /// and so on; `out` is written likewise.
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]);
}

/// Arguments and results of one lane, and of the widest register: up to so many numbers stay on the stack.
const ON_STACK: [usize; 2] = [64, 64 * 8];

/// Calls a block for all lanes.
#[inline(always)]
pub(super) fn call<T: Lane>(block: &dyn Block, given: &[T], out: &mut [T]) {
    let count = T::N * (given.len() + out.len());
    let (mut few, mut many, mut heap);
    let numbers = if count <= ON_STACK[0] {
        few = [0.0; ON_STACK[0]];
        &mut few[..count]
    } else if count <= ON_STACK[1] {
        many = [0.0; ON_STACK[1]];
        &mut many[..count]
    } else {
        heap = vec![0.0; count];
        &mut heap[..]
    };
    let (from, to) = numbers.split_at_mut(T::N * given.len());
    for (i, x) in given.iter().enumerate() {
        for l in 0..T::N {
            from[T::N * i + l] = x.get(l);
        }
    }
    block.call(T::N, from, to);
    for (i, x) in out.iter_mut().enumerate() {
        *x = T::from_lanes(
            #[inline(always)]
            |l| to[T::N * i + l],
        );
    }
}
