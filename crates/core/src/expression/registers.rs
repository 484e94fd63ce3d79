//! The values of a tape in the order in which they come.

use std::mem::MaybeUninit;

/// How many values stand on the stack.
pub(super) const SMALL: usize = 160;

/// Values that are written in their order and read by number.
///
/// How many there are is for the caller to keep: in a field it would go through memory at every value.
pub(super) trait Registers<T> {
    /// Writes value number `count`, the next one.
    ///
    /// # Safety
    /// There is room for it.
    unsafe fn put(&mut self, count: usize, x: T);
    /// Writes the values from number `count` on.
    fn put_all(&mut self, count: usize, x: &[T]);
    /// Value number `i` of `count`.
    ///
    /// # Safety
    /// So many values have been put, one after another, and `i` is smaller.
    unsafe fn get(&self, i: u16, count: usize) -> T;
}

/// What a program is given and what it computes, on the stack as long as there is room.
///
/// Nothing is written before its value is there: zeros to start from would cost as much as half of a law.
pub struct Values<T> {
    places: [MaybeUninit<T>; SMALL],
    /// How many places have been written.
    count: usize,
    /// Everything, of programs that are too long for the stack.
    heap: Vec<T>,
}

impl<T: Copy> Values<T> {
    /// How many numbers can be given.
    pub const ROOM: usize = 96;

    /// None yet.
    #[inline(always)]
    pub fn empty() -> Self {
        Self { places: [const { MaybeUninit::uninit() }; SMALL], count: 0, heap: Vec::new() }
    }

    /// Writes the first numbers.
    #[inline(always)]
    pub fn start<const N: usize>(&mut self, first: [T; N]) {
        const { assert!(N <= Self::ROOM) };
        let mut i = 0;
        while i < N {
            self.places[i].write(first[i]);
            i += 1;
        }
        self.count = N;
    }

    /// Adds a number, if there is room for it.
    #[inline(always)]
    pub fn push(&mut self, x: T) {
        assert!(self.count < Self::ROOM, "more numbers are given than there is room for");
        self.places[self.count].write(x);
        self.count += 1;
    }

    /// Goes over to the heap, for so many values; how many there are already.
    #[inline(always)]
    pub(super) fn on_heap(&mut self, values: usize) -> (&mut Vec<T>, usize) {
        self.heap.reserve_exact(values);
        for i in 0..self.count {
            // SAFETY: `count` counts what has been written.
            self.heap.push(unsafe { self.places.get(i as u16, self.count) });
        }
        (&mut self.heap, self.count)
    }

    /// Stays on the stack; how many values there are already.
    #[inline(always)]
    pub(super) fn on_stack(&mut self) -> (&mut OnStack<T>, usize) {
        (&mut self.places, self.count)
    }

    /// So many values are there now.
    ///
    /// # Safety
    /// They have been put, one after another.
    #[inline(always)]
    pub(super) unsafe fn now(&mut self, count: usize) {
        self.count = count;
    }

    /// Value number `i`.
    #[inline(always)]
    pub(super) fn get(&self, i: u16) -> T {
        if !self.heap.is_empty() {
            return self.heap[usize::from(i)];
        }
        assert!(usize::from(i) < self.count, "a result is read before it is there");
        // SAFETY: `count` counts what has been written.
        unsafe { self.places.get(i, self.count) }
    }
}

/// Up to [`SMALL`] values.
pub(super) type OnStack<T> = [MaybeUninit<T>; SMALL];

impl<T: Copy> Registers<T> for OnStack<T> {
    #[inline(always)]
    unsafe fn put(&mut self, count: usize, x: T) {
        debug_assert!(count < SMALL, "there is no room for more values");
        // SAFETY: there is room.
        unsafe { self.get_unchecked_mut(count).write(x) };
    }
    #[inline(always)]
    fn put_all(&mut self, count: usize, x: &[T]) {
        for (place, x) in self[count..][..x.len()].iter_mut().zip(x) {
            place.write(*x);
        }
    }
    #[inline(always)]
    unsafe fn get(&self, i: u16, count: usize) -> T {
        let i = usize::from(i);
        debug_assert!(i < count, "a value is read before it is there");
        // SAFETY: all places below `count` have been written, and no value is ever taken away.
        unsafe { self.get_unchecked(i).assume_init() }
    }
}

impl<T: Copy> Registers<T> for Vec<T> {
    #[inline(always)]
    unsafe fn put(&mut self, _: usize, x: T) {
        self.push(x);
    }
    #[inline(always)]
    fn put_all(&mut self, _: usize, x: &[T]) {
        self.extend_from_slice(x);
    }
    #[inline(always)]
    unsafe fn get(&self, i: u16, _: usize) -> T {
        self[usize::from(i)]
    }
}
