//! What one trajectory promises.

use super::{MAKES, Random, kinds, rotation};
use crate::algebra::{Sym3, Vec3, quaternion_from_rotation};
use crate::charts::Sequence;
use crate::forces::{Axes, Force, InputWrench, PointMassGravity, TabulatedWrench, UniformGravity};
use crate::inertia::Inertia;
use crate::integrators::Tolerance;
use crate::phase_space::{Chart, Form, FreeBody, RigidState};
use crate::scalar::{Interpolation, Table};
use crate::screw::Screw;
use crate::simulate::{Ending, Inputs, MethodName, Run, Task, simulate};

pub const METHODS: [MethodName; 7] = {
    use MethodName::{Dop853, Dp54, Gauss, Rk4, Rodas, Vern8, Vern9};
    [Rk4, Dp54, Dop853, Vern8, Vern9, Rodas, Gauss]
};

fn none() -> Inputs {
    Inputs::constant(Vec::new())
}

pub fn task<'a>(x0: &'a [f64], inputs: &'a Inputs, method: MethodName) -> Task<'a> {
    Task {
        x0,
        span: [0.0, 2.0],
        inputs,
        save_at: None,
        method,
        tolerance: Tolerance { relative: 1e-10, absolute: 1e-10 },
        step: matches!(method, MethodName::Rk4 | MethodName::Gauss).then_some(0.01),
        max_steps: 100_000,
        watched: None,
    }
}

pub fn run(body: &FreeBody<f64>, task: &Task<'_>) -> Run {
    simulate(body, task, &mut |_| true)
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|v| v.to_bits()).collect()
}

/// A ball of unit mass and unit moments that starts at rest.
pub fn ball(forces: Vec<Force<f64>>) -> (FreeBody<f64>, Vec<f64>) {
    let tensor = Sym3::from_array([1.0, 0.0, 0.0, 1.0, 0.0, 1.0]);
    let inertia = Inertia::new(1.0, Vec3::zero(), tensor);
    let mut x = vec![0.0; 13];
    x[3] = 1.0;
    (FreeBody::new(inertia, forces, Chart::Quaternion, Form::QuasiVelocity), x)
}

#[test]
fn a_run_repeats_bit_for_bit_and_samples_do_not_change_it() {
    let mut random = Random(90);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let mut case = make(&mut random, kind);
        // With random signs, damping drives motions beyond all bounds.
        case.model.forces.retain(|f| !matches!(f, Force::LinearDamping(_) | Force::QuadraticDamping(_)));
        let inputs = Inputs::constant(case.u);
        for method in METHODS {
            let plain = task(&case.x, &inputs, method);
            let first = run(&case.model, &plain);
            let second = run(&case.model, &plain);
            assert_eq!(bits(&first.states), bits(&second.states));
            assert_eq!(first.times, second.times);
            assert_eq!((first.steps, first.rejected), (second.steps, second.rejected));

            let times: Vec<f64> = (0..=40).map(|k| 0.05 * f64::from(k)).collect();
            let sampled = run(&case.model, &Task { save_at: Some(&times), ..plain });
            // A fixed step may be too large for the fastest of these motions: it ends earlier, with samples or without.
            let reached: Vec<f64> = times.iter().copied().filter(|t| *t <= first.end_time).collect();
            assert_eq!((&sampled.times, &sampled.ending), (&reached, &first.ending), "{kind:?} {method:?}");
            assert_eq!(bits(&sampled.end_state), bits(&first.end_state), "{kind:?} {method:?}");
            assert_eq!((sampled.steps, sampled.rejected), (first.steps, first.rejected));
            let n = case.x.len();
            assert_eq!(bits(&sampled.states[..n]), bits(&case.x));
            if first.ending != Ending::ReachedEnd {
                continue;
            }
            // The end of a step is met by its interpolant up to rounding.
            let last = &sampled.states[40 * n..];
            let size = last.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
            let gap = last.iter().zip(&sampled.end_state).fold(0.0, |m, (a, b)| f64::max(m, (a - b).abs()));
            assert!(gap < 1e-14 * size, "{kind:?} {method:?}: {gap}");
        }
    }
}

/// A force that jumps: between the jumps every method here is exact for a constant acceleration.
#[test]
fn steps_end_on_every_jump() {
    let jumps = [0.0, 0.3, 0.7, 1.1];
    let force = [1.0, -2.0, 0.5, 3.0];
    let table = Table::new(&jumps, &force, Interpolation::Hold).unwrap();
    let velocity = 0.3 * force[0] + 0.4 * force[1] + 0.4 * force[2] + 0.9 * force[3];
    for method in METHODS {
        let mut components = [const { None }; 6];
        components[0] = Some(table.clone());
        let (at, axes) = (Vec3::zero(), Axes::Body);
        let element = Force::TabulatedWrench(TabulatedWrench { components, at, axes });
        let input = Force::InputWrench(InputWrench { places: InputWrench::<f64>::from_place(0), at, axes });
        let silent = Table::new(&[0.0], &[0.0], Interpolation::Hold).unwrap();
        let mut tables = vec![silent; 6];
        tables[0] = table.clone();
        for (force, inputs) in [(element, none()), (input, Inputs::tabulated(tables))] {
            let (body, x0) = ball(vec![force]);
            let result = run(&body, &task(&x0, &inputs, method));
            assert_eq!(result.ending, Ending::ReachedEnd);
            for jump in &jumps {
                assert!(result.times.contains(jump), "{method:?} passed {jump}");
            }
            assert_eq!(result.end_time, 2.0);
            // 200 steps of RK4 at most, a rounding of numbers of order one each.
            assert!((result.end_state[7] - velocity).abs() < 1e-13, "{method:?}: {:?}", result.end_state);
        }
    }
}

#[test]
fn a_run_says_how_it_ended() {
    let (body, x0) = ball(vec![]);
    let inputs = none();
    let fixed = Task { step: Some(1e-4), ..task(&x0, &inputs, MethodName::Rk4) };
    let stopped = run(&body, &Task { max_steps: 7, ..fixed.clone() });
    assert_eq!((stopped.ending, stopped.steps), (Ending::StepLimit, 7));
    let mut told = Vec::new();
    let interrupted = simulate(&body, &fixed, &mut |t| {
        told.push(t);
        told.len() < 3
    });
    assert_eq!(interrupted.ending, Ending::Interrupted);
    assert!(told.is_sorted() && told[2] == interrupted.end_time && interrupted.end_time < 2.0);

    // In the centre of attraction nothing is finite; the second force is to blame.
    let gravity = Force::UniformGravity(UniformGravity { acceleration: Vec3::zero() });
    let pull = PointMassGravity { mu: 1.0, center: Vec3::zero(), gradient_torque: false };
    let (body, x0) = ball(vec![gravity, Force::PointMassGravity(pull)]);
    for method in METHODS {
        let lost = run(&body, &task(&x0, &inputs, method));
        assert_eq!(lost.ending, Ending::NonFinite { force: Some(1) }, "{method:?}");
        assert_eq!((lost.end_time, &lost.end_state), (0.0, &x0));
    }
}

/// Straight through the singularity of each sequence: the run changes its chart, comes back, and goes where the
/// quaternions go.
#[test]
fn angles_pass_their_singularities() {
    let mut random = Random(91);
    for sequence in Sequence::names().map(|name| Sequence::parse(name).unwrap()) {
        let (mut body, _) = ball(vec![]);
        let start = if sequence.is_proper_euler() { 0.6 } else { 1.0 };
        let down = if sequence.is_proper_euler() { -1.0 } else { 1.0 };
        let mut omega = [0.0; 3];
        omega[sequence.axes()[1]] = down;
        // α = (0, start + down t, 0) turns about the second axis alone.
        let c = crate::algebra::elementary(sequence.axes()[1], start);
        let twist = Screw::new(Vec3::zero(), Vec3::from_array(omega));
        let motion = RigidState { position: Vec3::zero(), quaternion: quaternion_from_rotation(&c), twist };
        let turned = rotation(&mut random).rows[0];
        let inputs = none();
        let mut ends = Vec::new();
        for chart in [Chart::Angles(sequence), Chart::Quaternion] {
            body.chart = chart;
            let n = if chart == Chart::Quaternion { 13 } else { 12 };
            let mut x0 = vec![0.0; n];
            body.write_state(&motion, &vec![0.0; n], &mut x0);
            let result = run(&body, &task(&x0, &inputs, MethodName::Dop853));
            assert_eq!(result.ending, Ending::ReachedEnd);
            let changes: Vec<bool> = result.chart_changes.iter().map(|c| c.left).collect();
            let expected: &[bool] = if chart == Chart::Quaternion { &[] } else { &[true, false] };
            assert_eq!(changes, expected, "{sequence:?}");
            ends.push(body.rigid_state(&result.end_state).rotation().apply(turned));
        }
        // The tolerance is 1e-10 a step, and there are some ten steps.
        let gap = (ends[0] - ends[1]).norm();
        assert!(gap < 1e-9, "{sequence:?}: {gap}");
    }
}
