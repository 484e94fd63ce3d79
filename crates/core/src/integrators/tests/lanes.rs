//! A lane computes what its trajectory computes alone, to the last bit.

use super::{Kepler, tolerance};
use crate::integrators::{Dop853, Dp54, Gauss6, Lanes, Method, Rk4, Rodas5P, Stepper};
use crate::scalar::Lane;
use crate::scalar::isa::{Isa, with_lanes, with_scalar};

/// Eccentricity, time at the start, at the end; one of them starts in the centre, where nothing is finite.
const RUNS: [(f64, f64, f64); 19] = [
    (0.1, 0.0, 6.0),
    (0.7, 0.1, 6.0),
    (0.3, 0.2, 0.2001),
    (f64::NAN, 0.0, 3.0),
    (0.5, 3.0, -2.0),
    (0.85, 0.0, 12.0),
    (0.0, 0.0, 5.0),
    (0.2, 5.0, 1.0),
    (0.6, 0.0, 7.0),
    (0.4, 1.0, 1.5),
    (0.8, 0.0, 6.3),
    (f64::NAN, 2.0, 3.0),
    (0.15, 0.0, 9.0),
    (0.25, 0.0, 0.5),
    (0.35, 0.0, 3.5),
    (0.45, 0.0, 4.5),
    (0.55, 2.0, 5.5),
    (0.65, 0.5, 6.5),
    (0.75, 0.25, 7.5),
];

/// Everything that a trajectory yields: states at samples, end, numbers of steps; as bits.
type Record = Vec<u64>;

fn run_all<T: Lane, M: Method>(runs: &[(f64, f64, f64)], step: Option<f64>) -> Vec<Record> {
    T::call(|| {
        let mut stepper = Stepper::<T, M>::new(tolerance(1e-9));
        let mut records = vec![Record::new(); runs.len()];
        let mut next = 0;
        // Which run each lane holds; lanes without a run stand at time zero.
        let mut holds = vec![None; T::N];
        loop {
            let mut fresh = Lanes::NONE;
            for (l, held) in holds.iter_mut().enumerate() {
                if held.is_none() && next < runs.len() {
                    *held = Some(next);
                    next += 1;
                    fresh = fresh.with(Lanes::one(l));
                }
            }
            let of = |f: fn((f64, f64, f64)) -> f64| {
                T::from_lanes(|l| holds[l].map_or(0.0, |i: usize| f(runs[i])))
            };
            let end = of(|r| r.2);
            if !fresh.is_empty() {
                let y0 = [0, 1, 2, 3].map(|i| {
                    T::from_lanes(|l| holds[l].map_or(0.0, |h: usize| Kepler::orbit(runs[h].0, runs[h].1)[i]))
                });
                stepper.start(&Kepler, fresh, of(|r| r.1), &y0, end, step);
            }
            let idle = T::from_lanes(|l| holds[l].map_or(stepper.t().get(l), |i| runs[i].2));
            let trial = stepper.attempt(&Kepler, idle);
            let (from, to) = (stepper.t(), stepper.trial_t());
            let middle = T::lit(0.5) * (from + to);
            stepper.dense(&Kepler);
            let mut sample = [T::zero(); 4];
            stepper.interpolate(middle, &mut sample);
            for l in trial.accepted.iter() {
                // Where the other lanes look changes nothing.
                let mut alone = [T::zero(); 4];
                stepper.interpolate(T::lit(middle.get(l)), &mut alone);
                let [alone, sample] = [alone, sample].map(|all| all.map(|y| y.get(l).to_bits()));
                assert_eq!(alone, sample);
                records[holds[l].unwrap()].extend(alone);
            }
            stepper.commit(&Kepler);
            for (l, held) in holds.iter_mut().enumerate() {
                let Some(run) = *held else { continue };
                let stopped = trial.stopped.contains(l);
                if stopped || stepper.t().get(l) == runs[run].2 {
                    let counts = [stepper.t(), stepper.steps(), stepper.rejected(), stepper.step_size()];
                    let all = stepper.y().iter().chain(&counts).map(|x| x.get(l));
                    // A NaN has many patterns of bits.
                    let bits = all.map(|x| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() });
                    records[run].extend(bits);
                    records[run].push(stepper.verdict(l) as u64);
                    *held = None;
                }
            }
            if next == runs.len() && holds.iter().all(Option::is_none) {
                return records;
            }
        }
    })
}

/// Runs in lanes, refilled as they come free, against each run alone in `One`.
fn same_alone<One: Lane, Many: Lane, M: Method>(step: Option<f64>) {
    let together = run_all::<Many, M>(&RUNS, step);
    for (run, together) in RUNS.iter().zip(together) {
        let alone = &run_all::<One, M>(&[*run], step)[0];
        assert_eq!(*alone, together, "run {run:?}");
    }
    let turned: Vec<_> = RUNS.iter().rev().copied().collect();
    let mut reversed = run_all::<Many, M>(&turned, step);
    reversed.reverse();
    assert_eq!(reversed, run_all::<Many, M>(&RUNS, step), "in another order");
}

fn same_alone_everywhere<M: Method>(step: Option<f64>) {
    for isa in Isa::available() {
        with_lanes!(isa, Many => with_scalar!(isa, One => same_alone::<One, Many, M>(step)));
    }
}

#[test]
fn lanes_are_alone_rk4() {
    same_alone_everywhere::<Rk4>(Some(0.05));
}

#[test]
fn lanes_are_alone_dp54() {
    same_alone_everywhere::<Dp54>(None);
}

#[test]
fn lanes_are_alone_dop853() {
    same_alone_everywhere::<Dop853>(None);
}

#[test]
fn lanes_are_alone_rodas5p() {
    same_alone_everywhere::<Rodas5P>(None);
}

#[test]
fn lanes_are_alone_gauss6() {
    same_alone_everywhere::<Gauss6>(Some(0.05));
    // Near the pericentre of the long orbits this is too large a step: their lanes stop.
    same_alone_everywhere::<Gauss6>(Some(0.5));
}
