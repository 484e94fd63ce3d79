//! The method of Dormand and Prince of order 5.

use super::method::{Method, Row, Stage};

/// The Runge-Kutta method of Dormand and Prince of order 5(4), with continuous output of order 4.
///
/// J. R. Dormand, P. J. Prince (1980); Hairer, Nørsett & Wanner, *Solving Ordinary Differential
/// Equations I*, 2nd ed., II.5 table 5.2 and II.6.
#[derive(Clone, Copy, Debug)]
pub struct Dp54;

impl Method for Dp54 {
    const ORDER: usize = 5;
    const ERROR_ORDER: usize = 4;
    const DENSE_ORDER: usize = 4;
    const STAGES: &'static [Stage] = &[
        Stage { c: 0.0, a: &[] },
        Stage { c: 1.0 / 5.0, a: &[(0, 1.0 / 5.0)] },
        Stage { c: 3.0 / 10.0, a: &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)] },
        Stage { c: 4.0 / 5.0, a: &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)] },
        Stage {
            c: 8.0 / 9.0,
            a: &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)],
        },
        Stage {
            c: 1.0,
            a: &[
                (0, 9017.0 / 3168.0),
                (1, -355.0 / 33.0),
                (2, 46732.0 / 5247.0),
                (3, 49.0 / 176.0),
                (4, -5103.0 / 18656.0),
            ],
        },
    ];
    const WEIGHTS: Row = &[
        (0, 35.0 / 384.0),
        (2, 500.0 / 1113.0),
        (3, 125.0 / 192.0),
        (4, -2187.0 / 6784.0),
        (5, 11.0 / 84.0),
    ];
    const ERROR: &'static [Row] = &[&[
        (0, 71.0 / 57600.0),
        (2, -71.0 / 16695.0),
        (3, 71.0 / 1920.0),
        (4, -17253.0 / 339200.0),
        (5, 22.0 / 525.0),
        (6, -1.0 / 40.0),
    ]];
    const FIRST_SAME_AS_LAST: bool = true;
    const DENSE_STAGES: &'static [Stage] = &[];
    const DENSE: &'static [Row] = &[&[
        (0, -12715105075.0 / 11282082432.0),
        (2, 87487479700.0 / 32700410799.0),
        (3, -10690763975.0 / 1880347072.0),
        (4, 701980252875.0 / 199316789632.0),
        (5, -1453857185.0 / 822651844.0),
        (6, 69997945.0 / 29380423.0),
    ]];
}
