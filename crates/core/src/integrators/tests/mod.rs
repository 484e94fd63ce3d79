//! What the integrators must obey.

mod control;
mod failure;
mod implicit;
mod lanes;
mod limits;
mod linear;
mod order;
mod rigid;
mod tableau;

use super::{Block, ErrorScale, Lanes, Method, Stepper, System, Tolerance, differentiate};
use crate::scalar::{Lane, Real};

/// Two bodies, one fixed at the origin, with unit attraction: position (2), velocity (2).
pub struct Kepler;

impl<T: Lane> System<T> for Kepler {
    fn size(&self) -> usize {
        4
    }
    fn derivative(&self, _: T, y: &[T], dy: &mut [T]) {
        T::call(
            #[inline(always)]
            || Self::law(y, dy),
        );
    }
    fn jacobian(&self, t: T, y: &[T], by_time: &mut [T], by_state: &mut [T]) {
        T::call(
            #[inline(always)]
            || differentiate(t, y, by_time, by_state, |_, y, dy| Self::law(y, dy)),
        );
    }
    fn error_blocks(&self) -> &[Block] {
        &[
            Block { start: 0, len: 2, scale: ErrorScale::Relative },
            Block { start: 2, len: 2, scale: ErrorScale::Relative },
        ]
    }
}

impl Kepler {
    pub fn law<T: Real>(y: &[T], dy: &mut [T]) {
        let r2 = y[0].fma(y[0], y[1] * y[1]);
        let pull = -T::one() / (r2 * r2.sqrt());
        (dy[0], dy[1]) = (y[2], y[3]);
        (dy[2], dy[3]) = (pull * y[0], pull * y[1]);
    }

    /// The orbit of eccentricity `e` and period 2π, `t` after the pericentre.
    pub fn orbit(e: f64, t: f64) -> [f64; 4] {
        // Kepler's equation by Newton's method; 50 steps are far more than enough below e = 0.9.
        let mut u = t;
        for _ in 0..50 {
            u -= (u - e * u.sin() - t) / (1.0 - e * u.cos());
        }
        let (s, c) = u.sin_cos();
        let (b, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * c));
        [c - e, b * s, -s * rate, b * c * rate]
    }
}

/// A scalar equation given by a function; its derivatives are difference quotients, right to about 1e-10.
pub struct Scalar<F>(pub F);

impl<F: Fn(f64, f64) -> f64> Scalar<F> {
    fn quotient(f: impl Fn(f64) -> f64, x: f64) -> f64 {
        // Ahead, within the step: behind the point may lie a jump.
        let d = 1e-5 * x.abs().max(1.0);
        (4.0 * f(x + d) - f(x + 2.0 * d) - 3.0 * f(x)) / (2.0 * d)
    }
}

impl<F: Fn(f64, f64) -> f64> System<f64> for Scalar<F> {
    fn size(&self) -> usize {
        1
    }
    fn derivative(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        dy[0] = (self.0)(t, y[0]);
    }
    fn jacobian(&self, t: f64, y: &[f64], by_time: &mut [f64], by_state: &mut [f64]) {
        by_time[0] = Self::quotient(|t| (self.0)(t, y[0]), t);
        by_state[0] = Self::quotient(|y| (self.0)(t, y), y[0]);
    }
    fn error_blocks(&self) -> &[Block] {
        &[Block { start: 0, len: 1, scale: ErrorScale::Relative }]
    }
}

/// So loose that no step is rejected: for steps whose size the limits alone decide.
pub const LOOSE: Tolerance = Tolerance { relative: 1e9, absolute: 1e9 };

/// A tolerance for positions and velocities of the order of one.
pub fn tolerance(x: f64) -> Tolerance {
    Tolerance { relative: x, absolute: x }
}

pub fn begin<M: Method, S: System<f64>>(
    system: &S,
    tolerance: Tolerance,
    (t0, t1): (f64, f64),
    y0: &[f64],
    step: Option<f64>,
) -> Stepper<f64, M> {
    let mut stepper = Stepper::new(tolerance);
    stepper.start(system, Lanes::one(0), t0, y0, t1, step);
    stepper
}

/// Goes to `t1` or to where the lane stops; no run of these tests needs 10,000 trials.
pub fn advance<M: Method, S: System<f64>>(stepper: &mut Stepper<f64, M>, system: &S, t1: f64) {
    for _ in 0..10_000 {
        if stepper.t() == t1 || !stepper.attempt(system, t1).stopped.is_empty() {
            return;
        }
        stepper.commit(system);
    }
    panic!("{t1} is not reached: at {} with step {}", stepper.t(), stepper.step_size());
}

/// `n` equal steps from `t0` to `t1`.
pub fn equal_steps<M: Method, S: System<f64>>(
    stepper: &mut Stepper<f64, M>,
    system: &S,
    (t0, t1): (f64, f64),
    n: usize,
) {
    for i in 1..=n {
        let before = stepper.steps();
        advance(stepper, system, t0 + (t1 - t0) * i as f64 / n as f64);
        assert_eq!(stepper.steps(), before + 1.0, "one step to each limit");
    }
}

/// The largest difference of two vectors.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The slope of log(error) over log(h), from pairs `(h, error)`, by least squares.
pub fn slope(pairs: &[(f64, f64)]) -> f64 {
    let n = pairs.len() as f64;
    let logs: Vec<_> = pairs.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / n;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let over: f64 = logs.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    over / logs.iter().map(|p| (p.0 - mx).powi(2)).sum::<f64>()
}
