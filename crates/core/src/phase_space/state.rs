//! States between charts and kinds of velocity, and what can be read off them.

use super::{Chart, Form, FreeBody};
use crate::algebra::{Mat3, Vec3, normalized, quaternion_from_rotation, rotation_from_quaternion};
use crate::charts::{AngleChart, angular_velocity, quaternion_rate};
use crate::screw::Screw;

/// The motion of a body frame, free of charts.
#[derive(Clone, Copy, Debug)]
pub struct RigidState {
    /// Position of the body origin, world axes, m.
    pub position: Vec3<f64>,
    /// Unit quaternion (w, x, y, z), world from body.
    pub quaternion: [f64; 4],
    /// Quasi-velocities of the body origin, body axes.
    pub twist: Screw<f64>,
}

impl RigidState {
    /// The rotation, world from body.
    pub fn rotation(&self) -> Mat3<f64> {
        rotation_from_quaternion(self.quaternion)
    }
}

impl FreeBody<f64> {
    /// The motion that a state x of this model means.
    pub fn rigid_state(&self, x: &[f64]) -> RigidState {
        let position = Vec3::from_slice(x);
        let (orientation, velocities) = x[3..].split_at(self.chart.size());
        match self.chart {
            Chart::Quaternion => {
                let quaternion = normalized([orientation[0], orientation[1], orientation[2], orientation[3]]);
                let twist = match self.form {
                    Form::QuasiVelocity => Screw::from_slice(velocities),
                    Form::Generalized => {
                        let c = rotation_from_quaternion(quaternion);
                        let rate = [velocities[3], velocities[4], velocities[5], velocities[6]];
                        Screw::new(
                            c.transpose_apply(Vec3::from_slice(velocities)),
                            angular_velocity(quaternion, rate),
                        )
                    }
                };
                RigidState { position, quaternion, twist }
            }
            Chart::Angles(sequence) => {
                let chart = AngleChart::new(sequence, Vec3::from_slice(orientation));
                let given = Screw::from_slice(velocities);
                let twist = match self.form {
                    Form::QuasiVelocity => given,
                    Form::Generalized => Screw::new(
                        chart.rotation.transpose_apply(given.linear),
                        chart.angular_velocity(given.angular),
                    ),
                };
                let quaternion = quaternion_from_rotation(&chart.rotation);
                RigidState { position, quaternion, twist }
            }
        }
    }

    /// Writes the state x of a motion, all but its auxiliary part; of the many angle triples, or of ±η, the one nearest to `like`.
    ///
    /// `like` is another state x of this model: the sample before this one.
    pub fn write_state(&self, s: &RigidState, like: &[f64], x: &mut [f64]) {
        s.position.store(x);
        let (orientation, velocities) = x[3..].split_at_mut(self.chart.size());
        let c = s.rotation();
        let velocity = c.apply(s.twist.linear);
        match self.chart {
            Chart::Quaternion => {
                let near: f64 = s.quaternion.iter().zip(&like[3..7]).map(|(a, b)| a * b).sum();
                let q = if near < 0.0 { s.quaternion.map(|v| -v) } else { s.quaternion };
                orientation.copy_from_slice(&q);
                match self.form {
                    Form::QuasiVelocity => s.twist.store(velocities),
                    Form::Generalized => {
                        velocity.store(velocities);
                        velocities[3..7].copy_from_slice(&quaternion_rate(q, s.twist.angular));
                    }
                }
            }
            Chart::Angles(sequence) => {
                let like = [like[3], like[4], like[5]];
                let angles = sequence.nearest(sequence.angles_of(&c, like), like);
                orientation.copy_from_slice(&angles);
                match self.form {
                    Form::QuasiVelocity => s.twist.store(velocities),
                    Form::Generalized => {
                        let chart = AngleChart::new(sequence, Vec3::from_array(angles));
                        Screw::new(velocity, chart.rates(s.twist.angular)).store(velocities);
                    }
                }
            }
        }
    }

    /// The distance of the second angle to the nearest singular one, rad; none without angles.
    pub fn singularity_distance(&self, x: &[f64]) -> Option<f64> {
        match self.chart {
            Chart::Quaternion => None,
            Chart::Angles(sequence) => Some(sequence.singularity_distance([x[3], x[4], x[5]])),
        }
    }
}
