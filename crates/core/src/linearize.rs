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
    let lane = L::from_lanes(
        #[inline(always)]
        |l| l as f64,
    );
    let mut first = 0;
    while first < n + m {
        // Direction `first + k N + l` lives in slope k, lane l.
        for (i, v) in point.iter_mut().chain(&mut input).enumerate() {
            for (k, slope) in v.slope.iter_mut().enumerate() {
                let apart = lane - L::lit(i as f64 - (first + k * L::N) as f64);
                *slope = L::select_le(apart.abs(), L::lit(0.5), L::one(), L::zero());
            }
        }
        dynamics.derivative(Dual::lit(t), &point, &input, &mut rate);
        for (row, r) in rate.iter().enumerate() {
            let (by_state, by_input) = (&mut by_state[row * n..][..n], &mut by_input[row * m..][..m]);
            let mut places = by_state.iter_mut().chain(by_input).skip(first);
            for slope in r.slope {
                for (l, place) in places.by_ref().take(L::N).enumerate() {
                    *place = slope.get(l);
                }
            }
        }
        first += K * L::N;
    }
}
