//! The orientation part of a state, in whichever chart it is written.

use super::Chart;
use crate::algebra::{Mat3, Vec3, rotation_from_quaternion};
use crate::charts::{AngleChart, angular_velocity, quaternion_rate, quaternion_second_rate};
use crate::generalized::angle_acceleration;
use crate::scalar::Real;

/// Four numbers of a slice.
#[inline(always)]
pub fn quaternion_of<T: Real>(x: &[T]) -> [T; 4] {
    [x[0], x[1], x[2], x[3]]
}

/// An orientation with what its chart needs for rates.
pub enum Orientation<T> {
    Quaternion([T; 4]),
    Angles(AngleChart<T>),
}

impl<T: Real> Orientation<T> {
    /// Of the numbers of a state.
    #[inline(always)]
    pub fn read(chart: Chart, x: &[T]) -> Self {
        match chart {
            Chart::Quaternion => Self::Quaternion(quaternion_of(x)),
            Chart::Angles(sequence) => Self::Angles(AngleChart::new(sequence, Vec3::from_slice(x))),
        }
    }

    /// C, world from body.
    #[inline(always)]
    pub fn rotation(&self) -> Mat3<T> {
        match self {
            Self::Quaternion(q) => rotation_from_quaternion(*q),
            Self::Angles(a) => a.rotation,
        }
    }

    /// ω in body axes of the rates of the chart.
    #[inline(always)]
    pub fn angular_velocity(&self, rates: &[T]) -> Vec3<T> {
        match self {
            Self::Quaternion(q) => angular_velocity(*q, quaternion_of(rates)),
            Self::Angles(a) => a.angular_velocity(Vec3::from_slice(rates)),
        }
    }

    /// The rates of the chart, of ω in body axes.
    #[inline(always)]
    pub fn write_rates(&self, w: Vec3<T>, out: &mut [T]) {
        match self {
            Self::Quaternion(q) => out[..4].copy_from_slice(&quaternion_rate(*q, w)),
            Self::Angles(a) => a.rates(w).store(out),
        }
    }

    /// The second rates of the chart, of ω and ω* in body axes and the first rates.
    #[inline(always)]
    pub fn write_second_rates(&self, w: Vec3<T>, dw: Vec3<T>, rates: &[T], out: &mut [T]) {
        match self {
            Self::Quaternion(q) => {
                out[..4].copy_from_slice(&quaternion_second_rate(*q, quaternion_of(rates), w, dw));
            }
            Self::Angles(a) => angle_acceleration(a, Vec3::from_slice(rates), dw).store(out),
        }
    }
}
