//! What events and outputs promise.

mod lanes;
mod laws;

use super::{Crossing, Event, Output, Take, Watched};
use crate::algebra::Vec3;
use crate::forces::{Force, Places, UniformGravity};
use crate::phase_space::FreeBody;
use crate::tests::programs::{E, Seen, traced};
use crate::tests::simulate::ball;

/// A law of the motion without parameters, which reads these inputs.
pub fn event(
    crossing: Crossing,
    terminal: bool,
    inputs: &[usize],
    law: impl FnOnce(&Seen<'_>) -> E,
) -> Event {
    let places = Places::new(inputs, 0..0);
    Event { law: traced(&[], places, |_, s| vec![law(s)]), crossing, terminal }
}

pub fn output(take: Take, law: impl FnOnce(&Seen<'_>) -> E) -> Output {
    Output { law: event(Crossing::Both, false, &[], law).law, take }
}

pub fn events(events: Vec<Event>) -> Watched {
    Watched { events, outputs: Vec::new() }
}

/// Gravity downwards along z, which points up.
pub const G: f64 = 9.80665;

/// A ball thrown from the origin with a velocity.
pub fn thrown(velocity: [f64; 3]) -> (FreeBody<f64>, Vec<f64>) {
    let acceleration = Vec3::new(0.0, 0.0, -G);
    let (body, mut x0) = ball(vec![Force::UniformGravity(UniformGravity { acceleration })]);
    x0[7..10].copy_from_slice(&velocity);
    (body, x0)
}

/// The velocity of the origin along the world's z.
pub fn climb(s: &Seen<'_>) -> E {
    let c = s.rotation[2];
    c[0] * s.twist[0] + c[1] * s.twist[1] + c[2] * s.twist[2]
}
