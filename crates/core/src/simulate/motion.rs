//! A body and its inputs as a system that the integrators know.

use super::Inputs;
use crate::buffer::Buffer;
use crate::integrators::{Block, System};
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::Lane;

/// Inputs up to this count are passed on the stack.
const ON_STACK: usize = 8;

/// A free body under given inputs.
pub struct Motion<'a, T> {
    body: FreeBody<T>,
    inputs: &'a Inputs,
    blocks: Vec<Block>,
}

impl<'a, T: Lane> Motion<'a, T> {
    pub fn new(body: &FreeBody<f64>, inputs: &'a Inputs) -> Self {
        Self { body: body.lift(), inputs, blocks: Dynamics::<f64>::error_blocks(body) }
    }
}

impl<T: Lane> System<T> for Motion<'_, T> {
    #[inline(always)]
    fn size(&self) -> usize {
        self.body.state_size()
    }

    #[inline(always)]
    fn derivative(&self, t: T, y: &[T], dy: &mut [T]) {
        T::call(
            #[inline(always)]
            || {
                let mut u = Buffer::<T, ON_STACK>::new(self.inputs.size());
                let u = u.slice();
                self.inputs.write(t, u);
                self.body.derivative(t, y, u, dy);
            },
        );
    }

    #[inline(always)]
    fn project(&self, y: &mut [T]) {
        self.body.project(y);
    }

    #[inline(always)]
    fn error_blocks(&self) -> &[Block] {
        &self.blocks
    }
}
