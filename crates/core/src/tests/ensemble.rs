//! What many runs at once promise.

use super::programs::traced;
use super::simulate::{METHODS, ball, run as single, task};
use super::{Case, MAKES, Random};
use crate::algebra::Vec3;
use crate::ensemble::{Batch, Caller, Rows, run_on};
use crate::forces::{Axes, Force, InputWrench, Places, PointMassGravity};
use crate::integrators::Tolerance;
use crate::phase_space::{BODY_PARAMETERS, Chart, Dynamics, Form, FreeBody};
use crate::scalar::isa::Isa;
use crate::scalar::{Interpolation, Table};
use crate::simulate::{Ending, Inputs, MethodName, Task};
use crate::watch::{Crossing, Event, Output, Take, Watched};

const RUNS: usize = 21;
const TIMES: [f64; 4] = [0.0, 0.1, 0.11, 0.5];

/// Runs of a case that differ in everything that may differ.
struct Dispersed {
    model: FreeBody<f64>,
    starts: Vec<f64>,
    places: Vec<usize>,
    values: Vec<f64>,
    constants: Vec<f64>,
    inputs: Inputs,
    watched: Watched,
    method: MethodName,
}

impl Dispersed {
    fn new(random: &mut Random, case: Case, method: MethodName) -> Self {
        let mut model = case.model;
        // With random signs, damping drives motions beyond all bounds.
        model.forces.retain(|f| !matches!(f, Force::LinearDamping(_) | Force::QuadraticDamping(_)));
        let model = model.made_ready();
        let n = case.x.len();
        let nominal = model.in_quaternions().parameters();
        let places: Vec<usize> = (0..nominal.len()).collect();
        let (mut starts, mut values, mut constants) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..RUNS {
            starts.extend(case.x.iter().map(|x| x * random.between(0.95, 1.05)));
            values.extend(nominal.iter().map(|p| p * random.between(0.99, 1.01)));
            constants.extend(case.u.iter().map(|u| u * random.between(0.9, 1.1)));
        }
        let ramp = Table::new(&[0.0, 0.2, 0.3], &[0.0, 0.5, -0.5], Interpolation::Linear).unwrap();
        let inputs = Inputs { constants: case.u.clone(), tables: vec![ramp; case.u.len()] };
        if model.chart == Chart::Quaternion {
            for x in starts.chunks_mut(n) {
                Dynamics::<f64>::project(&model, x);
            }
        }
        // The first one ends some of the runs.
        let law = |k: usize| traced(&[0.3], Places::default(), move |p, s| vec![s.twist[k] - p[0]]);
        let event = |k, terminal| Event { law: law(k), crossing: Crossing::Both, terminal };
        let output = |k, take| Output { law: law(k), take };
        let watched = Watched {
            events: vec![event(0, true), event(4, false)],
            outputs: vec![output(1, Take::Greatest), output(2, Take::Least), output(3, Take::Final)],
        };
        Self { model, starts, places, values, constants, inputs, watched, method }
    }

    fn batch(&self, runs: std::ops::Range<usize>) -> Batch<'_> {
        let size = |all: &[f64]| all.len() / RUNS;
        let part = |all: &'_ [f64]| runs.start * size(all)..runs.end * size(all);
        Batch {
            body: &self.model,
            starts: &self.starts[part(&self.starts)],
            places: &self.places,
            values: &self.values[part(&self.values)],
            constants: &self.constants[part(&self.constants)],
            inputs: &self.inputs,
            span: [0.0, 0.5],
            save_at: &TIMES,
            watched: &self.watched,
            method: self.method,
            tolerance: Tolerance { relative: 1e-9, absolute: 1e-9 },
            step: matches!(self.method, MethodName::Rk4 | MethodName::Gauss).then_some(0.01),
            max_steps: 100_000,
        }
    }

    /// One run as a single one: the body with its own parameters.
    fn alone(&self, run: usize) -> crate::simulate::Run {
        let count = self.values.len() / RUNS;
        let mut next = self.values[run * count..][..count].iter();
        let model: FreeBody<f64> = self.model.map(&mut |_| *next.next().unwrap());
        let (n, m) = (self.starts.len() / RUNS, self.constants.len() / RUNS);
        let constants = self.constants[run * m..][..m].to_vec();
        let inputs = Inputs { constants, tables: self.inputs.tables.clone() };
        let batch = self.batch(0..1);
        let plain = task(&self.starts[run * n..][..n], &inputs, self.method);
        single(
            &model,
            &Task {
                watched: Some(&self.watched),
                span: batch.span,
                save_at: Some(&TIMES),
                tolerance: batch.tolerance,
                ..plain
            },
        )
    }
}

fn go(isa: Isa, batch: &Batch<'_>, threads: usize) -> Rows {
    let caller = Caller { threads, around: &|work| work(), progress: &mut |_| true };
    run_on(isa, batch, caller).expect("nobody stopped it")
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|v| v.to_bits()).collect()
}

/// Each row is, to the last bit, that of the run alone; so it is the same for any threads, neighbours and chunks.
#[test]
fn a_row_is_that_of_the_run_alone() {
    let mut random = Random(400);
    let kind = (Chart::Quaternion, Form::QuasiVelocity);
    for make in MAKES {
        for method in METHODS {
            let case = make(&mut random, kind);
            let all = Dispersed::new(&mut random, case, method);
            let rows = go(Isa::detect(), &all.batch(0..RUNS), 2);
            let n = all.starts.len() / RUNS;
            for run in 0..RUNS {
                let alone = all.alone(run);
                let ended = &rows.ended[run];
                assert_eq!(ended.run, run);
                assert_eq!(ended.ending, alone.ending);
                assert_eq!((ended.steps, ended.rejected), (alone.steps, alone.rejected), "{method:?} {run}");
                assert_eq!(bits(&rows.states[run * n..][..n]), bits(&alone.end_state), "{method:?} {run}");
                let size = n * TIMES.len();
                let (kept, never) = rows.samples[run * size..][..size].split_at(alone.states.len());
                assert_eq!(bits(kept), bits(&alone.states), "{method:?} {run}");
                assert!(never.iter().all(|v| v.is_nan()));
                assert_eq!(bits(&rows.outputs[run * 3..][..3]), bits(&alone.outputs));
                for event in 0..2 {
                    let of: Vec<_> = alone.occurrences.iter().filter(|o| o.event == event).collect();
                    let place = run * 2 + event;
                    assert_eq!(rows.event_counts[place] as usize, of.len());
                    let first = of.first().map_or(f64::NAN, |o| o.time);
                    assert_eq!(rows.event_times[place].to_bits(), first.to_bits());
                    if let Some(first) = of.first() {
                        assert_eq!(bits(&rows.event_states[place * n..][..n]), bits(&first.state));
                    }
                }
            }
        }
    }
}

/// On every instruction set, in any chart: one thread or three, all at once, in pieces, or one by one.
#[test]
fn rows_do_not_depend_on_company() {
    let mut random = Random(401);
    let zyx = crate::charts::Sequence::parse("zyx").unwrap();
    let kinds = [
        (Chart::Quaternion, Form::QuasiVelocity),
        (Chart::Quaternion, Form::Generalized),
        (Chart::Angles(zyx), Form::QuasiVelocity),
        (Chart::Angles(zyx), Form::Generalized),
    ];
    for kind in kinds {
        let case = MAKES[1](&mut random, kind);
        let all = Dispersed::new(&mut random, case, MethodName::Dop853);
        let n = all.starts.len() / RUNS;
        for isa in Isa::available() {
            let together = go(isa, &all.batch(0..RUNS), 1);
            assert_eq!(bits(&together.states), bits(&go(isa, &all.batch(0..RUNS), 3).states));
            for size in [1, 7] {
                let mut pieces = Vec::new();
                for first in (0..RUNS).step_by(size) {
                    pieces.extend(go(isa, &all.batch(first..first + size), 2).samples);
                }
                assert_eq!(bits(&pieces), bits(&together.samples), "{isa:?} {kind:?} {size}");
            }
            // In another chart a run takes other steps: each is within its tolerance of 1e-9 of the truth, and the
            // case multiplies that. Angles may be those of the other triple that means the same.
            for run in 0..RUNS {
                let motion = |x: &[f64]| {
                    let s = all.model.rigid_state(x);
                    let (c, v) = (s.rotation().rows, s.twist);
                    [s.position, c[0], c[1], c[2], v.linear, v.angular].map(Vec3::to_array).concat()
                };
                let (alone, row) = (all.alone(run).end_state, &together.states[run * n..][..n]);
                for (a, b) in motion(&alone).into_iter().zip(motion(row)) {
                    assert!((a - b).abs() < 1e-5 * a.abs().max(1.0), "{isa:?} {kind:?} {run}: {a} {b}");
                }
            }
        }
    }
}

/// A run that ends badly is a row that says how; its neighbours do not notice.
#[test]
fn bad_runs_are_rows() {
    let places = InputWrench::<f64>::from_place(0);
    let push = Force::InputWrench(InputWrench { places, at: Vec3::zero(), axes: Axes::Body });
    let pull = PointMassGravity { mu: 1.0, center: Vec3::zero(), gradient_torque: false };
    let (body, x0) = ball(vec![push, Force::PointMassGravity(pull)]);
    let inputs = Inputs::constant(vec![0.0; 6]);
    let mut starts = Vec::new();
    for run in 0..RUNS {
        let mut x = x0.clone();
        // The third of five starts in the centre, where nothing is finite; the fifth falls into it.
        x[0] = if run % 5 == 2 { 0.0 } else { 2.0 };
        x[8] = if run % 5 == 4 { 0.0 } else { 0.7 };
        starts.extend(x);
    }
    let batch = Batch {
        body: &body,
        starts: &starts,
        places: &[],
        values: &[],
        constants: &[],
        inputs: &inputs,
        span: [0.0, 10.0],
        save_at: &[0.0, 10.0],
        watched: &Watched::default(),
        method: MethodName::Dop853,
        tolerance: Tolerance { relative: 1e-9, absolute: 1e-9 },
        step: None,
        max_steps: 100_000,
    };
    let rows = go(Isa::detect(), &batch, 2);
    for (run, ended) in rows.ended.iter().enumerate() {
        let last = &rows.samples[run * 26 + 13..][..13];
        match run % 5 {
            2 => assert_eq!(ended.ending, Ending::NonFinite { force: Some(1) }),
            4 => assert_ne!(ended.ending, Ending::ReachedEnd),
            _ => assert_eq!((&ended.ending, ended.time), (&Ending::ReachedEnd, 10.0)),
        }
        assert_eq!(ended.ending == Ending::ReachedEnd, last.iter().all(|v| v.is_finite()));
    }
    let short = go(Isa::detect(), &Batch { max_steps: 3, ..batch.clone() }, 1);
    let limited = short.ended.iter().filter(|e| e.ending == Ending::StepLimit).count();
    assert_eq!(limited, RUNS - rows.ended.iter().filter(|e| e.time == 0.0).count());
    assert!(short.ended.iter().all(|e| e.steps + e.rejected <= 3));

    let mut looks = 0;
    let mut progress = |_| {
        looks += 1;
        false
    };
    let long = Batch { step: Some(1e-5), method: MethodName::Rk4, ..batch };
    let caller = Caller { threads: 2, around: &|work| work(), progress: &mut progress };
    assert!(run_on(Isa::detect(), &long, caller).is_none() && looks > 0);
}

/// Every force finds its parameters where it is told.
#[test]
fn parameters_have_places() {
    let mut random = Random(402);
    for make in MAKES {
        let model = make(&mut random, (Chart::Quaternion, Form::QuasiVelocity)).model.made_ready();
        let (all, places) = (model.parameters(), model.parameter_places());
        let laws = model.forces.len() + usize::from(model.control.is_some());
        assert_eq!(places.len(), laws);
        let mut behind = 0;
        if let Some(left) = &model.left {
            left.map(&mut |p: f64| {
                behind += 1;
                p
            });
        }
        let count = places.iter().map(ExactSizeIterator::len).sum::<usize>();
        assert_eq!(count, all.len() - BODY_PARAMETERS - behind);
        for (force, place) in model.forces.iter().zip(&places) {
            let mut own = Vec::new();
            force.map(&mut |p: f64| {
                own.push(p);
                p
            });
            assert_eq!(own, all[place.clone()]);
        }
        if let Some(law) = &model.control {
            assert_eq!(law.parameters(), &all[places[laws - 1].clone()]);
        }
    }
}
