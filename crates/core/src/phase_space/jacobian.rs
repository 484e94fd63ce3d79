//! ∂f/∂x and ∂f/∂u in closed form: of bodies in quaternions and quasi-velocities under the usual forces. (3.2)
//!
//! The derivatives through duals are the general way; this one knows which entries are zero and what is constant.

use super::orientation::quaternion_of;
use super::{Chart, Form, FreeBody};
use crate::algebra::{Mat3, Vec3, basis, rotation_from_quaternion};
use crate::charts::quaternion_rate;
use crate::scalar::Real;
use crate::screw::Screw;

/// Where the entries of a matrix are written.
pub trait Entries<T> {
    /// Writes one of them.
    fn put(&mut self, row: usize, column: usize, value: T);
}

/// The first columns, and rows, of orientation and velocities.
const TURN: usize = 3;
const LINEAR: usize = 7;
const ANGULAR: usize = 10;
const INPUTS: usize = 13;

/// Writes three numbers one below the other.
#[inline(always)]
fn put<T: Real>(out: &mut impl Entries<T>, row: usize, column: usize, v: Vec3<T>) {
    out.put(row, column, v.x);
    out.put(row + 1, column, v.y);
    out.put(row + 2, column, v.z);
}

impl<T: Real> FreeBody<T> {
    /// Whether [`FreeBody::write_jacobian`] knows this body.
    pub fn has_closed_jacobian(&self) -> bool {
        let usual = self.acting.as_ref().is_some_and(|a| a.law.is_none() && a.others.is_empty());
        let kind = (self.chart, self.form) == (Chart::Quaternion, Form::QuasiVelocity);
        kind && usual && self.control.is_none() && self.left.is_none() && self.compiled.is_none()
    }

    /// Writes the entries of (∂f/∂x ∂f/∂u) that are not always zero. Konoplev (3.2)
    #[inline(always)]
    pub fn write_jacobian(&self, x: &[T], out: &mut impl Entries<T>) {
        let Some(acting) = &self.acting else { return };
        let q = quaternion_of(&x[TURN..]);
        let (v, w) = (Vec3::from_slice(&x[LINEAR..]), Vec3::from_slice(&x[ANGULAR..]));
        let turns = rotation_by_quaternion(q);

        // ȯ = C v
        let rotation = rotation_from_quaternion(q);
        for (k, turn) in turns.iter().enumerate() {
            put(out, 0, TURN + k, turn.apply(v));
        }
        let columns = rotation.transpose().rows;
        for (k, column) in columns.iter().enumerate() {
            put(out, 0, LINEAR + k, *column);
        }
        self.write_turning(q, w, out);
        if let Some(gravity) = acting.usual.acceleration() {
            for (k, turn) in turns.iter().enumerate() {
                put(out, LINEAR, TURN + k, turn.transpose_apply(gravity));
            }
        }
        self.write_velocities(v, w, acting.usual.damping(), out);
        if let Some((input, arm)) = acting.usual.input() {
            let arm = Mat3::skew(arm).transpose().rows;
            for (k, moment) in arm.into_iter().enumerate() {
                self.write_solved(Screw::new(basis(k), moment), INPUTS + input.places[k], out);
                self.write_solved(Screw::new(Vec3::zero(), basis(k)), INPUTS + input.places[3 + k], out);
            }
        }
    }

    /// η̇ = ½ η ∘ ω, linear in both.
    #[inline(always)]
    fn write_turning(&self, q: [T; 4], w: Vec3<T>, out: &mut impl Entries<T>) {
        let h = w.scale(T::lit(0.5));
        let zero = T::zero();
        let by_quaternion = [
            [zero, -h.x, -h.y, -h.z],
            [h.x, zero, h.z, -h.y],
            [h.y, -h.z, zero, h.x],
            [h.z, h.y, -h.x, zero],
        ];
        for (i, row) in by_quaternion.into_iter().enumerate() {
            for (j, entry) in row.into_iter().enumerate() {
                if i != j {
                    out.put(TURN + i, TURN + j, entry);
                }
            }
        }
        for k in 0..3 {
            for (i, entry) in quaternion_rate(q, basis(k)).into_iter().enumerate() {
                out.put(TURN + i, ANGULAR + k, entry);
            }
        }
    }

    /// The columns of v and ω in the rows of v̇ and ω̇.
    #[inline(always)]
    fn write_velocities(&self, v: Vec3<T>, w: Vec3<T>, damping: Option<Screw<T>>, out: &mut impl Entries<T>) {
        let r = self.inertia.com;
        let tensor = self.inertia.about_com.full();
        // M + Jω × ω by ω
        let gyroscopic = Mat3::skew(self.inertia.about_com.apply(w)) - Mat3::skew(w) * tensor;
        let gyroscopic = gyroscopic.transpose().rows;
        let (skew_r, skew_w) = (Mat3::skew(r).transpose().rows, Mat3::skew(w).transpose().rows);
        let com_velocity = Mat3::skew(w.cross_add(r, v)).transpose().rows;
        for k in 0..3 {
            // v̇ = ... + v × ω
            let turned = -skew_w[k];
            match damping {
                Some(d) => {
                    let push = basis::<T>(k).scale(-d.linear.to_array()[k]);
                    let s = self.inertia.solve_about_com(Screw::new(push, push.cross(r)));
                    put(out, LINEAR, LINEAR + k, s.linear + turned);
                    put(out, ANGULAR, LINEAR + k, s.angular);
                }
                None => put(out, LINEAR, LINEAR + k, turned),
            }
            let mut moment = gyroscopic[k];
            if let Some(d) = damping {
                moment = moment - basis::<T>(k).scale(d.angular.to_array()[k]);
            }
            let s = self.inertia.solve_about_com(Screw::new(Vec3::zero(), moment));
            put(out, LINEAR, ANGULAR + k, s.linear + w.cross_add(skew_r[k], com_velocity[k]));
            put(out, ANGULAR, ANGULAR + k, s.angular);
        }
    }

    /// Θ⁻¹ of a wrench about the mass centre, as a column.
    #[inline(always)]
    fn write_solved(&self, wrench: Screw<T>, column: usize, out: &mut impl Entries<T>) {
        let s = self.inertia.solve_about_com(wrench);
        put(out, LINEAR, column, s.linear);
        put(out, ANGULAR, column, s.angular);
    }
}

/// ∂C/∂η of the rotation that [`rotation_from_quaternion`] makes, for each of the four numbers.
#[inline(always)]
fn rotation_by_quaternion<T: Real>(q: [T; 4]) -> [Mat3<T>; 4] {
    let [w, x, y, z] = [q[0] + q[0], q[1] + q[1], q[2] + q[2], q[3] + q[3]];
    let (zero, two, rows) = (T::zero(), T::lit(-2.0), Mat3::from_rows);
    [
        rows(Vec3::new(zero, -z, y), Vec3::new(z, zero, -x), Vec3::new(-y, x, zero)),
        rows(Vec3::new(zero, y, z), Vec3::new(y, two * x, -w), Vec3::new(z, w, two * x)),
        rows(Vec3::new(two * y, x, w), Vec3::new(x, zero, z), Vec3::new(-w, z, two * y)),
        rows(Vec3::new(two * z, -w, x), Vec3::new(w, two * z, y), Vec3::new(x, y, zero)),
    ]
}
