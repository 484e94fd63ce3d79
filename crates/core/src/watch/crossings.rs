//! The crossings of one law within a step.

use super::bracket::{Bracket, sign, tangents_meet};
use super::inside::Inside;
use super::seer::Reading;
use crate::integrators::{Lanes, Method};
use crate::scalar::Lane;

/// Up to two crossings in each lane, there and back.
pub struct Crossings<T> {
    /// Lanes that crossed, and when.
    pub first: Lanes,
    pub first_time: T,
    /// Lanes that came back, and when.
    pub second: Lanes,
    pub second_time: T,
}

/// The side that a law is on, -1 or 1, or goes to from zero; 0 of what is not a number.
#[inline(always)]
pub fn side<T: Lane>(r: Reading<T>) -> T {
    beside_zero(r, sign(r.slope[0]))
}

/// The side after a step: who crosses and stands on zero has reached it from the other side.
#[inline(always)]
pub fn next_side<T: Lane>(before: T, end: Reading<T>) -> T {
    beside_zero(end, T::select_le(T::one(), before.abs(), -before, sign(end.slope[0])))
}

#[inline(always)]
fn beside_zero<T: Lane>(r: Reading<T>, at_zero: T) -> T {
    let (is, zero) = (sign(r.value), T::zero());
    let otherwise = T::select_le(r.value.abs(), zero, at_zero, zero);
    T::select_le(T::one(), is.abs(), is, otherwise)
}

/// The lanes where a function falls at the beginning of a step and rises at its end.
#[inline(always)]
pub fn turns<T: Lane>([q0, q1]: [T; 2]) -> Lanes {
    Lanes::where_le(T::lit(2.0), sign(q1) - sign(q0))
}

/// Finds the crossings of a law that was on the side `from`; a step without any costs a few comparisons.
#[inline(always)]
pub fn find<T: Lane, M: Method>(
    inside: &mut Inside<'_, '_, T, M>,
    law: usize,
    lanes: Lanes,
    from: T,
    ends: [Reading<T>; 2],
) -> Crossings<T> {
    let zero = T::zero();
    let (t0, t1) = (inside.stepper.t(), inside.stepper.trial_t());
    // Seen from its side, a law starts from above zero.
    let ([p0, p1], rates) = (ends.map(|r| from * r.value), ends.map(|r| from * r.slope[0]));
    let lanes = lanes.and(Lanes::where_le(T::one(), from.abs()));
    let crossed = lanes.and(Lanes::where_le(p1, zero));
    let meet = tangents_meet([p0, p1], rates, t1 - t0);
    let turned = lanes.and(turns(rates)).and(Lanes::where_le(meet, zero)).without(crossed);

    let (mut second, mut end, mut at_end) = (Lanes::NONE, t1, p1);
    if !turned.is_empty() {
        let (time, least) = inside.lowest(law, turned, from, [t0, t1], rates);
        second = turned.and(Lanes::where_le(least, zero)).without(Lanes::where_le(zero, least));
        (end, at_end) = (second.select(time, end), second.select(least, at_end));
    }
    let first = crossed.with(second);
    let (mut first_time, mut second_time) = (t1, t1);
    if !first.is_empty() {
        let there = Bracket { a: t0, b: end, at_a: p0, at_b: at_end };
        first_time = inside.crossing(law, first, from, there);
    }
    if !second.is_empty() {
        let back = Bracket { a: end, b: t1, at_a: -at_end, at_b: -p1 };
        second_time = inside.crossing(law, second, -from, back);
    }
    Crossings { first, first_time, second, second_time }
}
