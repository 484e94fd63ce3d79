//! The values of a program while it runs.

use std::marker::PhantomData;
use std::mem::MaybeUninit;
use std::ops::Range;

/// How many values stand on the stack.
const SMALL: usize = 160;

/// Up to `N` numbers one after another, without zeros to start from.
pub struct Row<T, const N: usize> {
    places: [MaybeUninit<T>; N],
    /// How many places have been written.
    count: usize,
}

impl<T: Copy, const N: usize> Row<T, N> {
    /// None yet.
    #[inline(always)]
    pub fn empty() -> Self {
        Self { places: [const { MaybeUninit::uninit() }; N], count: 0 }
    }

    /// Writes all numbers.
    #[inline(always)]
    pub fn fill(&mut self, numbers: [T; N]) {
        self.places = numbers.map(MaybeUninit::new);
        self.count = N;
    }

    /// Adds a number, if there is room for it.
    #[inline(always)]
    pub fn push(&mut self, x: T) {
        self.places[self.count].write(x);
        self.count += 1;
    }

    /// The numbers.
    #[inline(always)]
    pub fn slice(&self) -> &[T] {
        // SAFETY: `count` counts what has been written.
        unsafe { std::slice::from_raw_parts(self.places.as_ptr().cast(), self.count) }
    }
}

/// Numbers side by side, as machine code finds them.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Piece<'a, T> {
    start: *const T,
    len: usize,
    lent: PhantomData<&'a [T]>,
}

impl<'a, T> Piece<'a, T> {
    /// Of a slice.
    #[inline(always)]
    pub fn of(numbers: &'a [T]) -> Self {
        Self { start: numbers.as_ptr(), len: numbers.len(), lent: PhantomData }
    }

    /// How many numbers.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// The slice.
    #[inline(always)]
    pub(super) fn slice(&self) -> &'a [T] {
        // SAFETY: it was made of one that is lent for so long.
        unsafe { std::slice::from_raw_parts(self.start, self.len) }
    }
}

/// What a program computes, on the stack as long as there is room.
///
/// Nothing is written before its value is there: zeros to start from would cost as much as half of a law.
pub struct Values<T> {
    stack: [MaybeUninit<T>; SMALL],
    /// Everything, of programs that are too long for the stack.
    heap: Vec<MaybeUninit<T>>,
    /// Where the results of a run are.
    results: Range<usize>,
}

impl<T: Copy> Values<T> {
    /// None yet.
    #[inline(always)]
    pub fn empty() -> Self {
        Self { stack: [const { MaybeUninit::uninit() }; SMALL], heap: Vec::new(), results: 0..0 }
    }

    /// Places for so many values, in which nothing stands yet.
    #[inline(always)]
    pub(super) fn places(&mut self, count: usize) -> &mut [MaybeUninit<T>] {
        self.results = 0..0;
        if count <= SMALL {
            self.heap.clear();
            return &mut self.stack[..count];
        }
        self.heap.resize_with(count, MaybeUninit::uninit);
        &mut self.heap
    }

    /// The results of a run stand in these places of so many.
    ///
    /// # Safety
    /// They have been written since there are so many places.
    #[inline(always)]
    pub(super) unsafe fn now(&mut self, results: Range<usize>) {
        self.results = results;
    }

    /// The results of the last run.
    #[inline(always)]
    pub fn results(&self) -> &[T] {
        let all = if self.heap.is_empty() { &self.stack[..] } else { &self.heap[..] };
        let results = &all[self.results.clone()];
        // SAFETY: `now` says that they have been written.
        unsafe { std::slice::from_raw_parts(results.as_ptr().cast(), results.len()) }
    }
}
