//! The classical method of order 4, with fixed step.

use super::method::{Method, Row, Stage};

/// The Runge-Kutta method of order 4 with fixed step; its continuous output is the cubic through both ends.
///
/// W. Kutta (1901); Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.1.
#[derive(Clone, Copy, Debug)]
pub struct Rk4;

impl Method for Rk4 {
    const ORDER: usize = 4;
    const ERROR_ORDER: usize = 3;
    const DENSE_ORDER: usize = 3;
    const STAGES: &'static [Stage] = &[
        Stage { c: 0.0, a: &[] },
        Stage { c: 0.5, a: &[(0, 0.5)] },
        Stage { c: 0.5, a: &[(1, 0.5)] },
        Stage { c: 1.0, a: &[(2, 1.0)] },
    ];
    const WEIGHTS: Row = &[(0, 1.0 / 6.0), (1, 1.0 / 3.0), (2, 1.0 / 3.0), (3, 1.0 / 6.0)];
    const ERROR: &'static [Row] = &[];
    const FIRST_SAME_AS_LAST: bool = false;
    const DENSE_STAGES: &'static [Stage] = &[];
    const DENSE: &'static [Row] = &[];
}
