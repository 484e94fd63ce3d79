//! Exact Jacobians against each other, against differences, and against the derivative alone.

use super::bounded::Bounded;
use super::{Case, MAKES, Random, case, inertia, kinds, same, screw, sequences, vector};
use crate::charts::AngleChart;
use crate::evaluate::Evaluator;
use crate::generalized::{Generalized, acceleration_by_blocks};
use crate::lagrange::{Lagrange, christoffel_sums, generalized_force, lagrange_operator};
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::isa::{Isa, with_scalar};
use crate::scalar::{Dual, Lane, Real};

/// ∂f/∂(x, u), by columns.
type Columns = Vec<Vec<f64>>;

fn jacobian(isa: Isa, case: &Case) -> Columns {
    let (n, m) = (case.x.len(), case.u.len());
    let (mut a, mut b) = (vec![0.0; n * n], vec![0.0; n * m]);
    Evaluator::on(isa, &case.model).jacobian(case.t, &case.x, &case.u, &mut a, &mut b);
    let column = |rows: &[f64], width: usize, j: usize| (0..n).map(|i| rows[i * width + j]).collect();
    (0..n).map(|j| column(&a, n, j)).chain((0..m).map(|j| column(&b, m, j))).collect()
}

/// The same one direction at a time.
fn one_by_one<S: Real>(case: &Case, number: fn(S) -> f64, out: &mut Columns) {
    let body: FreeBody<Dual<S, 1>> = case.model.lift();
    let n = case.x.len();
    for (j, out) in out.iter_mut().enumerate() {
        S::call(
            #[inline(always)]
            || {
                let (mut x, mut u) = (vec![Dual::zero(); n], vec![Dual::zero(); case.u.len()]);
                for (i, (v, from)) in x.iter_mut().chain(&mut u).zip(case.x.iter().chain(&case.u)).enumerate()
                {
                    *v = Dual { value: S::lit(*from), slope: [S::lit(f64::from(u8::from(i == j)))] };
                }
                let mut dx = vec![Dual::zero(); n];
                body.derivative(Dual::lit(case.t), &x, &u, &mut dx);
                for (o, d) in out.iter_mut().zip(dx) {
                    *o = number(d.slope[0]);
                }
            },
        );
    }
}

#[test]
fn lanes_of_directions_give_each_direction_alone_bit_for_bit() {
    let mut random = Random(30);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let case = make(&mut random, kind);
        for isa in Isa::available() {
            let together = jacobian(isa, &case);
            let mut alone = together.clone();
            with_scalar!(isa, S => one_by_one::<S>(&case, |x| x.get(0), &mut alone));
            for (together, alone) in together.iter().zip(&alone) {
                let equal = together.iter().zip(alone).all(|(a, b)| same(*a, *b));
                assert!(equal, "{kind:?} on {isa:?}: {together:?}, alone {alone:?}");
            }
        }
    }
}

#[test]
fn instruction_sets_differ_by_two_units_an_operation() {
    let mut random = Random(31);
    for kind in kinds() {
        let case = case(&mut random, kind);
        let baseline = jacobian(Isa::Baseline, &case);
        let mut allowed = baseline.clone();
        one_by_one::<Bounded>(&case, |x| x.bound, &mut allowed);
        for isa in Isa::available() {
            let columns = jacobian(isa, &case);
            for ((a, b), allowed) in
                columns.iter().flatten().zip(baseline.iter().flatten()).zip(allowed.iter().flatten())
            {
                assert!((a - b).abs() <= *allowed, "{kind:?} on {isa:?}: {a} is not {b} to {allowed}");
            }
        }
    }
}

/// The derivative of `f` at zero: central differences over h, 2h, 4h and 8h, extrapolated to order eight.
fn difference(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let h = 1.0 / 256.0;
    let central = |step: f64| -> Vec<f64> {
        f(step).iter().zip(f(-step)).map(|(a, b)| (a - b) / (2.0 * step)).collect()
    };
    let mut table: Vec<_> = [h, 2.0 * h, 4.0 * h, 8.0 * h].map(central).into();
    for order in 1..4 {
        let weight = f64::from(1 << (2 * order));
        for k in 0..4 - order {
            let (fine, coarse) = table.split_at_mut(k + 1);
            for (a, b) in fine[k].iter_mut().zip(&coarse[0]) {
                *a += (*a - b) / (weight - 1.0);
            }
        }
    }
    table.swap_remove(0)
}

#[test]
fn jacobians_are_the_limits_of_differences() {
    let mut random = Random(32);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let case = make(&mut random, kind);
        let ready = Evaluator::on(Isa::Baseline, &case.model);
        let n = case.x.len();
        let mut size = 0.0;
        for (j, column) in jacobian(Isa::Baseline, &case).iter().enumerate() {
            let numeric = difference(|step| {
                let (mut x, mut u, mut dx) = (case.x.clone(), case.u.clone(), vec![0.0; n]);
                if j < n {
                    x[j] += step;
                } else {
                    u[j - n] += step;
                }
                ready.derivative(case.t, &x, &u, &mut dx);
                dx
            });
            size = column.iter().fold(f64::max(size, 1.0), |m, x| f64::max(m, x.abs()));
            for (exact, numeric) in column.iter().zip(numeric) {
                // Roundings of f, some ten units of 2e-16, over the step of 4e-3 make 1e-12, and extrapolation
                // twice that; what the order leaves is h^8 · 4096 · f⁽⁹⁾/9! < 1e-16 f⁽⁹⁾/f.
                assert!((exact - numeric).abs() < 2e-11 * size, "{kind:?}, {j}: {exact} is not {numeric}");
            }
        }
    }
}

/// (2.11) differentiates the kinetic energy twice, by a dual of duals; (2.9) and (2.12) find its forces otherwise.
#[test]
fn the_lagrange_operator_gives_the_generalized_forces() {
    let mut random = Random(33);
    for sequence in sequences() {
        for _ in 0..10 {
            let body = inertia(&mut random);
            let first = vector(&mut random);
            let second = if sequence.is_proper_euler() { 0.8 } else { 0.3 } * first.y.signum();
            let alpha = crate::algebra::Vec3::new(first.x, second, first.z);
            let (q_dot, wrench) = (screw(&mut random), screw(&mut random));
            let chart = AngleChart::new(sequence, alpha);
            let q_ddot = acceleration_by_blocks(&body, &chart, q_dot, wrench);
            let found = lagrange_operator(&body, sequence, alpha, q_dot, q_ddot);
            let mut force = [0.0; 6];
            generalized_force(&chart, wrench).store(&mut force);

            let g = Generalized::new(&body, sequence, alpha, q_dot);
            let mut phi_q_dot = [0.0; 6];
            Lagrange::new(&body, &g).phi_q.apply(q_dot).store(&mut phi_q_dot);
            let sums = christoffel_sums(&body, sequence, alpha, q_dot);

            let size = |x: &[f64; 6]| x.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
            // The terms of (2.11) are up to A q̈, whose roundings stay when they cancel down to Q.
            let terms = size(&phi_q_dot) * body.mass * 10.0;
            for i in 0..6 {
                assert!((found[i] - force[i]).abs() < 1e-13 * terms, "{sequence:?}: {found:?} {force:?}");
                let gap = (sums[i] - phi_q_dot[i]).abs();
                assert!(gap < 1e-12 * size(&phi_q_dot), "{sequence:?}: {sums:?} {phi_q_dot:?}");
            }
        }
    }
}
