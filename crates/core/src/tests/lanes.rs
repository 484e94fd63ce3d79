//! The derivative in lanes is the derivative of each lane alone.

use super::bounded::Bounded;
use super::{Case, MAKES, Random, case, kinds, same};
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Lane, Real};

/// As many as the widest register has lanes.
const CASES: usize = 8;

/// A body whose every parameter holds those of all models, one in each lane.
#[inline(always)]
fn gather<L: Lane>(cases: &[Case]) -> FreeBody<L> {
    let parameters: Vec<Vec<f64>> = cases
        .iter()
        .map(|case| {
            let mut all = Vec::new();
            case.model.map(&mut |p: f64| {
                all.push(p);
                p
            });
            all
        })
        .collect();
    let mut next = 0;
    cases[0].model.map(&mut |_| {
        next += 1;
        L::from_lanes(|l| parameters[l][next - 1])
    })
}

/// The derivatives of all cases, [`Lane::N`] at once, each lane with a body, a time, a state and inputs of its own.
pub fn derivatives<L: Lane>(cases: &[Case]) -> Vec<Vec<f64>> {
    let mut out: Vec<_> = cases.iter().map(|c| vec![0.0; c.x.len()]).collect();
    for (cases, out) in cases.chunks(L::N).zip(out.chunks_mut(L::N)) {
        L::call(
            #[inline(always)]
            || {
                let body = gather::<L>(cases);
                let t = L::from_lanes(|l| cases[l].t);
                let (mut x, mut u) = (vec![L::zero(); cases[0].x.len()], vec![L::zero(); cases[0].u.len()]);
                for (i, x) in x.iter_mut().enumerate() {
                    *x = L::from_lanes(|l| cases[l].x[i]);
                }
                for (i, u) in u.iter_mut().enumerate() {
                    *u = L::from_lanes(|l| cases[l].u[i]);
                }
                let mut dx = x.clone();
                body.derivative(t, &x, &u, &mut dx);
                for (l, out) in out.iter_mut().enumerate() {
                    for (o, d) in out.iter_mut().zip(&dx) {
                        *o = d.get(l);
                    }
                }
            },
        );
    }
    out
}

#[test]
fn a_lane_is_the_number_alone_bit_for_bit() {
    let mut random = Random(20);
    for (kind, make) in kinds().into_iter().flat_map(|kind| MAKES.map(|make| (kind, make))) {
        let cases: Vec<Case> = (0..CASES).map(|_| make(&mut random, kind)).collect();
        for isa in Isa::available() {
            let alone = with_scalar!(isa, S => derivatives::<S>(&cases));
            let lanes = with_lanes!(isa, L => derivatives::<L>(&cases));
            for (l, (lane, alone)) in lanes.iter().zip(&alone).enumerate() {
                let equal = lane.iter().zip(alone).all(|(a, b)| same(*a, *b));
                assert!(equal, "{kind:?} on {isa:?}, lane {l}: {lane:?}, alone {alone:?}");
            }
        }
    }
}

#[test]
fn fused_products_differ_by_two_units_an_operation() {
    let mut random = Random(21);
    for kind in kinds() {
        let cases: Vec<Case> = (0..CASES).map(|_| case(&mut random, kind)).collect();
        let plain = derivatives::<f64>(&cases);
        let fused = with_scalar!(Isa::detect(), S => derivatives::<S>(&cases));
        for ((case, plain), fused) in cases.iter().zip(plain).zip(fused) {
            let constants = |x: &[f64]| -> Vec<Bounded> { x.iter().map(|v| Bounded::lit(*v)).collect() };
            let mut allowed = constants(&case.x);
            let body: FreeBody<Bounded> = case.model.lift();
            body.derivative(Bounded::lit(case.t), &constants(&case.x), &constants(&case.u), &mut allowed);
            let size = plain.iter().fold(1.0, |m, x| f64::max(m, x.abs()));
            for ((p, f), b) in plain.iter().zip(fused).zip(allowed) {
                assert!((p - f).abs() <= b.bound, "{kind:?}: {p} is not {f} to {}", b.bound);
                // The bound is worth something: some hundred operations of well-conditioned numbers.
                assert!(b.bound < 1e-11 * size, "{kind:?}: {} of {size}", b.bound);
            }
        }
    }
}
