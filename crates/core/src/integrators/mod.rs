//! Integration of ordinary differential equations over lanes, by methods of Runge-Kutta kind.
//!
//! Every lane of a [`Stepper`] is a trajectory with its own time, step size and acceptance; what a lane
//! computes does not depend, to the last bit, on what its neighbours do. The caller drives:
//! [`Stepper::attempt`] tries a step, [`Stepper::dense`] and [`Stepper::interpolate`] give the solution
//! inside it, [`Stepper::commit`] accepts or rejects it; after that, and before the next attempt, lanes may
//! be started and restarted. Nothing here knows of bodies.

mod collocation;
mod controller;
mod dense;
mod dop853;
mod dp54;
mod gauss6;
mod jacobian;
mod lanes;
mod lu;
mod method;
mod rigid;
mod rk4;
mod rodas5p;
mod rosenbrock;
mod start;
mod step;
mod stepper;
mod sums;
#[cfg(test)]
mod tests;
mod vern8;
mod vern9;

use crate::scalar::Lane;
pub use dop853::Dop853;
pub use dp54::Dp54;
pub use gauss6::Gauss6;
pub use jacobian::differentiate;
pub use lanes::Lanes;
pub use method::{Iterated, Linear, Method, Row, Solve, Stage};
pub use rk4::Rk4;
pub use rodas5p::Rodas5P;
pub(crate) use stepper::write_lane;
pub use stepper::{Stepper, Trial, Verdict};
pub use vern8::Vern8;
pub use vern9::Vern9;

/// The size of a state that there is code of its own for: that of a rigid body in quaternions.
const RIGID: usize = 13;

/// A system of ordinary differential equations `dy/dt = f(t, y)`.
pub trait System<T> {
    /// The number of components of `y`.
    fn size(&self) -> usize;
    /// Writes `f(t, y)` to `dy`.
    ///
    /// Implementations outline their body through [`crate::scalar::Real::call`].
    fn derivative(&self, t: T, y: &[T], dy: &mut [T]);
    /// Writes `∂f/∂t` to `by_time` and `∂f/∂y` to `by_state`, by rows; only methods with [`Solve::Linear`] ask.
    ///
    /// Without an implementation they are not numbers, and such a method takes no step.
    ///
    /// Implementations outline their body, as that of the derivative; see [`differentiate`].
    fn jacobian(&self, _t: T, _y: &[T], by_time: &mut [T], by_state: &mut [T])
    where
        T: Lane,
    {
        T::call(
            #[inline(always)]
            || {
                by_time.fill(T::lit(f64::NAN));
                by_state.fill(T::lit(f64::NAN));
            },
        );
    }
    /// The same but for the components before [`System::first_read`], which may stay as they are.
    #[inline(always)]
    fn derivative_read(&self, t: T, y: &[T], dy: &mut [T]) {
        self.derivative(t, y, dy);
    }
    /// The first component that [`System::derivative`] reads: those before it are quadratures.
    #[inline(always)]
    fn first_read(&self) -> usize {
        0
    }
    /// Puts the end of a step back on the manifold where it belongs, a unit quaternion for one.
    ///
    /// The correction must be of the size of the local error: it is not in the error estimate.
    #[inline(always)]
    fn project(&self, _y: &mut [T]) {}
    /// How the error of the state is weighed.
    fn error_blocks(&self) -> &[Block];
}

/// A vector within the state whose error is measured by its length, however its axes are turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Index of the first component.
    pub start: usize,
    /// Number of components.
    pub len: usize,
    /// What its error is compared with.
    pub scale: ErrorScale,
}

/// What the error of a [`Block`] is compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ErrorScale {
    /// The length of the block: `absolute + relative · length`, taken as a root of squares.
    Relative,
    /// This size, whatever the block: `relative · size`. One for angles; a half for unit quaternions, whose error
    /// is half of the angle that it means.
    Fixed(f64),
}

/// The error allowed to one step.
///
/// With `e_b` the estimated error of block `b` and `y0_b`, `y1_b` its values at both ends of the step,
/// a step is accepted when `|e_b|² / s_b²` is at most one for every block, where
/// `s_b² = absolute² + relative² max(|y0_b|², |y1_b|²)`, or `relative² size²` for [`ErrorScale::Fixed`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Relative to the length of a block.
    pub relative: f64,
    /// In the unit of a block.
    pub absolute: f64,
}
