//! What makes a method of Runge-Kutta kind.

/// The nonzero coefficients of a weighted sum of stages: `(stage, coefficient)`.
pub type Row = &'static [(usize, f64)];

/// One stage of a method: of an explicit one `k = f(t + c h, y + h Σ a_j k_j)`.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Its place in the step.
    pub c: f64,
    /// Its weights of the stages before it.
    pub a: Row,
}

/// How the stages of a method are found.
#[derive(Clone, Copy, Debug)]
pub enum Solve {
    /// One after another, each from those before it.
    Explicit,
    /// All from each other, by iteration.
    Iterated(Iterated),
    /// One after another, each from a linear system with the Jacobian of the right-hand side.
    Linear(Linear),
}

/// Stages that depend on each other: `k_i = b_i f(t + c_i h, y + h Σ a_ij k_j)`.
#[derive(Clone, Copy, Debug)]
pub struct Iterated {
    /// The factor `b` of each stage.
    pub weights: &'static [f64],
    /// The stages of the next step, but for the first, guessed from those of this one.
    pub guess: &'static [Row],
}

/// Stages of a Rosenbrock-Wanner method: `(1/γ - h ∂f/∂y) k_i = f(t + c_i h, y + h Σ a_ij k_j) + Σ c_ij k_j +
/// h d_i ∂f/∂t`.
#[derive(Clone, Copy, Debug)]
pub struct Linear {
    /// The number γ.
    pub gamma: f64,
    /// The weights `c_ij` of the stages before each.
    pub rows: &'static [Row],
    /// The numbers `d_i`.
    pub by_time: &'static [f64],
}

/// A one-step method with continuous output.
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
    /// How the stages are found.
    const SOLVE: Solve = Solve::Explicit;
    /// The stages of a trial step; the first is the derivative at its beginning.
    const STAGES: &'static [Stage];
    /// The weights of the solution.
    const WEIGHTS: Row;
    /// The error estimates: none for a method with fixed step, else one, or two of which the second is of
    /// low order and steadies the first: `e = e1² / √(e1² + 0.01 e2²)` (Hairer, Nørsett & Wanner, II.10).
    const ERROR: &'static [Row];
    /// What the second error estimate is more than the change of the state, where that takes fewer products.
    const ERROR_BEYOND_CHANGE: Option<Row> = None;
    /// Whether of two error estimates the larger counts instead.
    const LARGER_ERROR: bool = false;
    /// Whether the error estimate needs the derivative at the end of the step.
    const FIRST_SAME_AS_LAST: bool;
    /// Stages for the continuous output alone, numbered from `STAGES.len() + 1`.
    const DENSE_STAGES: &'static [Stage];
    /// Weights of the second and third term of the continuous output; without them, those of the cubic that fits
    /// values and derivatives at both ends.
    const DENSE_CUBIC: Option<[Row; 2]> = None;
    /// Weights of the terms of the continuous output beyond the third.
    const DENSE: &'static [Row];
}
