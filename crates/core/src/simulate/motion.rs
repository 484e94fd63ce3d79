//! A body and its inputs as a system that the integrators know; in lanes, each with parameters of its own.

use super::inputs::{Inputs, add_tables};
use crate::buffer::Buffer;
use crate::forces::Usual;
use crate::integrators::{Block, System, differentiate};
use crate::phase_space::{Dynamics, FreeBody};
use crate::scalar::{Dual, Lane, Table};
use std::cell::OnceCell;
use std::convert::identity;

/// Inputs up to this count are passed on the stack.
const ON_STACK: usize = 8;

/// A free body under given inputs.
pub struct Motion<'a, T> {
    /// The body as the lanes have it.
    pub body: FreeBody<T>,
    original: &'a FreeBody<f64>,
    /// What the tables are added to.
    constants: Vec<T>,
    tables: &'a [Table],
    /// Of the body, see [`FreeBody::parameters`].
    parameters: Vec<T>,
    /// The body over duals, once a method has asked for a Jacobian.
    duals: OnceCell<FreeBody<Dual<T, 1>>>,
    blocks: Vec<Block>,
    first_read: usize,
    /// The usual forces under constant inputs on a body that [`FreeBody::straight_rate`] knows.
    straight: Option<Usual<T>>,
}

impl<'a, T: Lane> Motion<'a, T> {
    /// The same body and inputs in all lanes.
    pub fn new(body: &'a FreeBody<f64>, inputs: &'a Inputs) -> Self {
        let mut constants = Vec::with_capacity(inputs.constants.len());
        T::call(
            #[inline(always)]
            || {
                for constant in &inputs.constants {
                    constants.push(T::lit(*constant));
                }
            },
        );
        let mut made = Self {
            body: body.lift(),
            original: body,
            constants,
            tables: &inputs.tables,
            parameters: Vec::new(),
            duals: OnceCell::new(),
            blocks: Dynamics::<f64>::error_blocks(body),
            first_read: if body.reads_position() { 0 } else { 3 },
            straight: None,
        };
        made.settle();
        made
    }

    /// Puts together what does not change any more; what compiled derivatives do is not known.
    fn settle(&mut self) {
        let settled = self.body.compiled.is_none() && self.tables.is_empty();
        self.straight = match self.body.plain_forces() {
            Some(acting) if settled => T::call(
                #[inline(always)]
                || Some(acting.usual.with_constant(&self.constants)),
            ),
            _ => None,
        };
    }

    /// Gives lane `l` other constant inputs, which hold from the next [`Motion::renew`] on; tables are added to them.
    pub fn set_inputs(&mut self, l: usize, constants: &[f64]) {
        T::call(
            #[inline(always)]
            || {
                for (all, own) in self.constants.iter_mut().zip(constants) {
                    *all = all.with(l, *own);
                }
            },
        );
    }

    /// Gives lane `l` other [`FreeBody::parameters`]; they hold from the next [`Motion::renew`] on.
    pub fn set_parameters(&mut self, l: usize, parameters: &[f64]) {
        T::call(
            #[inline(always)]
            || {
                if self.parameters.is_empty() {
                    self.parameters.resize(parameters.len(), T::zero());
                }
                for (all, own) in self.parameters.iter_mut().zip(parameters) {
                    *all = all.with(l, *own);
                }
            },
        );
    }

    /// Makes the body of the parameters that the lanes were given, and what comes of their inputs. What was compiled
    /// elsewhere knows none of the parameters.
    pub fn renew(&mut self) {
        if !self.parameters.is_empty() {
            self.renew_body();
        }
        self.settle();
    }

    fn renew_body(&mut self) {
        T::call(
            #[inline(always)]
            || {
                let mut all = self.parameters.iter();
                // Attributes stand on closures in arguments alone.
                let mut next = identity(
                    #[inline(always)]
                    |_| *all.next().expect("as many as the body has"),
                );
                self.body = self.original.map(&mut next);
                self.duals = OnceCell::new();
            },
        );
    }

    /// How many inputs there are.
    #[inline(always)]
    pub fn input_count(&self) -> usize {
        self.constants.len()
    }

    /// Writes u(t) with its rate.
    #[inline(always)]
    pub fn inputs_along(&self, t: T, u: &mut [Dual<T, 1>]) {
        for (u, constant) in u.iter_mut().zip(&self.constants) {
            *u = Dual::constant(*constant);
        }
        add_tables(self.tables, Dual { value: t, slope: [T::one()] }, u);
    }

    /// Writes u(t), each lane at its own time.
    #[inline(always)]
    pub fn inputs_at(&self, t: T, u: &mut [T]) {
        for (u, constant) in u.iter_mut().zip(&self.constants) {
            *u = *constant;
        }
        add_tables(self.tables, t, u);
    }
}

impl<T: Lane> System<T> for Motion<'_, T> {
    #[inline(always)]
    fn size(&self) -> usize {
        self.body.state_size()
    }

    #[inline(always)]
    fn derivative(&self, t: T, y: &[T], dy: &mut [T]) {
        if let Some(usual) = &self.straight {
            return self.body.straight_rate::<true>(usual, t, y, &self.constants, dy);
        }
        if self.tables.is_empty() {
            return self.body.derivative(t, y, &self.constants, dy);
        }
        T::call(
            #[inline(always)]
            || {
                let mut u = Buffer::<T, ON_STACK>::new(self.constants.len());
                self.inputs_at(t, u.slice());
                self.body.derivative(t, y, u.slice(), dy);
            },
        );
    }

    #[inline(always)]
    fn derivative_read(&self, t: T, y: &[T], dy: &mut [T]) {
        match &self.straight {
            Some(usual) => self.body.straight_rate::<false>(usual, t, y, &self.constants, dy),
            None => self.derivative(t, y, dy),
        }
    }

    fn jacobian(&self, t: T, y: &[T], by_time: &mut [T], by_state: &mut [T]) {
        T::call(
            #[inline(always)]
            || {
                if self.duals.get().is_none() {
                    let duals = self.body.map(&mut Dual::constant);
                    // It was empty.
                    let _ = self.duals.set(duals);
                }
                let body = self.duals.get().expect("made above");
                differentiate(
                    t,
                    y,
                    by_time,
                    by_state,
                    #[inline(always)]
                    |t, y, dy| {
                        let mut u = Buffer::<Dual<T, 1>, ON_STACK>::new(self.constants.len());
                        let u = u.slice();
                        for (u, constant) in u.iter_mut().zip(&self.constants) {
                            *u = Dual::constant(*constant);
                        }
                        add_tables(self.tables, t, u);
                        body.derivative(t, y, u, dy);
                    },
                );
            },
        );
    }

    #[inline(always)]
    fn first_read(&self) -> usize {
        self.first_read
    }

    #[inline(always)]
    fn project(&self, y: &mut [T]) {
        self.body.project(y);
    }

    #[inline(always)]
    fn error_blocks(&self) -> &[Block] {
        &self.blocks
    }
}
