//! Exact Jacobians of right-hand sides that are written over any scalar.

use crate::buffer::Buffer;
use crate::scalar::{Dual, Lane};

/// Systems up to this size are differentiated on the stack.
const ON_STACK: usize = 24;

/// Writes `∂f/∂t` and, by rows, `∂f/∂y`, where `f(t, y, dy)` writes the right-hand side; each lane at its own point.
///
/// Call inside [`crate::scalar::Real::call`].
#[inline(always)]
pub fn differentiate<T: Lane>(
    t: T,
    y: &[T],
    by_time: &mut [T],
    by_state: &mut [T],
    f: impl Fn(Dual<T, 1>, &[Dual<T, 1>], &mut [Dual<T, 1>]),
) {
    let n = y.len();
    let (zero, one) = (T::zero(), T::one());
    let (mut point, mut rate) = (Buffer::<_, ON_STACK>::new(n), Buffer::<_, ON_STACK>::new(n));
    let (point, rate) = (point.slice(), rate.slice());
    for (p, y) in point.iter_mut().zip(y) {
        *p = Dual::constant(*y);
    }
    // Last comes time.
    for direction in 0..=n {
        let mut time = Dual::constant(t);
        match point.get_mut(direction) {
            Some(p) => p.slope = [one],
            None => time.slope = [one],
        }
        f(time, point, rate);
        if let Some(p) = point.get_mut(direction) {
            p.slope = [zero];
            for (row, r) in rate.iter().enumerate() {
                by_state[row * n + direction] = r.slope[0];
            }
        } else {
            for (d, r) in by_time.iter_mut().zip(&*rate) {
                *d = r.slope[0];
            }
        }
    }
}
