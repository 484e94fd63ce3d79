//! Laws traced for tests.

use crate::expression::{Expression, Graph, Id, Program, Simplify};
use crate::forces::{Places, Traced};
use crate::scalar::Real;
use std::sync::Arc;

pub type E = Expression;

/// What a law is given, by name.
pub struct Seen<'a> {
    pub time: E,
    pub position: [E; 3],
    pub rotation: [[E; 3]; 3],
    pub twist: &'a [E],
    pub mass: E,
    pub com: [E; 3],
    pub inputs: &'a [E],
    pub states: &'a [E],
}

/// A law with these parameters and places.
pub fn traced(
    parameters: &[f64],
    places: Places,
    law: impl FnOnce(&[E], &Seen<'_>) -> Vec<E>,
) -> Traced<f64> {
    let mut graph = Graph::new(Simplify::Safely);
    let mut symbols = |stem: &str, n: usize| -> Vec<E> {
        let mut one = |k: usize| Expression(graph.symbol(&format!("{stem}{k}"), stem));
        (0..n).map(&mut one).collect()
    };
    let (p, given) = (symbols("p", parameters.len()), symbols("g", places.given_count()));
    let outputs = graph.enter(|| {
        let (motion, own) = given.split_at(Places::MOTION);
        let (inputs, states) = own.split_at(places.inputs.len());
        let three = |first: usize| [motion[first], motion[first + 1], motion[first + 2]];
        let rotation = [three(4), three(7), three(10)];
        let seen = Seen {
            time: motion[0],
            position: three(1),
            rotation,
            twist: &motion[13..19],
            mass: motion[19],
            com: three(20),
            inputs,
            states,
        };
        law(&p, &seen)
    });
    let ids = |all: &[E]| -> Vec<Id> { all.iter().map(|e| e.0).collect() };
    let program = Program::new(&graph, &ids(&p), &ids(&given), &ids(&outputs)).unwrap();
    Traced::new(Arc::new(program), parameters.to_vec(), places)
}

pub fn cross(a: [E; 3], b: [E; 3]) -> [E; 3] {
    let part = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// The weight of acceleration `p[..3]` and damping of coefficients `p[3..9]`, about the origin.
pub fn gravity_and_damping(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let c = s.rotation;
    let weight: [E; 3] = std::array::from_fn(|j| s.mass * (c[0][j] * p[0] + c[1][j] * p[1] + c[2][j] * p[2]));
    let moment = cross(s.com, weight);
    weight.into_iter().chain(moment).enumerate().map(|(i, w)| w - p[3 + i] * s.twist[i]).collect()
}

/// A fin with a servo: a side force by the lagging deflection, bounded at any speed.
pub fn fin(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let one = E::lit(1.0);
    let speed = (s.twist[0] * s.twist[0] + s.twist[1] * s.twist[1] + one).sqrt();
    let (sine, cosine) = s.states[0].sin_cos();
    let side = E::select_le(s.time, E::lit(1e9), p[0] * sine / speed, one);
    let rate = (s.inputs[0] + s.inputs[1] * cosine - s.states[0]) / p[1];
    let zero = E::lit(0.0);
    vec![zero, side, zero, zero, zero, -(p[2] * side), rate]
}

/// Commands an input against a turn, filtered: reads one reference, has one state.
pub fn pilot(p: &[E], s: &Seen<'_>) -> Vec<E> {
    let error = s.inputs[0] - s.twist[5];
    vec![p[0] * error + p[1] * s.states[0], error - s.states[0]]
}
