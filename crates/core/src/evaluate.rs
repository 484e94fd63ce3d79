//! A body made ready for this machine: f and its Jacobians at single states, on the best instruction set.

use crate::linearize;
use crate::phase_space::FreeBody;
use crate::phase_space::parts::{Parts, Sizes};
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::{Dual, Lane};

/// Inputs up to this count are passed on the stack.
const ON_STACK: usize = 16;

/// Directions a lane holds in one pass of a Jacobian: more make fewer passes, but long code that is no faster.
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

/// The number that a one-number type holds.
#[inline(always)]
fn number<S: Lane>(x: S) -> f64 {
    x.get(0)
}

impl<S: Lane, L: Lane> Evaluate for On<S, L> {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        // `S` rounds as a lane of `L` does, and in its instruction set it has more registers than in its own.
        L::call(
            #[inline(always)]
            || {
                let mut stack = [S::zero(); ON_STACK];
                let mut heap = Vec::new();
                let input = if u.len() <= ON_STACK {
                    &mut stack[..u.len()]
                } else {
                    heap.resize(u.len(), S::zero());
                    &mut heap[..]
                };
                for (a, b) in input.iter_mut().zip(u) {
                    *a = S::lit(*b);
                }
                let (sizes, all) = (self.values.sizes(), Sizes::LARGEST);
                let mut state = [S::zero(); Sizes::LARGEST.state()];
                let mut rate = state;
                Parts::of(x, sizes).convert(Parts::of_mut(&mut state, all), S::lit);
                self.values.rate(S::lit(t), Parts::of(&state, all), input, Parts::of_mut(&mut rate, all));
                Parts::of(&rate, all).convert(Parts::of_mut(dx, sizes), number);
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
