//! f and its Jacobians at many states at once.

use super::{Case, MAKES, Random, case, kinds};
use crate::bulk::Points;
use crate::evaluate::Evaluator;
use crate::forces::{Axes, Coefficients, Force, LinearDamping};
use crate::phase_space::{Chart, Dynamics, Form};
use crate::scalar::isa::Isa;

const COUNT: usize = 150;

/// States and inputs by component, near those of a case; times for each.
struct Set {
    t: Vec<f64>,
    x: Vec<f64>,
    u: Vec<f64>,
}

impl Set {
    fn new(random: &mut Random, case: &Case) -> Self {
        let mut near = |all: &[f64]| -> Vec<f64> {
            all.iter()
                .flat_map(|v| (0..COUNT).map(|_| v * random.between(0.9, 1.1)).collect::<Vec<_>>())
                .collect()
        };
        Self { t: near(&[case.t]), x: near(&case.x), u: near(&case.u) }
    }

    fn points(&self, inputs: usize) -> Points<'_> {
        Points { count: COUNT, t: &self.t, x: &self.x, u: &self.u, inputs }
    }

    fn one(&self, k: usize) -> (f64, Vec<f64>, Vec<f64>) {
        let of = |all: &[f64]| all.iter().skip(k).step_by(COUNT).copied().collect();
        (self.t[k], of(&self.x), of(&self.u))
    }
}

#[test]
fn derivatives_are_those_of_the_states_alone() {
    let mut random = Random(500);
    for (kind, make) in kinds().into_iter().step_by(3).flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let mut case = make(&mut random, kind);
        case.model = case.model.made_ready();
        let (set, n) = (Set::new(&mut random, &case), case.x.len());
        let points = set.points(case.u.len());
        let (mut all, mut again) = (vec![0.0; n * COUNT], vec![0.0; n * COUNT]);
        let evaluator = Evaluator::new(&case.model);
        evaluator.derivatives(&points, &mut all, 1);
        evaluator.derivatives(&points, &mut again, 3);
        let bits = |x: &[f64]| x.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&all), bits(&again));
        let mut alone = vec![0.0; n];
        for k in [0, 1, 63, 64, 149] {
            let (t, x, u) = set.one(k);
            evaluator.derivative(t, &x, &u, &mut alone);
            let row: Vec<f64> = all.iter().skip(k).step_by(COUNT).copied().collect();
            assert_eq!(bits(&row), bits(&alone), "{kind:?} {k}");
        }
        // One input and one time for all.
        let (t, _, u) = set.one(5);
        let few = Points { t: &[t], u: &u, ..points };
        evaluator.derivatives(&few, &mut again, 2);
        let (_, x, _) = set.one(70);
        evaluator.derivative(t, &x, &u, &mut alone);
        let row: Vec<f64> = again.iter().skip(70).step_by(COUNT).copied().collect();
        assert_eq!(bits(&row), bits(&alone));
    }
}

/// Leaves of the forces the first of each wanted kind that the closed form knows.
fn under_usual_forces(mut case: Case, mut wanted: [bool; 4]) -> Case {
    case.model.forces.retain(|f| {
        let kind = match f {
            Force::UniformGravity(_) => 0,
            Force::LinearDamping(LinearDamping { coefficients: Coefficients::Diagonal(_) }) => 1,
            Force::ConstantWrench(f) if f.axes == Axes::Body => 2,
            Force::InputWrench(f) if f.axes == Axes::Body => 3,
            _ => return false,
        };
        std::mem::take(&mut wanted[kind])
    });
    case
}

/// The closed form against duals; every subset of the forces that it knows.
#[test]
fn jacobians_are_those_of_the_states_alone() {
    let mut random = Random(501);
    let plain = (Chart::Quaternion, Form::QuasiVelocity);
    let mut cases: Vec<Case> = MAKES.map(|make| make(&mut random, plain)).into();
    for chosen in 0..16 {
        let all = case(&mut random, plain);
        cases.push(under_usual_forces(all, [chosen & 1 > 0, chosen & 2 > 0, chosen & 4 > 0, chosen & 8 > 0]));
    }
    for mut case in cases {
        // Without what is made ready the Jacobian goes through duals.
        let duals = Evaluator::new(&case.model);
        case.u.truncate(Dynamics::<f64>::input_size(&case.model));
        case.model = case.model.made_ready();
        let (set, n, m) = (Set::new(&mut random, &case), case.x.len(), case.u.len());
        let mut all = vec![1.0; n * (n + m) * COUNT];
        let ready = Evaluator::new(&case.model);
        ready.jacobians(&set.points(m), &mut all, 2);
        let sizes = (vec![0.0; n * n], vec![0.0; n * m]);
        for k in [0, 9, 149] {
            let (t, x, u) = set.one(k);
            let (mut by_x, mut by_u) = sizes.clone();
            duals.jacobian(t, &x, &u, &mut by_x, &mut by_u);
            let (mut closed_x, mut closed_u) = sizes.clone();
            ready.jacobian(t, &x, &u, &mut closed_x, &mut closed_u);
            let size = by_x.iter().chain(&by_u).fold(1.0, |m, v| f64::max(m, v.abs()));
            for i in 0..n {
                for j in 0..n + m {
                    let (right, closed) = if j < n {
                        (by_x[i * n + j], closed_x[i * n + j])
                    } else {
                        (by_u[i * m + j - n], closed_u[i * m + j - n])
                    };
                    // A few hundred roundings of numbers up to the largest entry.
                    let found = all[(i * (n + m) + j) * COUNT + k];
                    assert!((found - right).abs() < 1e-13 * size, "{i} {j}: {found} {right}");
                    assert!((closed - right).abs() < 1e-13 * size, "{i} {j}: {closed} {right}");
                }
            }
        }
    }
}

/// Few states fill lanes, many are written past the caches, at any place of a cache line; all by the same operations.
#[test]
fn results_do_not_depend_on_the_count() {
    let mut random = Random(502);
    let case = case(&mut random, (Chart::Quaternion, Form::QuasiVelocity));
    let mut case = under_usual_forces(case, [true; 4]);
    case.u.truncate(Dynamics::<f64>::input_size(&case.model));
    case.model = case.model.made_ready();
    let (set, n, m) = (Set::new(&mut random, &case), case.x.len(), case.u.len());
    type Fill = fn(&Evaluator, &Points<'_>, &mut [f64], usize);
    for isa in Isa::available() {
        let evaluator = Evaluator::on(isa, &case.model);
        let entries = evaluator.jacobian_entries().expect("a closed form").len();
        let kinds: [(usize, Fill, usize); 3] = [
            (n, Evaluator::derivatives, 41_000),
            (n * (n + m), Evaluator::jacobians, 2_200),
            (entries, Evaluator::sparse_jacobians, 4_200),
        ];
        for (rows, fill, many) in kinds {
            let mut right = vec![0.0; rows * COUNT];
            fill(&evaluator, &set.points(m), &mut right, 1);
            for (count, threads, skipped) in
                [(1, 1, 0), (5, 2, 0), (9, 1, 1), (67, 2, 0), (many, 1, 0), (many, 2, 3), (many + 3, 1, 1)]
            {
                let wide = |all: &[f64]| -> Vec<f64> {
                    all.chunks_exact(COUNT).flat_map(|row| row.iter().copied().cycle().take(count)).collect()
                };
                let (t, x, u) = (wide(&set.t), wide(&set.x), wide(&set.u));
                let points = Points { count, t: &t, x: &x, u: &u, inputs: m };
                let mut room = vec![1.0; skipped + rows * count];
                fill(&evaluator, &points, &mut room[skipped..], threads);
                for (k, value) in room[skipped..].iter().enumerate() {
                    let (row, point) = (k / count, k % count);
                    let right = right[row * COUNT + point % COUNT];
                    assert_eq!(value.to_bits(), right.to_bits(), "{isa:?} {count}: {row} {point}");
                }
            }
        }
    }
}
