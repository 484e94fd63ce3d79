//! What is seen in a lane is what is seen of its trajectory alone, to the last bit.

use super::{climb, event, output, thrown};
use crate::integrators::{Dop853, Dp54, Gauss6, Lanes, Method, Rk4, Rodas5P, Stepper, Tolerance};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::tests::Random;
use crate::scalar::{Lane, Real};
use crate::simulate::{Inputs, Motion};
use crate::watch::{Crossing, Take, Watched, Watcher};

/// A throw: its velocity, its spin, its mass, and when it ends if nothing ends it before.
#[derive(Clone, Copy, Debug)]
struct Throw {
    velocity: [f64; 3],
    spin: [f64; 3],
    mass: f64,
    end: f64,
}

fn throws() -> Vec<Throw> {
    let mut random = Random(17);
    let mut three = |size: f64| [0; 3].map(|_| random.between(-size, size));
    let one = |k: usize| {
        let (velocity, spin) = (three(6.0), three(12.0));
        // One is lost at once, others end before they land.
        let velocity = if k == 5 { [f64::NAN; 3] } else { [velocity[0], velocity[1], velocity[2].abs()] };
        Throw { velocity, spin, mass: 1.0 + velocity[0].abs(), end: 0.3 + 0.1 * k as f64 }
    };
    (0..21).map(one).collect()
}

/// Landing ends it; a fin's tip goes up and down many times; the height is taken in all ways, and a root that is not
/// a number below the start.
fn watched() -> Watched {
    Watched {
        events: vec![
            event(Crossing::Falling, true, &[], |s| s.position[2]),
            event(Crossing::Both, false, &[], |s| s.rotation[2][0]),
            event(Crossing::Rising, false, &[], climb),
            event(Crossing::Falling, false, &[], |s| s.position[2] - s.mass * s.mass / s.mass),
        ],
        outputs: vec![
            output(Take::Greatest, |s| s.position[2]),
            output(Take::Least, |s| s.rotation[0][1]),
            output(Take::Final, climb),
            output(Take::Least, |s| s.position[2].sqrt()),
        ],
    }
}

/// Everything seen of a throw, as bits.
type Record = Vec<u64>;

fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

fn run_all<T: Lane, M: Method>(throws: &[Throw], step: Option<f64>) -> Vec<Record> {
    let (body, x0) = thrown([0.0; 3]);
    let (inputs, plain, watched) = (Inputs::constant(vec![]), body.parameters(), watched());
    T::call(|| {
        let mut motion = Motion::<T>::new(&body, &inputs);
        let mut stepper = Stepper::<T, M>::new(Tolerance { relative: 1e-8, absolute: 1e-8 });
        let mut watcher = Watcher::<T>::new(&watched);
        let mut records = vec![Record::new(); throws.len()];
        let mut next = 0;
        let mut holds = vec![None; T::N];
        loop {
            let mut fresh = Lanes::NONE;
            for (l, held) in holds.iter_mut().enumerate() {
                if held.is_none() && next < throws.len() {
                    let mut own = plain.clone();
                    own[0] = throws[next].mass;
                    motion.set_parameters(l, &own);
                    *held = Some(next);
                    next += 1;
                    fresh = fresh.with(Lanes::one(l));
                }
            }
            let of =
                |f: &dyn Fn(&Throw) -> f64| T::from_lanes(|l| holds[l].map_or(0.0, |i: usize| f(&throws[i])));
            let end = of(&|throw| throw.end);
            if !fresh.is_empty() {
                motion.renew();
                let mut y: Vec<T> = x0.iter().map(|x| T::lit(*x)).collect();
                for i in 0..3 {
                    y[7 + i] = of(&|throw| throw.velocity[i]);
                    y[10 + i] = of(&|throw| throw.spin[i]);
                }
                stepper.start(&motion, fresh, T::zero(), &y, end, step);
                watcher.start(fresh, &motion, T::zero(), &y);
            }
            let idle = T::from_lanes(|l| holds[l].map_or(stepper.t().get(l), |_| end.get(l)));
            let trial = stepper.attempt(&motion, idle);
            let stopped = watcher.look(&motion, &mut stepper, trial.accepted);
            stepper.commit(&motion);
            for (l, held) in holds.iter_mut().enumerate() {
                let Some(run) = *held else { continue };
                let ended = stopped.with(trial.stopped).contains(l) || stepper.t().get(l) == end.get(l);
                if ended {
                    assert_eq!(watcher.stop(l).is_some(), stopped.contains(l));
                    let record = &mut records[run];
                    for seen in watcher.occurrences(l) {
                        record.extend([seen.event as u64, bits(seen.time)]);
                        record.extend(seen.state.iter().copied().map(bits));
                    }
                    record.extend(watcher.outputs(l).into_iter().map(bits));
                    record.extend((0..4).map(|event| u64::from(watcher.count(l, event))));
                    *held = None;
                }
            }
            if next == throws.len() && holds.iter().all(Option::is_none) {
                return records;
            }
        }
    })
}

fn same_alone<One: Lane, Many: Lane, M: Method>(step: Option<f64>) {
    let all = throws();
    let together = run_all::<Many, M>(&all, step);
    for (throw, together) in all.iter().zip(&together) {
        assert_eq!(run_all::<One, M>(&[*throw], step)[0], *together, "{throw:?}");
    }
    let turned: Vec<Throw> = all.iter().rev().copied().collect();
    let mut reversed = run_all::<Many, M>(&turned, step);
    reversed.reverse();
    assert_eq!(reversed, together, "in another order");
    // What is compared is not empty: some land, some turn their tips.
    let [landed, tips] = [4, 3].map(|back| together.iter().filter(|r| r[r.len() - back] > 0).count());
    assert!(landed > 5 && landed < 20 && tips > 10, "{landed} {tips}");
}

fn same_alone_everywhere<M: Method>(step: Option<f64>) {
    for isa in Isa::available() {
        with_lanes!(isa, Many => with_scalar!(isa, One => same_alone::<One, Many, M>(step)));
    }
}

#[test]
fn lanes_are_watched_alone_rk4() {
    same_alone_everywhere::<Rk4>(Some(0.05));
}

#[test]
fn lanes_are_watched_alone_dp54() {
    same_alone_everywhere::<Dp54>(None);
}

#[test]
fn lanes_are_watched_alone_dop853() {
    same_alone_everywhere::<Dop853>(None);
}

#[test]
fn lanes_are_watched_alone_rodas5p() {
    same_alone_everywhere::<Rodas5P>(None);
}

#[test]
fn lanes_are_watched_alone_gauss6() {
    same_alone_everywhere::<Gauss6>(Some(0.05));
}
