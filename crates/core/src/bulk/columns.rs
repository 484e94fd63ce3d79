//! Arrays by component, cut into pieces for threads and read in lanes.

use super::Points;
use crate::buffer::Buffer;
use crate::scalar::Lane;
use std::ops::Range;

/// Pieces are multiples of this: whole cache lines in every lane type.
const GRAIN: usize = 64;

/// Up to this many inputs are read to the stack.
const ON_STACK: usize = 16;

/// Cuts `count` columns among threads.
pub fn pieces(count: usize, threads: usize) -> Vec<Range<usize>> {
    let size = count.div_ceil(threads.max(1)).next_multiple_of(GRAIN);
    (0..count).step_by(size).map(|first| first..count.min(first + size)).collect()
}

/// Does the work of each piece of the columns of `out` on a thread of its own: it is given the rows of that piece.
pub fn share(
    out: &mut [f64],
    count: usize,
    threads: usize,
    work: impl Fn(Range<usize>, Vec<&mut [f64]>) + Sync,
) {
    if count == 0 {
        return;
    }
    if threads < 2 || count <= GRAIN {
        return work(0..count, out.chunks_exact_mut(count).collect());
    }
    let pieces = pieces(count, threads);
    let mut parts: Vec<Vec<&mut [f64]>> = pieces.iter().map(|_| Vec::new()).collect();
    for mut row in out.chunks_mut(count) {
        for (piece, part) in pieces.iter().zip(&mut parts) {
            let (own, rest) = row.split_at_mut(piece.len());
            part.push(own);
            row = rest;
        }
    }
    rayon::in_place_scope(|scope| {
        for (piece, part) in pieces.into_iter().zip(parts) {
            let work = &work;
            scope.spawn(move |_| work(piece, part));
        }
    });
}

/// Reads the numbers from `first` on, or the one that stands for all.
#[inline(always)]
fn read<T: Lane>(row: &[f64], first: usize, room: usize) -> T {
    if let [one] = row {
        return T::lit(*one);
    }
    let row = &row[first..first + room];
    if room == T::N {
        return T::load(row);
    }
    T::from_lanes(
        #[inline(always)]
        |l| row[l.min(room - 1)],
    )
}

/// Writes the lanes that have room.
#[inline(always)]
pub fn write<T: Lane>(x: T, out: &mut [f64]) {
    if out.len() == T::N {
        return x.store(out);
    }
    for (l, out) in out.iter_mut().enumerate() {
        *out = x.get(l);
    }
}

/// Time and inputs in the lanes.
pub struct Controls<'a, T> {
    points: &'a Points<'a>,
    /// Whether they are the same for all, and so read once.
    same: bool,
    pub t: T,
    pub u: Buffer<T, ON_STACK>,
}

impl<'a, T: Lane> Controls<'a, T> {
    #[inline(always)]
    pub fn new(points: &'a Points<'a>) -> Self {
        let same = points.t.len() == 1 && points.u.len() == points.inputs;
        let mut made = Self { points, same, t: T::zero(), u: Buffer::new(points.inputs) };
        made.read_all(0, 1);
        made
    }

    /// Reads those of the points from `first` on, `room` of them.
    #[inline(always)]
    pub fn read(&mut self, first: usize, room: usize) {
        if !self.same {
            self.read_all(first, room);
        }
    }

    #[inline(always)]
    fn read_all(&mut self, first: usize, room: usize) {
        self.t = read(self.points.t, first, room);
        let width = self.points.u.len() / self.points.inputs.max(1);
        for (u, row) in self.u.slice().iter_mut().zip(self.points.u.chunks_exact(width.max(1))) {
            *u = read(row, first, room);
        }
    }
}

/// The points in the lanes.
pub struct Lanes<'a, T> {
    pub controls: Controls<'a, T>,
    pub x: Vec<T>,
}

impl<'a, T: Lane> Lanes<'a, T> {
    #[inline(always)]
    pub fn new(points: &'a Points<'a>, states: usize) -> Self {
        Self { controls: Controls::new(points), x: vec![T::zero(); states] }
    }

    /// Reads the points from `first` on, `room` of them.
    #[inline(always)]
    pub fn read(&mut self, first: usize, room: usize) {
        let points = self.controls.points;
        for (x, row) in self.x.iter_mut().zip(points.x.chunks_exact(points.count)) {
            *x = if room == T::N { T::load(&row[first..]) } else { read(row, first, room) };
        }
        self.controls.read(first, room);
    }
}
