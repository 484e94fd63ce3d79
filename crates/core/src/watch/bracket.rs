//! Changes of sign in brackets, one in each lane.

use crate::integrators::Lanes;
use crate::scalar::Lane;

/// Bisection alone would be done by then: a bracket is at most twice as wide as its later end is far from zero.
const MOST: i32 = 64;

/// Times between which a function leaves the positive numbers: positive (or zero) at `a`, not at `b`.
#[derive(Clone, Copy, Debug)]
pub struct Bracket<T> {
    pub a: T,
    pub b: T,
    pub at_a: T,
    pub at_b: T,
}

impl<T: Lane> Bracket<T> {
    /// Makes the bracket as narrow as times are resolved, in `lanes`; what it does in a lane depends on that lane alone.
    ///
    /// Interpolate, truncate, project: never more than a step behind bisection, and quicker than it on smooth functions
    /// (Oliveira & Takahashi, ACM Trans. Math. Softw. 47 (2021), 5).
    #[inline(always)]
    pub fn close(mut self, lanes: Lanes, mut f: impl FnMut(T) -> T) -> Self {
        let (zero, half) = (T::zero(), T::lit(0.5));
        let width_0 = self.b - self.a;
        let tolerance = T::lit(f64::EPSILON).fma(self.a.abs().max(self.b.abs()), T::lit(f64::MIN_POSITIVE));
        for turn in 0..MOST {
            let width = self.b - self.a;
            let open = lanes.without(Lanes::where_le(width, tolerance));
            if open.is_empty() {
                break;
            }
            let middle = half * (self.a + self.b);
            let secant = (self.b * self.at_a - self.a * self.at_b) / (self.at_a - self.at_b);
            let inward = T::select_le(secant, middle, T::one(), -T::one());
            let nudge = T::lit(0.2) * width * width / width_0;
            let nudged = T::select_le(nudge, (middle - secant).abs(), inward.fma(nudge, secant), middle);
            let radius = width_0 * T::lit(0.5f64.powi(turn)) - half * width;
            let far = middle - inward * radius;
            let x = T::select_le((nudged - middle).abs(), radius, nudged, far);
            let at_x = f(open.select(x, self.b));
            let before = open.and(Lanes::where_le(zero, at_x)).without(Lanes::where_le(at_x, zero));
            let behind = open.without(before);
            self.a = before.select(x, self.a);
            self.at_a = before.select(at_x, self.at_a);
            self.b = behind.select(x, self.b);
            self.at_b = behind.select(at_x, self.at_b);
        }
        self
    }
}

/// The value where the tangents at both ends of a step of length `h` meet: a function that bends away from zero there
/// is nowhere below.
#[inline(always)]
pub fn tangents_meet<T: Lane>([p0, p1]: [T; 2], [q0, q1]: [T; 2], h: T) -> T {
    q0.fma((p1 - p0 - q1 * h) / (q0 - q1), p0)
}

/// -1, 0 or 1; 0 of what is not a number.
#[inline(always)]
pub fn sign<T: Lane>(x: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    T::select_le(zero, x, one, zero) - T::select_le(x, zero, one, zero)
}
