//! Rotation matrices and unit quaternions (w, x, y, z), both `world_from_body`.

use super::{Mat3, Vec3};
use crate::scalar::Real;

/// The elementary rotation `C_i(a)` about axis `i` (0, 1 or 2), with 1 at place (i, i). Konoplev, notation
#[inline(always)]
pub fn elementary<T: Real>(i: usize, a: T) -> Mat3<T> {
    let (s, c) = a.sin_cos();
    let (o, l) = (T::zero(), T::one());
    match i {
        0 => Mat3::from_rows(Vec3::new(l, o, o), Vec3::new(o, c, -s), Vec3::new(o, s, c)),
        1 => Mat3::from_rows(Vec3::new(c, o, s), Vec3::new(o, l, o), Vec3::new(-s, o, c)),
        _ => Mat3::from_rows(Vec3::new(c, -s, o), Vec3::new(s, c, o), Vec3::new(o, o, l)),
    }
}

/// The rotation matrix of a unit quaternion.
#[inline(always)]
pub fn rotation_from_quaternion<T: Real>(q: [T; 4]) -> Mat3<T> {
    let [w, x, y, z] = q;
    let (x2, y2, z2) = (x + x, y + y, z + z);
    // As few products as there are: sums have units of their own in a processor.
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    let (xx, yy, zz) = (x * x2, y * y2, z * z2);
    let (xy, xz, yz) = (x * y2, x * z2, y * z2);
    let one = T::one();
    Mat3::from_rows(
        Vec3::new(one - (yy + zz), xy - wz, xz + wy),
        Vec3::new(xy + wz, one - (xx + zz), yz - wx),
        Vec3::new(xz - wy, yz + wx, one - (xx + yy)),
    )
}

/// The product `a ∘ b` of two quaternions.
#[inline(always)]
pub fn multiply<T: Real>(a: [T; 4], b: [T; 4]) -> [T; 4] {
    let (u, v) = (Vec3::new(a[1], a[2], a[3]), Vec3::new(b[1], b[2], b[3]));
    let r = u.scale_add(b[0], v.scale_add(a[0], u.cross(v)));
    [a[0].fma(b[0], -u.dot(v)), r.x, r.y, r.z]
}

/// The quaternion divided by its length.
#[inline(always)]
pub fn normalized<T: Real>(q: [T; 4]) -> [T; 4] {
    let [w, x, y, z] = q;
    let s = T::one() / w.fma(w, x.fma(x, y.fma(y, z * z))).sqrt();
    [w * s, x * s, y * s, z * s]
}

/// The unit quaternion of a rotation matrix, with `w ≥ 0`.
///
/// Divides by the largest of the four components, so it is accurate everywhere (Shepperd 1978).
pub fn quaternion_from_rotation(c: &Mat3<f64>) -> [f64; 4] {
    let [a, b, d] = c.rows;
    let trace = a.x + b.y + d.z;
    let candidates = [trace, a.x, b.y, d.z];
    let largest = (0..4).fold(0, |best, i| if candidates[i] > candidates[best] { i } else { best });
    let q = match largest {
        0 => [1.0 + trace, d.y - b.z, a.z - d.x, b.x - a.y],
        1 => [d.y - b.z, 1.0 + a.x - b.y - d.z, a.y + b.x, a.z + d.x],
        2 => [a.z - d.x, a.y + b.x, 1.0 - a.x + b.y - d.z, b.z + d.y],
        _ => [b.x - a.y, a.z + d.x, b.z + d.y, 1.0 - a.x - b.y + d.z],
    };
    let [w, x, y, z] = normalized(q);
    if w < 0.0 { [-w, -x, -y, -z] } else { [w, x, y, z] }
}

/// Whether a matrix is a rotation: `CᵀC = E` to `tolerance` in every entry, and a positive determinant.
pub fn is_rotation(c: &Mat3<f64>, tolerance: f64) -> bool {
    let gap = c.transpose() * *c - Mat3::identity();
    gap.rows.iter().all(|r| r.to_array().iter().all(|e| e.abs() <= tolerance)) && c.determinant() > 0.0
}
