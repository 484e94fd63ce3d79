//! The unit quaternion (w, x, y, z), world from body: the chart without a singularity.

use crate::algebra::{Vec3, multiply};
use crate::scalar::Real;

/// η̇ = ½ η ∘ (0; ω), ω in body axes.
#[inline(always)]
pub fn quaternion_rate<T: Real>(q: [T; 4], w: Vec3<T>) -> [T; 4] {
    let [s, x, y, z] = q;
    let h = w.scale(T::lit(0.5));
    [
        -(x.fma(h.x, y.fma(h.y, z * h.z))),
        s.fma(h.x, y.fma(h.z, -(z * h.y))),
        s.fma(h.y, z.fma(h.x, -(x * h.z))),
        s.fma(h.z, x.fma(h.y, -(y * h.x))),
    ]
}

/// ω in body axes of a quaternion and its rate: the vector part of 2 η* ∘ η̇.
#[inline(always)]
pub fn angular_velocity<T: Real>(q: [T; 4], rate: [T; 4]) -> Vec3<T> {
    let conjugate = [q[0], -q[1], -q[2], -q[3]];
    let [_, x, y, z] = multiply(conjugate, rate);
    Vec3::new(x, y, z).scale(T::lit(2.0))
}

/// η̈ = ½ (η̇ ∘ (0; ω) + η ∘ (0; ω*)).
#[inline(always)]
pub fn quaternion_second_rate<T: Real>(q: [T; 4], rate: [T; 4], w: Vec3<T>, dw: Vec3<T>) -> [T; 4] {
    let (a, b) = (quaternion_rate(rate, w), quaternion_rate(q, dw));
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
}
