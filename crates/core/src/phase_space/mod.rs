//! The equations as x' = f(x, u, t): (3.1), (3.2).

mod dynamics;
mod free_body;
mod jacobian;
mod laws;
mod left;
mod lift;
mod orientation;
mod parameters;
pub(crate) mod parts;
mod pattern;
mod plain;
mod state;

pub use free_body::{Chart, Form, FreeBody};
pub(crate) use jacobian::{ClosedJacobian, Entries};
pub(crate) use laws::elsewhere;
pub use left::{Contents, Left, Spin};
pub use parameters::BODY_PARAMETERS;
pub use pattern::STATES;
pub(crate) use pattern::{PLACES, VARYING};
pub use state::RigidState;

use crate::algebra::Vec3;
use crate::charts::Sequence;
use crate::generalized::Generalized;
use crate::inertia::Inertia;
use crate::integrators::Block;
use crate::scalar::Real;
use crate::screw::Screw;

/// A system x' = f(x, u, t), written over one scalar.
///
/// Integration, linearization and ensembles need no more than this: they know no bodies.
pub trait Dynamics<T: Real> {
    /// How many numbers x has.
    fn state_size(&self) -> usize;
    /// How many numbers u has.
    fn input_size(&self) -> usize;
    /// dx = f(x, u, t).
    fn derivative(&self, t: T, x: &[T], u: &[T], dx: &mut [T]);
    /// Puts a state back on its manifold.
    fn project(&self, x: &mut [T]);
    /// The vectors that x is made of, for the error of a step.
    fn error_blocks(&self) -> Vec<Block>;
}

/// f of (3.1) with literal matrices: x = (q; q̇), x' = (q̇; A1⁻¹F − Φ1 q̇). Konoplev (3.1)
pub fn phase_velocity<T: Real>(body: &Inertia<T>, sequence: Sequence, x: &[T], wrench: Screw<T>) -> [T; 12] {
    let q_dot = Screw::from_slice(&x[6..12]);
    let g = Generalized::new(body, sequence, Vec3::from_slice(&x[3..6]), q_dot);
    let mut dx = [T::zero(); 12];
    q_dot.store(&mut dx[..6]);
    g.acceleration_2_7(q_dot, wrench).store(&mut dx[6..]);
    dx
}
