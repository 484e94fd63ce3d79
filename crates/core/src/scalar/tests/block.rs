//! Functions that were compiled elsewhere.

use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Block, Dual, Lane, Real};

/// The sum of its arguments, and as many times that as the place of the result says.
#[derive(Debug)]
struct Sums;

impl Block for Sums {
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]) {
        for l in 0..lanes {
            let sum: f64 = given.iter().skip(l).step_by(lanes).sum();
            for (i, column) in out.chunks_mut(lanes).enumerate() {
                column[l] = (i + 1) as f64 * sum;
            }
        }
    }
}

fn check<L: Lane>(arguments: usize) {
    L::call(
        #[inline(always)]
        || {
            let mut given = vec![L::zero(); arguments];
            for (i, x) in given.iter_mut().enumerate() {
                *x = L::from_lanes(
                    #[inline(always)]
                    |l| (i * l) as f64,
                );
            }
            let mut out = [L::zero(); 3];
            assert!(L::outside(&Sums, &given, &mut out));
            for (i, x) in out.into_iter().enumerate() {
                for l in 0..L::N {
                    assert_eq!(x.get(l), ((i + 1) * l * arguments * arguments.saturating_sub(1) / 2) as f64);
                }
            }
        },
    );
}

#[test]
fn a_block_sees_each_lane_alone() {
    // On both sides of what the stack holds.
    for arguments in [0, 1, 5, 61, 62, 600] {
        for isa in Isa::available() {
            with_scalar!(isa, L => check::<L>(arguments));
            with_lanes!(isa, L => check::<L>(arguments));
        }
    }
}

#[test]
fn a_derivative_cannot_pass_through() {
    let mut out = [Dual::<f64, 1>::one()];
    assert!(!Dual::outside(&Sums, &[Dual::one()], &mut out));
    assert_eq!(out[0].value, 1.0);
}
