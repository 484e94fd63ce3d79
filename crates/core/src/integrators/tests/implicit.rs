//! What implicit methods are for: stiff systems, and invariants that hold for ever.

use super::{LOOSE, Scalar, advance, begin, tolerance};
use crate::integrators::{
    Block, Dop853, ErrorScale, Gauss6, Method, Rk4, Rodas5P, System, Verdict, differentiate,
};
use crate::scalar::{Lane, Real};

/// `y' = -λ (y - cos t) - sin t`: whatever it starts from is drawn to cos t within some 1/λ.
///
/// A. Prothero, A. Robinson, Mathematics of Computation 28 (1974).
struct Drawn(f64);

impl Drawn {
    #[inline(always)]
    fn law<T: Real>(&self, t: T, y: &[T], dy: &mut [T]) {
        let (s, c) = t.sin_cos();
        dy[0] = T::lit(-self.0) * (y[0] - c) - s;
    }
}

impl<T: Lane> System<T> for Drawn {
    fn size(&self) -> usize {
        1
    }
    fn derivative(&self, t: T, y: &[T], dy: &mut [T]) {
        self.law(t, y, dy);
    }
    fn jacobian(&self, t: T, y: &[T], by_time: &mut [T], by_state: &mut [T]) {
        differentiate(t, y, by_time, by_state, |t, y, dy| self.law(t, y, dy));
    }
    fn error_blocks(&self) -> &[Block] {
        &[Block { start: 0, len: 1, scale: ErrorScale::Relative }]
    }
}

fn drawn<M: Method>(stiffness: f64, tolerated: f64) -> (f64, f64) {
    let law = Drawn(stiffness);
    let mut stepper = begin::<M, _>(&law, tolerance(tolerated), (0.0, 10.0), &[1.5], None);
    advance(&mut stepper, &law, 10.0);
    assert_eq!(stepper.t(), 10.0);
    (stepper.steps() + stepper.rejected(), (stepper.y()[0] - 10f64.cos()).abs())
}

#[test]
fn rodas5p_does_not_mind_stiffness() {
    let (plain, _) = drawn::<Rodas5P>(1.0, 1e-7);
    for stiffness in [1e3, 1e6, 1e9] {
        let (steps, error) = drawn::<Rodas5P>(stiffness, 1e-7);
        // The way from the start to cos t takes some steps more.
        assert!(steps < 3.0 * plain + 50.0, "{steps} steps, {plain} without stiffness");
        // Some hundred steps of the tolerance.
        assert!(error < 1e-5, "{error}");
    }
    // An explicit method takes steps of some 1/λ.
    let (steps, _) = drawn::<Dop853>(1e3, 1e-7);
    assert!(steps > 1000.0 && steps < 10_000.0, "{steps}");
}

#[test]
fn samples_inside_stiff_steps_meet_the_tolerance() {
    let law = Drawn(1e6);
    let mut stepper = begin::<Rodas5P, _>(&law, tolerance(1e-7), (0.0, 10.0), &[1.0], None);
    while stepper.t() < 10.0 {
        stepper.attempt(&law, 10.0);
        stepper.dense(&law);
        if stepper.error() <= 1.0 {
            for x in [0.25, 0.5, 0.75] {
                let t = stepper.t() + x * (stepper.trial_t() - stepper.t());
                let mut y = [0.0];
                stepper.interpolate(t, &mut y);
                // Nothing of an error stays until the next step. The tolerance is 1e-7 and as much of the length.
                let error = (y[0] - t.cos()).abs();
                assert!(error < 2e-7, "{error} at {t}");
            }
        }
        stepper.commit(&law);
    }
}

/// Euler's equations of a free body with moments of inertia 1, 2, 3.
struct Euler;

impl System<f64> for Euler {
    fn size(&self) -> usize {
        3
    }
    fn derivative(&self, _: f64, w: &[f64], dw: &mut [f64]) {
        dw[0] = -w[1] * w[2];
        dw[1] = w[2] * w[0];
        dw[2] = -w[0] * w[1] / 3.0;
    }
    fn error_blocks(&self) -> &[Block] {
        &[Block { start: 0, len: 3, scale: ErrorScale::Relative }]
    }
}

/// The largest relative drift of energy and squared momentum, at every step of `n`.
fn drift<M: Method>(n: usize, step: f64) -> f64 {
    let invariants = |w: &[f64]| {
        let sum = |j: [f64; 3]| -> f64 { j.iter().zip(w).map(|(j, w)| j * w * w).sum() };
        [sum([1.0, 2.0, 3.0]), sum([1.0, 4.0, 9.0])]
    };
    let end = n as f64 * step;
    let mut stepper = begin::<M, _>(&Euler, LOOSE, (0.0, end), &[0.3, 1.0, 0.2], Some(step));
    let first = invariants(stepper.y());
    let mut worst: f64 = 0.0;
    while stepper.t() < end {
        assert!(stepper.attempt(&Euler, end).stopped.is_empty());
        stepper.commit(&Euler);
        for (now, first) in invariants(stepper.y()).iter().zip(first) {
            worst = worst.max((now / first - 1.0).abs());
        }
    }
    worst
}

#[test]
fn gauss6_keeps_quadratic_invariants() {
    let [early, late] = [drift::<Gauss6>(1000, 0.5), drift::<Gauss6>(100_000, 0.5)];
    // Rounding alone, as a random walk of some 1e-17 a step.
    assert!(early < 2e-15 && late < 1e-14, "{early} {late}");
    // The same steps of an explicit method lose the motion.
    assert!(drift::<Rk4>(1000, 0.5) > 1e-4);
}

#[test]
fn a_step_too_large_to_solve_for_is_an_end() {
    let law = Scalar(|_, y: f64| -1e4 * y);
    for (step, verdict) in [(1e-4, Verdict::Accepted), (1e-1, Verdict::StepTooLarge)] {
        let mut stepper = begin::<Gauss6, _>(&law, tolerance(1e-9), (0.0, 1.0), &[1.0], Some(step));
        stepper.attempt(&law, 1.0);
        assert_eq!(stepper.verdict(0), verdict);
        let before = stepper.y()[0];
        stepper.commit(&law);
        assert_eq!(stepper.y()[0] == before, verdict == Verdict::StepTooLarge);
    }
    // This iteration soon comes to numbers that are none.
    let law = Scalar(|_, y: f64| 1.0 + 1e3 * y * y);
    let mut stepper = begin::<Gauss6, _>(&law, tolerance(1e-9), (0.0, 1.0), &[1.0], Some(1.0));
    stepper.attempt(&law, 1.0);
    assert_eq!(stepper.verdict(0), Verdict::StepTooLarge);
}

#[test]
fn without_a_jacobian_no_stiff_step_is_taken() {
    let mut stepper = begin::<Rodas5P, _>(&Euler, tolerance(1e-9), (0.0, 1.0), &[1.0, 1.0, 1.0], None);
    advance(&mut stepper, &Euler, 1.0);
    assert_eq!((stepper.verdict(0), stepper.steps()), (Verdict::StepTooSmall, 0.0));
}
