//! What makes a Runge-Kutta method.

/// The nonzero coefficients of a weighted sum of stages: `(stage, coefficient)`.
pub type Row = &'static [(usize, f64)];

/// One stage of a method: `k = f(t + c h, y + h Σ a_j k_j)`.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Its place in the step.
    pub c: f64,
    /// Its weights of the stages before it.
    pub a: Row,
}

/// An explicit Runge-Kutta method with continuous output.
///
/// Stages are numbered from 0; number `STAGES.len()` is the derivative at the end of the step, which the
/// next step begins with.
pub trait Method: 'static {
    /// Order of the solution that is carried on.
    const ORDER: usize;
    /// Order of the solution that the error is estimated against; the step size goes with its error.
    const ERROR_ORDER: usize;
    /// Order of the continuous output.
    const DENSE_ORDER: usize;
    /// The stages of a trial step; the first is the derivative at its beginning.
    const STAGES: &'static [Stage];
    /// The weights of the solution.
    const WEIGHTS: Row;
    /// The error estimates: none for a method with fixed step, else one, or two of which the second is of
    /// low order and steadies the first: `e = e1² / √(e1² + 0.01 e2²)` (Hairer, Nørsett & Wanner, II.10).
    const ERROR: &'static [Row];
    /// Whether the error estimate needs the derivative at the end of the step.
    const FIRST_SAME_AS_LAST: bool;
    /// Stages for the continuous output alone, numbered from `STAGES.len() + 1`.
    const DENSE_STAGES: &'static [Stage];
    /// Weights of the terms of the continuous output beyond the cubic that fits values and derivatives
    /// at both ends.
    const DENSE: &'static [Row];
}
