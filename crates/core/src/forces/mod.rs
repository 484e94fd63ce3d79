//! Force elements: each gives a wrench in body axes.
//!
//! One element a file. Parameters are scalars of the kernel, so that they may differ per lane,
//! carry derivatives or be symbols.

mod acting;
mod damping;
mod gravity;
mod harmonics;
mod input;
mod places;
mod point_mass;
mod tabulated;
mod traced;
mod usual;
mod wrench;

pub use acting::Acting;
pub(crate) use acting::total;
pub use damping::{Coefficients, LinearDamping, QuadraticDamping};
pub use gravity::UniformGravity;
pub use harmonics::{Field, HarmonicGravity, Harmonics};
pub use input::InputWrench;
pub use places::{Places, Seen, Source};
pub use point_mass::PointMassGravity;
pub use tabulated::TabulatedWrench;
pub use traced::{Callback, Traced};
pub use usual::Usual;
pub use wrench::{Axes, ConstantWrench};

use crate::algebra::{Mat3, Vec3};
use crate::inertia::Inertia;
use crate::scalar::Real;
use crate::screw::Screw;
use std::ops::Range;

/// What a force element can see.
#[derive(Clone, Copy, Debug)]
pub struct Situation<'a, T> {
    /// Time, s.
    pub time: T,
    /// Position of the body origin, world axes, m.
    pub position: Vec3<T>,
    /// Rotation, world from body.
    pub rotation: Mat3<T>,
    /// Quasi-velocities of the body origin, body axes.
    pub twist: Screw<T>,
    /// The body that the force acts on.
    pub inertia: &'a Inertia<T>,
    /// All inputs of the forces: u, and behind it what a control law commands.
    pub inputs: &'a [T],
    /// All auxiliary states.
    pub states: &'a [T],
}

impl<T: Real> Situation<'_, T> {
    /// Position of the mass centre, world axes, m.
    #[inline(always)]
    pub fn com_position(&self) -> Vec3<T> {
        self.position + self.rotation.apply(self.inertia.com)
    }
}

/// A force element.
#[derive(Clone, Debug)]
pub enum Force<T> {
    /// See [`UniformGravity`].
    UniformGravity(UniformGravity<T>),
    /// See [`PointMassGravity`].
    PointMassGravity(PointMassGravity<T>),
    /// See [`HarmonicGravity`].
    HarmonicGravity(HarmonicGravity<T>),
    /// See [`ConstantWrench`].
    ConstantWrench(ConstantWrench<T>),
    /// See [`TabulatedWrench`].
    TabulatedWrench(TabulatedWrench<T>),
    /// See [`LinearDamping`].
    LinearDamping(LinearDamping<T>),
    /// See [`QuadraticDamping`].
    QuadraticDamping(QuadraticDamping<T>),
    /// See [`InputWrench`].
    InputWrench(InputWrench<T>),
    /// See [`Traced`].
    Traced(Traced<T>),
    /// See [`Callback`].
    Callback(Callback),
}

/// The wrench of an element, computed in code of its own.
///
/// Were the longer elements inlined into the loop over all of them, the compiler would compute what they
/// need before the loop, in models without them too. Situation and wrench are copied, so that the
/// originals can stay in registers.
macro_rules! apart {
    ($force:expr, $s:expr $(, $rates:expr)?) => {{
        let (s, mut wrench) = (*$s, [T::zero(); 6]);
        T::call(
            #[inline(always)]
            || $force.about_com(&s $(, $rates)?).store(&mut wrench),
        );
        Screw::from_slice(&wrench)
    }};
}

impl<T: Real> Force<T> {
    /// The wrench in body axes about the mass centre, N and N m: what the kernel sums. The rates of the element's
    /// states are written to their places in `rates`.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        match self {
            Self::UniformGravity(f) => f.about_com(s),
            Self::ConstantWrench(f) => f.about_com(s),
            Self::InputWrench(f) => f.about_com(s),
            Self::LinearDamping(f @ LinearDamping { coefficients: Coefficients::Diagonal(_) }) => {
                f.about_com(s)
            }
            Self::LinearDamping(f) => apart!(f, s),
            Self::PointMassGravity(f) => apart!(f, s),
            Self::HarmonicGravity(f) => apart!(f, s),
            Self::TabulatedWrench(f) => apart!(f, s),
            Self::QuadraticDamping(f) => apart!(f, s),
            Self::Traced(f) => apart!(f, s, rates),
            Self::Callback(f) => apart!(f, s),
        }
    }

    /// The wrench in body axes about the body origin, N and N m; rates as above.
    pub fn about_origin(&self, s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        let w = self.about_com(s, rates);
        Screw::new(w.linear, w.angular + s.inertia.com.cross(w.linear))
    }

    /// The potential energy, J, of an element that has one.
    pub fn potential_energy(&self, s: &Situation<'_, T>) -> Option<T> {
        match self {
            Force::UniformGravity(f) => Some(f.potential_energy(s)),
            Force::PointMassGravity(f) => Some(f.potential_energy(s)),
            Force::HarmonicGravity(f) => Some(f.potential_energy(s)),
            _ => None,
        }
    }

    /// The place behind the last input that the element reads.
    pub fn inputs_end(&self) -> usize {
        match self {
            Force::InputWrench(f) => f.places.iter().max().map_or(0, |place| place + 1),
            Force::Traced(f) => f.places.inputs_end(),
            Force::Callback(f) => f.places.inputs_end(),
            _ => 0,
        }
    }

    /// Whether the wrench, or the rates of the element's states, depend on the position.
    pub fn reads_position(&self) -> bool {
        match self {
            Force::PointMassGravity(_) | Force::HarmonicGravity(_) | Force::Callback(_) => true,
            Force::Traced(f) => f.reads_position(),
            _ => false,
        }
    }

    /// The places of the element's own states among all auxiliary states.
    pub fn states(&self) -> Range<usize> {
        if let Force::Traced(f) = self { f.places.states.clone() } else { 0..0 }
    }

    /// Times at which the wrench or its slope jumps: integrators step onto them.
    pub fn breaks(&self) -> Vec<f64> {
        if let Force::TabulatedWrench(f) = self { f.breaks() } else { Vec::new() }
    }

    /// The parameters passed through `f` one by one.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> Force<U> {
        match self {
            Force::UniformGravity(e) => Force::UniformGravity(e.map(f)),
            Force::PointMassGravity(e) => Force::PointMassGravity(e.map(f)),
            Force::HarmonicGravity(e) => Force::HarmonicGravity(e.map(f)),
            Force::ConstantWrench(e) => Force::ConstantWrench(e.map(f)),
            Force::TabulatedWrench(e) => Force::TabulatedWrench(e.map(f)),
            Force::LinearDamping(e) => Force::LinearDamping(e.map(f)),
            Force::QuadraticDamping(e) => Force::QuadraticDamping(e.map(f)),
            Force::InputWrench(e) => Force::InputWrench(e.map(f)),
            Force::Traced(e) => Force::Traced(e.map(f)),
            Force::Callback(e) => Force::Callback(e.clone()),
        }
    }
}
