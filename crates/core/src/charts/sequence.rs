//! The twelve angle sequences of section 4.

use crate::algebra::{Mat3, elementary};

/// An intrinsic angle sequence (i1, i2, i3): C = C_i1(α1) C_i2(α2) C_i3(α3). Konoplev, section 4
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    axes: [usize; 3],
}

const NAMES: [&str; 12] =
    ["zxz", "xyx", "yzy", "zyz", "xzx", "yxy", "xyz", "yzx", "zxy", "xzy", "zyx", "yxz"];

impl Sequence {
    /// The names of all twelve: the proper Euler sequences first, then the Tait–Bryan ones.
    pub fn names() -> [&'static str; 12] {
        NAMES
    }

    /// The sequence of a name such as "zyx" (ship: yaw, pitch, roll), "yzx" (aircraft) or "zxz" (Euler).
    pub fn parse(name: &str) -> Option<Self> {
        let known = NAMES.contains(&name);
        let axis = |i: usize| usize::from(name.as_bytes()[i] - b'x');
        known.then(|| Self { axes: [axis(0), axis(1), axis(2)] })
    }

    /// The name.
    pub fn name(self) -> &'static str {
        NAMES.into_iter().find(|n| Self::parse(n) == Some(self)).unwrap_or("zyx")
    }

    /// The three axes as numbers 0, 1, 2.
    #[inline(always)]
    pub fn axes(self) -> [usize; 3] {
        self.axes
    }

    /// Whether the first and the third axis are the same: a proper Euler sequence.
    pub fn is_proper_euler(self) -> bool {
        self.axes[0] == self.axes[2]
    }

    /// The distance of the second angle to the nearest singular one, rad, from 0 to π/2.
    pub fn singularity_distance(self, alpha: [f64; 3]) -> f64 {
        let (s, c) = alpha[1].sin_cos();
        let (near, far) = if self.is_proper_euler() { (s, c) } else { (c, s) };
        near.abs().atan2(far.abs())
    }

    /// +1 when i1 → i2 is a step of the cycle x → y → z → x, else −1.
    fn parity(self) -> f64 {
        if (self.axes[0] + 1) % 3 == self.axes[1] { 1.0 } else { -1.0 }
    }

    /// The angles of a rotation matrix, with α2 in \[0, π\] (proper Euler) or \[−π/2, π/2\] (Tait–Bryan).
    ///
    /// Where the first and third axes align, only their combined turn exists: α1 is then taken from
    /// `like`, and α3 completes the rotation.
    pub fn angles_of(self, c: &Mat3<f64>, like: [f64; 3]) -> [f64; 3] {
        let [i, j, k3] = self.axes;
        let third = 3 - i - j;
        let sign = self.parity();
        let e = |m: &Mat3<f64>, r: usize, s: usize| m.rows[r].to_array()[s];
        // The third rotation axis in world axes, C2 e_i3, holds α1 and α2 alone.
        let (u, v, w) = (e(c, i, k3), e(c, j, k3), e(c, third, k3));
        let size = v.hypot(w);
        let (a1, a2) = if self.is_proper_euler() {
            (v.atan2(-sign * w), size.atan2(u))
        } else {
            ((-sign * v).atan2(w), (sign * u).atan2(size))
        };
        // Below, rounding alone decides the direction.
        let a1 = if size < 1e-14 { like[0] } else { a1 };
        // With α1 and α2 known, C_i3(α3) = (C_i1 C_i2)ᵀ C.
        let rest = (elementary(i, a1) * elementary(j, a2)).transpose() * *c;
        let (p, q) = ((k3 + 1) % 3, (k3 + 2) % 3);
        [a1, a2, e(&rest, q, p).atan2(e(&rest, p, p))]
    }

    /// The angle triple of the same rotation that lies nearest to `like`.
    ///
    /// Every rotation has two families of triples, (α1, α2, α3) and (α1 + π, ±α2, α3 + π), each up to whole turns.
    pub fn nearest(self, angles: [f64; 3], like: [f64; 3]) -> [f64; 3] {
        use std::f64::consts::{PI, TAU};
        let [a, b, c] = angles;
        let other = if self.is_proper_euler() { [a + PI, -b, c + PI] } else { [a + PI, PI - b, c + PI] };
        let unwrap = |x: [f64; 3]| {
            let mut y = x;
            for (v, l) in y.iter_mut().zip(like) {
                *v += TAU * ((l - *v) / TAU).round();
            }
            y
        };
        let gap = |x: [f64; 3]| (0..3).map(|m| (x[m] - like[m]).powi(2)).sum::<f64>();
        let (first, second) = (unwrap(angles), unwrap(other));
        if gap(second) < gap(first) { second } else { first }
    }
}
