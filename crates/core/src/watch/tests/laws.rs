//! Against closed forms, in single runs of every method.

use super::{G, climb, event, events, output, thrown};
use crate::algebra::Vec3;
use crate::forces::{Force, Places, PointMassGravity};
use crate::phase_space::Form;
use crate::scalar::{Interpolation, Real, Table};
use crate::simulate::{Ending, Inputs, MethodName, Run, Task};
use crate::tests::programs::{E, Seen, traced};
use crate::tests::runs_with_laws::tumbling;
use crate::tests::simulate::{METHODS, ball, run, task};
use crate::watch::{Crossing, Take, Watched};
use std::f64::consts::PI;

/// How many times the roundings of numbers of the order of one a method makes: the stages of Rodas5P are sums of numbers
/// ten times as large, which cancel; those of Vern8 a hundred times, and its weights are beyond thirty.
fn cancels(method: MethodName) -> f64 {
    match method {
        MethodName::Rodas => 10.0,
        MethodName::Vern8 => 1000.0,
        _ => 1.0,
    }
}

/// A thrown body: the methods are exact for it, so that times are right to a few roundings.
#[test]
fn apex_and_impact_of_a_throw() {
    let (height, speed) = (1.5, 4.0);
    let (body, mut x0) = thrown([1.0, 0.0, speed]);
    x0[2] = height;
    let inputs = Inputs::constant(vec![]);
    let watched = Watched {
        events: vec![
            event(Crossing::Falling, false, &[], climb),
            event(Crossing::Falling, true, &[], |s| s.position[2]),
        ],
        outputs: vec![
            output(Take::Greatest, |s| s.position[2]),
            output(Take::Final, |s| s.position[0]),
            output(Take::Least, |s| s.position[2]),
        ],
    };
    let apex = speed / G;
    let impact = (speed + (speed * speed + 2.0 * G * height).sqrt()) / G;
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let result = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!(result.ending, Ending::Event(1), "{method:?}");
        let seen: Vec<usize> = result.occurrences.iter().map(|o| o.event).collect();
        assert_eq!(seen, [0, 1]);
        let expected = [height + speed * speed / (2.0 * G), impact, 0.0];
        for (found, expected) in result.occurrences.iter().map(|o| o.time).zip([apex, impact]) {
            assert!((found - expected).abs() < 1e-14 * cancels(method), "{method:?}: {found} {expected}");
        }
        for (found, expected) in result.outputs.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-13 * cancels(method), "{method:?}: {found} {expected}");
        }
        let last = result.occurrences.last().unwrap();
        assert_eq!((result.end_time, &result.end_state), (last.time, &last.state));
        assert_eq!(result.times.last(), Some(&result.end_time));
        assert_eq!(result.states[result.states.len() - 13..], result.end_state[..]);
        assert!(result.end_state[2] <= 0.0 && result.end_state[2] > -1e-13);
    }
}

/// A height that is passed twice within a step, a hair below the apex; and one a hair above it, which is not reached.
#[test]
fn two_crossings_within_a_step_are_found() {
    let speed = 4.0;
    let (body, x0) = thrown([1.0, 0.0, speed]);
    let (apex, height) = (speed / G, speed * speed / (2.0 * G));
    let inputs = Inputs::constant(vec![]);
    for hair in [1e-3, 1e-6, 1e-9] {
        let level = |by: f64| move |s: &Seen<'_>| s.position[2] - E::lit(height + by);
        let watched = events(vec![
            event(Crossing::Both, false, &[], level(-hair)),
            event(Crossing::Falling, false, &[], level(-hair)),
            event(Crossing::Both, true, &[], level(hair)),
        ]);
        let gap = (2.0 * hair / G).sqrt();
        for method in METHODS {
            let plain = task(&x0, &inputs, method);
            let result = run(&body, &Task { watched: Some(&watched), ..plain });
            assert_eq!(result.ending, Ending::ReachedEnd, "{method:?}");
            let seen: Vec<usize> = result.occurrences.iter().map(|o| o.event).collect();
            assert_eq!(seen, [0, 0, 1], "{method:?} {hair}");
            // Roundings of the height, of the order of 1e-15, over the speed there.
            let allowed = cancels(method) * (1e-14 + 2e-15 / (G * gap));
            for (o, time) in result.occurrences.iter().zip([apex - gap, apex + gap, apex + gap]) {
                assert!((o.time - time).abs() < allowed, "{method:?} {hair}: {} {time}", o.time);
            }
        }
    }
}

/// From zero, a law has to come back before it crosses; what only leaves zero does not.
#[test]
fn an_event_at_the_start_does_not_count() {
    let speed = 4.0;
    let (body, x0) = thrown([1.0, 0.0, speed]);
    let inputs = Inputs::constant(vec![]);
    let watched = events(vec![
        event(Crossing::Rising, true, &[], |s| s.position[0]),
        event(Crossing::Both, false, &[], |s| s.position[1]),
        event(Crossing::Both, true, &[], |s| s.position[2]),
    ]);
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let result = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!((result.ending, result.occurrences.len()), (Ending::Event(2), 1), "{method:?}");
        assert!((result.end_time - 2.0 * speed / G).abs() < 1e-14 * cancels(method), "{method:?}");
    }
    // The state at an event is on the new side: from there on it does not happen again.
    let plain = task(&x0, &inputs, METHODS[2]);
    let landed = run(&body, &Task { watched: Some(&watched), ..plain });
    let again =
        run(&body, &Task { x0: &landed.end_state, watched: Some(&watched), ..plain_from(&landed, &inputs) });
    assert_eq!((again.ending, again.occurrences.len()), (Ending::ReachedEnd, 0));
}

fn plain_from<'a>(run: &'a Run, inputs: &'a Inputs) -> Task<'a> {
    Task { span: [run.end_time, run.end_time + 1.0], ..task(&run.end_state, inputs, METHODS[2]) }
}

/// The first event that ends a run ends it: nothing later is recorded, sampled or taken.
#[test]
fn nothing_comes_after_the_end() {
    let (body, x0) = thrown([1.0, 0.0, 4.0]);
    let inputs = Inputs::constant(vec![]);
    let passes = |x: f64| move |s: &Seen<'_>| s.position[0] - E::lit(x);
    let watched = Watched {
        events: vec![
            event(Crossing::Rising, false, &[], passes(0.6)),
            event(Crossing::Rising, true, &[], passes(0.5)),
            event(Crossing::Rising, false, &[], passes(0.4)),
            event(Crossing::Rising, true, &[], passes(0.7)),
            event(Crossing::Rising, false, &[], passes(0.5)),
        ],
        outputs: vec![output(Take::Greatest, |s| s.position[0]), output(Take::Final, |s| s.time)],
    };
    let times = [0.0, 0.25, 0.49, 0.75, 2.0];
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let result = run(&body, &Task { watched: Some(&watched), save_at: Some(&times), ..plain });
        assert_eq!(result.ending, Ending::Event(1));
        let seen: Vec<usize> = result.occurrences.iter().map(|o| o.event).collect();
        assert_eq!(seen, [2, 4, 1], "{method:?}");
        assert_eq!(result.times, times[..3]);
        assert!((result.end_time - 0.5).abs() < 1e-14 * cancels(method));
        assert_eq!(result.outputs, [result.end_state[0], result.end_time]);
    }
}

/// Watching changes nothing of a run.
#[test]
fn a_run_is_the_same_when_it_is_watched() {
    let (body, mut x0) = thrown([1.0, 2.0, 4.0]);
    x0[10..13].copy_from_slice(&[1.0, -2.0, 3.0]);
    let inputs = Inputs::constant(vec![]);
    let watched = Watched {
        events: vec![event(Crossing::Both, false, &[], climb)],
        outputs: vec![output(Take::Least, |s| s.rotation[0][0])],
    };
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let alone = run(&body, &plain);
        let seen = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!((alone.times, alone.states, alone.steps), (seen.times, seen.states, seen.steps));
    }
}

/// An input that jumps crosses where it jumps; commands stand behind the inputs.
#[test]
fn inputs_and_commands_are_seen() {
    let (mut body, x0) = thrown([1.0, 0.0, 4.0]);
    body.control = Some(traced(&[], Places::new(&[0], 0..0), |_, s| vec![s.inputs[0] + s.time]));
    let jump = Table::new(&[0.0, 0.7], &[0.0, 1.0], Interpolation::Hold).unwrap();
    let inputs = Inputs::tabulated(vec![jump]);
    let watched = events(vec![
        event(Crossing::Both, false, &[0], |s| s.inputs[0] - E::lit(0.5)),
        event(Crossing::Both, true, &[1, 0], |s| s.inputs[0] - E::lit(2.25)),
    ]);
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let result = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!((result.ending, result.occurrences.len()), (Ending::Event(1), 2), "{method:?}");
        assert_eq!(result.occurrences[0].time, 0.7);
        assert!((result.end_time - 1.25).abs() < 1e-15);
    }
}

/// What is not a number is no event and no end; an output that met it is not a number.
#[test]
fn what_is_not_a_number_is_passed_over() {
    let (body, x0) = thrown([1.0, 0.0, 4.0]);
    let inputs = Inputs::constant(vec![]);
    let root = |s: &Seen<'_>| (s.position[0] - E::lit(1.0)).sqrt() - E::lit(0.5);
    let watched = Watched {
        events: vec![
            event(Crossing::Both, false, &[], root),
            event(Crossing::Both, true, &[], |s| (s.position[2] - E::lit(9.0)).sqrt()),
            event(Crossing::Both, true, &[], |s| s.time / (s.time - s.time)),
        ],
        outputs: vec![
            output(Take::Least, root),
            output(Take::Greatest, root),
            output(Take::Final, root),
            output(Take::Greatest, |s| -E::lit(1.0) / s.time),
        ],
    };
    for method in METHODS {
        let plain = task(&x0, &inputs, method);
        let result = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!(result.ending, Ending::ReachedEnd, "{method:?}");
        assert!(result.outputs[0].is_nan() && result.outputs[1].is_nan());
        assert!((result.outputs[2] - 0.5).abs() < 1e-14);
        assert_eq!(result.outputs[3], -0.5);
        if matches!(method, MethodName::Rk4 | MethodName::Gauss) {
            // Steps of 0.01 end between 1, where the root begins, and 1.25.
            assert!((result.occurrences[0].time - 1.25).abs() < 1e-14);
        }
    }
}

/// A turning body in angles, through their singularity: what is seen is what the quaternions see.
#[test]
fn events_pass_changes_of_chart() {
    for form in [Form::QuasiVelocity, Form::Generalized] {
        let (body, x0) = tumbling(form);
        let inputs = Inputs::constant(vec![]);
        let watched = Watched {
            events: vec![
                event(Crossing::Both, false, &[], |s| s.rotation[2][0] + E::lit(0.9999)),
                event(Crossing::Rising, true, &[], |s| s.rotation[2][0] + E::lit(0.2)),
            ],
            outputs: vec![output(Take::Least, |s| s.rotation[2][0]), output(Take::Final, |s| s.time)],
        };
        // R[2][0] = -sin(1 + t).
        let near = 0.9999f64.asin();
        let times = [near - 1.0, PI - near - 1.0, PI - 0.2f64.asin() - 1.0];
        for method in METHODS {
            let plain = task(&x0, &inputs, method);
            let result = run(&body, &Task { watched: Some(&watched), ..plain });
            assert_eq!((result.ending, result.chart_changes.len()), (Ending::Event(1), 2), "{method:?}");
            // Tolerance 1e-10 a step, h⁴/120 of RK4's 0.01; at the first the law is flat, 0.014 a second.
            for (o, time) in result.occurrences.iter().zip(times) {
                assert!((o.time - time).abs() < 1e-7, "{method:?}: {} {time}", o.time);
                let rotation = body.rigid_state(&o.state).rotation();
                let value = [-0.9999, -0.2][o.event];
                assert!((rotation.rows[2].x - value).abs() < 1e-12);
                assert!((o.state[4] - (1.0 + o.time)).abs() < 1e-9, "the angle goes on");
            }
            assert!((result.outputs[0] + 1.0).abs() < 1e-9, "{method:?}");
            assert_eq!(result.outputs[1], result.end_time);
        }
    }
}

/// Around a point mass: nearest and farthest point, and the energy and the law's zero at the events.
#[test]
fn an_orbit_is_seen_as_it_is() {
    let eccentricity = 0.5;
    let pull = PointMassGravity { mu: 1.0, center: Vec3::zero(), gradient_torque: false };
    let (body, mut x0) = ball(vec![Force::PointMassGravity(pull)]);
    // From the pericentre of an orbit of period 2π.
    x0[0] = 1.0 - eccentricity;
    x0[8] = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
    let inputs = Inputs::constant(vec![]);
    let radius = |s: &Seen<'_>| {
        let [x, y, z] = s.position;
        (x * x + y * y + z * z).sqrt()
    };
    let watched = Watched {
        events: vec![event(Crossing::Both, false, &[], |s| s.position[1])],
        outputs: vec![output(Take::Least, radius), output(Take::Greatest, radius)],
    };
    let energy = |t: f64, x: &[f64]| {
        let (kinetic, potential) = body.energies(t, x, &[]);
        kinetic + potential
    };
    for method in METHODS {
        let plain = Task { span: [0.0, 20.0], ..task(&x0, &inputs, method) };
        let result = run(&body, &Task { watched: Some(&watched), ..plain });
        assert_eq!(result.occurrences.len(), 6, "{method:?}: every half period");
        for (k, o) in result.occurrences.iter().enumerate() {
            // The error of the run: tolerance 1e-10 a step, RK4 with 600 steps a period.
            assert!((o.time - PI * (k + 1) as f64).abs() < 1e-6, "{method:?}: {}", o.time);
            assert!((energy(o.time, &o.state) + 0.5).abs() < 1e-7, "{method:?}");
            assert!(o.state[1].abs() < 1e-14);
        }
        for (found, expected) in result.outputs.iter().zip([1.0 - eccentricity, 1.0 + eccentricity]) {
            assert!((found - expected).abs() < 1e-7, "{method:?}: {found}");
        }
    }
}
