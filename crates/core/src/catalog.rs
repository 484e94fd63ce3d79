//! Every numbered matrix and form of the paper by its name, over any scalar.

use crate::algebra::{Mat3, Vec3, normalized, rotation_from_quaternion};
use crate::charts::{AngleChart, Sequence, angular_velocity_skew, quaternion_rate};
use crate::forces::{Force, Situation, UniformGravity};
use crate::generalized::{
    Generalized, acceleration_by_blocks, inverse_dynamics_by_blocks, rotation_acceleration,
};
use crate::inertia::Inertia;
use crate::lagrange::{
    Lagrange, christoffel_sums, christoffel_symbols, generalized_force, lagrange_operator,
};
use crate::newton_euler as ne;
use crate::phase_space::phase_velocity;
use crate::scalar::Real;
use crate::screw::{self, Screw};

/// What a form does with its arguments; matrices are flattened by rows.
pub type Row<T> = Box<dyn Fn(&[&[T]], &mut [T])>;

/// One form: the lengths of its arguments and its result, and what it does with one row of each.
pub struct Entry<T> {
    /// How many numbers each argument has.
    pub arguments: &'static [usize],
    /// How many numbers the result has.
    pub result: usize,
    /// What it does.
    pub row: Row<T>,
}

fn entry<T: Real>(
    arguments: &'static [usize],
    result: usize,
    row: impl Fn(&[&[T]], &mut [T]) + 'static,
) -> Option<Entry<T>> {
    Some(Entry { arguments, result, row: Box::new(row) })
}

/// The form of a name, of an angle sequence, a body, both or neither.
pub fn find<T: Real>(name: &str, sequence: Option<Sequence>, body: Option<Inertia<T>>) -> Option<Entry<T>> {
    match (sequence, body) {
        (None, None) => plain(name),
        (None, Some(b)) => of_body(name, b),
        (Some(s), None) => of_angles(name, s),
        (Some(s), Some(b)) => of_both(name, s, b),
    }
}

fn v3<T: Real>(x: &[T]) -> Vec3<T> {
    Vec3::from_slice(x)
}
fn m3<T: Real>(x: &[T]) -> Mat3<T> {
    Mat3::from_slice(x)
}
fn v6<T: Real>(x: &[T]) -> Screw<T> {
    Screw::from_slice(x)
}
fn v4<T: Real>(x: &[T]) -> [T; 4] {
    [x[0], x[1], x[2], x[3]]
}

/// Forms that need neither body nor angles.
fn plain<T: Real>(name: &str) -> Option<Entry<T>> {
    match name {
        "skew" => entry(&[3], 9, |a, out| Mat3::skew(v3(a[0])).store(out)),
        "line_matrix" => entry(&[3], 36, |a, out| screw::line_matrix(v3(a[0])).store(out)),
        "wrench_transform" => {
            entry(&[3, 9], 36, |a, out| screw::wrench_transform(v3(a[0]), m3(a[1])).store(out))
        }
        "wrench_transform_inverse" => {
            entry(&[3, 9], 36, |a, out| screw::wrench_transform_inverse(v3(a[0]), m3(a[1])).store(out))
        }
        "force_cross" => entry(&[6], 36, |a, out| screw::force_cross(v6(a[0])).store(out)),
        "inertia_regressor" => entry(&[6, 6], 60, |a, out| {
            for (j, column) in ne::regressor(v6(a[0]), v6(a[1])).into_iter().enumerate() {
                let mut six = [T::zero(); 6];
                column.store(&mut six);
                for (i, x) in six.into_iter().enumerate() {
                    out[10 * i + j] = x;
                }
            }
        }),
        "rotation_from_quaternion" => {
            entry(&[4], 9, |a, out| rotation_from_quaternion(normalized(v4(a[0]))).store(out))
        }
        "rotation_from_unit_quaternion" => {
            entry(&[4], 9, |a, out| rotation_from_quaternion(v4(a[0])).store(out))
        }
        "quaternion_rate" => {
            entry(&[4, 3], 4, |a, out| out.copy_from_slice(&quaternion_rate(v4(a[0]), v3(a[1]))))
        }
        _ => None,
    }
}

/// Forms of a body in quasi-velocities.
fn of_body<T: Real>(name: &str, body: Inertia<T>) -> Option<Entry<T>> {
    match name {
        "spatial_inertia" => entry(&[], 36, move |_, out| body.matrix().store(out)),
        "inverse_spatial_inertia" => entry(&[], 36, move |_, out| body.inverse_matrix().store(out)),
        "inertia_about_com" => entry(&[], 6, move |_, out| out.copy_from_slice(&body.about_com.to_array())),
        "momentum" => entry(&[6], 6, move |a, out| body.momentum(v6(a[0])).store(out)),
        "momentum_world" => entry(&[3, 9, 6], 6, move |a, out| {
            ne::momentum_world(&body, v3(a[0]), m3(a[1]), v6(a[2])).store(out);
        }),
        "inverse_dynamics" => {
            entry(&[6, 6], 6, move |a, out| ne::inverse_dynamics(&body, v6(a[0]), v6(a[1])).store(out))
        }
        "quasi_acceleration.1.8" => {
            entry(&[6, 6], 6, move |a, out| ne::acceleration_literal(&body, v6(a[0]), v6(a[1])).store(out))
        }
        "quasi_acceleration.1.11" => entry(&[6, 6], 6, move |a, out| {
            ne::quasi_coordinate_acceleration(&body, v6(a[0]), v6(a[1])).store(out);
        }),
        "quasi_acceleration.blocks" => {
            entry(&[6, 6], 6, move |a, out| ne::acceleration(&body, v6(a[0]), v6(a[1])).store(out))
        }
        "quasi_velocity.Phi_pi" => entry(&[6], 36, move |a, out| ne::phi_pi(&body, v6(a[0])).store(out)),
        "gravity_wrench" => entry(&[9, 3], 6, move |a, out| {
            let s = Situation {
                time: T::zero(),
                position: Vec3::zero(),
                rotation: m3(a[0]),
                twist: Screw::zero(),
                inertia: &body,
                inputs: &[],
                states: &[],
            };
            Force::UniformGravity(UniformGravity { acceleration: v3(a[1]) })
                .about_origin(&s, &mut [])
                .store(out);
        }),
        "kinetic_energy" => entry(&[6], 1, move |a, out| out[0] = body.kinetic_energy(v6(a[0]))),
        "inertial_parameters" => entry(&[], 10, move |_, out| out.copy_from_slice(&body.parameters())),
        _ => None,
    }
}

/// Forms of an angle sequence alone.
fn of_angles<T: Real>(name: &str, s: Sequence) -> Option<Entry<T>> {
    let at = move |alpha: &[T]| AngleChart::new(s, v3(alpha));
    let of_q = move |q: &[T]| AngleChart::new(s, v3(&q[3..]));
    match name {
        "rotation" => entry(&[3], 9, move |a, out| at(a[0]).rotation.store(out)),
        "rate_matrix_world" => entry(&[3], 9, move |a, out| at(a[0]).rate_matrix_world().store(out)),
        "rate_matrix_body" => entry(&[3], 9, move |a, out| at(a[0]).rate_matrix_body().store(out)),
        "rate_matrix_world_inverse" => {
            entry(&[3], 9, move |a, out| at(a[0]).rate_matrix_world_inverse().store(out))
        }
        "rate_matrix_body_inverse" => {
            entry(&[3], 9, move |a, out| at(a[0]).rate_matrix_body_inverse().store(out))
        }
        "rate_matrix_world_dot" => {
            entry(&[3, 3], 9, move |a, out| at(a[0]).rate_matrix_world_dot(v3(a[1])).store(out))
        }
        "angular_velocity_skew_world" => {
            entry(&[3, 3], 9, move |a, out| angular_velocity_skew(s, v3(a[0]), v3(a[1])).store(out))
        }
        "velocity_map" => entry(&[6], 36, move |a, out| of_q(a[0]).velocity_map().store(out)),
        "velocity_map_inverse" => entry(&[6], 36, move |a, out| of_q(a[0]).velocity_map_inverse().store(out)),
        "twist" => entry(&[6, 6], 6, move |a, out| of_q(a[0]).velocity_map().apply(v6(a[1])).store(out)),
        "generalized_force" => {
            entry(&[6, 6], 6, move |a, out| generalized_force(&of_q(a[0]), v6(a[1])).store(out))
        }
        "rotation_acceleration" => entry(&[9, 3, 3, 3], 3, move |a, out| {
            rotation_acceleration(m3(a[0]), s, v3(a[1]), v3(a[2]), v3(a[3])).store(out);
        }),
        _ => None,
    }
}

/// Forms of a body in generalized coordinates.
fn of_both<T: Real>(name: &str, s: Sequence, body: Inertia<T>) -> Option<Entry<T>> {
    if let Some(which) = name.strip_prefix("generalized_acceleration.") {
        return acceleration(which.to_owned(), s, body);
    }
    if let Some(which) = name.strip_prefix("generalized.") {
        let which = which.to_owned();
        return ["K", "A1", "B1", "Phi1", "Phi_qD", "D_inv_D_dot"].contains(&which.as_str()).then(|| Entry {
            arguments: &[6, 6],
            result: 36,
            row: Box::new(move |a, out| {
                let g = Generalized::new(&body, s, v3(&a[0][3..]), v6(a[1]));
                let m = match which.as_str() {
                    "K" => g.k,
                    "A1" => g.a1,
                    "B1" => g.b1,
                    "Phi1" => g.phi1,
                    "Phi_qD" => g.phi_qd,
                    _ => g.d_inverse_d_dot,
                };
                m.store(out);
            }),
        });
    }
    if let Some(which) = name.strip_prefix("inverse_dynamics.") {
        return inverse_dynamics(which.to_owned(), s, body);
    }
    match name {
        "lagrange.christoffel" => entry(&[6, 6], 6, move |a, out| {
            out.copy_from_slice(&christoffel_sums(&body, s, v3(&a[0][3..]), v6(a[1])));
        }),
        "lagrange.A" | "lagrange.B" | "lagrange.Phi_q" | "lagrange.Phi_up_q" => {
            let which = name["lagrange.".len()..].to_owned();
            entry(&[6, 6], 36, move |a, out| {
                let l = Lagrange::new(&body, &Generalized::new(&body, s, v3(&a[0][3..]), v6(a[1])));
                let m = match which.as_str() {
                    "A" => l.a,
                    "B" => l.b,
                    "Phi_q" => l.phi_q,
                    _ => l.phi_up_q,
                };
                m.store(out);
            })
        }
        "christoffel_symbols" => entry(&[6], 216, move |a, out| {
            let symbols = christoffel_symbols(&body, s, v3(&a[0][3..]));
            out.copy_from_slice(symbols.as_flattened().as_flattened());
        }),
        "lagrange_operator" => entry(&[6, 6, 6], 6, move |a, out| {
            out.copy_from_slice(&lagrange_operator(&body, s, v3(&a[0][3..]), v6(a[1]), v6(a[2])));
        }),
        "phase_velocity" => {
            entry(&[12, 6], 12, move |a, out| out.copy_from_slice(&phase_velocity(&body, s, a[0], v6(a[1]))))
        }
        _ => None,
    }
}

/// q̈ by one of the paper's forms.
fn acceleration<T: Real>(which: String, s: Sequence, body: Inertia<T>) -> Option<Entry<T>> {
    if !["blocks", "2.4", "2.7", "2.8", "2.9", "2.10"].contains(&which.as_str()) {
        return None;
    }
    entry(&[6, 6, 6], 6, move |a, out| {
        let (alpha, q_dot, wrench) = (v3(&a[0][3..]), v6(a[1]), v6(a[2]));
        let g = || Generalized::new(&body, s, alpha, q_dot);
        let l = || Lagrange::new(&body, &g());
        let chart = || AngleChart::new(s, alpha);
        let force = || generalized_force(&chart(), wrench);
        let q_ddot = match which.as_str() {
            "2.4" => g().acceleration_2_4(q_dot, wrench),
            "2.7" => g().acceleration_2_7(q_dot, wrench),
            "2.8" => g().acceleration_2_8(q_dot, wrench),
            "2.9" => l().acceleration_2_9(q_dot, force()),
            "2.10" => l().acceleration_2_10(q_dot, force()),
            _ => acceleration_by_blocks(&body, &chart(), q_dot, wrench),
        };
        q_ddot.store(out);
    })
}

/// The left sides of (2.8) and (2.10), as they stand and by blocks.
fn inverse_dynamics<T: Real>(which: String, s: Sequence, body: Inertia<T>) -> Option<Entry<T>> {
    if !["2.8", "2.10", "2.8.blocks", "2.10.blocks"].contains(&which.as_str()) {
        return None;
    }
    entry(&[6, 6, 6], 6, move |a, out| {
        let (alpha, q_dot, q_ddot) = (v3(&a[0][3..]), v6(a[1]), v6(a[2]));
        let chart = AngleChart::new(s, alpha);
        let by_blocks = || inverse_dynamics_by_blocks(&body, &chart, q_dot, q_ddot);
        let g = || Generalized::new(&body, s, alpha, q_dot);
        let needed = match which.as_str() {
            "2.8" => g().inverse_dynamics(q_dot, q_ddot),
            "2.10" => Lagrange::new(&body, &g()).inverse_dynamics(q_dot, q_ddot),
            "2.8.blocks" => by_blocks(),
            _ => generalized_force(&chart, by_blocks()),
        };
        needed.store(out);
    })
}
