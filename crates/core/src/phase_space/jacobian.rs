//! ∂f/∂x and ∂f/∂u in closed form: of bodies in quaternions and quasi-velocities under the usual forces. (3.2)
//!
//! The derivatives through duals are the general way; this one knows which entries are zero and what is constant.

use super::FreeBody;
use super::orientation::quaternion_of;
use super::pattern::{ANGULAR, LINEAR, PLACES, STATES, TURN, varies};
use crate::algebra::{Mat3, Vec3, basis, rotation_from_quaternion};
use crate::forces::Acting;
use crate::inertia::Inertia;
use crate::scalar::Real;
use crate::screw::Screw;

/// Where the entries of a matrix are written.
pub trait Entries<T> {
    /// Writes one of them.
    fn put(&mut self, row: usize, column: usize, value: T);
}

/// What of the Jacobian does not depend on the state.
#[derive(Clone, Debug)]
pub struct ClosedJacobian {
    /// ∂f/∂x and ∂f/∂u by rows; where they are not constant, zeros.
    by_state: [f64; STATES * STATES],
    by_input: Vec<f64>,
    inputs: usize,
    gravity: Option<Vec3<f64>>,
    /// The columns of v in the rows of v̇ and ω̇, without what turns with ω.
    by_linear: [Screw<f64>; 3],
    /// The columns of ω, without what changes with ω.
    by_angular: [Screw<f64>; 3],
    /// By how much each of the three numbers of ω changes these columns.
    by_angular_of: [[Screw<f64>; 3]; 3],
}

impl ClosedJacobian {
    /// Of a body that it knows.
    pub fn new(body: &FreeBody<f64>) -> Option<Self> {
        let Acting { usual, .. } =
            body.acting.as_ref().filter(|_| body.is_plain() && body.compiled.is_none())?;
        let inertia = &body.inertia;
        let damping = usual.damping().unwrap_or(Screw::zero());
        let axes: [Vec3<f64>; 3] = [basis(0), basis(1), basis(2)];
        let [slowed, braked] = [damping.linear, damping.angular].map(Vec3::to_array);
        let by_linear = [0, 1, 2].map(|k| {
            let push = axes[k].scale(-slowed[k]);
            inertia.solve_about_com(Screw::new(push, push.cross(inertia.com)))
        });
        let by_angular = [0, 1, 2].map(|k| {
            let moment = axes[k].scale(-braked[k]);
            inertia.solve_about_com(Screw::new(Vec3::zero(), moment))
        });
        let by_angular_of = axes.map(|w| axes.map(|e| turning(inertia, w, e)));
        let inputs = usual.inputs_end();
        let mut made = Self {
            by_state: [0.0; STATES * STATES],
            by_input: vec![0.0; STATES * inputs],
            inputs,
            gravity: usual.acceleration(),
            by_linear,
            by_angular,
            by_angular_of,
        };
        for (k, column) in by_linear.into_iter().enumerate() {
            made.keep(column, LINEAR + k);
        }
        if let Some((input, arm)) = usual.input() {
            let arm = Mat3::skew(arm).transpose().rows;
            for (k, moment) in arm.into_iter().enumerate() {
                let (pushed, turned) = (Screw::new(axes[k], moment), Screw::new(Vec3::zero(), axes[k]));
                made.keep(inertia.solve_about_com(pushed), STATES + input.places[k]);
                made.keep(inertia.solve_about_com(turned), STATES + input.places[3 + k]);
            }
        }
        Some(made)
    }

    /// Keeps those entries of a column that do not change.
    fn keep(&mut self, s: Screw<f64>, column: usize) {
        let entries = s.linear.to_array().into_iter().chain(s.angular.to_array());
        for (row, entry) in (LINEAR..).zip(entries) {
            if column >= STATES {
                self.by_input[row * self.inputs + column - STATES] = entry;
            } else if !varies(row, column) {
                self.by_state[row * STATES + column] = entry;
            }
        }
    }

    /// How many inputs it knows.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// An entry that does not change, of those that change zero.
    pub fn constant(&self, row: usize, column: usize) -> f64 {
        match column.checked_sub(STATES) {
            None => self.by_state[row * STATES + column],
            Some(input) => self.by_input[row * self.inputs + input],
        }
    }

    /// Writes the entries that do not change.
    pub fn write_constant(&self, by_state: &mut [f64], by_input: &mut [f64]) {
        by_state.copy_from_slice(&self.by_state);
        by_input.copy_from_slice(&self.by_input);
    }

    /// The places of those that do not change for want of gravity.
    pub fn still(&self) -> impl Iterator<Item = usize> {
        let rows = if self.gravity.is_some() { LINEAR..LINEAR } else { LINEAR..ANGULAR };
        rows.flat_map(|row| PLACES[row][TURN..LINEAR].iter().copied())
    }

    /// Writes the entries that change with the state x. Konoplev (3.2)
    #[inline(always)]
    pub fn write_varying<T: Real>(&self, x: &[T; STATES], out: &mut impl Entries<T>) {
        let q = quaternion_of(&x[TURN..]);
        let (v, w) = (Vec3::from_slice(&x[LINEAR..]), Vec3::from_slice(&x[ANGULAR..]));
        // ȯ = C v
        let [a, b, c, d] = turned_by_quaternion([q[0] + q[0], q[1] + q[1], q[2] + q[2], q[3] + q[3]], v);
        put(out, 0, TURN, a);
        put(out, 0, TURN + 1, b);
        put(out, 0, TURN + 2, c);
        put(out, 0, TURN + 3, d);
        let [a, b, c] = rotation_from_quaternion(q).transpose().rows;
        put(out, 0, LINEAR, a);
        put(out, 0, LINEAR + 1, b);
        put(out, 0, LINEAR + 2, c);
        write_turning(q, w, out);
        self.write_velocities(v, w, out);
        // v̇ = ... + Cᵀ g: the same as C with the sign of the quaternion's scalar turned
        if let Some(g) = self.gravity {
            let doubled = [-(q[0] + q[0]), q[1] + q[1], q[2] + q[2], q[3] + q[3]];
            let [a, b, c, d] = turned_by_quaternion(doubled, Vec3::lit(g.to_array()));
            put(out, LINEAR, TURN, -a);
            put(out, LINEAR, TURN + 1, b);
            put(out, LINEAR, TURN + 2, c);
            put(out, LINEAR, TURN + 3, d);
        }
    }

    /// The columns of v and ω in the rows of v̇ and ω̇.
    #[inline(always)]
    fn write_velocities<T: Real>(&self, v: Vec3<T>, w: Vec3<T>, out: &mut impl Entries<T>) {
        // v̇ = ... + v × ω
        let [a, b, c] = self.by_linear;
        out.put(LINEAR + 1, LINEAR, T::lit(a.linear.y) - w.z);
        out.put(LINEAR + 2, LINEAR, T::lit(a.linear.z) + w.y);
        out.put(LINEAR, LINEAR + 1, T::lit(b.linear.x) + w.z);
        out.put(LINEAR + 2, LINEAR + 1, T::lit(b.linear.z) - w.x);
        out.put(LINEAR, LINEAR + 2, T::lit(c.linear.x) - w.y);
        out.put(LINEAR + 1, LINEAR + 2, T::lit(c.linear.y) + w.x);
        let s = self.column(0, w);
        put(out, LINEAR, ANGULAR, Vec3::new(s.linear.x, s.linear.y + v.z, s.linear.z - v.y));
        put(out, ANGULAR, ANGULAR, s.angular);
        let s = self.column(1, w);
        put(out, LINEAR, ANGULAR + 1, Vec3::new(s.linear.x - v.z, s.linear.y, s.linear.z + v.x));
        put(out, ANGULAR, ANGULAR + 1, s.angular);
        let s = self.column(2, w);
        put(out, LINEAR, ANGULAR + 2, Vec3::new(s.linear.x + v.y, s.linear.y - v.x, s.linear.z));
        put(out, ANGULAR, ANGULAR + 2, s.angular);
    }

    /// A column of ω where v is zero.
    #[inline(always)]
    fn column<T: Real>(&self, k: usize, w: Vec3<T>) -> Screw<T> {
        let ([x, y, z], s) = (&self.by_angular_of, self.by_angular[k]);
        Screw::new(
            along(w, [x[k].linear, y[k].linear, z[k].linear], s.linear),
            along(w, [x[k].angular, y[k].angular, z[k].angular], s.angular),
        )
    }
}

/// The sum of three constant vectors, so many of each, and of another.
#[inline(always)]
fn along<T: Real>(w: Vec3<T>, [x, y, z]: [Vec3<f64>; 3], sum: Vec3<f64>) -> Vec3<T> {
    lit::<T>(x).scale_add(w.x, lit::<T>(y).scale_add(w.y, lit::<T>(z).scale_add(w.z, lit(sum))))
}

#[inline(always)]
fn lit<T: Real>(v: Vec3<f64>) -> Vec3<T> {
    Vec3::lit(v.to_array())
}

/// Writes three numbers one below the other.
#[inline(always)]
fn put<T: Real>(out: &mut impl Entries<T>, row: usize, column: usize, v: Vec3<T>) {
    out.put(row, column, v.x);
    out.put(row + 1, column, v.y);
    out.put(row + 2, column, v.z);
}

/// By how much ω along `e` changes the accelerations of a body that turns with `w`: they are linear in that.
fn turning(body: &Inertia<f64>, w: Vec3<f64>, e: Vec3<f64>) -> Screw<f64> {
    let (tensor, r) = (body.about_com, body.com);
    // M_c + J_c ω × ω
    let moment = tensor.apply(w).cross(e) - w.cross(tensor.apply(e));
    let s = body.solve_about_com(Screw::new(Vec3::zero(), moment));
    // v̇ = ... + (v + ω × r_c) × ω, and its own r_c × ω̇ is in s
    Screw::new(s.linear + w.cross_add(r.cross(e), w.cross(r).cross(e)), s.angular)
}

/// η̇ = ½ η ∘ ω, linear in both.
#[inline(always)]
fn write_turning<T: Real>(q: [T; 4], w: Vec3<T>, out: &mut impl Entries<T>) {
    let half = T::lit(0.5);
    let [s, x, y, z] = [q[0] * half, q[1] * half, q[2] * half, q[3] * half];
    put(out, TURN + 1, ANGULAR, Vec3::new(s, z, -y));
    put(out, TURN + 1, ANGULAR + 1, Vec3::new(-z, s, x));
    put(out, TURN + 1, ANGULAR + 2, Vec3::new(y, -x, s));
    let h = w.scale(half);
    let columns = [h.x, h.y, h.z];
    for (k, (h, q)) in columns.into_iter().zip([x, y, z]).enumerate() {
        out.put(TURN, ANGULAR + k, -q);
        out.put(TURN + 1 + k, TURN, h);
        out.put(TURN, TURN + 1 + k, -h);
    }
    // Of the quaternion's vector part, -ω/2 × itself.
    out.put(TURN + 1, TURN + 2, h.z);
    out.put(TURN + 2, TURN + 1, -h.z);
    out.put(TURN + 2, TURN + 3, h.x);
    out.put(TURN + 3, TURN + 2, -h.x);
    out.put(TURN + 3, TURN + 1, h.y);
    out.put(TURN + 1, TURN + 3, -h.y);
}

/// ∂(C v)/∂η of the rotation that [`rotation_from_quaternion`] makes, for each of the four numbers; their doubles are
/// given.
///
/// With u the vector part, a = u × v, b = w v + a and d = u · v the columns are a and, for the k-th unit vector e,
/// d e + b × e - u_k v.
#[inline(always)]
fn turned_by_quaternion<T: Real>([w, x, y, z]: [T; 4], v: Vec3<T>) -> [Vec3<T>; 4] {
    let u = Vec3::new(x, y, z);
    let a = u.cross(v);
    let (b, d) = (v.scale_add(w, a), u.dot(v));
    [
        a,
        Vec3::new((-x).fma(v.x, d), (-x).fma(v.y, -b.z), (-x).fma(v.z, b.y)),
        Vec3::new((-y).fma(v.x, b.z), (-y).fma(v.y, d), (-y).fma(v.z, -b.x)),
        Vec3::new((-z).fma(v.x, -b.y), (-z).fma(v.y, b.x), (-z).fma(v.z, d)),
    ]
}
