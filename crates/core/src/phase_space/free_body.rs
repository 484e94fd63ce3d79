//! The free rigid body with its forces, in any chart and either kind of velocity.

use super::Dynamics;
use super::orientation::{Orientation, quaternion_of};
use crate::algebra::{Mat3, Vec3, normalized};
use crate::charts::{Sequence, angular_velocity, quaternion_rate};
use crate::forces::{Force, Situation};
use crate::generalized::origin_acceleration;
use crate::inertia::Inertia;
use crate::integrators::{Block, ErrorScale};
use crate::newton_euler::acceleration_about_com;
use crate::scalar::Real;
use crate::screw::Screw;

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

    /// Where the velocities begin in x.
    #[inline(always)]
    fn velocities(&self) -> usize {
        3 + self.chart.size()
    }

    /// The same body and forces with every parameter passed through `f`.
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> FreeBody<U> {
        FreeBody {
            inertia: self.inertia.map(f),
            forces: self.forces.iter().map(|e| e.map(f)).collect(),
            chart: self.chart,
            form: self.form,
        }
    }
}

impl FreeBody<f64> {
    /// The same body over another scalar, every parameter a constant of it.
    pub fn lift<T: Real>(&self) -> FreeBody<T> {
        self.map(&mut T::lit)
    }
}

impl<T: Real> Dynamics<T> for FreeBody<T> {
    #[inline(always)]
    fn state_size(&self) -> usize {
        match self.form {
            Form::QuasiVelocity => self.velocities() + 6,
            Form::Generalized => 2 * self.velocities(),
        }
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
        let n = self.velocities();
        let (x, v) = x.split_at(n);
        let (dx, dv) = dx.split_at_mut(n);
        let o = Vec3::from_slice(x);
        // Where the body is and how it moves, out of any chart and form ...
        let at = Orientation::read(self.chart, &x[3..]);
        let rotation = at.rotation();
        let twist = match self.form {
            Form::QuasiVelocity => Screw::from_slice(v),
            Form::Generalized => {
                let linear = rotation.transpose_apply(Vec3::from_slice(v));
                Screw::new(linear, at.angular_velocity(&v[3..]))
            }
        };
        // ... the equation itself ...
        let wrench = self.wrench(t, o, rotation, twist, u);
        let rate = acceleration_about_com(&self.inertia, twist, wrench);
        // ... and back into them.
        match self.form {
            Form::QuasiVelocity => {
                rotation.apply(twist.linear).store(dx);
                at.write_rates(twist.angular, &mut dx[3..]);
                rate.store(dv);
            }
            Form::Generalized => {
                dx.copy_from_slice(v);
                origin_acceleration(rotation, twist, rate).store(dv);
                at.write_second_rates(twist.angular, rate.angular, &v[3..], &mut dv[3..]);
            }
        }
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
        let n = self.velocities();
        let rates = self.state_size() - n - 3;
        let radian = if self.chart == Chart::Quaternion { 0.5 } else { 1.0 };
        vec![
            Block { start: 0, len: 3, scale: ErrorScale::Relative },
            Block { start: 3, len: n - 3, scale: ErrorScale::Fixed(radian) },
            Block { start: n, len: 3, scale: ErrorScale::Relative },
            Block { start: n + 3, len: rates, scale: ErrorScale::Relative },
        ]
    }
}
