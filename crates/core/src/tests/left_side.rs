//! What stands on the left: contents, added mass and wheels.

use super::programs::{E, Seen, cross, fin, pilot, traced};
use super::{Case, Random, case, kinds, matrix, same, screw, vector};
use crate::algebra::{Mat3, Mat6, Sym6, Vec3};
use crate::expression::{Graph, Program, Simplify};
use crate::forces::{Force, Places, Source};
use crate::inertia::Inertia;
use crate::phase_space::{Chart, Contents, Dynamics, Form, FreeBody, Left, RigidState, Spin};
use crate::scalar::Real;
use crate::screw::{Screw, force_cross};

/// Mass that depends on two published states, in a place that depends on one of them.
fn tank(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let (zero, x) = (E::lit(0.0), s.inputs[0]);
    let mass = p[0] + p[0] * x * x + s.inputs[1] * s.inputs[1] * p[1] * p[1];
    let j = mass * p[1];
    vec![mass, p[1] * x, p[0], zero, j, zero, zero, j, zero, j + j * s.mass]
}

/// A wheel about `p[..3]` of inertia `p[3]` with a motor: its state is the speed.
fn wheel(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let (speed, axis) = (s.states[0], [p[0], p[1], p[2]]);
    let turned = cross([s.twist[3], s.twist[4], s.twist[5]], axis);
    let (torque, zero) = ((s.inputs[0] - speed) * p[3], E::lit(0.0));
    let moment: [E; 3] = std::array::from_fn(|i| -(axis[i] * torque) - turned[i] * (p[3] * speed));
    [vec![zero; 3], moment.to_vec(), vec![torque / p[3]]].concat()
}

/// A fluid at rest, -Φ(V) M V, of the 36 numbers of M by rows: without it its mass would feed on the motion.
fn fluid(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let row = |i: usize| (0..6).fold(E::lit(0.0), |sum, j| sum + p[6 * i + j] * s.twist[j]);
    let (v, w) = ([s.twist[0], s.twist[1], s.twist[2]], [s.twist[3], s.twist[4], s.twist[5]]);
    let (linear, angular) = ([row(0), row(1), row(2)], [row(3), row(4), row(5)]);
    let (force, first, second) = (cross(w, linear), cross(v, linear), cross(w, angular));
    (0..6).map(|i| if i < 3 { -force[i] } else { -(first[i - 3] + second[i - 3]) }).collect()
}

/// AᵀA + E, scaled: symmetric and positive definite.
fn positive(random: &mut Random) -> Sym6<f64> {
    let a = Mat6::new(matrix(random), matrix(random), matrix(random), matrix(random));
    let mut m = [0.0; 36];
    (a.transpose() * a + Mat6::identity()).store(&mut m);
    Sym6::from_slice(&m.map(|v| 0.02 * v))
}

/// Every force, and laws that read states of others: with a wheel, with added mass, with contents.
pub fn case_with_left(random: &mut Random, kind: (Chart, Form)) -> Case {
    let mut case = case(random, kind);
    let read = |sources: &[Source], states| Places::new(sources, states);
    let numbers = [0; 3].map(|_| random.between(0.5, 2.0));
    let axis = vector(random);
    let axis = axis.scale(1.0 / axis.norm());
    let inertia = random.between(0.01, 0.05);
    let [x, y, z] = axis.to_array();
    let fin = traced(&numbers, read(&[Source::Input(3), Source::Input(12)], 0..1), fin);
    let wheel = traced(&[x, y, z, inertia], read(&[Source::State(0)], 1..2), wheel);
    let added = positive(random);
    let mut numbers_of_fluid = [0.0; 36];
    Mat6::new(added.ll.full(), added.la, added.la.transpose(), added.aa.full()).store(&mut numbers_of_fluid);
    let fluid = traced(&numbers_of_fluid, Places::default(), fluid);
    case.model.forces.extend([fin, wheel, fluid].map(Force::Traced));
    case.model.control = Some(traced(&numbers[..2], read(&[Source::State(1)], 2..3), pilot));
    let law = traced(&[0.3, 0.2], read(&[Source::State(0), Source::State(1)], 0..0), tank);
    let contents = vec![Contents { law, force: case.model.forces.len() - 3 }];
    let spins = vec![Spin { axis, inertia, state: 1 }];
    case.model.left = Some(Left { contents, added_mass: Some(added), spins });
    case.x.extend([0; 3].map(|_| random.between(-1.0, 1.0)));
    case
}

fn derivative(model: &FreeBody<f64>, case: &Case) -> Vec<f64> {
    let mut dx = vec![0.0; case.x.len()];
    model.derivative(case.t, &case.x, &case.u, &mut dx);
    dx
}

/// The matrix of the left side, and V* by its inverse. Konoplev (1.8)
fn solved(model: &FreeBody<f64>, case: &Case, twist: Screw<f64>, wrench: Screw<f64>) -> Screw<f64> {
    let body = model.inertia_at(case.t, &case.x, &case.u);
    let left = model.left.as_ref().unwrap();
    let mut matrix = body.matrix();
    if let Some(added) = left.added_mass {
        matrix = matrix + Mat6::new(added.ll.full(), added.la, added.la.transpose(), added.aa.full());
    }
    for spin in &left.spins {
        let a = spin.axis;
        let rows = a.to_array().map(|component| a.scale(component * spin.inertia));
        let wheel = Mat3::from_rows(rows[0], rows[1], rows[2]);
        matrix = matrix - Mat6::diagonal(Mat3::zero(), wheel);
    }
    matrix.inverse().apply(wrench - (force_cross(twist) * body.matrix()).apply(twist))
}

#[test]
fn the_mass_matrix_has_all_of_it() {
    let mut random = Random(601);
    let kind = (Chart::Quaternion, Form::QuasiVelocity);
    for parts in 0..8 {
        let mut case = case_with_left(&mut random, kind);
        let left = case.model.left.as_mut().unwrap();
        if parts & 1 == 0 {
            left.contents.clear();
        }
        if parts & 2 == 0 {
            left.added_mass = None;
        }
        if parts & 4 == 0 {
            left.spins.clear();
        }
        let model = &case.model;
        let twist = model.rigid_state(&case.x).twist;
        let total = model.wrenches(case.t, &case.x, &case.u).into_iter().fold(Screw::zero(), |a, b| a + b);
        let (mut expected, dx) = ([0.0; 6], derivative(model, &case));
        solved(model, &case, twist, total).store(&mut expected);
        let size = dx.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
        // Matrices of condition below 1e3, of entries that are roundings of 1e-16.
        for (found, expected) in dx[7..13].iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11 * size, "{parts}: {found} is not {expected}");
        }
        // A wheel without a motor would keep its speed in space about its axis.
        let [x, y, z] = [10, 11, 12].map(|i| dx[i]);
        if let Some(spin) = case.model.left.as_ref().unwrap().spins.first() {
            let rate = (case.x[13] - case.x[14]) - spin.axis.dot(Vec3::new(x, y, z));
            assert!((dx[14] - rate).abs() < 1e-12 * rate.abs().max(1.0));
        }
    }
}

#[test]
fn contents_without_mass_are_none() {
    let mut random = Random(602);
    for kind in kinds() {
        let mut case = case_with_left(&mut random, kind);
        case.model.left.as_mut().unwrap().added_mass = None;
        case.model.left.as_mut().unwrap().spins.clear();
        let zero = |_: &[E], s: &Seen<'_>| -> Vec<E> {
            let zero = E::lit(0.0);
            [vec![zero, s.inputs[0], zero, E::lit(1.0)], vec![zero; 6]].concat()
        };
        let law = traced(&[], Places::new(&[Source::State(0)], 0..0), zero);
        case.model.left.as_mut().unwrap().contents[0].law = law;
        let with = derivative(&case.model, &case);
        let bare = derivative(&FreeBody { left: None, ..case.model.clone() }, &case);
        let size = bare.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
        // The two ways differ by the inverse of the tensor, computed once or at every evaluation.
        let near = with.iter().zip(&bare).all(|(a, b)| (a - b).abs() < 1e-14 * size);
        assert!(near, "{kind:?}: {with:?} {bare:?}");
    }
}

/// Two tanks are those of the body that has them in it.
#[test]
fn contents_are_joined_with_the_body() {
    let mut random = Random(603);
    let body = super::inertia(&mut random);
    let mut parts = vec![body];
    let mut contents = Vec::new();
    for _ in 0..2 {
        let part = super::inertia(&mut random);
        let (mass, r, j) = (part.mass, part.com, part.about_com);
        let numbers: Vec<f64> = [&[mass][..], &r.to_array(), &j.to_array()].concat();
        let law = traced(&numbers, Places::default(), |p, _| p.to_vec());
        contents.push(Contents { law, force: 0 });
        parts.push(part);
    }
    let whole = parts.iter().skip(1).fold(body, |all, part| all.joined(part));
    let model = FreeBody {
        left: Some(Left { contents, added_mass: None, spins: Vec::new() }),
        ..FreeBody::new(body, Vec::new(), Chart::Quaternion, Form::QuasiVelocity)
    };
    let mut x = vec![0.0; 13];
    let motion = RigidState {
        position: vector(&mut random),
        quaternion: super::quaternion(&mut random),
        twist: screw(&mut random),
    };
    model.write_state(&motion, &[0.0; 13], &mut x);
    let found = model.inertia_at(0.0, &x, &[]);
    let numbers = |i: &Inertia<f64>| i.parameters();
    for (a, b) in numbers(&found).iter().zip(numbers(&whole)) {
        assert!((a - b).abs() < 1e-14 * whole.mass, "{a} {b}");
    }
    let z = model.momentum_world(0.0, &x, &[]).angular;
    let alone = FreeBody { inertia: whole, left: None, ..model.clone() }.momentum_world(0.0, &x, &[]).angular;
    assert!((z - alone).norm() < 1e-13 * alone.norm());
}

/// Read by another law, joined with its own or apart, a state is the same number.
#[test]
fn a_published_state_is_an_input() {
    let mut random = Random(604);
    for kind in kinds() {
        let mut case = case(&mut random, kind);
        case.x.extend([0.4, -0.7]);
        let lag = |p: &[E], s: &Seen<'_>| -> Vec<E> {
            [vec![E::lit(0.0); 6], vec![(p[0] - s.states[0]) * p[1]]].concat()
        };
        let push = |_: &[E], s: &Seen<'_>| -> Vec<E> { vec![s.inputs[0] * s.inputs[1]; 6] };
        let first = traced(&[1.0, 2.0], Places::new(&[0], 0..1), lag);
        let second = traced(&[2.0, 3.0], Places::new(&[0], 1..2), lag);
        let by_state = traced(&[], Places::new(&[Source::State(1), Source::State(0)], 0..0), push);
        let places: Vec<Source> = [case.u.len(), case.u.len() + 1].map(Source::Input).into();
        let by_input = traced(&[], Places::new(&places, 0..0), push);
        case.model.forces.extend([first, second].map(Force::Traced));
        let mut other = case.model.clone();
        case.model.forces.push(Force::Traced(by_state));
        other.forces.push(Force::Traced(by_input));
        let u = [&case.u[..], &[-0.7, 0.4]].concat();
        for (model, other) in
            [(case.model.clone(), other.clone()), (case.model.clone().made_ready(), other.made_ready())]
        {
            let (mut a, mut b) = (case.x.clone(), case.x.clone());
            model.derivative(case.t, &case.x, &case.u, &mut a);
            other.derivative(case.t, &case.x, &u, &mut b);
            assert!(a.iter().zip(&b).all(|(a, b)| same(*a, *b)), "{kind:?}: {a:?} {b:?}");
        }
    }
}

/// The equations that are printed are those that run.
#[test]
fn expressions_have_the_left_side() {
    let mut random = Random(605);
    let kind = (Chart::Quaternion, Form::QuasiVelocity);
    let mut case = case_with_left(&mut random, kind);
    case.model.forces.retain(|f| matches!(f, Force::Traced(_) | Force::UniformGravity(_)));
    let mut graph = Graph::new(Simplify::Algebraically);
    let mut symbols = |stem: &str, n: usize| -> Vec<E> {
        (0..n).map(|k| crate::expression::Expression(graph.symbol(&format!("{stem}{k}"), ""))).collect()
    };
    let (t, x, u) = (symbols("t", 1), symbols("x", case.x.len()), symbols("u", case.u.len()));
    let outputs = graph.enter(|| {
        let body: FreeBody<E> = case.model.lift();
        let mut dx = vec![E::lit(0.0); x.len()];
        body.derivative(t[0], &x, &u, &mut dx);
        dx.iter().map(|e| e.0).collect::<Vec<_>>()
    });
    let given: Vec<_> = t.iter().chain(&x).chain(&u).map(|e| e.0).collect();
    let program = Program::new(&graph, &[], &given, &outputs).unwrap();
    let mut found = vec![0.0; case.x.len()];
    let numbers: Vec<f64> = [&[case.t][..], &case.x, &case.u].concat();
    program.run(&program.prepare(&[]), &numbers, &mut found);
    let expected = derivative(&case.model, &case);
    let size = expected.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
    // Some hundred operations in another order.
    for (a, b) in found.iter().zip(&expected) {
        assert!((a - b).abs() < 1e-11 * size, "{found:?} {expected:?}");
    }
}

#[test]
fn contents_that_are_not_finite_are_named_by_their_force() {
    let mut random = Random(606);
    let mut case = case_with_left(&mut random, (Chart::Quaternion, Form::QuasiVelocity));
    assert_eq!(case.model.culprit(case.t, &case.x, &case.u), None);
    let nan = traced(&[f64::NAN], Places::default(), |p, _| vec![p[0]; 10]);
    case.model.left.as_mut().unwrap().contents[0].law = nan;
    let owner = case.model.left.as_ref().unwrap().contents[0].force;
    assert_eq!(case.model.culprit(case.t, &case.x, &case.u), Some(owner));
}

/// The kinetic energy of a fluid does not depend on the point about which its matrix is told.
#[test]
fn a_symmetric_matrix_moves_with_its_point() {
    let mut random = Random(607);
    for _ in 0..20 {
        let (a, r, v) = (positive(&mut random), vector(&mut random), screw(&mut random));
        // The twist of the origin is X times that of the point: (v, ω) = (v_r + r × ω, ω).
        let moved = Screw::new(v.linear - r.cross(v.angular), v.angular);
        let energy = |m: Sym6<f64>, v: Screw<f64>| {
            let z = m.apply(v);
            v.linear.dot(z.linear) + v.angular.dot(z.angular)
        };
        let (one, other) = (energy(a, v), energy(a.about(r), moved));
        assert!((one - other).abs() < 1e-13 * one, "{one} {other}");
        let solved = a.apply(a.solve(v));
        // Condition below 1e4.
        assert!((solved.linear - v.linear).norm() + (solved.angular - v.angular).norm() < 1e-11);
    }
}
