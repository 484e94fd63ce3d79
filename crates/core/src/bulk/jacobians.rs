//! The Jacobians of f at many states.

use super::Points;
use super::blocks::{Kernel, Places, go, past_caches};
use super::columns::{Lanes, share, write};
use super::layout::Layout;
use crate::phase_space::{ClosedJacobian, Dynamics, Entries, FreeBody, PLACES, STATES, VARYING};
use crate::scalar::{Dual, Lane, Real};
use std::ops::Range;

/// Writes the entries of a layout for each point, by the closed form. Konoplev (3.2)
pub fn closed_jacobians<L: Lane>(
    closed: &ClosedJacobian,
    layout: &Layout,
    points: &Points<'_>,
    out: &mut [f64],
    threads: usize,
) {
    let past = past_caches::<L>(layout.entries.len(), points.count);
    share(out, points.count, threads, |piece, rows| {
        go::<L, VARYING>(closed, points, piece, layout.fill::<L>(rows), past);
    });
}

impl<L: Lane> Kernel<L, VARYING> for ClosedJacobian {
    #[inline(always)]
    fn at(&self, _: L, x: &[L; STATES], _: &[L], out: &mut impl Places<L>) {
        self.write_varying(x, &mut InOrder(out));
    }
}

/// Entries of a matrix, as they follow each other among those that vary.
struct InOrder<'a, P>(&'a mut P);

impl<T, P: Places<T>> Entries<T> for InOrder<'_, P> {
    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, value: T) {
        self.0.put(PLACES[row][column], value);
    }
}

/// Writes (∂f/∂x ∂f/∂u) of any body for each point, by rows of the matrix, through duals. Konoplev (3.2)
pub fn dual_jacobians<L: Lane>(
    body: &FreeBody<Dual<L, 1>>,
    points: &Points<'_>,
    out: &mut [f64],
    threads: usize,
) {
    let states = body.state_size();
    share(out, points.count, threads, |piece, rows| dual(body, points, states, piece, rows));
}

fn dual<L: Lane>(
    body: &FreeBody<Dual<L, 1>>,
    points: &Points<'_>,
    states: usize,
    piece: Range<usize>,
    mut rows: Vec<&mut [f64]>,
) {
    L::call(
        #[inline(always)]
        || {
            let width = states + points.inputs;
            let mut lanes = Lanes::<L>::new(points, states);
            let mut point = vec![Dual::<L, 1>::lit(0.0); width];
            let mut rate = vec![Dual::<L, 1>::lit(0.0); states];
            for at in (0..piece.len()).step_by(L::N) {
                let room = L::N.min(piece.len() - at);
                lanes.read(piece.start + at, room);
                for (p, v) in point.iter_mut().zip(lanes.x.iter().chain(&*lanes.controls.u.slice())) {
                    *p = Dual::constant(*v);
                }
                for column in 0..width {
                    point[column].slope = [L::one()];
                    let (x, u) = point.split_at(states);
                    body.derivative(Dual::constant(lanes.controls.t), x, u, &mut rate);
                    point[column].slope = [L::zero()];
                    for (row, rate) in rate.iter().enumerate() {
                        write(rate.slope[0], &mut rows[row * width + column][at..at + room]);
                    }
                }
            }
        },
    );
}
