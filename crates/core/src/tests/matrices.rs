//! Matrices of three and six, quaternions, principal moments.

use super::{Random, inertia, matrix, quaternion, rotation, vector};
use crate::algebra::{
    Mat3, Mat6, Sym3, Vec3, elementary, is_rotation, multiply, quaternion_from_rotation,
    rotation_from_quaternion,
};
use crate::inertia::principal_moments;
use crate::screw::{wrench_transform, wrench_transform_inverse};
use std::f64::consts::{FRAC_PI_2, PI};

/// A few roundings of numbers of order one.
const ROUNDING: f64 = 4e-15;

/// The largest entry of a difference.
fn gap6(a: Mat6<f64>, b: Mat6<f64>) -> f64 {
    let mut entries = [0.0; 36];
    (a - b).store(&mut entries);
    entries.iter().fold(0.0, |m, x| f64::max(m, x.abs()))
}

fn gap(a: Mat3<f64>, b: Mat3<f64>) -> f64 {
    let entries = (a - b).rows.map(Vec3::to_array);
    entries.iter().flatten().fold(0.0, |m, x| f64::max(m, x.abs()))
}

#[test]
fn inverses_of_six_invert() {
    let mut random = Random(50);
    for _ in 0..100 {
        // Next to diagonal, so that blocks and Schur complement are far from singular.
        let mut next = || matrix(&mut random) + Mat3::identity().scale(8.0);
        let m = Mat6::new(next(), matrix_of_ones(), matrix_of_ones(), next());
        // Condition below ten, 36 products: some hundred units.
        assert!(gap6(m * m.inverse(), Mat6::identity()) < 3e-14);
        assert!(gap6(m.inverse() * m, Mat6::identity()) < 3e-14);
        assert_eq!(gap6(m.transpose().transpose(), m), 0.0);
        let mut flat = [0.0; 36];
        m.store(&mut flat);
        assert_eq!(gap6(Mat6::from_slice(&flat), m), 0.0);

        let body = inertia(&mut random);
        // Condition below a hundred.
        assert!(gap6(body.matrix() * body.inverse_matrix(), Mat6::identity()) < 1e-13);
        let (o, c) = (vector(&mut random), rotation(&mut random));
        assert!(gap6(wrench_transform(o, c) * wrench_transform_inverse(o, c), Mat6::identity()) < ROUNDING);
    }
}

fn matrix_of_ones() -> Mat3<f64> {
    Mat3::lit([[1.0; 3]; 3])
}

#[test]
fn symmetric_matrices_are_their_full_ones() {
    let mut random = Random(51);
    for _ in 0..100 {
        let s = inertia(&mut random).about_com;
        let (c, v) = (rotation(&mut random), vector(&mut random));
        assert!(gap(s.full() * s.inverse().full(), Mat3::identity()) < 10.0 * ROUNDING);
        assert!(gap(s.full().inverse(), s.inverse().full()) < 10.0 * ROUNDING);
        assert!(gap(s.turned(c).full(), c.transpose() * s.full() * c) < ROUNDING);
        assert_eq!(s.apply(v), s.full().apply(v));
        assert_eq!(Sym3::of(s.full()), s);
        assert_eq!(Sym3::from_array(s.to_array()), s);
        let unit = Mat3::skew(v).transpose() * Mat3::skew(v);
        assert!(gap(Sym3::of_unit_mass(v).full(), unit) < ROUNDING);
    }
}

#[test]
fn principal_moments_are_those_the_tensor_was_made_of() {
    let mut random = Random(52);
    // Different, two alike, all alike, a rod, and moments ten orders apart.
    let cases = [
        [1.0, 2.0, 2.5],
        [1.0, 1.0, 2.0],
        [1.0, 2.0, 2.0],
        [3.0, 3.0, 3.0],
        [1e-10, 1.0, 1.0],
        [1e-10, 1e-5, 1.0],
        [0.0, 0.0, 0.0],
        [-1.0, 0.5, 2.0],
    ];
    for known in cases {
        let diagonal = Sym3::from_array([known[1], 0.0, 0.0, known[2], 0.0, known[0]]);
        assert_eq!(principal_moments(diagonal), known);
        for _ in 0..50 {
            let found = principal_moments(diagonal.turned(rotation(&mut random)));
            // Turning the tensor rounds its entries to units of the largest.
            for (found, known) in found.iter().zip(known) {
                assert!((found - known).abs() < ROUNDING * 2.5, "{found} is not {known}");
            }
        }
    }
}

#[test]
fn a_quaternion_goes_to_a_rotation_and_back() {
    let mut random = Random(53);
    let mut all: Vec<[f64; 4]> = (0..1000).map(|_| quaternion(&mut random)).collect();
    // Half turns, where w is zero, and next to them: each of the four ways of the conversion.
    for axis in 0..3 {
        for angle in [0.0, 1e-9, FRAC_PI_2, PI - 1e-9, PI] {
            let mut q = [(0.5 * angle).cos(), 0.0, 0.0, 0.0];
            q[1 + axis] = (0.5 * angle).sin();
            all.push(q);
            assert!(gap(rotation_from_quaternion(q), elementary(axis, angle)) < ROUNDING);
        }
    }
    for q in all {
        let c = rotation_from_quaternion(q);
        assert!(is_rotation(&c, ROUNDING));
        let back = quaternion_from_rotation(&c);
        assert!(back[0] >= 0.0);
        // The same up to sign.
        let overlap: f64 = q.iter().zip(back).map(|(a, b)| a * b).sum();
        for (a, b) in q.iter().zip(back) {
            assert!((a * overlap.signum() - b).abs() < ROUNDING, "{q:?} came back as {back:?}");
        }
        let p = quaternion(&mut random);
        let product = rotation_from_quaternion(multiply(p, q));
        assert!(gap(product, rotation_from_quaternion(p) * c) < ROUNDING);
    }
}
