//! f and its Jacobians at many states at once, a state a lane, on threads; behind [`crate::evaluate::Evaluator`].
//!
//! Arrays are kept by component: all states' first numbers, then all second ones. Nothing is checked: where f does
//! not exist the results are not finite.

mod blocks;
mod columns;
mod derivatives;
mod jacobians;
mod layout;

pub(crate) use derivatives::derivatives;
pub(crate) use jacobians::{closed_jacobians, dual_jacobians};
pub(crate) use layout::Layout;

/// States to be evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    /// How many.
    pub count: usize,
    /// Times, s: one for all or one for each.
    pub t: &'a [f64],
    /// States, by component.
    pub x: &'a [f64],
    /// Inputs, by component, for each or one number for all.
    pub u: &'a [f64],
    /// How many inputs.
    pub inputs: usize,
}
