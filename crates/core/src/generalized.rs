//! The equations in generalized coordinates: (2.4), (2.7), (2.8), (2.13).
//!
//! q = (o; α): the position of the body origin in world axes and the angles of any sequence.

use crate::algebra::{Mat3, Mat6, Vec3};
use crate::charts::{AngleChart, Sequence};
use crate::inertia::Inertia;
use crate::newton_euler::{self, acceleration, phi_pi};
use crate::scalar::Real;
use crate::screw::{Screw, force_cross};

/// Every matrix of section 2 at one state (q, q̇), written as the paper writes it.
///
/// For reading, teaching and testing: [`acceleration_by_blocks`] is the same equation, ten times cheaper.
#[derive(Clone, Copy, Debug)]
pub struct Generalized<T> {
    /// The orientation: C, M0, M1 and the rest.
    pub chart: AngleChart<T>,
    /// V = D q̇. Konoplev (2.2)
    pub twist: Screw<T>,
    /// D. Konoplev (2.2)
    pub d: Mat6<T>,
    /// D⁻¹. Konoplev (2.2)
    pub d_inverse: Mat6<T>,
    /// D⁻¹Ḋ. Konoplev (2.4)
    pub d_inverse_d_dot: Mat6<T>,
    /// Φ^{qD} = D⁻¹ Φ_π D. Konoplev (2.4)
    pub phi_qd: Mat6<T>,
    /// K. Konoplev (2.5)
    pub k: Mat6<T>,
    /// A1 = ΘD. Konoplev (2.7)
    pub a1: Mat6<T>,
    /// A1⁻¹ = D⁻¹Θ⁻¹. Konoplev (2.7)
    pub a1_inverse: Mat6<T>,
    /// B1 = A1 K + Φ A1. Konoplev (2.8)
    pub b1: Mat6<T>,
    /// Φ1 = K + A1⁻¹ Φ A1. Konoplev (2.7)
    pub phi1: Mat6<T>,
}

impl<T: Real> Generalized<T> {
    /// All matrices at the angles `alpha` and the rates `q_dot` = (ȯ; α̇).
    pub fn new(body: &Inertia<T>, sequence: Sequence, alpha: Vec3<T>, q_dot: Screw<T>) -> Self {
        let chart = AngleChart::new(sequence, alpha);
        let (d, d_inverse) = (chart.velocity_map(), chart.velocity_map_inverse());
        let twist = d.apply(q_dot);
        let phi = force_cross(twist);
        let k = chart.convective_matrix(q_dot.angular);
        let a1 = body.matrix() * d;
        let a1_inverse = d_inverse * body.inverse_matrix();
        Self {
            chart,
            twist,
            d,
            d_inverse,
            d_inverse_d_dot: d_inverse * chart.velocity_map_dot(q_dot.angular),
            phi_qd: d_inverse * phi_pi(body, twist) * d,
            k,
            a1,
            a1_inverse,
            b1: a1 * k + phi * a1,
            phi1: k + a1_inverse * (phi * a1),
        }
    }

    /// q̈ of (2.4): D⁻¹Θ⁻¹F − (Φ^{qD} + D⁻¹Ḋ) q̇. Konoplev (2.4)
    pub fn acceleration_2_4(&self, q_dot: Screw<T>, wrench: Screw<T>) -> Screw<T> {
        self.a1_inverse.apply(wrench) - (self.phi_qd + self.d_inverse_d_dot).apply(q_dot)
    }

    /// q̈ of (2.7): A1⁻¹F − Φ1 q̇. Konoplev (2.7)
    pub fn acceleration_2_7(&self, q_dot: Screw<T>, wrench: Screw<T>) -> Screw<T> {
        self.a1_inverse.apply(wrench) - self.phi1.apply(q_dot)
    }

    /// The wrench A1 q̈ + B1 q̇ that a motion needs, the left side of (2.8). Konoplev (2.8)
    pub fn inverse_dynamics(&self, q_dot: Screw<T>, q_ddot: Screw<T>) -> Screw<T> {
        self.a1.apply(q_ddot) + self.b1.apply(q_dot)
    }

    /// q̈ of (2.8): A1⁻¹(F − B1 q̇). Konoplev (2.8)
    pub fn acceleration_2_8(&self, q_dot: Screw<T>, wrench: Screw<T>) -> Screw<T> {
        self.a1_inverse.apply(wrench - self.b1.apply(q_dot))
    }
}

/// ö = C(v* + ω × v), world axes. Konoplev (2.7), upper block
#[inline(always)]
pub fn origin_acceleration<T: Real>(rotation: Mat3<T>, twist: Screw<T>, rate: Screw<T>) -> Vec3<T> {
    rotation.apply(twist.angular.cross_add(twist.linear, rate.linear))
}

/// α̈ = M1⁻¹(ω* − CᵀṀ0α̇). Konoplev (2.7), lower block
#[inline(always)]
pub fn angle_acceleration<T: Real>(chart: &AngleChart<T>, alpha_dot: Vec3<T>, dw: Vec3<T>) -> Vec3<T> {
    chart.rates(dw - chart.convective_rate(alpha_dot))
}

/// The left side of (2.8) by blocks: A1 q̈ + B1 q̇ = ΘV* + ΦΘV with V = D q̇, V* = D(q̈ + K q̇). Konoplev (2.8)
#[inline(always)]
pub fn inverse_dynamics_by_blocks<T: Real>(
    body: &Inertia<T>,
    chart: &AngleChart<T>,
    q_dot: Screw<T>,
    q_ddot: Screw<T>,
) -> Screw<T> {
    let v = chart.rotation.transpose_apply(q_dot.linear);
    let w = chart.angular_velocity(q_dot.angular);
    let linear = chart.rotation.transpose_apply(q_ddot.linear) - w.cross(v);
    let angular = chart.angular_velocity(q_ddot.angular) + chart.convective_rate(q_dot.angular);
    newton_euler::inverse_dynamics(body, Screw::new(v, w), Screw::new(linear, angular))
}

/// q̈ by blocks, the form that runs. Konoplev (2.7)
#[inline(always)]
pub fn acceleration_by_blocks<T: Real>(
    body: &Inertia<T>,
    chart: &AngleChart<T>,
    q_dot: Screw<T>,
    wrench: Screw<T>,
) -> Screw<T> {
    let v = chart.rotation.transpose_apply(q_dot.linear);
    let twist = Screw::new(v, chart.angular_velocity(q_dot.angular));
    let rate = acceleration(body, twist, wrench);
    Screw::new(
        origin_acceleration(chart.rotation, twist, rate),
        angle_acceleration(chart, q_dot.angular, rate.angular),
    )
}

/// α̈ about the mass centre as pole: M1⁻¹\[J⁻¹(M − ⟨ω⟩ J M1 α̇) − CᵀṀ0 α̇\]. Konoplev (2.13)
pub fn rotation_acceleration<T: Real>(
    inertia: Mat3<T>,
    sequence: Sequence,
    alpha: Vec3<T>,
    alpha_dot: Vec3<T>,
    moment: Vec3<T>,
) -> Vec3<T> {
    let chart = AngleChart::new(sequence, alpha);
    let w = chart.rate_matrix_body().apply(alpha_dot);
    let gyroscopic = Mat3::skew(w).apply(inertia.apply(w));
    let from_moment = inertia.inverse().apply(moment - gyroscopic);
    let ct = chart.rotation.transpose();
    let convective = ct.apply(chart.rate_matrix_world_dot(alpha_dot).apply(alpha_dot));
    chart.rate_matrix_body_inverse().apply(from_moment - convective)
}
