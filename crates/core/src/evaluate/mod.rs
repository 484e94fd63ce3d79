//! A body made ready for this machine: f and its Jacobians at single states, on the best instruction set.

mod on;

use crate::bulk::Points;
use crate::phase_space::{FreeBody, elsewhere};
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::{Block, Lane};
use on::{Evaluate, On};
use std::sync::Arc;

/// A free body made ready for this machine.
pub struct Evaluator {
    /// f, if it was compiled elsewhere.
    compiled: Option<Arc<dyn Block>>,
    kernel: Box<dyn Evaluate>,
}

impl Evaluator {
    /// On the best instruction set of this machine.
    pub fn new(body: &FreeBody<f64>) -> Self {
        Self::on(Isa::detect(), body)
    }

    /// On one of the instruction sets that this machine has, [`Isa::available`].
    pub fn on(isa: Isa, body: &FreeBody<f64>) -> Self {
        assert!(Isa::available().contains(&isa), "this machine has no {isa:?}");
        with_lanes!(isa, L => {
            let kernel = On::<<L as Lane>::Single, L>::new(body);
            let compiled = body.compiled.as_ref().map(|[block, _]| block.clone());
            Self { compiled, kernel: Box::new(kernel) }
        })
    }

    /// dx = f(x, u, t); the slices are as long as state and input. Konoplev (3.2)
    pub fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        match &self.compiled {
            Some(block) => {
                elsewhere(&**block, t, x, u, dx);
            }
            None => self.kernel.derivative(t, x, u, dx),
        }
    }

    /// The same of a body in quaternions and quasi-velocities under the usual forces alone, if all that goes in and
    /// comes out is finite; else nothing is written, and the answer is false. No inputs are zeros.
    pub fn plain_derivative(&self, x: &[f64], u: &[f64], dx: &mut [f64]) -> bool {
        self.compiled.is_none() && self.kernel.plain_derivative(x, u, dx)
    }

    /// ∂f/∂x and ∂f/∂u, by rows, exact. Konoplev (3.2)
    pub fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        self.kernel.jacobian(t, x, u, by_state, by_input);
    }

    /// f(x, u, t) of each point, by component. Konoplev (3.2)
    pub fn derivatives(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        self.kernel.derivatives(points, out, threads);
    }

    /// (∂f/∂x ∂f/∂u) of each point, by rows of the matrix, each entry of all points together. Konoplev (3.2)
    pub fn jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        self.kernel.jacobians(points, out, threads);
    }

    /// Rows and columns of the entries of (∂f/∂x ∂f/∂u) that can be other than zero, by rows; none if all can be, for
    /// all that is known.
    pub fn jacobian_entries(&self) -> Option<&[(usize, usize)]> {
        self.kernel.jacobian_entries()
    }

    /// These entries of each point, each of all points together.
    pub fn sparse_jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        self.kernel.sparse_jacobians(points, out, threads);
    }
}
