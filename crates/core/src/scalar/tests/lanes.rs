//! A lane of a register is the number that runs alone, bit for bit.
//!
//! All fused types are compared to `Fused`, and so to one another.

use super::{Random, same};
use crate::scalar::isa::{Isa, with_lanes, with_scalar};
use crate::scalar::{Interpolation, Lane, Real, Table};

const RESULTS: usize = 18;

/// Every operation of [`Real`], and an expression that mixes them.
#[inline(always)]
fn operations<T: Real>(a: T, b: T, c: T, table: &Table) -> [T; RESULTS] {
    let (s, k) = a.sin_cos();
    let mut mixed = a;
    for _ in 0..5 {
        let (s, k) = (mixed * b).sin_cos();
        let bent = T::select_le(s, k, s.fma(c, k) / (b.squared() + T::one()), (k - s).abs().sqrt());
        mixed = bent.min(c).max(-b).fma(mixed, T::lit(0.1)) + bent.lookup(table);
    }
    [
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        T::lit(0.3),
        a.fma(b, c),
        a.sqrt(),
        a.abs(),
        s,
        k,
        T::select_le(a, b, c, a),
        a.lookup(table),
        a.squared(),
        a.min(b),
        a.max(b),
        T::zero() - T::one(),
        mixed,
    ]
}

/// Rows of results from rows of three arguments, [`Lane::N`] rows at a time.
fn run<L: Lane>(rows: &[[f64; 3]], table: &Table) -> Vec<[f64; RESULTS]> {
    let mut out = vec![[0.0; RESULTS]; rows.len()];
    L::call(
        #[inline(always)]
        || {
            for start in (0..rows.len()).step_by(L::N) {
                let arg = [0, 1, 2].map(
                    #[inline(always)]
                    |i| L::from_lanes(|l| rows[start + l][i]),
                );
                let all = operations(arg[0], arg[1], arg[2], table);
                for l in 0..L::N {
                    for i in 0..RESULTS {
                        out[start + l][i] = all[i].get(l);
                    }
                }
            }
        },
    );
    out
}

fn table() -> Table {
    Table::new(&[-1.0, 0.0, 0.0, 2.0], &[3.0, 1.0, -1.0, 0.5], Interpolation::Linear).unwrap()
}

fn arguments() -> Vec<[f64; 3]> {
    let special =
        [0.0, -0.0, 1.0, -2.5, 1e-310, 3e5, -7e9, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let mut rows = Vec::new();
    for a in special {
        for b in special {
            rows.extend(special.map(|c| [a, b, c]));
        }
    }
    let mut random = Random(4);
    // A number of rows that every width divides.
    while rows.len() < 8 * 1000 {
        let size = random.between(-3.0, 5.2);
        rows.push([0; 3].map(|_| random.between(-1.0, 1.0) * 10f64.powf(size)));
    }
    rows
}

fn assert_same(got: &[[f64; RESULTS]], expected: &[[f64; RESULTS]], rows: &[[f64; 3]], isa: Isa) {
    for ((got, expected), row) in got.iter().zip(expected).zip(rows) {
        for i in 0..RESULTS {
            let (g, e) = (got[i], expected[i]);
            assert!(same(g, e), "{isa:?}, result {i} of {row:?}: {g:e} in a lane, {e:e} alone");
        }
    }
}

#[test]
fn every_operation_is_that_of_the_number_alone() {
    let (rows, table) = (arguments(), table());
    for isa in Isa::available() {
        let alone = with_scalar!(isa, S => run::<S>(&rows, &table));
        let lanes = with_lanes!(isa, L => run::<L>(&rows, &table));
        assert_same(&lanes, &alone, &rows, isa);
    }
}

#[test]
fn a_lane_does_not_see_its_neighbours() {
    fn check<L: Lane>(isa: Isa) {
        let table = table();
        let mut random = Random(5);
        for neighbour in [f64::NAN, f64::INFINITY, 1e22, -1.1e5, 0.0, 0.7] {
            for l in 0..L::N {
                let row = [0; 3].map(|_| random.between(-20.0, 20.0));
                let mut crowd = vec![[neighbour; 3]; L::N];
                crowd[l] = row;
                let company = run::<L>(&crowd, &table);
                let alone = run::<L>(&vec![row; L::N], &table);
                assert_same(&company[l..=l], &alone[l..=l], &[row], isa);
            }
        }
    }
    for isa in Isa::available() {
        with_lanes!(isa, L => check::<L>(isa));
    }
}

#[test]
fn lanes_are_set_and_read_one_by_one() {
    fn check<L: Lane>() {
        L::call(
            #[inline(always)]
            || {
                let count = L::from_lanes(|l| l as f64);
                for l in 0..L::N {
                    let changed = count.with(l, -1.0);
                    for i in 0..L::N {
                        assert_eq!(count.get(i), i as f64);
                        assert_eq!(changed.get(i), if i == l { -1.0 } else { i as f64 });
                    }
                }
            },
        );
    }
    for isa in Isa::available() {
        with_scalar!(isa, L => check::<L>());
        with_lanes!(isa, L => check::<L>());
    }
}

#[test]
fn all_le_needs_every_lane() {
    fn check<L: Lane>() {
        L::call(
            #[inline(always)]
            || {
                assert!(L::all_le(L::one(), L::one()));
                for l in 0..L::N {
                    assert!(L::all_le(L::one().with(l, f64::NEG_INFINITY), L::one()));
                    assert!(!L::all_le(L::one().with(l, 1.0f64.next_up()), L::one()));
                    assert!(!L::all_le(L::one().with(l, f64::NAN), L::one()));
                    assert!(!L::all_le(L::one(), L::one().with(l, f64::NAN)));
                }
            },
        );
    }
    for isa in Isa::available() {
        with_scalar!(isa, L => check::<L>());
        with_lanes!(isa, L => check::<L>());
    }
}

#[test]
fn the_best_instruction_set_is_available() {
    assert!(Isa::available().contains(&Isa::Baseline));
    assert!(Isa::available().contains(&Isa::detect()));
}
