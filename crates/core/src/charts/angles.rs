//! What an angle sequence does at one orientation: C, M0, M1, their rates and inverses. (2.2)–(2.6)

use super::Sequence;
use crate::algebra::{Mat3, Mat6, Vec3, basis, elementary};
use crate::scalar::Real;

/// The partial rotations C_0 = E, C_1, C_2 and C = C_3. Konoplev (2.3)
pub fn partial_rotations<T: Real>(sequence: Sequence, alpha: Vec3<T>) -> [Mat3<T>; 4] {
    let [i1, i2, i3] = sequence.axes();
    let c1 = elementary(i1, alpha.x);
    let c2 = c1 * elementary(i2, alpha.y);
    let c3 = c2 * elementary(i3, alpha.z);
    [Mat3::identity(), c1, c2, c3]
}

/// ⟨ω⁰⟩ = Σ C_k⟨e_{i_{k+1}}⟩C_kᵀ α̇_{k+1}. Konoplev (2.6)
pub fn angular_velocity_skew<T: Real>(sequence: Sequence, alpha: Vec3<T>, rate: Vec3<T>) -> Mat3<T> {
    let c = partial_rotations(sequence, alpha);
    let rate = rate.to_array();
    let mut sum = Mat3::zero();
    for (k, axis) in sequence.axes().into_iter().enumerate() {
        sum = sum + (c[k] * Mat3::skew(basis(axis)) * c[k].transpose()).scale(rate[k]);
    }
    sum
}

/// An angle sequence at given angles α.
#[derive(Clone, Copy, Debug)]
pub struct AngleChart<T> {
    /// C, world from body.
    pub rotation: Mat3<T>,
    /// The three rotation axes in body axes: the columns of M1.
    body_axes: [Vec3<T>; 3],
    /// 1/det M1; not finite where the first and third axes align.
    inverse_determinant: T,
}

impl<T: Real> AngleChart<T> {
    /// Of a sequence and its angles. Konoplev (2.3)
    #[inline(always)]
    pub fn new(sequence: Sequence, alpha: Vec3<T>) -> Self {
        let [i1, i2, i3] = sequence.axes();
        let second = elementary(i2, alpha.y);
        let third = elementary(i3, alpha.z);
        let rotation = elementary(i1, alpha.x) * second * third;
        // M1 = CᵀM0: the last axis is fixed in the body, the others are turned back into it.
        let a = third.transpose_apply(second.transpose_apply(basis(i1)));
        let b = third.transpose_apply(basis(i2));
        let c = basis(i3);
        let inverse_determinant = T::one() / a.dot(b.cross(c));
        Self { rotation, body_axes: [a, b, c], inverse_determinant }
    }

    /// M1: ω in body axes = M1 α̇. Konoplev (2.3)
    #[inline(always)]
    pub fn rate_matrix_body(&self) -> Mat3<T> {
        let [a, b, c] = self.body_axes;
        Mat3::from_columns(a, b, c)
    }

    /// M0 = C M1: ω in world axes = M0 α̇. Konoplev (2.3)
    pub fn rate_matrix_world(&self) -> Mat3<T> {
        self.rotation * self.rate_matrix_body()
    }

    /// M1⁻¹, in closed form: the second axis is normal to the other two.
    #[inline(always)]
    pub fn rate_matrix_body_inverse(&self) -> Mat3<T> {
        let [a, b, c] = self.body_axes;
        let s = self.inverse_determinant;
        Mat3::from_rows(b.cross(c).scale(s), b, a.cross(b).scale(s))
    }

    /// M0⁻¹ = M1⁻¹Cᵀ.
    pub fn rate_matrix_world_inverse(&self) -> Mat3<T> {
        self.rate_matrix_body_inverse() * self.rotation.transpose()
    }

    /// Ṁ0 = \[0, ω1 × C1 e_i2, ω2 × C2 e_i3\]. Konoplev (2.5)
    pub fn rate_matrix_world_dot(&self, rate: Vec3<T>) -> Mat3<T> {
        let [a, b, c] = self.rate_matrix_world().transpose().rows;
        let first = a.scale(rate.x);
        let second = first + b.scale(rate.y);
        Mat3::from_columns(Vec3::zero(), first.cross(b), second.cross(c))
    }

    /// CᵀṀ0α̇, the part of ω̇ in body axes that does not come from α̈. Konoplev (2.13)
    #[inline(always)]
    pub fn convective_rate(&self, rate: Vec3<T>) -> Vec3<T> {
        let [a, b, c] = self.body_axes;
        let first = a.scale(rate.x);
        let second = first + b.scale(rate.y);
        first.cross(b).scale(rate.y) + second.cross(c).scale(rate.z)
    }

    /// ω in body axes of the angle rates, by columns: M1 α̇. Konoplev (2.3)
    #[inline(always)]
    pub fn angular_velocity(&self, rate: Vec3<T>) -> Vec3<T> {
        let [a, b, c] = self.body_axes;
        a.scale_add(rate.x, b.scale_add(rate.y, c.scale(rate.z)))
    }

    /// The angle rates of ω in body axes: M1⁻¹ ω. Konoplev (2.3)
    #[inline(always)]
    pub fn rates(&self, w: Vec3<T>) -> Vec3<T> {
        self.rate_matrix_body_inverse().apply(w)
    }

    /// D = diag(Cᵀ, M1): V = D q̇. Konoplev (2.2)
    pub fn velocity_map(&self) -> Mat6<T> {
        Mat6::diagonal(self.rotation.transpose(), self.rate_matrix_body())
    }

    /// D⁻¹ = diag(C, M1⁻¹): q̇ = D⁻¹V. Konoplev (2.2)
    pub fn velocity_map_inverse(&self) -> Mat6<T> {
        Mat6::diagonal(self.rotation, self.rate_matrix_body_inverse())
    }

    /// Ḋ = diag(−⟨ω⟩Cᵀ, Ṁ1), with Ṁ1 = Cᵀ(Ṁ0 − ⟨ω⁰⟩M0). Konoplev (2.4)
    pub fn velocity_map_dot(&self, rate: Vec3<T>) -> Mat6<T> {
        let ct = self.rotation.transpose();
        let w = Mat3::skew(self.angular_velocity(rate));
        let m1_dot = ct * self.rate_matrix_world_dot(rate) - w * self.rate_matrix_body();
        Mat6::diagonal(-(w * ct), m1_dot)
    }

    /// K = diag(⟨ω⁰⟩ᵀ, M0⁻¹Ṁ0): K q̇ = D⁻¹Ḋ q̇. Konoplev (2.5)
    pub fn convective_matrix(&self, rate: Vec3<T>) -> Mat6<T> {
        let w = self.rotation.apply(self.angular_velocity(rate));
        let lower = self.rate_matrix_world_inverse() * self.rate_matrix_world_dot(rate);
        Mat6::diagonal(Mat3::skew(w).transpose(), lower)
    }
}
