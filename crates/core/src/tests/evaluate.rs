//! A body made ready for the machine is the body.

use super::{MAKES, Random, case, inertia, kinds, same, vector};
use crate::evaluate::Evaluator;
use crate::forces::{Axes, Force, InputWrench};
use crate::phase_space::{Chart, Dynamics, Form, FreeBody};
use crate::scalar::isa::Isa;

#[test]
fn on_the_baseline_it_is_the_plain_derivative() {
    let mut random = Random(70);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let case = make(&mut random, kind);
        let (mut plain, mut ready) = (vec![0.0; case.x.len()], vec![0.0; case.x.len()]);
        case.model.derivative(case.t, &case.x, &case.u, &mut plain);
        Evaluator::on(Isa::Baseline, &case.model).derivative(case.t, &case.x, &case.u, &mut ready);
        assert!(plain.iter().zip(&ready).all(|(a, b)| same(*a, *b)), "{kind:?}: {plain:?} {ready:?}");
    }
}

#[test]
fn the_best_instruction_set_is_chosen() {
    let case = case(&mut Random(71), (Chart::Quaternion, Form::QuasiVelocity));
    let (mut chosen, mut best) = (vec![0.0; 13], vec![0.0; 13]);
    Evaluator::new(&case.model).derivative(case.t, &case.x, &case.u, &mut chosen);
    Evaluator::on(Isa::detect(), &case.model).derivative(case.t, &case.x, &case.u, &mut best);
    assert_eq!(chosen, best);
}

#[test]
#[should_panic(expected = "this machine has no")]
fn an_instruction_set_of_other_machines_is_refused() {
    let case = case(&mut Random(72), (Chart::Quaternion, Form::QuasiVelocity));
    let foreign = if cfg!(target_arch = "aarch64") { Isa::Avx2 } else { Isa::Neon };
    Evaluator::on(foreign, &case.model);
}

/// A body with some input wrenches at one point.
fn with_inputs(count: usize) -> FreeBody<f64> {
    let mut random = Random(73);
    let inertia = inertia(&mut random);
    let at = vector(&mut random);
    let input = |k: usize| {
        Force::InputWrench(InputWrench {
            places: InputWrench::<f64>::from_place(6 * k),
            at,
            axes: Axes::World,
        })
    };
    let forces = (0..count).map(input).collect();
    FreeBody::new(inertia, forces, Chart::Quaternion, Form::QuasiVelocity)
}

/// However many inputs there are, and wherever they are kept on the way.
#[test]
fn many_inputs_are_evaluated_as_few() {
    let mut random = Random(74);
    let x = case(&mut random, (Chart::Quaternion, Form::QuasiVelocity)).x;
    let six: Vec<f64> = (0..6).map(|_| random.between(-2.0, 2.0)).collect();
    for isa in Isa::available() {
        let few = Evaluator::on(isa, &with_inputs(1));
        let (mut dx, mut a, mut b) = (vec![0.0; 13], vec![0.0; 13 * 13], vec![0.0; 13 * 6]);
        few.derivative(0.0, &x, &six, &mut dx);
        few.jacobian(0.0, &x, &six, &mut a, &mut b);
        for count in [2, 3, 7] {
            let many = Evaluator::on(isa, &with_inputs(count));
            for active in [0, count - 1] {
                let m = 6 * count;
                let mut u = vec![0.0; m];
                u[6 * active..6 * active + 6].copy_from_slice(&six);
                let (mut dx_many, mut a_many, mut b_many) =
                    (vec![0.0; 13], vec![0.0; 13 * 13], vec![0.0; 13 * m]);
                many.derivative(0.0, &x, &u, &mut dx_many);
                many.jacobian(0.0, &x, &u, &mut a_many, &mut b_many);
                // The silent wrenches add nothing but zeros.
                assert_eq!(dx_many, dx, "{count} on {isa:?}");
                assert_eq!(a_many, a, "{count} on {isa:?}");
                for (row, expected) in b_many.chunks(m).zip(b.chunks(6)) {
                    assert!(row.chunks(6).all(|part| part == expected), "{count} on {isa:?}");
                }
            }
        }
    }
}
