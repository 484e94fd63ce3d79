//! The Jacobians of f at many states.

use super::Points;
use super::columns::{Lanes, share, write};
use crate::phase_space::{Dynamics, Entries, FreeBody};
use crate::scalar::{Dual, Lane, Real};
use std::ops::Range;

/// Writes (∂f/∂x ∂f/∂u) of each point by the closed form, see [`FreeBody::has_closed_jacobian`].
///
/// By rows of the matrix, each entry of all points together. Konoplev (3.2)
pub fn closed_jacobians<L: Lane>(
    body: &FreeBody<L>,
    zeros: &[usize],
    points: &Points<'_>,
    out: &mut [f64],
    threads: usize,
) {
    let sizes = (body.state_size(), points.inputs);
    share(out, points.count, threads, |piece, rows| closed(body, points, sizes, zeros, piece, rows));
}

/// The same of any body, through duals.
pub fn dual_jacobians<L: Lane>(
    body: &FreeBody<Dual<L, 1>>,
    points: &Points<'_>,
    out: &mut [f64],
    threads: usize,
) {
    let states = body.state_size();
    share(out, points.count, threads, |piece, rows| dual(body, points, states, piece, rows));
}

/// The entries that the closed form leaves out: they are always zero.
pub fn always_zero(body: &FreeBody<f64>) -> Vec<usize> {
    let (states, inputs) = (Dynamics::<f64>::state_size(body), Dynamics::<f64>::input_size(body));
    let mut marks = Marks { written: vec![false; states * (states + inputs)], width: states + inputs };
    body.write_jacobian(&vec![0.5; states], &mut marks);
    (0..marks.written.len()).filter(|i| !marks.written[*i]).collect()
}

/// Which entries the closed form writes.
struct Marks {
    written: Vec<bool>,
    width: usize,
}

impl Entries<f64> for Marks {
    fn put(&mut self, row: usize, column: usize, _: f64) {
        self.written[row * self.width + column] = true;
    }
}

/// The rows of some lanes.
struct Matrix<'a, 'b> {
    rows: &'a mut [&'b mut [f64]],
    width: usize,
    at: usize,
    room: usize,
}

impl<L: Lane> Entries<L> for Matrix<'_, '_> {
    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, value: L) {
        write(value, &mut self.rows[row * self.width + column][self.at..self.at + self.room]);
    }
}

fn closed<L: Lane>(
    body: &FreeBody<L>,
    points: &Points<'_>,
    (states, inputs): (usize, usize),
    zeros: &[usize],
    piece: Range<usize>,
    rows: &mut [&mut [f64]],
) {
    L::call(
        #[inline(always)]
        || {
            let mut lanes = Lanes::<L>::new(points, states);
            for at in (0..piece.len()).step_by(L::N) {
                let room = L::N.min(piece.len() - at);
                lanes.read(piece.start + at, room);
                for i in zeros {
                    write(L::zero(), &mut rows[*i][at..at + room]);
                }
                let mut matrix = Matrix { rows: &mut *rows, width: states + inputs, at, room };
                body.write_jacobian(&lanes.x, &mut matrix);
            }
        },
    );
}

fn dual<L: Lane>(
    body: &FreeBody<Dual<L, 1>>,
    points: &Points<'_>,
    states: usize,
    piece: Range<usize>,
    rows: &mut [&mut [f64]],
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
                for (p, v) in point.iter_mut().zip(lanes.x.iter().chain(&lanes.u)) {
                    *p = Dual::constant(*v);
                }
                for column in 0..width {
                    point[column].slope = [L::one()];
                    let (x, u) = point.split_at(states);
                    body.derivative(Dual::constant(lanes.t), x, u, &mut rate);
                    point[column].slope = [L::zero()];
                    for (row, rate) in rate.iter().enumerate() {
                        write(rate.slope[0], &mut rows[row * width + column][at..at + room]);
                    }
                }
            }
        },
    );
}
