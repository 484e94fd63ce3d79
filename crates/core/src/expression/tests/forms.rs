//! The paper's equations as expressions.

use super::*;
use crate::algebra::{Sym3, Vec3};
use crate::charts::{AngleChart, Sequence};
use crate::expression::Shortest;
use crate::generalized::{Generalized, inverse_dynamics_by_blocks};
use crate::inertia::Inertia;
use crate::lagrange::{Lagrange, generalized_force};
use crate::newton_euler;
use crate::screw::Screw;

struct Motion {
    graph: Graph,
    body: Inertia<Expression>,
    alpha: Vec3<Expression>,
    q_dot: Screw<Expression>,
    q_ddot: Screw<Expression>,
}

/// A body with all six components of its tensor about an origin off the mass centre, in any motion.
fn motion() -> Motion {
    let mut graph = Graph::new(Simplify::Algebraically);
    let mut number = 0;
    let mut next = || {
        number += 1;
        Expression(graph.symbol(&format!("x_{number}"), ""))
    };
    let mut vector = || Vec3::new(next(), next(), next());
    let alpha = vector();
    let (q_dot, q_ddot) = (Screw::new(vector(), vector()), Screw::new(vector(), vector()));
    let (com, [j1, j2, j3], [j4, j5, j6]) = (vector(), vector().to_array(), vector().to_array());
    let mass = next();
    let tensor = Sym3::from_array([j1, j2, j3, j4, j5, j6]);
    let body = graph.enter(|| Inertia::of_origin(mass, com, tensor));
    Motion { graph, body, alpha, q_dot, q_ddot }
}

fn six(screw: Screw<Expression>) -> Vec<Id> {
    let mut out = [Expression(0); 6];
    screw.store(&mut out);
    ids(&out)
}

#[test]
fn by_blocks_and_as_they_stand_they_are_one() {
    for name in Sequence::names() {
        let Motion { mut graph, body, alpha, q_dot, q_ddot } = motion();
        let sequence = Sequence::parse(name).unwrap();
        graph.enter(|| {
            let chart = AngleChart::new(sequence, alpha);
            let wrench = inverse_dynamics_by_blocks(&body, &chart, q_dot, q_ddot);
            let generalized = Generalized::new(&body, sequence, alpha, q_dot);
            assert_eq!(six(generalized.inverse_dynamics(q_dot, q_ddot)), six(wrench), "(2.8) {name}");
            let lagrange = Lagrange::new(&body, &generalized);
            let force = generalized_force(&chart, wrench);
            assert_eq!(six(lagrange.inverse_dynamics(q_dot, q_ddot)), six(force), "(2.10) {name}");
        });
    }
}

#[test]
fn they_are_short() {
    let Motion { mut graph, body, alpha, q_dot, q_ddot } = motion();
    let [quasi, generalized, lagrange] = graph.enter(|| {
        let chart = AngleChart::new(Sequence::parse("zyx").unwrap(), alpha);
        let wrench = inverse_dynamics_by_blocks(&body, &chart, q_dot, q_ddot);
        let quasi = newton_euler::inverse_dynamics(&body, q_dot, q_ddot);
        [six(quasi), six(wrench), six(generalized_force(&chart, wrench))]
    });
    // A third of the 1149 operations of SymPy's Lagrange equations; and round numbers.
    for (outputs, most) in [(quasi, 200), (generalized, 300), (lagrange, 383)] {
        graph.settle(&outputs, Shortest::Shared);
        let count = graph.operation_count(&outputs).shared;
        assert!(count <= most, "{count} operations");
    }
}
