//! f at many states.

use super::Points;
use super::columns::{Lanes, share, write};
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::Lane;
use std::ops::Range;

/// Writes f(x, u, t) of each point, by component. Konoplev (3.2)
pub fn derivatives<L: Lane>(body: &FreeBody<L>, points: &Points<'_>, out: &mut [f64], threads: usize) {
    share(out, points.count, threads, |piece, rows| go(body, points, piece, rows));
}

fn go<L: Lane>(body: &FreeBody<L>, points: &Points<'_>, piece: Range<usize>, rows: &mut [&mut [f64]]) {
    L::call(
        #[inline(always)]
        || {
            let mut lanes = Lanes::<L>::new(points, rows.len());
            let mut rate = vec![L::zero(); rows.len()];
            for at in (0..piece.len()).step_by(L::N) {
                let room = L::N.min(piece.len() - at);
                lanes.read(piece.start + at, room);
                body.derivative(lanes.t, &lanes.x, &lanes.u, &mut rate);
                for (rate, row) in rate.iter().zip(rows.iter_mut()) {
                    write(*rate, &mut row[at..at + room]);
                }
            }
        },
    );
}
