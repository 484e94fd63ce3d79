//! The matrix analogue of Lagrange's equations of the second kind: (2.9)–(2.12).

use crate::algebra::{Mat6, Vec3};
use crate::charts::{AngleChart, Sequence};
use crate::generalized::Generalized;
use crate::inertia::Inertia;
use crate::scalar::{Dual, Real};
use crate::screw::{Screw, force_cross};

/// The matrices of (2.9) and (2.10) at one state, written as the paper writes them.
#[derive(Clone, Copy, Debug)]
pub struct Lagrange<T> {
    /// A = DᵀΘD, the kinetic-energy matrix. Konoplev (2.9)
    pub a: Mat6<T>,
    /// A⁻¹ = D⁻¹Θ⁻¹D⁻ᵀ.
    pub a_inverse: Mat6<T>,
    /// Φ^q = DᵀΦD⁻ᵀ. Konoplev (2.9)
    pub phi_up_q: Mat6<T>,
    /// B = AK + Φ^q A. Konoplev (2.10)
    pub b: Mat6<T>,
    /// Φ_q = K + A⁻¹Φ^q A: the same matrix as Φ1. Konoplev (2.9)
    pub phi_q: Mat6<T>,
}

impl<T: Real> Lagrange<T> {
    /// Of the matrices of section 2 at the same state.
    pub fn new(body: &Inertia<T>, g: &Generalized<T>) -> Self {
        let dt = g.d.transpose();
        let a = dt * body.matrix() * g.d;
        let a_inverse = g.d_inverse * body.inverse_matrix() * g.d_inverse.transpose();
        let phi_up_q = dt * force_cross(g.twist) * g.d_inverse.transpose();
        Self { a, a_inverse, phi_up_q, b: a * g.k + phi_up_q * a, phi_q: g.k + a_inverse * (phi_up_q * a) }
    }

    /// q̈ of (2.9): A⁻¹Q − Φ_q q̇. Konoplev (2.9)
    pub fn acceleration_2_9(&self, q_dot: Screw<T>, force: Screw<T>) -> Screw<T> {
        self.a_inverse.apply(force) - self.phi_q.apply(q_dot)
    }

    /// The generalized forces A q̈ + B q̇ that a motion needs, the left side of (2.10). Konoplev (2.10)
    pub fn inverse_dynamics(&self, q_dot: Screw<T>, q_ddot: Screw<T>) -> Screw<T> {
        self.a.apply(q_ddot) + self.b.apply(q_dot)
    }

    /// q̈ of (2.10): A⁻¹(Q − B q̇). Konoplev (2.10)
    pub fn acceleration_2_10(&self, q_dot: Screw<T>, force: Screw<T>) -> Screw<T> {
        self.a_inverse.apply(force - self.b.apply(q_dot))
    }
}

/// The generalized forces Q = DᵀF. Konoplev (2.9)
pub fn generalized_force<T: Real>(chart: &AngleChart<T>, wrench: Screw<T>) -> Screw<T> {
    chart.velocity_map().transpose().apply(wrench)
}

/// T(q, q̇) = ½ q̇ᵀAq̇, from V = D q̇.
fn kinetic_energy<T: Real>(body: &Inertia<T>, sequence: Sequence, alpha: Vec3<T>, q_dot: Screw<T>) -> T {
    let chart = AngleChart::new(sequence, alpha);
    body.kinetic_energy(chart.velocity_map().apply(q_dot))
}

/// d/dt ∂T/∂q̇ − ∂T/∂q by exact differentiation of the kinetic energy alone. Konoplev (2.11)
///
/// The inner dual carries d/dt along (q̇, q̈), the outer one the partial derivatives.
pub fn lagrange_operator<T: Real>(
    body: &Inertia<T>,
    sequence: Sequence,
    alpha: Vec3<T>,
    q_dot: Screw<T>,
    q_ddot: Screw<T>,
) -> [T; 6] {
    type Along<T> = Dual<T, 1>;
    type Nested<T> = Dual<Along<T>, 1>;
    let along = |x: T, rate: T| Along { value: x, slope: [rate] };
    let nested =
        |x: Along<T>, seed: bool| Nested { value: x, slope: [Along::lit(f64::from(u8::from(seed)))] };
    let body = body.map(&mut |x| Nested::constant(Along::constant(x)));
    let (mut dq, mut ddq) = ([T::zero(); 6], [T::zero(); 6]);
    q_dot.store(&mut dq);
    q_ddot.store(&mut ddq);
    let a = alpha.to_array();
    let energy = |velocity_seed: usize, angle_seed: usize| {
        let mut v = [Nested::lit(0.0); 6];
        for i in 0..6 {
            v[i] = nested(along(dq[i], ddq[i]), i == velocity_seed);
        }
        let mut angle = [Nested::lit(0.0); 3];
        for i in 0..3 {
            angle[i] = nested(along(a[i], dq[3 + i]), 3 + i == angle_seed);
        }
        kinetic_energy(&body, sequence, Vec3::from_array(angle), Screw::from_slice(&v)).slope[0]
    };
    let none = 6;
    let mut out = [T::zero(); 6];
    for (s, o) in out.iter_mut().enumerate() {
        // T does not depend on the position, whose seeds 0..3 therefore find nothing.
        *o = energy(s, none).slope[0] - energy(none, s).value;
    }
    out
}

/// The Christoffel symbols of the second kind {s; i j} of A(q), exact: `[s][i][j]`. Konoplev (2.12)
pub fn christoffel_symbols<T: Real>(
    body: &Inertia<T>,
    sequence: Sequence,
    alpha: Vec3<T>,
) -> [[[T; 6]; 6]; 6] {
    let lifted = body.map(&mut |x| Dual::<T, 1>::constant(x));
    let entries = |m: &Mat6<T>| {
        let mut flat = [T::zero(); 36];
        m.store(&mut flat);
        flat
    };
    // da[k] = ∂A/∂q_k: zero for the position.
    let mut da = [[T::zero(); 36]; 6];
    for k in 0..3 {
        let mut angle = [Dual::lit(0.0); 3];
        for (i, (d, x)) in angle.iter_mut().zip(alpha.to_array()).enumerate() {
            *d = Dual { value: x, slope: [T::lit(f64::from(u8::from(i == k)))] };
        }
        let d = AngleChart::new(sequence, Vec3::from_array(angle)).velocity_map();
        let a = d.transpose() * lifted.matrix() * d;
        let mut flat = [Dual::lit(0.0); 36];
        a.store(&mut flat);
        for (o, x) in da[3 + k].iter_mut().zip(flat) {
            *o = x.slope[0];
        }
    }
    let inverse_map = AngleChart::new(sequence, alpha).velocity_map_inverse();
    let inverse = entries(&(inverse_map * body.inverse_matrix() * inverse_map.transpose()));
    let mut symbols = [[[T::zero(); 6]; 6]; 6];
    for i in 0..6 {
        for j in 0..6 {
            for r in 0..6 {
                let first = (da[i][6 * r + j] + da[j][6 * r + i] - da[r][6 * i + j]) * T::lit(0.5);
                for (s, out) in symbols.iter_mut().enumerate() {
                    out[i][j] = inverse[6 * s + r].fma(first, out[i][j]);
                }
            }
        }
    }
    symbols
}

/// Σ_ij {s; i j} q̇_i q̇_j, which equals Φ_q q̇. Konoplev (2.12)
pub fn christoffel_sums<T: Real>(
    body: &Inertia<T>,
    sequence: Sequence,
    alpha: Vec3<T>,
    q_dot: Screw<T>,
) -> [T; 6] {
    let mut dq = [T::zero(); 6];
    q_dot.store(&mut dq);
    let symbols = christoffel_symbols(body, sequence, alpha);
    let mut out = [T::zero(); 6];
    for (o, s) in out.iter_mut().zip(&symbols) {
        for (row, a) in s.iter().zip(dq) {
            for (x, b) in row.iter().zip(dq) {
                *o = x.fma(a * b, *o);
            }
        }
    }
    out
}
