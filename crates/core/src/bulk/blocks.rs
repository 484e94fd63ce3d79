//! Through the states of bodies in quaternions and quasi-velocities, as many at once as there are lanes.
//!
//! The compiler knows how many numbers state and results have. The last block overlaps the one before it.

use super::Points;
use super::columns::Controls;
use crate::phase_space::STATES;
use crate::scalar::Lane;
use std::array;
use std::ops::Range;

/// Results of so many bytes are written past the caches: they would push out everything, and each line of theirs
/// would be read before it is written.
const LARGE: usize = 4 << 20;

/// The lanes of the widest register.
const WIDEST: usize = 8;

/// So many columns make up for a block more.
const ALIGNED: usize = 128;

/// Bytes of a cache line.
const LINE: usize = 64;

/// What is computed at each state; `R` numbers, some of which may be left out.
pub trait Kernel<L, const R: usize>: Sync {
    fn at(&self, t: L, x: &[L; STATES], u: &[L], out: &mut impl Places<L>);
}

/// Where the results of a state are written.
pub trait Places<L> {
    /// Writes one of them.
    fn put(&mut self, place: usize, value: L);
}

/// The rows of some lanes.
struct Rows<'a, 'b, const R: usize, const PAST: bool> {
    rows: &'a mut [&'b mut [f64]; R],
    at: usize,
}

impl<L: Lane, const R: usize, const PAST: bool> Places<L> for Rows<'_, '_, R, PAST> {
    #[inline(always)]
    fn put(&mut self, place: usize, value: L) {
        let places = &mut self.rows[place][self.at..self.at + L::N];
        if PAST { value.stream(places) } else { value.store(places) }
    }
}

/// Whether rows of so many numbers, `count` each, are to be written past the caches by these lanes.
///
/// That pays only by whole lines, whose places are the same in all rows.
pub fn past_caches<L: Lane>(rows: usize, count: usize) -> bool {
    let whole = size_of::<L>() == LINE && (count * size_of::<f64>()).is_multiple_of(LINE);
    whole && rows * count * size_of::<f64>() >= LARGE
}

/// Writes the results of the states in `piece` to rows of that length.
pub fn go<L: Lane, const R: usize>(
    kernel: &impl Kernel<L, R>,
    points: &Points<'_>,
    piece: Range<usize>,
    mut rows: [&mut [f64]; R],
    past: bool,
) {
    let len = piece.len();
    if len < L::N {
        return few(kernel, points, piece, rows);
    }
    // Blocks begin where cache lines do, in all rows if they are whole lines long.
    let whole = (points.count * size_of::<f64>()).is_multiple_of(LINE);
    if !whole || len < ALIGNED {
        return run::<L, R, false>(kernel, points, piece.start, &mut rows, 0..len);
    }
    let first = rows[0].as_ptr().align_offset(LINE);
    let last = first + (len - first) / L::N * L::N;
    if first > 0 {
        run::<L, R, false>(kernel, points, piece.start, &mut rows, 0..first.max(L::N));
    }
    if past {
        run::<L, R, true>(kernel, points, piece.start, &mut rows, first..last);
    } else {
        run::<L, R, false>(kernel, points, piece.start, &mut rows, first..last);
    }
    if last < len {
        run::<L, R, false>(kernel, points, piece.start, &mut rows, len - L::N..len);
    }
}

/// The same of the columns in `range`, at least as many as there are lanes.
fn run<L: Lane, const R: usize, const PAST: bool>(
    kernel: &impl Kernel<L, R>,
    points: &Points<'_>,
    start: usize,
    rows: &mut [&mut [f64]; R],
    range: Range<usize>,
) {
    L::call(
        #[inline(always)]
        || {
            let mut controls = Controls::<L>::new(points);
            // All of one length, so that it is asked once whether a block lies inside.
            let mut x = [&[][..]; STATES];
            let mut k = 0;
            while k < STATES {
                x[k] = &points.x[k * points.count + start..][..range.end];
                k += 1;
            }
            let mut out: [&mut [f64]; R] = array::from_fn(
                #[inline(always)]
                |_| Default::default(),
            );
            for (out, row) in out.iter_mut().zip(rows) {
                *out = &mut row[..range.end];
            }
            let mut state = [L::zero(); STATES];
            let mut next = range.start;
            while next < range.end {
                let at = next.min(range.end - L::N);
                let mut k = 0;
                while k < STATES {
                    state[k] = L::load(&x[k][at..at + L::N]);
                    k += 1;
                }
                controls.read(start + at, L::N);
                kernel.at(
                    controls.t,
                    &state,
                    controls.u.slice(),
                    &mut Rows::<R, PAST> { rows: &mut out, at },
                );
                next += L::N;
            }
            if PAST {
                L::settle();
            }
        },
    );
}

/// The same of fewer states than there are lanes: the last one fills them.
fn few<L: Lane, const R: usize>(
    kernel: &impl Kernel<L, R>,
    points: &Points<'_>,
    piece: Range<usize>,
    rows: [&mut [f64]; R],
) {
    let fill = |row: &[f64], to: &mut [f64]| {
        for (l, to) in to.iter_mut().enumerate() {
            *to = row[piece.start + l.min(piece.len() - 1)];
        }
    };
    let mut x = [0.0; STATES * WIDEST];
    for (row, to) in points.x.chunks_exact(points.count).zip(x.chunks_exact_mut(L::N)) {
        fill(row, to);
    }
    let mut t = [points.t[0]; WIDEST];
    if points.t.len() == points.count {
        fill(points.t, &mut t);
    }
    let mut wide;
    let mut u = points.u;
    if u.len() > points.inputs {
        wide = vec![0.0; points.inputs * L::N];
        for (row, to) in u.chunks_exact(points.count).zip(wide.chunks_exact_mut(L::N)) {
            fill(row, to);
        }
        u = &wide;
    }
    let filled = Points { count: L::N, t: &t[..L::N], x: &x[..STATES * L::N], u, inputs: points.inputs };
    let mut out = [[0.0; WIDEST]; R];
    let mut wide: [&mut [f64]; R] = array::from_fn(|_| Default::default());
    for (wide, out) in wide.iter_mut().zip(&mut out) {
        *wide = &mut out[..L::N];
    }
    run::<L, R, false>(kernel, &filled, 0, &mut wide, 0..L::N);
    for (row, out) in rows.into_iter().zip(out) {
        row.copy_from_slice(&out[..row.len()]);
    }
}
