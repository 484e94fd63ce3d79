//! Runs of models with auxiliary states, and with derivatives that were compiled elsewhere.

use super::programs::{E, Seen, traced};
use super::simulate::{METHODS, ball, run, task};
use crate::algebra::{Vec3, elementary, quaternion_from_rotation};
use crate::charts::Sequence;
use crate::evaluate::Evaluator;
use crate::forces::{Force, Places};
use crate::phase_space::{Chart, Dynamics, Form, FreeBody, RigidState};
use crate::scalar::{Block, Real};
use crate::screw::Screw;
use crate::simulate::{Ending, Inputs, Task};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A ball that turns through the singularity of its angles.
pub fn tumbling(form: Form) -> (FreeBody<f64>, Vec<f64>) {
    let sequence = Sequence::parse("zyx").unwrap();
    let (mut body, _) = ball(vec![]);
    (body.chart, body.form) = (Chart::Angles(sequence), form);
    let twist = Screw::new(Vec3::new(0.2, 0.0, 0.1), Vec3::new(0.0, 1.0, 0.0));
    let quaternion = quaternion_from_rotation(&elementary(sequence.axes()[1], 1.0));
    let mut x0 = vec![0.0; 12];
    body.write_state(&RigidState { position: Vec3::zero(), quaternion, twist }, &[0.0; 12], &mut x0);
    (body, x0)
}

/// x' = (u - x) / τ in a force, and the same of twice the τ in the control law, has x = u + (x₀ - u) exp(-t/τ).
#[test]
fn lags_are_followed_through_changes_of_chart() {
    let (tau, u, start) = (0.5, 1.5, [-1.0, 2.0]);
    let lag = |p: &[E], s: &Seen<'_>| -> E { (s.inputs[0] - s.states[0]) / p[0] };
    let exact = |t: f64, k: usize| u + (start[k] - u) * (-t / (tau * (k + 1) as f64)).exp();
    for form in [Form::QuasiVelocity, Form::Generalized] {
        let (mut body, mut x0) = tumbling(form);
        let places = |k: usize| Places::new(&[0], k..k + 1);
        let idle = traced(&[tau], places(0), |p, s| [vec![E::lit(0.0); 6], vec![lag(p, s)]].concat());
        body.forces = vec![Force::Traced(idle)];
        body.control = Some(traced(&[2.0 * tau], places(1), |p, s| vec![lag(p, s)]));
        x0.extend(start);
        let inputs = Inputs::constant(vec![u]);
        let times: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
        for method in METHODS {
            let plain = task(&x0, &inputs, method);
            for save_at in [None, Some(&times[..])] {
                let result = run(&body, &Task { save_at, ..plain.clone() });
                assert_eq!(result.ending, Ending::ReachedEnd);
                assert_eq!(result.chart_changes.len(), 2, "{method:?}");
                for (t, x) in result.times.iter().zip(result.states.chunks(14)) {
                    for k in 0..2 {
                        // Tolerance 1e-10 a step; h⁴/120 of RK4's 0.01, and its dense output has order three.
                        let gap = (x[12 + k] - exact(*t, k)).abs();
                        assert!(gap < 1e-7, "{method:?} {form:?} {t}: {gap}");
                    }
                }
            }
        }
    }
}

/// The derivative of a model as a function of numbers alone, which counts how often it is asked.
#[derive(Debug)]
struct Elsewhere(FreeBody<f64>, AtomicUsize);

impl Elsewhere {
    fn of(model: &FreeBody<f64>) -> Arc<Self> {
        Arc::new(Self(model.clone(), AtomicUsize::new(0)))
    }
    fn asked(&self) -> usize {
        self.1.load(Ordering::Relaxed)
    }
}

impl Block for Elsewhere {
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]) {
        self.1.fetch_add(1, Ordering::Relaxed);
        let n = Dynamics::<f64>::state_size(&self.0);
        for l in 0..lanes {
            let column: Vec<f64> = given.iter().skip(l).step_by(lanes).copied().collect();
            let mut dx = vec![0.0; n];
            self.0.derivative(column[0], &column[1..=n], &column[n + 1..], &mut dx);
            for (i, d) in dx.iter().enumerate() {
                out[lanes * i + l] = *d;
            }
        }
    }
}

#[test]
fn a_compiled_derivative_is_taken_in_the_chart_of_the_moment() {
    for form in [Form::QuasiVelocity, Form::Generalized] {
        let (body, x0) = tumbling(form);
        let blocks = [Elsewhere::of(&body), Elsewhere::of(&body.in_quaternions())];
        let compiled = FreeBody { compiled: Some([blocks[0].clone(), blocks[1].clone()]), ..body.clone() };
        let inputs = Inputs::constant(Vec::new());
        for method in METHODS {
            let before = [blocks[0].asked(), blocks[1].asked()];
            let task = task(&x0, &inputs, method);
            let (kernel, found) = (run(&body, &task), run(&compiled, &task));
            assert_eq!(found.ending, Ending::ReachedEnd);
            assert_eq!(found.chart_changes.len(), 2);
            assert!(blocks[0].asked() > before[0] && blocks[1].asked() > before[1]);
            // Plain products instead of fused ones: roundings, which may also move a step.
            for (a, b) in kernel.end_state.iter().zip(&found.end_state) {
                assert!((a - b).abs() < 1e-9, "{method:?} {form:?}: {a} {b}");
            }
        }
        let (mut dx, mut plain) = (vec![0.0; 12], vec![0.0; 12]);
        let (ready, asked) = (Evaluator::new(&compiled), blocks[0].asked());
        ready.derivative(0.0, &x0, &[], &mut dx);
        body.derivative(0.0, &x0, &[], &mut plain);
        assert_eq!((dx, blocks[0].asked()), (plain, asked + 1));
        // Jacobians need the kernel.
        let (mut a, mut b) = (vec![0.0; 144], vec![0.0; 144]);
        ready.jacobian(0.0, &x0, &[], &mut a, &mut []);
        Evaluator::new(&body).jacobian(0.0, &x0, &[], &mut b, &mut []);
        assert_eq!((a, blocks[0].asked()), (b, asked + 1));
    }
}
