//! Six-degree-of-freedom dynamics of free rigid bodies in matrix form, about any body-fixed frame.
//!
//! The equations are those of V. A. Konoplev, "Matrix forms of the equations of motion of a free rigid
//! body" (1984). Every formula is written once, generic over [`scalar::Real`], and names its equation.
//! Linear part first, always; SI units and radians; quaternions scalar first.

pub mod algebra;
pub mod buffer;
pub mod bulk;
pub mod catalog;
pub mod charts;
pub mod ensemble;
pub mod evaluate;
pub mod expression;
pub mod forces;
pub mod generalized;
pub mod inertia;
pub mod integrators;
pub mod lagrange;
pub mod linearize;
pub mod newton_euler;
pub mod phase_space;
pub mod scalar;
pub mod screw;
pub mod simulate;
pub mod watch;

#[cfg(test)]
mod tests;
