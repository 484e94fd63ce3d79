//! Room for a few numbers.

use crate::scalar::Real;

/// Numbers that start as zeros: up to `N` of them on the stack, more on the heap.
pub struct Buffer<T, const N: usize> {
    stack: [T; N],
    heap: Vec<T>,
    len: usize,
}

impl<T: Real, const N: usize> Buffer<T, N> {
    /// Of a length.
    #[inline(always)]
    pub fn new(len: usize) -> Self {
        let mut heap = Vec::new();
        if len > N {
            heap.resize(len, T::zero());
        }
        Self { stack: [T::zero(); N], heap, len }
    }

    /// The numbers.
    #[inline(always)]
    pub fn slice(&mut self) -> &mut [T] {
        if self.len <= N { &mut self.stack[..self.len] } else { &mut self.heap }
    }
}
