//! Gauss collocation of order 6.

use super::method::{Iterated, Method, Row, Solve, Stage};

/// Gauss collocation in three stages, of order 6, with fixed step; continuous output of order 5.
///
/// It keeps every quadratic invariant: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., II.1.3 and
/// IV.2.1. Each stage is kept times its weight `b`, with `a_ij / b_j` for the coefficients: these satisfy
/// `a_ij / b_j + a_ji / b_i = 1`, by which the invariants are kept, to the last bit (Antoñana, Makazaga & Murua,
/// *Numerical Algorithms* 76, 2017).
#[derive(Clone, Copy, Debug)]
pub struct Gauss6;

const ROOT_15: f64 = 3.872983346207417;
const NEAR: f64 = 0.5 + 3.0 / 20.0 * ROOT_15;
const FAR: f64 = 0.5 + 3.0 / 25.0 * ROOT_15;

impl Method for Gauss6 {
    const ORDER: usize = 6;
    const ERROR_ORDER: usize = 5;
    const DENSE_ORDER: usize = 5;
    const SOLVE: Solve = Solve::Iterated(Iterated {
        weights: &[1.0, 5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0],
        // The cubic through the stages and the end of a step, gone on into the next.
        guess: &[
            &[
                (1, (25.0 * ROOT_15 - 97.0) / 3.0),
                (2, (20.0 - 5.0 * ROOT_15) / 3.0),
                (3, (ROOT_15 - 10.0) / 3.0),
                (4, 65.0 / 9.0 - 5.0 * ROOT_15 / 3.0),
            ],
            &[
                (1, 4.0 * ROOT_15 - 52.0 / 3.0),
                (2, 17.0 / 3.0),
                (3, -4.0 * ROOT_15 - 52.0 / 3.0),
                (4, 68.0 / 9.0),
            ],
            &[
                (1, (-ROOT_15 - 10.0) / 3.0),
                (2, (20.0 + 5.0 * ROOT_15) / 3.0),
                (3, (-25.0 * ROOT_15 - 97.0) / 3.0),
                (4, 65.0 / 9.0 + 5.0 * ROOT_15 / 3.0),
            ],
        ],
    });
    const STAGES: &'static [Stage] = &[
        Stage { c: 0.0, a: &[] },
        Stage { c: 0.5 - 0.1 * ROOT_15, a: &[(1, 0.5), (2, 1.0 - NEAR), (3, 1.0 - FAR)] },
        Stage { c: 0.5, a: &[(1, NEAR), (2, 0.5), (3, 1.0 - NEAR)] },
        Stage { c: 0.5 + 0.1 * ROOT_15, a: &[(1, FAR), (2, NEAR), (3, 0.5)] },
    ];
    const WEIGHTS: Row = &[(1, 1.0), (2, 1.0), (3, 1.0)];
    const ERROR: &'static [Row] = &[];
    const FIRST_SAME_AS_LAST: bool = false;
    // On the polynomial whose derivative is that of the stages and of both ends, of order four.
    const DENSE_STAGES: &'static [Stage] = &[
        Stage {
            c: 1.0 / 6.0,
            a: &[
                (0, 325.0 / 7776.0),
                (1, 37.0 / 162.0 + 25.0 / 432.0 * ROOT_15),
                (2, -1.0 / 324.0),
                (3, 37.0 / 162.0 - 25.0 / 432.0 * ROOT_15),
                (4, -5.0 / 7776.0),
            ],
        },
        Stage {
            c: 5.0 / 6.0,
            a: &[
                (0, 5.0 / 7776.0),
                (1, 125.0 / 162.0 + 25.0 / 432.0 * ROOT_15),
                (2, 325.0 / 324.0),
                (3, 125.0 / 162.0 - 25.0 / 432.0 * ROOT_15),
                (4, -325.0 / 7776.0),
            ],
        },
    ];
    // Its derivative is that of those two and of both ends.
    const DENSE: &'static [Row] = &[
        &[
            (0, -153.0 / 55.0),
            (1, -108.0 / 11.0),
            (2, -108.0 / 11.0),
            (3, -108.0 / 11.0),
            (4, 9.0 / 11.0),
            (5, 189.0 / 22.0),
            (6, 351.0 / 110.0),
        ],
        &[
            (0, 108.0 / 55.0),
            (1, 216.0 / 11.0),
            (2, 216.0 / 11.0),
            (3, 216.0 / 11.0),
            (4, 108.0 / 55.0),
            (5, -648.0 / 55.0),
            (6, -648.0 / 55.0),
        ],
    ];
}
