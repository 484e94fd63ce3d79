//! The free rigid body with its forces, in any chart and either kind of velocity.

use super::Dynamics;
use super::orientation::{Orientation, quaternion_of};
use super::parts::{Parts, Sizes, convert};
use crate::algebra::{Mat3, Vec3, normalized};
use crate::charts::{Sequence, angular_velocity, quaternion_rate};
use crate::forces::{Force, Situation};
use crate::generalized::origin_acceleration;
use crate::inertia::Inertia;
use crate::integrators::{Block, ErrorScale};
use crate::newton_euler::acceleration_about_com;
use crate::scalar::Real;
use crate::screw::Screw;
use std::convert::identity;

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

/// A free rigid body with its forces: x = (o, orientation, velocities). Konoplev (3.2)
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
}

impl<T: Real> FreeBody<T> {
    /// The sum of all wrenches, in body axes about the mass centre.
    #[inline(always)]
    fn wrench(&self, t: T, o: Vec3<T>, rotation: Mat3<T>, twist: Screw<T>, u: &[T]) -> Screw<T> {
        let inertia = &self.inertia;
        let s = Situation { time: t, position: o, rotation, twist, inertia, inputs: u };
        let mut sum = Screw::zero();
        for f in &self.forces {
            sum = sum + f.about_com(&s);
        }
        sum
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

    /// dx = f(x, u, t), part by part. Konoplev (3.2)
    #[inline(always)]
    pub(crate) fn rate(&self, t: T, x: Parts<&[T]>, u: &[T], dx: Parts<&mut [T]>) {
        // Where the body is and how it moves, out of any chart and form ...
        let at = Orientation::read(self.chart, x.orientation);
        let rotation = at.rotation();
        let velocity = Vec3::from_slice(x.velocity);
        let twist = match self.form {
            Form::QuasiVelocity => Screw::new(velocity, Vec3::from_slice(x.turning)),
            Form::Generalized => {
                Screw::new(rotation.transpose_apply(velocity), at.angular_velocity(x.turning))
            }
        };
        // ... the equation itself ...
        let wrench = self.wrench(t, Vec3::from_slice(x.position), rotation, twist, u);
        let rate = acceleration_about_com(&self.inertia, twist, wrench);
        // ... and back into them.
        match self.form {
            Form::QuasiVelocity => {
                rotation.apply(twist.linear).store(dx.position);
                at.write_rates(twist.angular, dx.orientation);
                rate.linear.store(dx.velocity);
                rate.angular.store(dx.turning);
            }
            Form::Generalized => {
                velocity.store(dx.position);
                convert(x.turning, dx.orientation, identity);
                origin_acceleration(rotation, twist, rate).store(dx.velocity);
                at.write_second_rates(twist.angular, rate.angular, x.turning, dx.turning);
            }
        }
    }

    /// The same body and forces with every parameter passed through `f`.
    ///
    /// Call inside [`Real::call`] of `U`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> FreeBody<U> {
        let inertia = self.inertia.map(f);
        let mut forces = Vec::with_capacity(self.forces.len());
        for force in &self.forces {
            forces.push(force.map(f));
        }
        FreeBody { inertia, forces, chart: self.chart, form: self.form }
    }
}

impl FreeBody<f64> {
    /// The same body over another scalar, every parameter a constant of it.
    pub fn lift<T: Real>(&self) -> FreeBody<T> {
        T::call(
            #[inline(always)]
            || self.map(&mut T::lit),
        )
    }
}

impl<T: Real> Dynamics<T> for FreeBody<T> {
    #[inline(always)]
    fn state_size(&self) -> usize {
        self.sizes().state()
    }

    #[inline(always)]
    fn input_size(&self) -> usize {
        let mut n = 0;
        for f in &self.forces {
            n += f.input_count();
        }
        n
    }

    #[inline(always)]
    fn derivative(&self, t: T, x: &[T], u: &[T], dx: &mut [T]) {
        let sizes = self.sizes();
        self.rate(t, Parts::of(x, sizes), u, Parts::of_mut(dx, sizes));
    }

    /// The unit quaternion back to length one, and its rate back to the tangent.
    #[inline(always)]
    fn project(&self, x: &mut [T]) {
        if self.chart != Chart::Quaternion {
            return;
        }
        let q = normalized(quaternion_of(&x[3..7]));
        x[3..7].copy_from_slice(&q);
        if self.form == Form::Generalized {
            let w = angular_velocity(q, quaternion_of(&x[10..14]));
            x[10..14].copy_from_slice(&quaternion_rate(q, w));
        }
    }

    fn error_blocks(&self) -> Vec<Block> {
        let Sizes { orientation, turning } = self.sizes();
        let n = 3 + orientation;
        let radian = if self.chart == Chart::Quaternion { 0.5 } else { 1.0 };
        vec![
            Block { start: 0, len: 3, scale: ErrorScale::Relative },
            Block { start: 3, len: orientation, scale: ErrorScale::Fixed(radian) },
            Block { start: n, len: 3, scale: ErrorScale::Relative },
            Block { start: n + 3, len: turning, scale: ErrorScale::Relative },
        ]
    }
}
