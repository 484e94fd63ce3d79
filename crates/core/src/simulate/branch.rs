//! Which of its angle triples a rotation has: those that its motion has led to.

use crate::phase_space::{Chart, FreeBody, RigidState};

/// Nearer to the singularity than this, rad, the angles turn too fast to be followed, and any triple will do.
const NOWHERE: f64 = 1e-6;
/// After so many looks at one way it is taken as it comes: nobody can follow a motion that is not finite, or turns
/// many times within a step.
const LOOKS: u32 = 1000;

/// Moves a state in the angles of `model` along a motion from one time to another.
///
/// A rotation has two families of triples. The next one is taken from the family of the nearest triple, and
/// the pieces of the way are so short that the angles cannot come nearer to the other family on them.
pub fn follow(
    model: &FreeBody<f64>,
    state: &mut Vec<f64>,
    [from, to]: [f64; 2],
    motion: impl Fn(f64) -> RigidState,
) {
    let (mut t, mut next) = (from, to);
    let mut looks = 0;
    let mut at = motion(t);
    while t < to {
        let ahead = motion(next);
        let mut x = state.clone();
        model.write_state(&ahead, state, &mut x);
        let distance = [&*state, &x].map(|x| model.singularity_distance(x).unwrap_or(f64::INFINITY));
        let near = distance[0].min(distance[1]).max(NOWHERE);
        let piece = next - t;
        let short = [&at, &ahead].into_iter().all(|s| is_short(model.chart, piece, s, near));
        let middle = t + 0.5 * piece;
        looks += 1;
        if short || looks > LOOKS || middle <= t {
            (t, at, *state) = (next, ahead, x);
            next = to.min(t + 2.0 * piece);
        } else {
            next = middle;
        }
    }
}

/// Whether a motion turns by less than half a radian in a time, and its third axis, which the distance to the
/// singularity belongs to, by less than half of that distance.
///
/// Then no angle moves by much more than a radian; the families are more than four apart.
fn is_short(chart: Chart, time: f64, s: &RigidState, distance: f64) -> bool {
    let Chart::Angles(sequence) = chart else { return true };
    let w = s.twist.angular;
    let along = w.to_array()[sequence.axes()[2]];
    let across = (w.dot(w) - along * along).max(0.0).sqrt();
    time * w.norm() <= 0.5 && time * across <= 0.5 * distance
}
