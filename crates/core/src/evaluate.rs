//! A body made ready for this machine: f and its Jacobians at single states, on the best instruction set.

use crate::linearize;
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::{Dual, Lane, Real};

/// Numbers up to this count are passed on the stack.
const ON_STACK: usize = 16;

/// Directions a lane holds in one pass of a Jacobian: enough for 13 states and 6 inputs in eight lanes.
const DIRECTIONS: usize = 1;

/// f and its Jacobians over one choice of scalars.
trait Evaluate: Send + Sync {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]);
    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]);
}

/// The body over a single number `S` for values, and over lanes `L` of directions for derivatives.
struct On<S, L> {
    values: FreeBody<S>,
    duals: FreeBody<Dual<L, DIRECTIONS>>,
}

/// Numbers of a slice as another scalar.
#[inline(always)]
fn fill<S: Real>(to: &mut [S], from: &[f64]) {
    for (a, b) in to.iter_mut().zip(from) {
        *a = S::lit(*b);
    }
}

impl<S: Lane, L: Lane> Evaluate for On<S, L> {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        S::call(
            #[inline(always)]
            || {
                let (n, m) = (x.len(), u.len());
                let mut stack = [S::zero(); 3 * ON_STACK];
                let mut heap = Vec::new();
                let all = if n <= ON_STACK && m <= ON_STACK {
                    &mut stack[..]
                } else {
                    heap.resize(2 * n + m, S::zero());
                    &mut heap[..]
                };
                let (state, rest) = all.split_at_mut(n);
                let (input, rest) = rest.split_at_mut(m);
                let rate = &mut rest[..n];
                fill(state, x);
                fill(input, u);
                self.values.derivative(S::lit(t), state, input, rate);
                for (a, b) in dx.iter_mut().zip(rate) {
                    *a = b.get(0);
                }
            },
        );
    }

    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        L::call(
            #[inline(always)]
            || linearize::jacobian::<L, DIRECTIONS, _>(&self.duals, t, x, u, by_state, by_input),
        );
    }
}

/// A free body made ready for this machine.
pub struct Evaluator(Box<dyn Evaluate>);

impl Evaluator {
    /// On the best instruction set of this machine.
    pub fn new(body: &FreeBody<f64>) -> Self {
        Self::on(Isa::detect(), body)
    }

    /// On one of the instruction sets that this machine has, [`Isa::available`].
    pub fn on(isa: Isa, body: &FreeBody<f64>) -> Self {
        assert!(Isa::available().contains(&isa), "this machine has no {isa:?}");
        with_lanes!(isa, L => {
            Self(Box::new(On::<<L as Lane>::Single, L> { values: body.lift(), duals: body.lift() }))
        })
    }

    /// dx = f(x, u, t); the slices are as long as state and input. Konoplev (3.2)
    pub fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        self.0.derivative(t, x, u, dx);
    }

    /// ∂f/∂x and ∂f/∂u, by rows, exact. Konoplev (3.2)
    pub fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        self.0.jacobian(t, x, u, by_state, by_input);
    }
}
