//! Which numbers are refused as a body, by which rule, and what the message says.

use super::{Random, rotation};
use crate::algebra::{Sym3, Vec3};
use crate::inertia::{
    BodyDefect, Inertia, from_other_bodies, from_tensor_about_com, from_tensor_about_origin,
};

type Tensor = [[f64; 3]; 3];

fn diagonal(a: f64, b: f64, c: f64) -> Tensor {
    [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
}

fn about_com(mass: f64, com: [f64; 3], tensor: Tensor) -> Result<Inertia<f64>, BodyDefect> {
    from_tensor_about_com(mass, com, tensor)
}

fn defect(tensor: Tensor) -> BodyDefect {
    about_com(2.0, [0.0; 3], tensor).unwrap_err()
}

/// The message says all of this.
#[track_caller]
fn assert_says(defect: &BodyDefect, parts: &[&str]) {
    let text = defect.to_string();
    for part in parts {
        assert!(text.contains(part), "{text:?} does not say {part:?}");
    }
}

#[test]
fn a_body_keeps_its_numbers() {
    let tensor = [[1.0, 0.1, -0.2], [0.1, 1.5, 0.05], [-0.2, 0.05, 2.0]];
    let com = [0.3, -0.1, 0.2];
    let body = about_com(2.0, com, tensor).unwrap();
    assert_eq!((body.mass, body.com.to_array()), (2.0, com));
    assert_eq!(body.about_com.full().rows.map(Vec3::to_array), tensor);
    let about_origin = body.about_origin().full().rows.map(Vec3::to_array);
    let same = from_tensor_about_origin(2.0, com, about_origin).unwrap();
    for (a, b) in same.about_com.to_array().into_iter().zip(body.about_com.to_array()) {
        // There and back: two roundings of numbers up to three.
        assert!((a - b).abs() < 1e-15);
    }
}

#[test]
fn masses() {
    for mass in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for make in [from_tensor_about_com, from_tensor_about_origin] {
            let found = make(mass, [0.0; 3], diagonal(1.0, 1.0, 1.0)).unwrap_err();
            assert!(matches!(found, BodyDefect::Mass(m) if m.to_bits() == mass.to_bits()));
            assert_says(&found, &["mass", &format!("{mass:?}"), "greater than 0"]);
        }
    }
}

#[test]
fn mass_centres() {
    for bad in [f64::NAN, f64::INFINITY] {
        let found = about_com(1.0, [0.0, bad, 0.0], diagonal(1.0, 1.0, 1.0)).unwrap_err();
        assert!(matches!(found, BodyDefect::Com(_)));
        assert_says(&found, &["com", &format!("{bad:?}")]);
    }
}

#[test]
fn entries_that_are_not_finite() {
    let tensor = diagonal(1.0, f64::NAN, 1.0);
    assert_says(&defect(tensor), &["inertia_about_com must be finite", "NaN"]);
    let found = from_tensor_about_origin(1.0, [0.0; 3], tensor).unwrap_err();
    assert_says(&found, &["inertia_about_origin must be finite"]);
}

#[test]
fn asymmetry() {
    let mut tensor = diagonal(1.0, 2.0, 2.5);
    (tensor[0][2], tensor[2][0]) = (0.1, 0.3);
    let found = defect(tensor);
    let BodyDefect::Asymmetric { argument, place, pair, mean } = found.clone() else { panic!("{found:?}") };
    assert_eq!((argument, place, pair, mean), ("inertia_about_com", [0, 2], [0.1, 0.3], 0.2));
    assert_says(&found, &["symmetric", "(1, 3)", "(3, 1)", "0.1", "0.3", "0.2"]);
    // The rounding of nine digits is no asymmetry: the mean is taken.
    tensor[2][0] = 0.1 + 2e-9;
    let body = about_com(2.0, [0.0; 3], tensor).unwrap();
    assert!((body.about_com.xz - (0.1 + 1e-9)).abs() < 1e-16);
}

#[test]
fn moments_that_are_not_positive() {
    for tensor in [diagonal(-1.0, 1.0, 1.0), diagonal(0.0, 1.0, 1.0), diagonal(0.0, 0.0, 0.0)] {
        let found = defect(tensor);
        assert!(matches!(found, BodyDefect::NotPositive { .. }), "{found:?}");
        assert_says(&found, &["positive"]);
    }
    assert_says(&defect(diagonal(0.0, 1.0, 1.0)), &["thin rod", "1e-9"]);
    assert_says(&defect(diagonal(-1.0, 1.0, 1.0)), &["-1.0", "signs of the products"]);
    // Off the diagonal it shows in the principal moments only.
    let mut products = diagonal(1.0, 1.0, 1.0);
    (products[0][1], products[1][0]) = (1.5, 1.5);
    assert!(matches!(defect(products), BodyDefect::NotPositive { moments: [low, ..] } if low < -0.49));
}

#[test]
fn the_triangle_inequality() {
    let found = defect(diagonal(1.0, 1.0, 2.1));
    assert_eq!(found, BodyDefect::Triangle { moments: [1.0, 1.0, 2.1] });
    assert_says(&found, &["1.0 + 1.0 < 2.1", "at most 2.0"]);
    // Rods and discs lie on its edge, however they are turned.
    let mut random = Random(80);
    for edge in [[1e-9, 1.0, 1.0], [1.0, 1.0, 2.0], [1.0, 2.0, 3.0]] {
        for _ in 0..20 {
            let turned =
                Sym3::from_array([edge[0], 0.0, 0.0, edge[1], 0.0, edge[2]]).turned(rotation(&mut random));
            let tensor = turned.full().rows.map(Vec3::to_array);
            assert!(about_com(2.0, [0.0; 3], tensor).is_ok(), "{edge:?}");
        }
    }
    // Joining bodies may round past the edge.
    let past = diagonal(1.0, 1.0, 2.0 + 1e-8);
    assert!(matches!(defect(past), BodyDefect::Triangle { .. }));
    assert!(from_other_bodies(2.0, [0.0; 3], past).is_ok());
}

#[test]
fn offsets_too_large_for_the_inertia_about_the_origin() {
    // m |com|² = 2, of which the tensor has 1.
    let small = from_tensor_about_origin(2.0, [1.0, 0.0, 0.0], diagonal(1.0, 1.0, 1.0)).unwrap_err();
    let BodyDefect::OffsetTooLarge { moments, offset, fits_about_com } = small.clone() else {
        panic!("{small:?}")
    };
    assert_eq!((moments, offset, fits_about_com), ([-1.0, -1.0, 1.0], 2.0, true));
    assert_says(&small, &["inertia_about_origin", "2.0", "pass it as inertia_about_com"]);
    let worse = from_tensor_about_origin(2.0, [1.0, 0.0, 0.0], diagonal(1.0, 1.0, 2.1)).unwrap_err();
    assert!(matches!(worse, BodyDefect::OffsetTooLarge { fits_about_com: false, .. }));
    assert_says(&worse, &["check the mass, the mass centre and the tensor"]);
}

#[test]
fn numbers_that_doubles_cannot_hold() {
    let one = diagonal(1.0, 1.0, 1.0);
    let bodies = [
        about_com(1e-310, [0.0; 3], one),
        about_com(1.0, [1e200, 0.0, 0.0], one),
        about_com(1.0, [0.0; 3], diagonal(1e120, 1e120, 1e120)),
        about_com(1.0, [0.0; 3], diagonal(1e-120, 1e-120, 1e-120)),
    ];
    for body in bodies {
        let found = body.unwrap_err();
        assert!(matches!(found, BodyDefect::OutOfRange { .. }), "{found:?}");
        assert_says(&found, &["range of doubles", "1e100"]);
    }
    assert!(about_com(1e-300, [0.0; 3], diagonal(1e-100, 1e-100, 1e-100)).is_ok());
    assert!(about_com(1e300, [0.0; 3], diagonal(1e100, 1e100, 1e100)).is_ok());
}
