//! f at many states.

use super::Points;
use super::blocks::{Kernel, Places, go, past_caches};
use super::columns::{Lanes, share, write};
use crate::buffer::Buffer;
use crate::forces::Usual;
use crate::phase_space::{Dynamics, FreeBody, STATES};
use crate::scalar::Lane;
use std::array;
use std::ops::Range;

/// Up to this many inputs are passed on the stack.
const ON_STACK: usize = 16;

/// Writes f(x, u, t) of each point, by component. Konoplev (3.2)
pub fn derivatives<L: Lane>(body: &FreeBody<L>, points: &Points<'_>, out: &mut [f64], threads: usize) {
    let plain = body.is_plain() && body.compiled.is_none();
    if !plain {
        return share(out, points.count, threads, |piece, rows| any(body, points, piece, rows));
    }
    let past = past_caches::<L>(STATES, points.count);
    share(out, points.count, threads, |piece, rows| {
        let mut rows = rows.into_iter();
        let rows: [_; STATES] = array::from_fn(|_| rows.next().unwrap_or_default());
        let usual = body.acting.as_ref().map(
            #[inline(always)]
            |acting| &acting.usual,
        );
        let Some(usual) = usual else { return };
        if points.u.len() > points.inputs {
            return go::<L, STATES>(&Rate { body, usual }, points, piece, rows, past);
        }
        // One u for all is among what is constant.
        let usual = L::call(
            #[inline(always)]
            || {
                let mut u = Buffer::<L, ON_STACK>::new(points.inputs);
                for (to, u) in u.slice().iter_mut().zip(points.u) {
                    *to = L::lit(*u);
                }
                usual.with_constant(u.slice())
            },
        );
        go::<L, STATES>(&Rate { body, usual: &usual }, points, piece, rows, past);
    });
}

/// f of a body in quaternions and quasi-velocities under the usual forces.
struct Rate<'a, L> {
    body: &'a FreeBody<L>,
    usual: &'a Usual<L>,
}

impl<L: Lane> Kernel<L, STATES> for Rate<'_, L> {
    #[inline(always)]
    fn at(&self, _: L, x: &[L; STATES], u: &[L], out: &mut impl Places<L>) {
        let mut rate = [L::zero(); STATES];
        self.body.plain_rate_under::<true>(self.usual, x, u, &mut rate);
        let mut k = 0;
        while k < STATES {
            out.put(k, rate[k]);
            k += 1;
        }
    }
}

/// The same of any body.
fn any<L: Lane>(body: &FreeBody<L>, points: &Points<'_>, piece: Range<usize>, mut rows: Vec<&mut [f64]>) {
    L::call(
        #[inline(always)]
        || {
            let mut lanes = Lanes::<L>::new(points, rows.len());
            let mut rate = vec![L::zero(); rows.len()];
            for at in (0..piece.len()).step_by(L::N) {
                let room = L::N.min(piece.len() - at);
                lanes.read(piece.start + at, room);
                let controls = &mut lanes.controls;
                body.derivative(controls.t, &lanes.x, controls.u.slice(), &mut rate);
                for (rate, row) in rate.iter().zip(rows.iter_mut()) {
                    write(*rate, &mut row[at..at + room]);
                }
            }
        },
    );
}
