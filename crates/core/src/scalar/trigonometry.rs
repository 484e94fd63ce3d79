//! Sine and cosine over lanes (temporary: per-lane library calls).
use super::Lane;
/// Sine and cosine.
#[inline(always)]
pub fn sin_cos<T: Lane>(x: T) -> (T, T) {
    (T::from_lanes(|l| x.get(l).sin()), T::from_lanes(|l| x.get(l).cos()))
}
