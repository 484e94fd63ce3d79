//! Every run ends.

use super::{Kepler, LOOSE, Scalar, advance, begin, tolerance};
use crate::integrators::{Dop853, Dp54, Gauss6, Method, Rk4, Rodas5P, Verdict};

#[test]
fn a_start_that_is_not_finite_ends_at_once() {
    fn check<M: Method>() {
        for y0 in [[f64::NAN, 0.0, 0.0, 1.0], [0.0; 4]] {
            let mut stepper = begin::<M, _>(&Kepler, tolerance(1e-9), (0.0, 1.0), &y0, Some(0.1));
            let trial = stepper.attempt(&Kepler, 1.0);
            assert!(trial.stopped.contains(0) && trial.accepted.is_empty());
            assert_eq!(stepper.verdict(0), Verdict::NonFinite);
            assert_eq!(stepper.t(), 0.0);
        }
    }
    check::<Rk4>();
    check::<Dp54>();
    check::<Dop853>();
    check::<Rodas5P>();
    check::<Gauss6>();
}

#[test]
fn the_first_step_of_a_bad_start_is_finite() {
    for y0 in [[0.0; 4], [f64::NAN; 4], [f64::INFINITY; 4]] {
        let stepper = begin::<Dop853, _>(&Kepler, tolerance(1e-9), (0.0, 1.0), &y0, None);
        assert!((0.0..=1.0).contains(&stepper.step_size()));
    }
}

/// y' = y² from y(0) = 1 goes to infinity at t = 1.
#[test]
fn a_pole_ends_with_the_step_too_small() {
    fn check<M: Method>() {
        let law = Scalar(|_, y: f64| y * y);
        let mut stepper = begin::<M, _>(&law, tolerance(1e-9), (0.0, 2.0), &[1.0], None);
        advance(&mut stepper, &law, 2.0);
        assert_eq!(stepper.verdict(0), Verdict::StepTooSmall);
        // Stopped by the pole where the error of the run, about a hundred tolerances, puts it.
        assert!((stepper.t() - 1.0).abs() < 1e-7, "{}", stepper.t());
    }
    check::<Dp54>();
    check::<Dop853>();
    check::<Rodas5P>();
}

/// The right-hand side is not a number from t = 1 on.
#[test]
fn a_wall_of_nan_is_approached_but_not_passed() {
    fn check<M: Method>() {
        let law = Scalar(|t: f64, _| (1.0 - t).sqrt());
        let mut stepper = begin::<M, _>(&law, tolerance(1e-6), (0.0, 2.0), &[0.0], None);
        let trial = stepper.attempt(&law, 2.0);
        assert!(trial.stopped.is_empty());
        advance(&mut stepper, &law, 2.0);
        assert!(matches!(stepper.verdict(0), Verdict::StepTooSmall | Verdict::NonFinite));
        assert!(stepper.t() <= 1.0f64.next_up() && stepper.t() > 1.0 - 1e-6, "{}", stepper.t());
    }
    check::<Dp54>();
    check::<Dop853>();
}

#[test]
fn a_trial_that_is_not_finite_is_retried_with_a_fifth() {
    let law = Scalar(|t: f64, _| if t > 0.5 { f64::INFINITY } else { 1.0 });
    let mut stepper = begin::<Dop853, _>(&law, LOOSE, (0.0, 2.0), &[0.0], Some(1.0));
    stepper.attempt(&law, 10.0);
    stepper.commit(&law);
    assert_eq!((stepper.verdict(0), stepper.t(), stepper.step_size()), (Verdict::Diverged, 0.0, 0.2));
    stepper.attempt(&law, 10.0);
    stepper.commit(&law);
    assert_eq!((stepper.verdict(0), stepper.t()), (Verdict::Accepted, 0.2));
    // After a rejection a step does not grow, though the error is zero.
    assert_eq!(stepper.step_size(), 0.2);
}

#[test]
fn a_fixed_step_into_nan_is_an_end() {
    fn check<M: Method>() {
        let law = Scalar(|t: f64, _| (1.0 - t).sqrt());
        let mut stepper = begin::<M, _>(&law, LOOSE, (0.0, 2.0), &[0.0], Some(0.3));
        advance(&mut stepper, &law, 2.0);
        assert_eq!(stepper.verdict(0), Verdict::NonFinite);
        assert_eq!(stepper.steps(), 3.0);
    }
    check::<Rk4>();
    check::<Gauss6>();
}

#[test]
fn a_step_below_the_rounding_of_time_is_refused() {
    let law = Scalar(|_, _| 1.0);
    let mut stepper = begin::<Dop853, _>(&law, LOOSE, (1e9, 2e9), &[0.0], Some(1e-7));
    assert!(stepper.attempt(&law, 2e9).stopped.contains(0));
    assert_eq!(stepper.verdict(0), Verdict::StepTooSmall);
}
