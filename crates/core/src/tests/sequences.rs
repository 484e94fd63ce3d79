//! Angles out of rotations, in all twelve sequences and at every angle.

use super::{Random, rotation, sequences};
use crate::algebra::{Mat3, Vec3};
use crate::charts::{AngleChart, Sequence};
use std::f64::consts::{FRAC_PI_2, PI};

fn turned(sequence: Sequence, angles: [f64; 3]) -> Mat3<f64> {
    AngleChart::new(sequence, Vec3::from_array(angles)).rotation
}

fn gap(a: Mat3<f64>, b: Mat3<f64>) -> f64 {
    let entries = (a - b).rows.map(Vec3::to_array);
    entries.iter().flatten().fold(0.0, |m, x| f64::max(m, x.abs()))
}

/// Multiples of π/6 over two turns, and whatever the second angle can do around its singular values.
fn grid() -> Vec<[f64; 3]> {
    let outer = [-11, -6, -5, -1, 0, 2, 6, 9].map(|k| f64::from(k) * PI / 6.0);
    let mut second: Vec<f64> = (-12..=12).map(|k| f64::from(k) * PI / 6.0).collect();
    for singular in [-PI, -FRAC_PI_2, 0.0, FRAC_PI_2, PI] {
        for off in [1e-3, 1e-7, 1e-10, 1e-13, 1e-15] {
            second.extend([singular - off, singular + off]);
        }
    }
    let mut all = Vec::new();
    for a in outer {
        for b in &second {
            all.extend(outer.map(|c| [a, *b, c]));
        }
    }
    all
}

#[test]
fn names_and_sequences_are_one_to_one() {
    for (sequence, name) in sequences().into_iter().zip(Sequence::names()) {
        assert_eq!(sequence.name(), name);
        let axes = sequence.axes().map(|i| ['x', 'y', 'z'][i]);
        assert_eq!(axes.iter().collect::<String>(), name);
        assert_eq!(sequence.is_proper_euler(), axes[0] == axes[2]);
    }
    for name in ["", "zy", "zyz ", "ZYX", "xxz", "zyxz", "äyx"] {
        assert_eq!(Sequence::parse(name), None, "{name:?}");
    }
}

#[test]
fn angles_give_their_rotation_back_everywhere() {
    for sequence in sequences() {
        for like in grid() {
            let c = turned(sequence, like);
            let angles = sequence.angles_of(&c, like);
            // A dozen products and three arcs, each of order one; the singular points are no worse.
            let distance = gap(turned(sequence, angles), c);
            assert!(distance < 4e-15, "{sequence:?} {like:?}: {angles:?} is {distance} off");
            let [low, high] = if sequence.is_proper_euler() { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
            assert!((low..=high).contains(&angles[1]));
        }
    }
}

#[test]
fn the_nearest_angles_are_those_that_made_the_rotation() {
    let mut random = Random(60);
    for sequence in sequences() {
        for made in grid() {
            let distance = sequence.singularity_distance(made);
            if distance < 1e-6 {
                continue;
            }
            // Another triple lies at least π/2 away, or 2 · distance in the second angle and π in the others.
            let like = made.map(|a| a + random.between(-0.2, 0.2));
            let found = sequence.nearest(sequence.angles_of(&turned(sequence, made), like), like);
            // The first and third angles are known to the rounding over the distance.
            for (found, made) in found.iter().zip(made) {
                assert!(
                    (found - made).abs() < 4e-15 / distance.sin() + 4e-15,
                    "{sequence:?}: {found} {made}"
                );
            }
        }
    }
}

#[test]
fn at_a_singularity_the_first_angle_stays() {
    for sequence in sequences() {
        let singular = if sequence.is_proper_euler() { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
        for second in singular {
            for (first, third) in [(0.3, -0.7), (-2.0, 1.0), (0.0, 0.0)] {
                let made = [first, second, third];
                let found = sequence.angles_of(&turned(sequence, made), made);
                for (found, made) in found.iter().zip(made) {
                    // cos π/2 is 6e-17, not zero.
                    assert!((found - made).abs() < 1e-15, "{sequence:?}: {found} is not {made}");
                }
            }
        }
    }
}

/// det M0 is the volume of the three rotation axes: the sine of the distance.
#[test]
fn the_distance_to_the_singularity_is_that_of_the_rate_matrix() {
    let mut random = Random(61);
    for sequence in sequences() {
        for _ in 0..100 {
            let alpha = sequence.angles_of(&rotation(&mut random), [0.0; 3]);
            let chart = AngleChart::new(sequence, Vec3::from_array(alpha));
            let volume = chart.rate_matrix_world().determinant().abs();
            let distance = sequence.singularity_distance(alpha);
            // Some ten roundings of numbers up to one.
            assert!((distance.sin() - volume).abs() < 2e-15, "{sequence:?}: {distance} {volume}");
        }
    }
}
