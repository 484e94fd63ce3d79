//! The equations in quasi-velocities: (1.7), (1.8), (1.11).

use crate::algebra::{Mat3, Mat6, Vec3};
use crate::inertia::Inertia;
use crate::scalar::Real;
use crate::screw::{Screw, force_cross, force_cross_apply, world_from_body};

/// The momentum Z⁰ = LΘV about the fixed world origin; its rate is the wrench F⁰. Konoplev (1.5), (1.7)
#[inline(always)]
pub fn momentum_world<T: Real>(body: &Inertia<T>, o: Vec3<T>, c: Mat3<T>, twist: Screw<T>) -> Screw<T> {
    world_from_body(o, c, body.momentum(twist))
}

/// The wrench ΘV* + ΦΘV that a motion needs, about the body origin in body axes. Konoplev (1.8)
#[inline(always)]
pub fn inverse_dynamics<T: Real>(body: &Inertia<T>, twist: Screw<T>, twist_rate: Screw<T>) -> Screw<T> {
    body.momentum(twist_rate) + force_cross_apply(twist, body.momentum(twist))
}

/// V* of (1.8) with literal matrices: Θ⁻¹(F − ΦΘV). Konoplev (1.8)
pub fn acceleration_literal<T: Real>(body: &Inertia<T>, twist: Screw<T>, wrench: Screw<T>) -> Screw<T> {
    let phi_theta = force_cross(twist) * body.matrix();
    body.inverse_matrix().apply(wrench - phi_theta.apply(twist))
}

/// Φ_π = Θ⁻¹ΦΘ, the matrix of π°° + Φ_π π° = Θ⁻¹F. Konoplev (1.11)
pub fn phi_pi<T: Real>(body: &Inertia<T>, twist: Screw<T>) -> Mat6<T> {
    body.inverse_matrix() * (force_cross(twist) * body.matrix())
}

/// π°° = Θ⁻¹F − Φ_π π° with literal matrices; π° = V, π°° = V*. Konoplev (1.10), (1.11)
pub fn quasi_coordinate_acceleration<T: Real>(
    body: &Inertia<T>,
    twist: Screw<T>,
    wrench: Screw<T>,
) -> Screw<T> {
    body.inverse_matrix().apply(wrench) - phi_pi(body, twist).apply(twist)
}

/// V* of (1.8), solved by blocks at the mass centre. Konoplev (1.8)
#[inline(always)]
pub fn acceleration<T: Real>(body: &Inertia<T>, twist: Screw<T>, wrench: Screw<T>) -> Screw<T> {
    acceleration_about_com(body, twist, wrench.about_point(body.com), Vec3::zero())
}

/// V* of (1.8) for a wrench about the mass centre, in a field that accelerates it: the form that runs. Konoplev (1.8)
///
/// ω* = Jc⁻¹(M_c + Jc ω × ω) and v* = f/m + g + (v + ω × r_c) × ω + r_c × ω*. The weight m g is no part of the wrench:
/// it has no moment about the mass centre, and about the origin its moment would cancel only to the rounding of
/// m g |r_c|.
#[inline(always)]
pub fn acceleration_about_com<T: Real>(
    body: &Inertia<T>,
    twist: Screw<T>,
    wrench: Screw<T>,
    field: Vec3<T>,
) -> Screw<T> {
    let (v, w) = (twist.linear, twist.angular);
    let com_velocity = w.cross_add(body.com, v);
    let moment = body.about_com.apply(w).cross_add(w, wrench.angular);
    let turn = body.inverse_about_com.apply(moment);
    let pushed = com_velocity.cross_add(w, wrench.linear.scale(body.inverse_mass)) + field;
    Screw::new(body.com.cross_add(turn, pushed), turn)
}

/// The 6×10 matrix Y of ΘV* + ΦΘV = Y(V, V*) θ, by columns; θ are [`Inertia::parameters`].
///
/// The left side of (1.8) is linear in the ten inertial parameters.
pub fn regressor<T: Real>(twist: Screw<T>, twist_rate: Screw<T>) -> [Screw<T>; 10] {
    let (v, w) = (twist.linear, twist.angular);
    let dw = twist_rate.angular;
    let a = twist_rate.linear + w.cross(v);
    // Force m a + (⟨ω*⟩ + ⟨ω⟩⟨ω⟩) s, moment s × a + J ω* + ω × J ω, with s = m r_c.
    let by_s = Mat3::skew(dw) + Mat3::skew(w) * Mat3::skew(w);
    let turn = -Mat3::skew(a);
    let zero = Vec3::zero();
    let mut y = [Screw::zero(); 10];
    y[0] = Screw::new(a, zero);
    let (by_s, turn) = (by_s.transpose().rows, turn.transpose().rows);
    for i in 0..3 {
        y[1 + i] = Screw::new(by_s[i], turn[i]);
    }
    let places = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    for (k, (i, j)) in places.into_iter().enumerate() {
        // J with a single 1 at (i, j) and (j, i).
        let unit = |u: Vec3<T>| {
            let u = u.to_array();
            let mut r = [T::zero(); 3];
            r[i] = u[j];
            if i != j {
                r[j] = u[i];
            }
            Vec3::from_array(r)
        };
        y[4 + k] = Screw::new(zero, unit(dw) + w.cross(unit(w)));
    }
    y
}
