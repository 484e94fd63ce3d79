//! Laws of the whole kernel.

mod bounded;
mod bulk;
mod duals;
mod ensemble;
mod evaluate;
mod forms;
mod lanes;
mod laws;
mod left_side;
mod matrices;
mod motions;
pub(crate) mod programs;
pub(crate) mod runs_with_laws;
mod sequences;
pub(crate) mod simulate;
mod validity;

use crate::algebra::{Mat3, Mat6, Sym3, Vec3, normalized, rotation_from_quaternion};
use crate::charts::Sequence;
use crate::forces::{
    Axes, Coefficients, ConstantWrench, Field, Force, HarmonicGravity, Harmonics, InputWrench, LinearDamping,
    Places, PointMassGravity, QuadraticDamping, TabulatedWrench, UniformGravity,
};
use crate::inertia::Inertia;
use crate::phase_space::{Chart, Dynamics, Form, FreeBody, RigidState};
use crate::scalar::tests::{Random, same};
use crate::scalar::{Interpolation, Table};
use crate::screw::Screw;
use std::sync::Arc;

fn sequences() -> [Sequence; 12] {
    Sequence::names().map(|name| Sequence::parse(name).unwrap())
}

/// Every chart with both kinds of velocity.
fn kinds() -> Vec<(Chart, Form)> {
    let mut charts = vec![Chart::Quaternion];
    charts.extend(sequences().map(Chart::Angles));
    charts.iter().flat_map(|c| [(*c, Form::QuasiVelocity), (*c, Form::Generalized)]).collect()
}

/// Three numbers of either sign, none of them small.
fn vector(random: &mut Random) -> Vec3<f64> {
    let mut one = || {
        let size = random.between(0.5, 2.0);
        if random.bits() & 1 == 0 { size } else { -size }
    };
    Vec3::new(one(), one(), one())
}

fn screw(random: &mut Random) -> Screw<f64> {
    Screw::new(vector(random), vector(random))
}

fn quaternion(random: &mut Random) -> [f64; 4] {
    normalized([0; 4].map(|_| random.between(-1.0, 1.0)))
}

fn rotation(random: &mut Random) -> Mat3<f64> {
    rotation_from_quaternion(quaternion(random))
}

/// A box of random sides, its mass centre off the origin, its axes turned.
fn inertia(random: &mut Random) -> Inertia<f64> {
    let mass = random.between(1.0, 10.0);
    let [a, b, c] = [0; 3].map(|_| mass / 12.0 * random.between(0.5, 2.0));
    let tensor = Sym3::from_array([b + c, 0.0, 0.0, a + c, 0.0, a + b]).turned(rotation(random));
    Inertia::new(mass, vector(random).scale(0.2), tensor)
}

fn matrix(random: &mut Random) -> Mat3<f64> {
    Mat3::from_rows(vector(random), vector(random), vector(random))
}

/// A field of degree three, every coefficient of another size.
fn harmonics() -> Harmonics {
    let mut field = Harmonics::zero(3);
    for n in 0..4 {
        for m in 0..=n {
            let size = 1.0 / (1.0 + n as f64 + 0.3 * m as f64);
            *field.at(n, m) = [size, if m == 0 { 0.0 } else { -0.7 * size }];
        }
    }
    field
}

/// Every kind of force in each of its shapes, and two sets of inputs.
fn every_force(random: &mut Random) -> Vec<Force<f64>> {
    let mut forces = Vec::new();
    forces.push(Force::UniformGravity(UniformGravity { acceleration: vector(random) }));
    for gradient_torque in [false, true] {
        let (mu, center) = (random.between(20.0, 40.0), vector(random).scale(4.0));
        forces.push(Force::PointMassGravity(PointMassGravity { mu, center, gradient_torque }));
    }
    forces.push(Force::HarmonicGravity(HarmonicGravity {
        mu: 2e3,
        // So far away that no motion falls into it.
        center: Vec3::lit([20.0, -15.0, 12.0]),
        field: Arc::new(Field::new(6.0, harmonics(), true)),
        rotation_rate: 0.4,
        angle: -0.2,
    }));
    for (k, axes) in [Axes::Body, Axes::World].into_iter().enumerate() {
        let at = vector(random);
        forces.push(Force::ConstantWrench(ConstantWrench { wrench: screw(random), at, axes }));
        forces.push(Force::InputWrench(InputWrench {
            places: InputWrench::<f64>::from_place(6 * k),
            at,
            axes,
        }));
        let ramp = Table::new(&[0.0, 3.0], &[1.0, -2.0], Interpolation::Linear).unwrap();
        let steps = Table::new(&[0.0, 1.0, 2.0], &[1.0, 0.5, -0.5], Interpolation::Hold).unwrap();
        let components = [Some(ramp.clone()), None, Some(steps), None, Some(ramp), None];
        forces.push(Force::TabulatedWrench(TabulatedWrench { components, at, axes }));
    }
    let full = Mat6::new(matrix(random), matrix(random), matrix(random), matrix(random));
    for coefficients in [Coefficients::Diagonal(screw(random)), Coefficients::Full(full)] {
        forces.push(Force::LinearDamping(LinearDamping { coefficients }));
        forces.push(Force::QuadraticDamping(QuadraticDamping { coefficients }));
    }
    forces
}

/// One evaluation of x' = f(x, u, t).
struct Case {
    model: FreeBody<f64>,
    t: f64,
    x: Vec<f64>,
    u: Vec<f64>,
}

/// A random body under all forces, away from the singularities of its chart.
fn case(random: &mut Random, (chart, form): (Chart, Form)) -> Case {
    let model = FreeBody::new(inertia(random), every_force(random), chart, form);
    let n = Dynamics::<f64>::state_size(&model);
    let mut x = vec![0.0; n];
    loop {
        let twist = screw(random);
        let motion = RigidState { position: vector(random), quaternion: quaternion(random), twist };
        model.write_state(&motion, &vec![0.0; n], &mut x);
        // Nearer than this the angle rates, and with them all roundings, are more than three times as large.
        if model.singularity_distance(&x).is_none_or(|d| d > 0.4) {
            break;
        }
    }
    let u = (0..Dynamics::<f64>::input_size(&model)).map(|_| random.between(-2.0, 2.0)).collect();
    Case { model, t: random.between(0.0, 3.0), x, u }
}

/// The same with a traced force and a control law behind it, each with a state of its own.
fn case_with_laws(random: &mut Random, kind: (Chart, Form)) -> Case {
    let mut case = case(random, kind);
    let own = |inputs: &[usize], k: usize| Places::new(inputs, k..k + 1);
    // The fin shares an input with a wrench, and reads the one that the pilot commands.
    let numbers = [0; 3].map(|_| random.between(0.5, 2.0));
    case.model.forces.push(Force::Traced(programs::traced(&numbers, own(&[3, 12], 0), programs::fin)));
    case.model.control = Some(programs::traced(&numbers[..2], own(&[1], 1), programs::pilot));
    case.x.extend([0; 2].map(|_| random.between(-1.0, 1.0)));
    case
}

type Make = fn(&mut Random, (Chart, Form)) -> Case;

/// Cases of built-in forces alone, with laws of users, and with more than the body on the left.
const MAKES: [Make; 3] = [case, case_with_laws, left_side::case_with_left];
