//! Motions as the integrators know them: Jacobians in lanes.

use super::{Case, MAKES, Random, kinds, same};
use crate::evaluate::Evaluator;
use crate::integrators::System;
use crate::phase_space::FreeBody;
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::{Interpolation, Lane, Table};
use crate::simulate::{Inputs, Motion};

/// Case `l` of those that the lanes hold: another time, state and mass.
fn own(case: &Case, l: usize) -> (f64, Vec<f64>, Vec<f64>) {
    let factor = 1.0 + 0.01 * l as f64;
    let state = case.x.iter().map(|x| factor * x).collect();
    let mut parameters = case.model.parameters();
    parameters[0] *= factor;
    (factor * case.t, state, parameters)
}

/// ∂f/∂x by rows and ∂f/∂t of each lane.
fn in_lanes<L: Lane>(case: &Case, inputs: &Inputs) -> Vec<(Vec<f64>, Vec<f64>)> {
    L::call(|| {
        let n = case.x.len();
        let mut motion = Motion::<L>::new(&case.model, inputs);
        let t = L::from_lanes(|l| own(case, l).0);
        let y: Vec<L> = (0..n).map(|i| L::from_lanes(|l| own(case, l).1[i])).collect();
        let (mut by_time, mut by_state) = (vec![L::zero(); n], vec![L::zero(); n * n]);
        // What was asked before the parameters changed counts no more.
        motion.jacobian(t, &y, &mut by_time, &mut by_state);
        (0..L::N).for_each(|l| motion.set_parameters(l, &own(case, l).2));
        motion.renew();
        motion.jacobian(t, &y, &mut by_time, &mut by_state);
        let lane = |x: &[L], l: usize| x.iter().map(|x| x.get(l)).collect();
        (0..L::N).map(|l| (lane(&by_state, l), lane(&by_time, l))).collect()
    })
}

#[test]
fn each_lane_has_the_jacobian_of_its_own_body_state_and_time() {
    let mut random = Random(120);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let mut case = make(&mut random, kind);
        // Away from where the tabulated forces jump, and so that all lanes are.
        case.t = 1.2;
        let ramp = |u: &f64| Table::new(&[0.0, 3.0], &[*u, 1.0 - u], Interpolation::Linear).unwrap();
        let inputs = Inputs::tabulated(case.u.iter().map(ramp).collect());
        for isa in Isa::available() {
            let lanes = with_lanes!(isa, L => in_lanes::<L>(&case, &inputs));
            for (l, (by_state, by_time)) in lanes.iter().enumerate() {
                let (t, x, parameters) = own(&case, l);
                let mut next = parameters.iter();
                let body: FreeBody<f64> = case.model.map(&mut |_| *next.next().unwrap());
                let (n, m) = (x.len(), case.u.len());
                let ready = Evaluator::on(isa, &body);
                let (mut a, mut b) = (vec![0.0; n * n], vec![0.0; n * m]);
                ready.jacobian(t, &x, &inputs.at(t), &mut a, &mut b);
                assert!(a.iter().zip(by_state).all(|(a, b)| same(*a, *b)), "{kind:?} on {isa:?}, lane {l}");
                let at = |t: f64| {
                    let mut dx = vec![0.0; n];
                    ready.derivative(t, &x, &inputs.at(t), &mut dx);
                    dx
                };
                let (d, size) = (1e-4, at(t).iter().fold(1.0, |m, x| f64::max(m, x.abs())));
                for ((slope, after), before) in by_time.iter().zip(at(t + d)).zip(at(t - d)) {
                    // Time enters linearly: roundings over the distance.
                    let gap = (slope - (after - before) / (2.0 * d)).abs();
                    assert!(gap < 1e-10 * size, "{kind:?} on {isa:?}, lane {l}: {gap}");
                }
            }
        }
    }
}
