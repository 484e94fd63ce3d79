//! Steps end where the caller wants them, and right-hand sides may jump there.

use super::{Kepler, LOOSE, Scalar, advance, begin, equal_steps, slope, tolerance};
use crate::integrators::{Block, Dop853, Dp54, Gauss6, Lanes, Method, Rk4, Rodas5P, System, Verdict};

#[test]
fn limits_are_met_exactly() {
    let y0 = Kepler::orbit(0.5, 0.0);
    let mut free = begin::<Dop853, _>(&Kepler, tolerance(1e-9), (0.0, 6.0), &y0, None);
    advance(&mut free, &Kepler, 6.0);
    let limits = [0.1, 0.1 + 1e-13, 0.2, 1.0 / 3.0, 2.0, 2.0f64.next_up(), 5.9999999999, 6.0];
    let mut stepper = begin::<Dop853, _>(&Kepler, tolerance(1e-9), (0.0, 6.0), &y0, None);
    for limit in limits {
        advance(&mut stepper, &Kepler, limit);
        assert_eq!(stepper.t().to_bits(), f64::to_bits(limit));
    }
    // A limit costs its own step and at most one to split evenly what was left; a spoiled step size
    // would cost about log10(1e13) steps to grow again after each of the close pairs.
    assert!(stepper.steps() <= free.steps() + 2.0 * limits.len() as f64);
}

#[test]
fn a_limit_keeps_the_step_size() {
    let y0 = Kepler::orbit(0.1, 0.0);
    let mut stepper = begin::<Dp54, _>(&Kepler, tolerance(1e-8), (0.0, 6.0), &y0, None);
    stepper.attempt(&Kepler, 6.0);
    stepper.commit(&Kepler);
    let (t, h) = (stepper.t(), stepper.step_size());
    advance(&mut stepper, &Kepler, t + 1e-9 * h);
    assert_eq!(stepper.step_size(), h);
}

#[test]
fn no_sliver_is_left_before_a_limit() {
    let flat = Scalar(|_, _| 1.0);
    for remainder in [1.005, 1.02, 1.5, 1.999] {
        let mut stepper = begin::<Dp54, _>(&flat, LOOSE, (0.0, remainder), &[0.0], Some(1.0));
        let mut shortest = f64::INFINITY;
        while stepper.t() < remainder {
            let t = stepper.t();
            stepper.attempt(&flat, remainder);
            stepper.commit(&flat);
            shortest = f64::min(shortest, stepper.t() - t);
        }
        assert!(shortest >= 0.5 * remainder.min(1.01), "{remainder}: {shortest}");
    }
}

#[test]
fn fixed_steps_are_not_split() {
    // A thousand tenths add up to something else than a hundred.
    let flat = Scalar(|_, _| 1.0);
    let mut stepper = begin::<Rk4, _>(&flat, LOOSE, (0.0, 100.0), &[0.0], Some(0.1));
    advance(&mut stepper, &flat, 100.0);
    assert_eq!((stepper.t(), stepper.steps()), (100.0, 1000.0));
    // A span that is no multiple ends with a shorter step, and the step after it is whole again.
    advance(&mut stepper, &flat, 100.25);
    assert_eq!((stepper.steps(), stepper.step_size()), (1003.0, 0.1));
}

#[test]
fn a_lane_at_its_limit_is_idle() {
    let mut stepper = begin::<Dop853, _>(&Kepler, tolerance(1e-9), (0.0, 6.0), &[1.0, 0.0, 0.0, 1.0], None);
    advance(&mut stepper, &Kepler, 1.0);
    let before = (stepper.t(), stepper.y().to_vec(), stepper.step_size(), stepper.steps());
    for limit in [1.0, 0.5] {
        let trial = stepper.attempt(&Kepler, limit);
        stepper.commit(&Kepler);
        assert!(trial.accepted.is_empty() && trial.stopped.is_empty());
        assert_eq!(stepper.verdict(0), Verdict::Idle);
        assert_eq!((stepper.t(), stepper.y().to_vec(), stepper.step_size(), stepper.steps()), before);
    }
}

/// `y' = y cos t` before t = 1, `y' = -2 y` from there on.
fn jump(t: f64, y: f64) -> f64 {
    if t < 1.0 { y * t.cos() } else { -2.0 * y }
}

fn order_across_jump<M: Method>(counts: &[usize], allowance: f64) {
    let law = Scalar(jump);
    let exact = (1f64.sin() - 4.0).exp();
    let errors: Vec<_> = counts
        .iter()
        .map(|&n| {
            let h = 1.0 / n as f64;
            let mut stepper = begin::<M, _>(&law, LOOSE, (0.0, 3.0), &[1.0], Some(2.0 * h));
            equal_steps(&mut stepper, &law, (0.0, 1.0), n);
            stepper.refresh(&law, Lanes::one(0));
            equal_steps(&mut stepper, &law, (1.0, 3.0), n);
            (h, (stepper.y()[0] - exact).abs())
        })
        .collect();
    let measured = slope(&errors);
    // One evaluation on the wrong side would leave order one.
    assert!(measured > M::ORDER as f64 - allowance, "order {measured}: {errors:?}");
}

#[test]
fn a_jump_at_a_limit_keeps_the_order() {
    order_across_jump::<Rk4>(&[20, 40, 80, 160], 0.2);
    order_across_jump::<Dp54>(&[10, 20, 40, 80], 0.3);
    order_across_jump::<Dop853>(&[3, 4, 6, 8], 0.5);
    order_across_jump::<Rodas5P>(&[10, 20, 40, 80], 0.3);
    order_across_jump::<Gauss6>(&[4, 8, 16, 32], 0.3);
}

#[test]
fn dense_output_before_a_jump_is_of_the_law_before_it() {
    fn check<M: Method>() {
        let law = Scalar(jump);
        let mut stepper = begin::<M, _>(&law, LOOSE, (0.9, 1.0), &[0.9f64.sin().exp()], Some(0.1));
        stepper.attempt(&law, 1.0);
        stepper.dense(&law);
        let mut y = [0.0];
        stepper.interpolate(0.95, &mut y);
        // Order three at least, h = 0.1: 1e-4/384 of a fourth derivative of the order of ten.
        assert!((y[0] - 0.95f64.sin().exp()).abs() < 5e-6, "{}", y[0]);
    }
    check::<Rk4>();
    check::<Dp54>();
    check::<Dop853>();
    check::<Rodas5P>();
    check::<Gauss6>();
}

#[test]
fn a_restart_may_change_state_size_and_time() {
    let decay = Scalar(|_, y: f64| -y);
    let mut stepper = begin::<Dop853, _>(&decay, tolerance(1e-10), (0.0, 2.0), &[1.0], None);
    advance(&mut stepper, &decay, 1.0);
    let h = stepper.step_size();
    stepper.restart(&Kepler, Lanes::one(0), 0.5, &Kepler::orbit(0.2, 0.5));
    assert_eq!((stepper.t(), stepper.y().len(), stepper.step_size()), (0.5, 4, h));
    advance(&mut stepper, &Kepler, 2.0);
    // Some ten steps of 1e-10.
    assert!(super::distance(stepper.y(), &Kepler::orbit(0.2, 2.0)) < 1e-8);
}

/// The system whose time runs the other way.
struct Mirrored;

impl System<f64> for Mirrored {
    fn size(&self) -> usize {
        4
    }
    fn derivative(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        Kepler.derivative(-t, y, dy);
        dy.iter_mut().for_each(|d| *d = -*d);
    }
    fn jacobian(&self, t: f64, y: &[f64], by_time: &mut [f64], by_state: &mut [f64]) {
        Kepler.jacobian(-t, y, by_time, by_state);
        by_state.iter_mut().for_each(|d| *d = -*d);
    }
    fn error_blocks(&self) -> &[Block] {
        System::<f64>::error_blocks(&Kepler)
    }
}

#[test]
fn backward_is_forward_with_time_mirrored() {
    fn check<M: Method>(step: Option<f64>) {
        let y0 = Kepler::orbit(0.5, 1.0);
        let mut backward = begin::<M, _>(&Kepler, tolerance(1e-9), (1.0, -3.0), &y0, step);
        let mut forward = begin::<M, _>(&Mirrored, tolerance(1e-9), (-1.0, 3.0), &y0, step);
        while backward.t() > -3.0 {
            backward.attempt(&Kepler, -3.0);
            forward.attempt(&Mirrored, 3.0);
            backward.dense(&Kepler);
            forward.dense(&Mirrored);
            let middle = 0.5 * (backward.t() + backward.trial_t());
            let (mut a, mut b) = ([0.0; 4], [0.0; 4]);
            backward.interpolate(middle, &mut a);
            forward.interpolate(-middle, &mut b);
            assert_eq!(a, b);
            backward.commit(&Kepler);
            forward.commit(&Mirrored);
            assert_eq!((backward.t(), backward.y()), (-forward.t(), forward.y()));
        }
        assert_eq!(backward.t(), -3.0);
    }
    check::<Rk4>(Some(0.3));
    check::<Dp54>(None);
    check::<Dop853>(None);
    check::<Rodas5P>(None);
    check::<Gauss6>(Some(0.3));
}
