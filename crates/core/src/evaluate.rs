//! A body made ready for this machine: f and its Jacobians at single states, on the best instruction set.

use crate::buffer::Buffer;
use crate::bulk::{Points, always_zero, closed_jacobians, derivatives, dual_jacobians};
use crate::linearize;
use crate::phase_space::parts::{Parts, Sizes};
use crate::phase_space::{Entries, FreeBody, elsewhere};
use crate::scalar::isa::{Isa, with_lanes};
use crate::scalar::{Block, Dual, Lane};
use std::sync::Arc;

/// Inputs up to this count are passed on the stack.
const ON_STACK: usize = 16;

/// Directions a lane holds in one pass of a Jacobian: more make fewer passes, but long code that is no faster.
const DIRECTIONS: usize = 1;

/// f and its Jacobians over one choice of scalars.
trait Evaluate: Send + Sync {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]);
    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]);
    fn derivatives(&self, points: &Points<'_>, out: &mut [f64], threads: usize);
    fn jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize);
}

/// The body over a single number `S` for values, and over lanes `L` of directions for derivatives.
struct On<S, L> {
    values: FreeBody<S>,
    lanes: FreeBody<L>,
    duals: FreeBody<Dual<L, DIRECTIONS>>,
    /// If the Jacobian has a closed form, the entries that are always zero.
    zeros: Option<Vec<usize>>,
}

/// The two parts of a Jacobian that is written.
struct Parted<'a> {
    by_state: &'a mut [f64],
    by_input: &'a mut [f64],
    states: usize,
    inputs: usize,
}

impl<S: Lane> Entries<S> for Parted<'_> {
    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, value: S) {
        let place = match column.checked_sub(self.states) {
            None => &mut self.by_state[row * self.states + column],
            Some(input) => &mut self.by_input[row * self.inputs + input],
        };
        *place = number(value);
    }
}

/// The number that a one-number type holds.
#[inline(always)]
fn number<S: Lane>(x: S) -> f64 {
    x.get(0)
}

impl<S: Lane, L: Lane> On<S, L> {
    /// The derivative under laws of users, with their states. Apart: without them all numbers have fixed places.
    #[inline(never)]
    fn with_laws<const LEFT: bool>(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        L::call(
            #[inline(always)]
            || {
                let numbers = x.iter().chain(u).copied();
                let mut given = Buffer::<S, { 2 * ON_STACK }>::new(x.len() + u.len());
                let given = given.slice();
                for (to, v) in given.iter_mut().zip(numbers) {
                    *to = S::lit(v);
                }
                let (x, u) = given.split_at(x.len());
                let mut rate = Buffer::<S, { 2 * ON_STACK }>::new(x.len());
                let rate = rate.slice();
                let sizes = self.values.sizes();
                let (from, to) = (Parts::of(x, sizes), Parts::of_mut(rate, sizes));
                self.values.rate::<true, LEFT>(S::lit(t), from, u, to);
                for (d, r) in dx.iter_mut().zip(rate) {
                    *d = number(*r);
                }
            },
        );
    }
}

impl<S: Lane, L: Lane> On<S, L> {
    /// The Jacobian by its entries that are not always zero.
    fn closed_jacobian(&self, x: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        L::call(
            #[inline(always)]
            || {
                by_state.fill(0.0);
                by_input.fill(0.0);
                let mut state = [S::zero(); Sizes::LARGEST.rigid()];
                for (to, x) in state.iter_mut().zip(x) {
                    *to = S::lit(*x);
                }
                let inputs = by_input.len() / x.len();
                let mut out = Parted { by_state, by_input, states: x.len(), inputs };
                self.values.write_jacobian(&state[..x.len()], &mut out);
            },
        );
    }
}

impl<S: Lane, L: Lane> Evaluate for On<S, L> {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        if self.values.left.is_some() {
            return self.with_laws::<true>(t, x, u, dx);
        }
        if x.len() > self.values.rigid_size() || self.values.has_laws() {
            return self.with_laws::<false>(t, x, u, dx);
        }
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
                let mut state = [S::zero(); Sizes::LARGEST.rigid()];
                let mut rate = state;
                Parts::of(x, sizes).convert(Parts::of_mut(&mut state, all), S::lit);
                // Were the ends of state and rate passed on, both would have to be in memory throughout.
                let from = Parts { auxiliary: &[][..], ..Parts::of(&state, all) };
                let to = Parts { auxiliary: &mut [][..], ..Parts::of_mut(&mut rate, all) };
                self.values.rate::<false, false>(S::lit(t), from, input, to);
                Parts::of(&rate, all).convert(Parts::of_mut(dx, sizes), number);
            },
        );
    }

    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        if self.zeros.is_some() {
            return self.closed_jacobian(x, by_state, by_input);
        }
        L::call(
            #[inline(always)]
            || linearize::jacobian::<L, DIRECTIONS, _>(&self.duals, t, x, u, by_state, by_input),
        );
    }

    fn derivatives(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        derivatives(&self.lanes, points, out, threads);
    }

    fn jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        match &self.zeros {
            Some(zeros) => closed_jacobians(&self.lanes, zeros, points, out, threads),
            None => dual_jacobians(&self.duals, points, out, threads),
        }
    }
}

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
            let (values, lanes, duals) = (body.lift(), body.lift(), body.lift());
            let zeros = body.has_closed_jacobian().then(|| always_zero(body));
            let kernel = On::<<L as Lane>::Single, L> { values, lanes, duals, zeros };
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
}
