//! The stages for states of the usual size are those of all others.

use super::{Kepler, begin, distance, tolerance};
use crate::integrators::{
    Block, Dop853, Dp54, ErrorScale, Method, RIGID, Rk4, System, Tolerance, Vern8, Vern9,
};
use crate::scalar::Lane;

/// Two orbits, an oscillator, and before them three integrals over time that nothing reads: two components of the first
/// orbit's velocity, and one of the oscillator's.
struct Clockwork {
    first_read: usize,
}

const ORBITS: [(usize, f64); 2] = [(3, 0.1), (7, 0.3)];
const OSCILLATOR: usize = 11;

impl<T: Lane> System<T> for Clockwork {
    fn size(&self) -> usize {
        RIGID
    }
    fn derivative(&self, _: T, y: &[T], dy: &mut [T]) {
        for (at, _) in ORBITS {
            Kepler::law(&y[at..at + 4], &mut dy[at..at + 4]);
        }
        (dy[OSCILLATOR], dy[OSCILLATOR + 1]) = (y[OSCILLATOR + 1], -y[OSCILLATOR]);
        (dy[0], dy[1], dy[2]) = (y[5], y[6], y[OSCILLATOR + 1]);
    }
    fn derivative_read(&self, t: T, y: &[T], dy: &mut [T]) {
        self.derivative(t, y, dy);
        // Whoever asks for no integrals gets none.
        dy[..self.first_read].fill(T::lit(f64::NAN));
    }
    fn first_read(&self) -> usize {
        self.first_read
    }
    fn error_blocks(&self) -> &[Block] {
        &[Block { start: 0, len: RIGID, scale: ErrorScale::Relative }]
    }
}

/// The same, the error of its integrals measured apart from the rest, as that of a position.
struct Apart(Clockwork);

impl<T: Lane> System<T> for Apart {
    fn size(&self) -> usize {
        RIGID
    }
    fn derivative(&self, t: T, y: &[T], dy: &mut [T]) {
        self.0.derivative(t, y, dy);
    }
    fn first_read(&self) -> usize {
        self.0.first_read
    }
    fn error_blocks(&self) -> &[Block] {
        &[
            Block { start: 0, len: 3, scale: ErrorScale::Relative },
            Block { start: 3, len: 10, scale: ErrorScale::Relative },
        ]
    }
}

fn exact(t: f64) -> [f64; RIGID] {
    let mut y = [0.0; RIGID];
    for (at, e) in ORBITS {
        y[at..at + 4].copy_from_slice(&Kepler::orbit(e, t));
    }
    let (s, c) = t.sin_cos();
    (y[OSCILLATOR], y[OSCILLATOR + 1]) = (s, c);
    let start = Kepler::orbit(ORBITS[0].1, 0.0);
    (y[0], y[1], y[2]) = (y[3] - start[0], y[4] - start[1], s);
    y
}

fn end<M: Method>(first_read: usize, step: Option<f64>) -> Vec<f64> {
    let (system, t1) = (Clockwork { first_read }, 2.0);
    let mut stepper = begin::<M, _>(&system, tolerance(1e-11), (0.0, t1), &exact(0.0), step);
    super::advance(&mut stepper, &system, t1);
    stepper.y().to_vec()
}

fn agree<M: Method>(step: Option<f64>, rounding: f64) {
    let (known, any) = (end::<M>(3, step), end::<M>(0, step));
    assert!(distance(&known, &any) < rounding, "{known:?} {any:?}");
    // A hundred steps with errors of 1e-11 each; with steps of 2e-3 the error of order four is below 1e-10.
    assert!(distance(&known, &exact(2.0)) < 1e-9, "{known:?}");
}

/// Nor does the solution inside a step read what it may not.
fn is_whole_inside<M: Method>() {
    let (system, t1) = (Clockwork { first_read: 3 }, 0.1);
    let mut stepper = begin::<M, _>(&system, tolerance(1e-11), (0.0, t1), &exact(0.0), Some(t1));
    stepper.attempt(&system, t1);
    stepper.dense(&system);
    let mut y = [0.0; RIGID];
    stepper.interpolate(0.05, &mut y);
    // In a step of 0.1: even a cubic errs by its fourth power times a fourth derivative of fifty over 384.
    assert!(distance(&y, &exact(0.05)) < 1e-4, "{y:?}");
}

#[test]
fn integrals_are_whole_inside_steps() {
    is_whole_inside::<Dop853>();
    is_whole_inside::<Vern8>();
    is_whole_inside::<Vern9>();
    is_whole_inside::<Dp54>();
    is_whole_inside::<Rk4>();
}

/// Integrals begin at zero, where a relative tolerance allows nothing.
#[test]
fn integrals_do_not_hold_back_the_first_step() {
    let first = |first_read: usize, integrals: f64| {
        let (system, mut y) = (Apart(Clockwork { first_read }), exact(0.0));
        y[..3].fill(integrals);
        let tolerance = Tolerance { relative: 1e-8, absolute: 1e-12 };
        begin::<Dop853, _>(&system, tolerance, (0.0, 2.0), &y, None).step_size()
    };
    assert_eq!(first(3, 0.0), first(3, 1e3));
    assert!(first(0, 0.0) < 0.1 * first(3, 0.0), "what is read counts");
}

#[test]
fn known_and_unknown_sizes_go_the_same_way() {
    // Sums in another order, over some hundred steps of numbers of the order of one; the weights of one method are
    // beyond thirty.
    agree::<Dop853>(None, 1e-13);
    agree::<Vern8>(None, 5e-13);
    agree::<Vern9>(None, 1e-13);
    agree::<Dp54>(None, 1e-13);
    agree::<Rk4>(Some(2e-3), 1e-13);
}

/// The second error estimate is the difference of two solutions, whichever way it is computed.
#[test]
fn error_beyond_the_change_is_the_error_less_the_weights() {
    let beyond = Dop853::ERROR_BEYOND_CHANGE.unwrap();
    for stage in 0..Dop853::STAGES.len() {
        let of = |row: &[(usize, f64)]| row.iter().find(|(s, _)| *s == stage).map_or(0.0, |(_, w)| *w);
        // Coefficients below ten, printed to sixteen digits.
        assert!((of(Dop853::ERROR[1]) - of(Dop853::WEIGHTS) - of(beyond)).abs() < 1e-14, "stage {stage}");
    }
}
