//! The free rigid body with its forces, in any chart and either kind of velocity.

use super::Left;
use super::laws::command;
use super::orientation::Orientation;
use super::parts::{Parts, Sizes, convert};
use crate::algebra::{Mat3, Vec3};
use crate::buffer::Buffer;
use crate::charts::Sequence;
use crate::forces::{Acting, Force, Situation, Traced, total};
use crate::generalized::origin_acceleration;
use crate::inertia::Inertia;
use crate::newton_euler::acceleration_about_com;
use crate::scalar::{Block, Real};
use crate::screw::Screw;
use std::convert::identity;
use std::sync::Arc;

/// Up to this many inputs are passed on the stack.
const ON_STACK: usize = 16;

/// How the orientation is written in the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chart {
    /// A unit quaternion (w, x, y, z), world from body.
    Quaternion,
    /// Three angles of a sequence.
    Angles(Sequence),
}

impl Chart {
    /// How many numbers the orientation takes.
    #[inline(always)]
    pub fn size(self) -> usize {
        if matches!(self, Chart::Quaternion) { 4 } else { 3 }
    }
}

/// Which velocities the state holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Quasi-velocities (v; ω) in body axes. Konoplev (1.8)
    QuasiVelocity,
    /// Rates of the generalized coordinates. Konoplev (2.7)
    Generalized,
}

/// A free rigid body with its forces: x = (o, orientation, velocities), then the auxiliary states of the forces and
/// of the control law. Konoplev (3.2)
#[derive(Clone, Debug)]
pub struct FreeBody<T> {
    /// The body.
    pub inertia: Inertia<T>,
    /// What acts on it.
    pub forces: Vec<Force<T>>,
    /// The chart of the orientation.
    pub chart: Chart,
    /// The kind of velocity.
    pub form: Form,
    /// The forces made ready: where this is, it acts instead of them.
    pub acting: Option<Acting<T>>,
    /// What commands the inputs behind those of u.
    pub control: Option<Traced<T>>,
    /// What stands on the left besides the body.
    pub left: Option<Left<T>>,
    /// f compiled elsewhere, of (t, x, u): in the chart above, and in quaternions.
    pub compiled: Option<[Arc<dyn Block>; 2]>,
}

impl<T: Real> FreeBody<T> {
    /// Without control, and with nothing else on the left.
    pub fn new(inertia: Inertia<T>, forces: Vec<Force<T>>, chart: Chart, form: Form) -> Self {
        Self { inertia, forces, chart, form, acting: None, control: None, left: None, compiled: None }
    }

    /// All traced forces as one, if they are.
    #[inline(always)]
    pub(super) fn law(&self) -> Option<&Traced<T>> {
        self.acting.as_ref().and_then(
            #[inline(always)]
            |acting| acting.law.as_ref(),
        )
    }

    /// Whether laws of users act or command.
    #[inline(always)]
    pub(crate) fn has_laws(&self) -> bool {
        self.law().is_some() || self.control.is_some()
    }

    /// The sum of all wrenches but that of [`FreeBody::field`], in body axes about the mass centre; the rates of the
    /// auxiliary states are written.
    #[inline(always)]
    pub(super) fn wrench<const LAWS: bool>(&self, s: Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        if !LAWS {
            return self.sum(&s, rates);
        }
        let commands = self.control.as_ref().map_or(0, Traced::result_count);
        let mut all = Buffer::<T, ON_STACK>::new(s.inputs.len() + commands);
        let s = match &self.control {
            Some(law) => {
                command(law, &s, all.slice(), rates);
                Situation { inputs: all.slice(), ..s }
            }
            None => s,
        };
        match self.law() {
            // The law first: it needs all registers.
            Some(law) => {
                let wrench = law.about_com(&s, rates);
                self.sum(&s, rates) + wrench
            }
            None => self.sum(&s, rates),
        }
    }

    /// What accelerates the mass centre besides the wrenches, body axes.
    #[inline(always)]
    pub(super) fn field(&self, s: &Situation<'_, T>) -> Vec3<T> {
        match &self.acting {
            Some(acting) => acting.usual.field(s),
            None => Vec3::zero(),
        }
    }

    /// The sum over all forces that the one law does not stand for.
    #[inline(always)]
    fn sum(&self, s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        match &self.acting {
            Some(acting) => acting.about_com(s, rates),
            None => total(&self.forces, s, rates),
        }
    }

    /// How many numbers of a state are the rigid body's; behind them are the auxiliary ones.
    #[inline(always)]
    pub fn rigid_size(&self) -> usize {
        self.sizes().rigid()
    }

    /// How many numbers the parts of a state have.
    #[inline(always)]
    pub(crate) fn sizes(&self) -> Sizes {
        let orientation = self.chart.size();
        let turning = match self.form {
            Form::QuasiVelocity => 3,
            Form::Generalized => orientation,
        };
        Sizes { orientation, turning }
    }

    /// The quasi-velocities of a state, of either form.
    #[inline(always)]
    pub(super) fn twist(&self, at: &Orientation<T>, rotation: Mat3<T>, x: Parts<&[T]>) -> Screw<T> {
        let velocity = Vec3::from_slice(x.velocity);
        match self.form {
            Form::QuasiVelocity => Screw::new(velocity, Vec3::from_slice(x.turning)),
            Form::Generalized => {
                Screw::new(rotation.transpose_apply(velocity), at.angular_velocity(x.turning))
            }
        }
    }

    /// dx = f(x, u, t), part by part; with `LAWS` where there are any, with `LEFT` where something else stands on the
    /// left, which needs the other. Konoplev (3.2)
    ///
    /// Each is code of its own: within one, what they are given would be made ready for all bodies.
    #[inline(always)]
    pub(crate) fn rate<const LAWS: bool, const LEFT: bool>(
        &self,
        t: T,
        x: Parts<&[T]>,
        u: &[T],
        dx: Parts<&mut [T]>,
    ) {
        // Where the body is and how it moves, out of any chart and form ...
        let at = Orientation::read(self.chart, x.orientation);
        let rotation = at.rotation();
        let twist = self.twist(&at, rotation, x);
        // ... the equation itself ...
        let position = Vec3::from_slice(x.position);
        let (inertia, states) = (&self.inertia, x.auxiliary);
        let s = Situation { time: t, position, rotation, twist, inertia, inputs: u, states };
        let rate = match &self.left {
            Some(left) if LEFT => self.solved_with(left, s, dx.auxiliary),
            _ => acceleration_about_com(inertia, twist, self.wrench::<LAWS>(s, dx.auxiliary), self.field(&s)),
        };
        // ... and back into them.
        match self.form {
            Form::QuasiVelocity => {
                rotation.apply(twist.linear).store(dx.position);
                at.write_rates(twist.angular, dx.orientation);
                rate.linear.store(dx.velocity);
                rate.angular.store(dx.turning);
            }
            Form::Generalized => {
                Vec3::from_slice(x.velocity).store(dx.position);
                convert(x.turning, dx.orientation, identity);
                origin_acceleration(rotation, twist, rate).store(dx.velocity);
                at.write_second_rates(twist.angular, rate.angular, x.turning, dx.turning);
            }
        }
    }

    /// The same body and laws with every parameter passed through `f`; what was compiled knows none of them.
    ///
    /// Call inside [`Real::call`] of `U`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> FreeBody<U> {
        let inertia = self.inertia.map(f);
        let acting = self.acting.as_ref().map(
            #[inline(always)]
            |acting| acting.map(f, &inertia),
        );
        let mut forces = Vec::new();
        if acting.is_none() {
            for force in &self.forces {
                forces.push(force.map(f));
            }
        }
        let control = self.control.as_ref().map(
            #[inline(always)]
            |law| law.map(f),
        );
        let left = match &self.left {
            Some(left) => Some(left.map(f)),
            None => None,
        };
        let (chart, form) = (self.chart, self.form);
        FreeBody { inertia, forces, chart, form, acting, control, left, compiled: None }
    }
}
