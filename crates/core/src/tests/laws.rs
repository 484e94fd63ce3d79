//! Laws that users write are forces like the built-in ones.

use super::lanes::derivatives;
use super::programs::{E, Seen, gravity_and_damping, traced};
use super::{Case, Random, case, case_with_laws, inertia, kinds, same, screw, vector};
use crate::algebra::{Mat3, Vec3};
use crate::evaluate::Evaluator;
use crate::forces::{
    Axes, Callback, Coefficients, Force, InputWrench, LinearDamping, Places, Situation, Traced,
    UniformGravity,
};
use crate::phase_space::{Chart, Dynamics, Form, FreeBody};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Block, Real};
use crate::screw::Screw;
use std::sync::Arc;

fn derivative(model: &FreeBody<f64>, case: &Case) -> Vec<f64> {
    let mut dx = vec![0.0; case.x.len()];
    model.derivative(case.t, &case.x, &case.u, &mut dx);
    dx
}

/// The largest difference, relative to the largest number.
fn gap(a: &[f64], b: &[f64]) -> f64 {
    let size = a.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
    a.iter().zip(b).fold(0.0, |m, (a, b)| f64::max(m, (a - b).abs())) / size
}

/// Gravity and damping, built in and as one traced law.
fn both(random: &mut Random) -> [Vec<Force<f64>>; 2] {
    let (acceleration, d) = (vector(random), screw(random));
    let mut parameters = vec![0.0; 9];
    acceleration.store(&mut parameters);
    d.store(&mut parameters[3..]);
    let law = traced(&parameters, Places::default(), gravity_and_damping);
    let coefficients = Coefficients::Diagonal(d);
    let built_in = vec![
        Force::UniformGravity(UniformGravity { acceleration }),
        Force::LinearDamping(LinearDamping { coefficients }),
    ];
    [built_in, vec![Force::Traced(law)]]
}

#[test]
fn a_traced_law_is_the_built_in_force() {
    let mut random = Random(100);
    for kind in kinds() {
        let mut case = case(&mut random, kind);
        case.u.clear();
        let [built_in, law] = both(&mut random);
        let n = case.x.len();
        let mut found = Vec::new();
        for forces in [built_in, law] {
            case.model.forces = forces;
            let (mut a, mut dx) = (vec![0.0; n * n], vec![0.0; n]);
            let ready = Evaluator::new(&case.model);
            ready.derivative(case.t, &case.x, &[], &mut dx);
            ready.jacobian(case.t, &case.x, &[], &mut a, &mut []);
            found.push((derivative(&case.model, &case), dx, a));
        }
        // Some hundred operations; a moment about the origin and back loses what its arm is long.
        assert!(gap(&found[0].0, &found[1].0) < 1e-13, "{kind:?}");
        assert!(gap(&found[0].1, &found[1].1) < 1e-13, "{kind:?}");
        assert!(gap(&found[0].2, &found[1].2) < 1e-13, "{kind:?}");
    }
}

#[test]
fn laws_as_one_act_as_each_for_itself() {
    let mut random = Random(105);
    for kind in kinds() {
        let mut case = case_with_laws(&mut random, kind);
        let [_, law] = both(&mut random);
        case.model.forces.extend(law);
        let joined = case.model.clone().made_ready();
        assert!(
            joined.acting.as_ref().is_some_and(|a| a.law.is_some())
                && joined.forces.len() == case.model.forces.len()
        );
        assert_eq!(Dynamics::<f64>::state_size(&joined), Dynamics::<f64>::state_size(&case.model));
        assert_eq!(Dynamics::<f64>::input_size(&joined), Dynamics::<f64>::input_size(&case.model));
        let apart = derivative(&case.model, &case);
        // The sums are taken in another order.
        assert!(gap(&apart, &derivative(&joined, &case)) < 1e-14, "{kind:?}");
        let mut ready = apart.clone();
        Evaluator::new(&joined).derivative(case.t, &case.x, &case.u, &mut ready);
        assert!(gap(&apart, &ready) < 1e-13, "{kind:?}");
    }
}

/// What a block is that computes a traced law one column after another.
#[derive(Debug)]
struct Columns(Traced<f64>, FreeBody<f64>);

impl Block for Columns {
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]) {
        for l in 0..lanes {
            let column: Vec<f64> = given.iter().skip(l).step_by(lanes).copied().collect();
            let at = |i: usize| Vec3::from_slice(&column[i..]);
            let s = Situation {
                time: column[0],
                position: at(1),
                rotation: Mat3::from_rows(at(4), at(7), at(10)),
                twist: Screw::from_slice(&column[13..]),
                inertia: &self.1.inertia,
                inputs: &[],
                states: &[],
            };
            let mut wrench = [0.0; 6];
            self.0.command(&s, &mut wrench, &mut []);
            for (i, w) in wrench.iter().enumerate() {
                out[lanes * i + l] = *w;
            }
        }
    }
}

#[test]
fn a_callback_gets_what_a_law_gets_and_has_no_derivatives() {
    let mut random = Random(101);
    for kind in kinds() {
        let mut cases: Vec<Case> = Vec::new();
        let [_, law] = both(&mut random);
        let Force::Traced(traced) = &law[0] else { unreachable!() };
        let body = inertia(&mut random);
        let model = FreeBody::new(body, law.clone(), kind.0, kind.1);
        let block = Arc::new(Columns(traced.clone(), model.clone()));
        let callback = Force::Callback(Callback { block, places: Places::default() });
        for _ in 0..8 {
            let mut case = case(&mut random, kind);
            case.u.clear();
            case.model = model.clone();
            case.model.forces = vec![callback.clone()];
            cases.push(case);
        }
        for case in &cases {
            let (a, b) = (derivative(&model, case), derivative(&case.model, case));
            assert!(a.iter().zip(&b).all(|(a, b)| same(*a, *b)), "{kind:?}: {a:?} {b:?}");
        }
        for isa in Isa::available() {
            let alone = with_scalar!(isa, S => derivatives::<S>(&cases));
            let lanes = with_lanes!(isa, L => derivatives::<L>(&cases));
            for (a, b) in lanes.iter().flatten().zip(alone.iter().flatten()) {
                assert!(same(*a, *b), "{kind:?} on {isa:?}");
            }
        }
        let n = cases[0].x.len();
        let mut a = vec![0.0; n * n];
        Evaluator::new(&cases[0].model).jacobian(0.0, &cases[0].x, &[], &mut a, &mut []);
        assert!(a.iter().any(|v| v.is_nan()));
    }
}

/// Feedback through commanded inputs is the same law as a force: M = -p ω + r, r the reference.
#[test]
fn control_commands_what_a_force_would_do() {
    let mut random = Random(102);
    let moment = |p: &[E], s: &Seen<'_>| -> Vec<E> {
        let zero = E::lit(0.0);
        let m = |i: usize| s.inputs[0] - p[i] * s.twist[3 + i];
        vec![zero, zero, zero, m(0), m(1), m(2)]
    };
    for kind in kinds() {
        let mut case = case(&mut random, kind);
        case.u = vec![random.between(-2.0, 2.0)];
        let law = traced(&[0.3, 0.5, 0.7], Places::new(&[0], 0..0), moment);
        let (at, axes) = (Vec3::zero(), Axes::Body);
        case.model.forces = vec![Force::Traced(law.clone())];
        let open = derivative(&case.model, &case);
        case.model.forces =
            vec![Force::InputWrench(InputWrench { places: InputWrench::<f64>::from_place(1), at, axes })];
        case.model.control = Some(law);
        assert_eq!(Dynamics::<f64>::input_size(&case.model), 1);
        let closed = derivative(&case.model, &case);
        assert!(open.iter().zip(&closed).all(|(a, b)| same(*a, *b)), "{kind:?}: {open:?} {closed:?}");
        let commands = case.model.commands(case.t, &case.x, &case.u);
        let wrench = &case.model.wrenches(case.t, &case.x, &case.u)[0];
        let mut six = [0.0; 6];
        wrench.store(&mut six);
        assert!(gap(&commands, &six) < 1e-15 && commands.len() == 6);
    }
}

#[test]
fn many_commands_and_states_are_as_few() {
    let mut random = Random(103);
    let kind = (Chart::Quaternion, Form::QuasiVelocity);
    let mut case = case(&mut random, kind);
    case.model.forces.clear();
    case.u = vec![0.4];
    let n = 60;
    // Sixty states and commands that copy one lag; of them the force reads the last.
    case.x.extend(vec![0.1; n]);
    let lag = move |_: &[E], s: &Seen<'_>| -> Vec<E> {
        let rates = s.states.iter().map(|x| s.inputs[0] - *x);
        s.states.iter().copied().chain(rates).collect()
    };
    let push = |_: &[E], s: &Seen<'_>| -> Vec<E> { vec![s.inputs[0]; 6] };
    case.model.control = Some(traced(&[], Places::new(&[0], 0..n), lag));
    case.model.forces = vec![Force::Traced(traced(&[], Places::new(&[n], 0..0), push))];
    assert_eq!(Dynamics::<f64>::state_size(&case.model), case.x.len());
    let dx = derivative(&case.model, &case);
    assert!(dx[13..].iter().all(|rate| *rate == 0.4 - 0.1));
    let mut ready = dx.clone();
    Evaluator::on(Isa::Baseline, &case.model).derivative(case.t, &case.x, &case.u, &mut ready);
    assert_eq!(ready, dx);
    assert_eq!(case.model.commands(case.t, &case.x, &case.u), case.x[13..]);
    let six = case.model.wrenches(case.t, &case.x, &case.u)[0];
    assert_eq!(six.linear.to_array(), [0.1; 3]);
}

#[test]
fn the_law_that_is_not_finite_is_named() {
    let mut random = Random(104);
    let mut case = case_with_laws(&mut random, (Chart::Quaternion, Form::Generalized));
    assert_eq!(case.model.culprit(case.t, &case.x, &case.u), None);
    let (n, fin) = (case.x.len(), case.model.forces.len() - 1);
    case.x[n - 2] = f64::NAN;
    assert_eq!(case.model.culprit(case.t, &case.x, &case.u), Some(fin));
    case.x[n - 1] = f64::NAN;
    assert_eq!(case.model.culprit(case.t, &case.x, &case.u), Some(fin + 1));
}
