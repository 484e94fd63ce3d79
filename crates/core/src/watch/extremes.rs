//! What an output takes of a step.

use super::Take;
use super::bracket::tangents_meet;
use super::crossings::turns;
use super::inside::Inside;
use super::seer::Reading;
use crate::integrators::{Lanes, Method};
use crate::scalar::Lane;

/// What is kept of `kept` and a later value; what was not a number once stays so.
#[inline(always)]
pub fn taken<T: Lane>(take: Take, kept: T, value: T) -> T {
    let better = match take {
        Take::Final => return value,
        Take::Least => T::select_le(value, kept, value, kept),
        Take::Greatest => T::select_le(kept, value, value, kept),
    };
    T::select_le(value, value, better, value)
}

/// What an output has taken after a step that ends at `end`, in each lane at its own time.
#[inline(always)]
pub fn follow<T: Lane, M: Method>(
    inside: &mut Inside<'_, '_, T, M>,
    law: usize,
    lanes: Lanes,
    (take, kept): (Take, T),
    end: T,
    ends: [Reading<T>; 2],
) -> T {
    let at_end = taken(take, kept, ends[1].value);
    let factor = match take {
        Take::Final => return at_end,
        Take::Least => T::one(),
        Take::Greatest => -T::one(),
    };
    let (values, rates) = (ends.map(|r| factor * r.value), ends.map(|r| factor * r.slope[0]));
    let start = inside.stepper.t();
    let meet = tangents_meet(values, rates, end - start);
    // Where tangents lie below a function, it cannot better what is kept unless they do.
    let turned = lanes.and(turns(rates)).and(Lanes::where_le(meet, factor * at_end));
    if turned.is_empty() {
        return at_end;
    }
    let (_, least) = inside.lowest(law, turned, factor, [start, end], rates);
    turned.select(taken(take, at_end, factor * least), at_end)
}
