//! The step size follows the error, and evaluations are not wasted.

use super::{Kepler, advance, begin, distance, slope, tolerance};
use crate::integrators::controller::power;
use crate::integrators::{Block, Dop853, Dp54, ErrorScale, Method, Rk4, System, Vern8, Vern9};
use std::f64::consts::TAU;

/// Over one orbit the error stays near the tolerance, and steps grow by the order of the method.
fn follows_tolerance<M: Method>() {
    let e = 0.5;
    let mut work = Vec::new();
    for rtol in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let mut stepper = begin::<M, _>(&Kepler, tolerance(rtol), (0.0, TAU), &Kepler::orbit(e, 0.0), None);
        advance(&mut stepper, &Kepler, TAU);
        let error = distance(stepper.y(), &Kepler::orbit(e, TAU)) / rtol;
        // An orbit amplifies an error of its first steps, 3 π / (1 - e) times as a late arrival and
        // 1 / (1 - e)² as the acceleration there, some 80 times, and has 10 to 500 steps to add up.
        // Errors that small against the tolerance as the lower bound would be wasted work.
        assert!((1.0..1000.0).contains(&error), "tolerance {rtol}: error {error} tolerances");
        // On the way to the pericentre the error of a step grows by what the aim leaves in some steps.
        assert!(stepper.rejected() <= 0.3 * stepper.steps(), "{} of {}", stepper.rejected(), stepper.steps());
        work.push((rtol, stepper.steps()));
    }
    // The ten steps at the loosest tolerance are more than the law gives: the orbit needs them.
    let exponent = -slope(&work[1..]) * (M::ERROR_ORDER + 1) as f64;
    assert!((exponent - 1.0).abs() < 0.25, "steps grow as rtol^-({exponent} / {})", M::ERROR_ORDER + 1);
}

#[test]
fn error_follows_tolerance() {
    follows_tolerance::<Dp54>();
    follows_tolerance::<Dop853>();
    follows_tolerance::<Vern8>();
    follows_tolerance::<Vern9>();
}

/// The Arenstorf orbit of the restricted problem of three bodies (Hairer, Nørsett & Wanner, II.0).
struct Arenstorf;

impl System<f64> for Arenstorf {
    fn size(&self) -> usize {
        4
    }
    fn derivative(&self, _: f64, y: &[f64], dy: &mut [f64]) {
        let m = 0.012277471;
        let n = 1.0 - m;
        let d1 = ((y[0] + m).powi(2) + y[1].powi(2)).powf(1.5);
        let d2 = ((y[0] - n).powi(2) + y[1].powi(2)).powf(1.5);
        (dy[0], dy[1]) = (y[2], y[3]);
        dy[2] = y[0] + 2.0 * y[3] - n * (y[0] + m) / d1 - m * (y[0] - n) / d2;
        dy[3] = y[1] - 2.0 * y[2] - n * y[1] / d1 - m * y[1] / d2;
    }
    fn error_blocks(&self) -> &[Block] {
        &[
            Block { start: 0, len: 2, scale: ErrorScale::Relative },
            Block { start: 2, len: 2, scale: ErrorScale::Relative },
        ]
    }
}

#[test]
fn arenstorf_orbit_closes() {
    let y0 = [0.994, 0.0, 0.0, -2.0015851063790824];
    let period = 17.065216560157964;
    let mut stepper = begin::<Dop853, _>(&Arenstorf, tolerance(1e-13), (0.0, period), &y0, None);
    advance(&mut stepper, &Arenstorf, period);
    // Close passes amplify errors: 1e-13 a step, over some 170 steps, a thousandfold and more.
    assert!(distance(&stepper.y()[..2], &y0[..2]) < 1e-7, "{:?}", stepper.y());
    // The step size ranges over three decades; a fixed step as short as the shortest would take 1e4 steps.
    assert!(stepper.steps() < 500.0);
}

#[test]
fn every_evaluation_is_used() {
    let run = |evaluations: u64, start: u64| evaluations - start;
    let y0 = Kepler::orbit(0.5, 0.0);

    let mut dp54 = begin::<Dp54, _>(&Kepler, tolerance(1e-8), (0.0, TAU), &y0, None);
    let start = dp54.evaluations();
    assert_eq!(start, 2, "one for the first stage, one for the first step");
    advance(&mut dp54, &Kepler, TAU);
    let trials = dp54.steps() + dp54.rejected();
    assert_eq!(run(dp54.evaluations(), start) as f64, 6.0 * trials);

    let mut dop853 = begin::<Dop853, _>(&Kepler, tolerance(1e-8), (0.0, TAU), &y0, None);
    advance(&mut dop853, &Kepler, TAU);
    let trials = dop853.steps() + dop853.rejected();
    assert_eq!(run(dop853.evaluations(), start) as f64, 11.0 * trials + dop853.steps());

    let mut rk4 = begin::<Rk4, _>(&Kepler, tolerance(1e-8), (0.0, 1.0), &y0, Some(0.1));
    advance(&mut rk4, &Kepler, 1.0);
    assert_eq!((rk4.steps(), rk4.evaluations()), (10.0, 1 + 40));

    let before = dop853.evaluations();
    dop853.attempt(&Kepler, 7.0);
    dop853.dense(&Kepler);
    dop853.commit(&Kepler);
    assert_eq!(dop853.evaluations() - before, 11 + 1 + 3, "dense output shares the end of the step");
}

#[test]
fn dense_output_leaves_the_run_alone() {
    let y0 = Kepler::orbit(0.5, 0.0);
    let run = |dense: bool| {
        let mut stepper = begin::<Dop853, _>(&Kepler, tolerance(1e-9), (0.0, TAU), &y0, None);
        while stepper.t() < TAU {
            stepper.attempt(&Kepler, TAU);
            if dense {
                stepper.dense(&Kepler);
            }
            stepper.commit(&Kepler);
        }
        stepper.y().to_vec()
    };
    assert_eq!(run(true), run(false));
}

/// The error norm depends on the lengths of vectors, not on the directions of their axes.
#[test]
fn error_is_independent_of_axes() {
    let (s, c) = 0.7f64.sin_cos();
    let turn =
        |y: [f64; 4]| [c * y[0] - s * y[1], s * y[0] + c * y[1], c * y[2] - s * y[3], s * y[2] + c * y[3]];
    let y0 = Kepler::orbit(0.5, 0.3);
    let step = |y0: [f64; 4]| {
        let mut stepper = begin::<Dp54, _>(&Kepler, tolerance(1e-8), (0.0, 1.0), &y0, Some(0.05));
        stepper.attempt(&Kepler, 1.0);
        stepper.error()
    };
    let (plain, turned) = (step(y0), step(turn(y0)));
    // The estimate is 1e-8 of the state, so rounding of 1e-16 shows as 1e-8 of it at most.
    assert!((plain / turned - 1.0).abs() < 1e-7, "{plain} {turned}");
}

#[test]
fn power_is_right_to_a_hundred_thousandth() {
    for p in [-0.5 / 8.0, -0.1, 0.2] {
        for i in -2000..2000 {
            let x = (f64::from(i) * 0.1).exp();
            assert!((power(x, p) / x.powf(p) - 1.0).abs() < 1e-5, "{x}^{p}");
        }
    }
}

/// A point on the unit circle whose derivative carries it off: only the projection keeps it there.
struct Circle;

impl System<f64> for Circle {
    fn size(&self) -> usize {
        2
    }
    fn derivative(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        let rate = 1.0 + 0.5 * t.sin();
        (dy[0], dy[1]) = (-rate * y[1], rate * y[0]);
    }
    fn project(&self, y: &mut [f64]) {
        let length = (y[0] * y[0] + y[1] * y[1]).sqrt();
        (y[0], y[1]) = (y[0] / length, y[1] / length);
    }
    fn error_blocks(&self) -> &[Block] {
        &[Block { start: 0, len: 2, scale: ErrorScale::Fixed(1.0) }]
    }
}

fn stays_on_the_circle<M: Method>(step: Option<f64>) {
    let mut stepper = begin::<M, _>(&Circle, tolerance(1e-5), (0.0, 20.0), &[1.0, 0.0], step);
    while stepper.t() < 20.0 {
        stepper.attempt(&Circle, 20.0);
        stepper.dense(&Circle);
        let mut y = [0.0; 2];
        stepper.interpolate(stepper.trial_t(), &mut y);
        assert!(distance(&y, stepper.trial_y()) < 1e-15, "dense output meets the projected state");
        stepper.commit(&Circle);
        let y = stepper.y();
        assert!((y[0].hypot(y[1]) - 1.0).abs() < 4e-16);
        let mut f = [0.0; 2];
        let limit_reached = stepper.t() == 20.0;
        Circle.derivative(if limit_reached { 20f64.next_down() } else { stepper.t() }, y, &mut f);
        assert_eq!(stepper.derivative(), f, "the derivative is that of the projected state");
    }
    let angle = 20.0 + 0.5 * (1.0 - 20f64.cos());
    // Some 60 steps of 1e-5 at most each.
    assert!(distance(stepper.y(), &[angle.cos(), angle.sin()]) < 1e-3);
}

#[test]
fn projection_is_part_of_the_step() {
    stays_on_the_circle::<Rk4>(Some(0.1));
    stays_on_the_circle::<Dp54>(None);
    stays_on_the_circle::<Dop853>(None);
    stays_on_the_circle::<Vern8>(None);
    stays_on_the_circle::<Vern9>(None);
}
