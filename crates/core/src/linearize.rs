//! Exact Jacobians ∂f/∂x and ∂f/∂u of x' = f(x, u, t), through duals. (3.2)

use crate::phase_space::Dynamics;
use crate::scalar::{Dual, Lane, Real};

/// Writes ∂f/∂x (n×n) and ∂f/∂u (n×m), by rows. Konoplev (3.2)
///
/// All lanes hold the one state, and each lane `K` directions of its own: only the seeds differ.
/// Call inside [`Real::call`].
#[inline(always)]
pub fn jacobian<L: Lane, const K: usize, D: Dynamics<Dual<L, K>>>(
    dynamics: &D,
    t: f64,
    x: &[f64],
    u: &[f64],
    by_state: &mut [f64],
    by_input: &mut [f64],
) {
    let (n, m) = (x.len(), u.len());
    let constant = |v: &f64| Dual::<L, K>::lit(*v);
    let mut point: Vec<Dual<L, K>> = x.iter().map(constant).collect();
    let mut input: Vec<Dual<L, K>> = u.iter().map(constant).collect();
    let mut rate = vec![Dual::<L, K>::lit(0.0); n];
    let per_pass = K * L::N;
    let mut first = 0;
    while first < n + m {
        // Direction `first + k N + l` lives in slope k, lane l.
        for (i, v) in point.iter_mut().chain(&mut input).enumerate() {
            for k in 0..K {
                let start = first + k * L::N;
                let inside = i >= start && i < start + L::N;
                v.slope[k] = if inside { L::zero().with(i - start, 1.0) } else { L::zero() };
            }
        }
        dynamics.derivative(Dual::lit(t), &point, &input, &mut rate);
        for (row, r) in rate.iter().enumerate() {
            for direction in first..(first + per_pass).min(n + m) {
                let (k, l) = ((direction - first) / L::N, (direction - first) % L::N);
                let slope = r.slope[k].get(l);
                if direction < n {
                    by_state[row * n + direction] = slope;
                } else {
                    by_input[row * m + direction - n] = slope;
                }
            }
        }
        first += per_pass;
    }
}
