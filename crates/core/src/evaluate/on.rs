//! f and its Jacobians over one choice of scalars.

use crate::buffer::Buffer;
use crate::bulk::{Layout, Points, closed_jacobians, derivatives, dual_jacobians};
use crate::forces::Usual;
use crate::linearize;
use crate::phase_space::parts::{Parts, Sizes};
use crate::phase_space::{ClosedJacobian, Dynamics, Entries, FreeBody, STATES};
use crate::scalar::{Dual, Lane};

/// Inputs up to this count are passed on the stack.
const ON_STACK: usize = 16;

/// And up to this many of a body under the usual forces: those of one wrench.
const PLAIN_INPUTS: usize = 6;

/// Sums that are kept at the same time, so that none waits for the one before.
const CHAINS: usize = 4;

/// Directions a lane holds in one pass of a Jacobian: more make fewer passes, but long code that is no faster.
const DIRECTIONS: usize = 1;

/// f and its Jacobians over one choice of scalars.
pub(super) trait Evaluate: Send + Sync {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]);
    fn plain_derivative(&self, x: &[f64], u: &[f64], dx: &mut [f64]) -> bool;
    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]);
    fn derivatives(&self, points: &Points<'_>, out: &mut [f64], threads: usize);
    fn jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize);
    fn sparse_jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize);
    fn jacobian_entries(&self) -> Option<&[(usize, usize)]>;
}

/// The body over a single number `S` for values, and over lanes `L` of directions for derivatives.
pub(super) struct On<S, L> {
    /// The forces without inputs on a body that [`FreeBody::plain_rate`] knows.
    unforced: Option<Usual<S>>,
    values: FreeBody<S>,
    lanes: FreeBody<L>,
    duals: FreeBody<Dual<L, DIRECTIONS>>,
    closed: Option<Closed>,
}

/// The closed form of the Jacobian, with where many of them are written.
struct Closed {
    form: ClosedJacobian,
    dense: Layout,
    sparse: Layout,
}

/// ∂f/∂x that is written.
struct ByState<'a>(&'a mut [f64; STATES * STATES]);

impl<S: Lane> Entries<S> for ByState<'_> {
    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, value: S) {
        self.0[row * STATES + column] = number(value);
    }
}

/// The number that a one-number type holds.
#[inline(always)]
fn number<S: Lane>(x: S) -> f64 {
    x.get(0)
}

/// Writes the numbers that a one-number type holds.
#[inline(always)]
fn put<S: Lane>(rate: [S; STATES], dx: &mut [f64]) {
    for (to, r) in dx.iter_mut().zip(rate) {
        *to = number(r);
    }
}

impl<S: Lane, L: Lane> On<S, L> {
    /// Of a body.
    pub fn new(body: &FreeBody<f64>) -> Self {
        let (values, lanes, duals) = (body.lift(), body.lift(), body.lift());
        let closed = ClosedJacobian::new(body).map(|form| {
            let (dense, sparse) = (Layout::dense(&form), Layout::sparse(&form));
            Closed { form, dense, sparse }
        });
        Self { unforced: unforced(&values, body.input_size()), values, lanes, duals, closed }
    }

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
    /// The derivative of a body that is no more than that, and zero, or NaN where a number that goes in or comes out
    /// is not finite.
    #[inline(always)]
    fn plain_rate(&self, unforced: &Usual<S>, x: &[f64; STATES], u: &[f64]) -> ([S; STATES], S) {
        let mut state = [S::zero(); STATES];
        for (to, x) in state.iter_mut().zip(x) {
            *to = S::lit(*x);
        }
        let (mut rate, mut poison) = (state, [S::zero(); CHAINS]);
        // Most are asked without inputs.
        if u.iter().all(|u| u.to_bits() == 0) {
            self.values.plain_rate_under::<true>(unforced, &state, &[], &mut rate);
        } else {
            let mut input = [S::zero(); PLAIN_INPUTS];
            for (to, u) in input.iter_mut().zip(u) {
                *to = S::lit(*u);
                poison[0] = to.fma(S::zero(), poison[0]);
            }
            self.values.plain_rate(&state, &input, &mut rate);
        }
        for (k, (x, r)) in state.iter().zip(&rate).enumerate() {
            let chain = &mut poison[k % CHAINS];
            *chain = r.fma(S::zero(), x.fma(S::zero(), *chain));
        }
        (rate, (poison[0] + poison[1]) + (poison[2] + poison[3]))
    }

    /// The Jacobian by its closed form.
    fn closed_jacobian(
        &self,
        closed: &ClosedJacobian,
        x: &[f64],
        by_state: &mut [f64],
        by_input: &mut [f64],
    ) {
        closed.write_constant(by_state, by_input);
        let (Some(x), Some(by_state)) = (x.first_chunk(), by_state.first_chunk_mut()) else { return };
        L::call(
            #[inline(always)]
            || {
                let mut state = [S::zero(); STATES];
                for (to, x) in state.iter_mut().zip(x as &[f64; STATES]) {
                    *to = S::lit(*x);
                }
                closed.write_varying(&state, &mut ByState(by_state));
            },
        );
    }
}

impl<S: Lane, L: Lane> Evaluate for On<S, L> {
    fn derivative(&self, t: f64, x: &[f64], u: &[f64], dx: &mut [f64]) {
        // `S` rounds as a lane of `L` does.
        if let (Some(unforced), Some(x)) = (&self.unforced, x.first_chunk()) {
            return S::call(
                #[inline(always)]
                || put(self.plain_rate(unforced, x, u).0, dx),
            );
        }
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

    fn plain_derivative(&self, x: &[f64], u: &[f64], dx: &mut [f64]) -> bool {
        let (Some(unforced), Some(x)) = (&self.unforced, x.first_chunk()) else { return false };
        S::call(
            #[inline(always)]
            || {
                let (rate, poison) = self.plain_rate(unforced, x, u);
                let finite = number(poison) == 0.0;
                if finite {
                    put(rate, dx);
                }
                finite
            },
        )
    }

    fn jacobian(&self, t: f64, x: &[f64], u: &[f64], by_state: &mut [f64], by_input: &mut [f64]) {
        if let Some(Closed { form, .. }) = &self.closed
            && form.inputs() == u.len()
        {
            return self.closed_jacobian(form, x, by_state, by_input);
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
        match &self.closed {
            Some(Closed { form, dense, .. }) if form.inputs() == points.inputs => {
                closed_jacobians::<L>(form, dense, points, out, threads);
            }
            _ => dual_jacobians(&self.duals, points, out, threads),
        }
    }

    fn sparse_jacobians(&self, points: &Points<'_>, out: &mut [f64], threads: usize) {
        match &self.closed {
            Some(Closed { form, sparse, .. }) => closed_jacobians::<L>(form, sparse, points, out, threads),
            None => dual_jacobians(&self.duals, points, out, threads),
        }
    }

    fn jacobian_entries(&self) -> Option<&[(usize, usize)]> {
        self.closed.as_ref().map(|closed| &closed.sparse.entries[..])
    }
}

/// The forces of a plain body of a few inputs, without them.
fn unforced<S: Lane>(body: &FreeBody<S>, inputs: usize) -> Option<Usual<S>> {
    let acting = body.acting.as_ref().filter(|_| body.is_plain() && inputs <= PLAIN_INPUTS)?;
    let zero = S::call(
        #[inline(always)]
        || acting.usual.with_constant(&[S::zero(); PLAIN_INPUTS]),
    );
    Some(zero)
}
