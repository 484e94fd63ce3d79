//! Each method has the order that it states.

use super::{Kepler, LOOSE, advance, begin, distance, equal_steps, slope};
use crate::integrators::{Dop853, Dp54, Gauss6, Method, Rk4, Rodas5P, Vern8, Vern9};

const E: f64 = 0.3;

/// The error after most of an orbit in `n` equal steps falls as `n^-order`.
fn order<M: Method>(counts: &[usize], allowance: f64) {
    let t1 = 5.0;
    let errors: Vec<_> = counts
        .iter()
        .map(|&n| {
            let h = t1 / n as f64;
            let mut stepper = begin::<M, _>(&Kepler, LOOSE, (0.0, t1), &Kepler::orbit(E, 0.0), Some(h));
            equal_steps(&mut stepper, &Kepler, (0.0, t1), n);
            (h, distance(stepper.y(), &Kepler::orbit(E, t1)))
        })
        .collect();
    let measured = slope(&errors);
    assert!((measured - M::ORDER as f64).abs() < allowance, "order {measured}: {errors:?}");
}

// The counts are where the error is above 1e-12, so that rounding does not count, and small enough for the
// leading term to rule; what the next term adds to the slope is the allowance.
#[test]
fn order_rk4() {
    order::<Rk4>(&[200, 400, 800, 1600], 0.15);
}

#[test]
fn order_dp54() {
    order::<Dp54>(&[100, 200, 400, 800], 0.3);
}

#[test]
fn order_dop853() {
    order::<Dop853>(&[30, 40, 60, 80, 120], 0.5);
}

#[test]
fn order_vern8() {
    order::<Vern8>(&[20, 30, 40, 60, 80], 0.5);
}

#[test]
fn order_vern9() {
    order::<Vern9>(&[20, 25, 30, 40, 50], 0.8);
}

#[test]
fn order_rodas5p() {
    order::<Rodas5P>(&[50, 100, 200, 400], 0.3);
}

#[test]
fn order_gauss6() {
    order::<Gauss6>(&[20, 40, 80, 160], 0.3);
}

/// Inside one step of size h the solution is right to `h^(order + 1)`.
fn dense_order<M: Method>(sizes: &[f64], allowance: f64) {
    let errors: Vec<_> = sizes
        .iter()
        .map(|&h| {
            let mut worst: f64 = 0.0;
            for t0 in [0.5, 1.5, 2.5, 4.0] {
                let mut stepper = begin::<M, _>(&Kepler, LOOSE, (t0, t0 + h), &Kepler::orbit(E, t0), Some(h));
                stepper.attempt(&Kepler, t0 + h);
                stepper.dense(&Kepler);
                for x in [0.2, 0.45, 0.8] {
                    let mut y = [0.0; 4];
                    stepper.interpolate(t0 + x * h, &mut y);
                    worst = worst.max(distance(&y, &Kepler::orbit(E, t0 + x * h)));
                }
            }
            (h, worst)
        })
        .collect();
    let measured = slope(&errors) - 1.0;
    assert!((measured - M::DENSE_ORDER as f64).abs() < allowance, "order {measured}: {errors:?}");
}

#[test]
fn dense_order_rk4() {
    dense_order::<Rk4>(&[0.2, 0.1, 0.05, 0.025], 0.2);
}

#[test]
fn dense_order_dp54() {
    dense_order::<Dp54>(&[0.2, 0.1, 0.05, 0.025], 0.3);
}

#[test]
fn dense_order_dop853() {
    dense_order::<Dop853>(&[0.4, 0.3, 0.2, 0.15, 0.1], 0.5);
}

#[test]
fn dense_order_vern8() {
    dense_order::<Vern8>(&[0.25, 0.2, 0.15, 0.1], 0.5);
}

#[test]
fn dense_order_vern9() {
    dense_order::<Vern9>(&[0.4, 0.3, 0.25, 0.2], 0.9);
}

#[test]
fn dense_order_rodas5p() {
    dense_order::<Rodas5P>(&[0.2, 0.1, 0.05, 0.025], 0.3);
}

#[test]
fn dense_order_gauss6() {
    dense_order::<Gauss6>(&[0.2, 0.1, 0.05, 0.025], 0.3);
}

/// At the ends of a step the continuous solution is the step's, and its slope is the derivative there.
fn dense_ends<M: Method>() {
    let mut stepper = begin::<M, _>(&Kepler, LOOSE, (0.0, 1.0), &Kepler::orbit(E, 0.0), Some(0.25));
    advance(&mut stepper, &Kepler, 0.25);
    stepper.attempt(&Kepler, 0.5);
    stepper.dense(&Kepler);
    let d = 1e-6;
    let [start, after_start, before_end, end] = [0.25, 0.25 + d, 0.5 - d, 0.5].map(|t| {
        let mut y = [0.0; 4];
        stepper.interpolate(t, &mut y);
        y
    });
    // Numbers of the order of one, put together from a few roundings of 1e-16.
    assert!(distance(&start, stepper.y()) < 1e-15);
    assert!(distance(&end, stepper.trial_y()) < 1e-15);
    let agrees = |from: [f64; 4], to: [f64; 4], f: &[f64]| {
        let rate: Vec<_> = from.iter().zip(to).map(|(a, b)| (b - a) / d).collect();
        // A one-sided difference: its error is d/2 times the second derivative, below 10 here.
        assert!(distance(&rate, f) < 5.0 * d, "{rate:?} {f:?}");
    };
    agrees(start, after_start, stepper.derivative());
    stepper.commit(&Kepler);
    agrees(before_end, end, stepper.derivative());
}

#[test]
fn dense_output_is_smooth() {
    dense_ends::<Rk4>();
    dense_ends::<Dp54>();
    dense_ends::<Dop853>();
    dense_ends::<Vern8>();
    dense_ends::<Vern9>();
    dense_ends::<Gauss6>();
}
