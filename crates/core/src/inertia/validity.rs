//! Which numbers can be a rigid body, and what is wrong with those that cannot.

use super::Inertia;
use crate::algebra::{Mat3, Sym3, Vec3};
use std::fmt;

/// How far a rule may be missed, relative to the largest entry of the tensor as given: rods and discs at the edge
/// of the triangle inequality pass, computed or typed with eleven digits.
const ALLOWANCE: f64 = 1e-9;

/// A moment below this part of what it was computed from is rounding: in turned axes it could as well be negative.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Why numbers are not the mass properties of a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyDefect {
    /// The mass is not a positive finite number.
    Mass(f64),
    /// A component of the mass centre is not finite.
    Com([f64; 3]),
    /// An entry of the tensor is not finite.
    NotFinite {
        /// Which tensor: the argument's name.
        argument: &'static str,
        /// The tensor.
        tensor: [[f64; 3]; 3],
    },
    /// The tensor is not symmetric.
    Asymmetric {
        /// Which tensor: the argument's name.
        argument: &'static str,
        /// Row and column of the worst pair, from 0.
        place: [usize; 2],
        /// The two entries.
        pair: [f64; 2],
        /// Half their sum: the nearest symmetric entry.
        mean: f64,
    },
    /// A principal moment is not positive.
    NotPositive {
        /// The principal moments about the mass centre, rising, kg m².
        moments: [f64; 3],
    },
    /// One principal moment is larger than the sum of the others.
    Triangle {
        /// The principal moments about the mass centre, rising, kg m².
        moments: [f64; 3],
    },
    /// The inertia about the origin is smaller than the offset of the mass centre alone makes it.
    OffsetTooLarge {
        /// The principal moments that would be left about the mass centre, rising, kg m².
        moments: [f64; 3],
        /// m·|r_c|², kg m².
        offset: f64,
        /// Whether the same tensor would do about the mass centre.
        fits_about_com: bool,
    },
    /// Doubles cannot hold the body and its inverse.
    OutOfRange {
        /// Mass, kg.
        mass: f64,
        /// Mass centre, m.
        com: [f64; 3],
        /// The principal moments about the mass centre, rising, kg m².
        moments: [f64; 3],
    },
}

impl fmt::Display for BodyDefect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mass(m) => write!(
                f,
                "mass must be a positive finite number of kg, got {m:?}; give the mass in kg, greater than 0"
            ),
            Self::Com(r) => write!(
                f,
                "com must be three finite numbers in m, got {r:?}; give the mass centre from the body origin"
            ),
            Self::NotFinite { argument, tensor } => {
                write!(f, "{argument} must be finite, got {tensor:?} kg m²; give every entry")
            }
            Self::Asymmetric { argument, place: [i, j], pair: [a, b], mean } => write!(
                f,
                "{argument} must be symmetric (to {ALLOWANCE:e} of its largest entry), but entry ({}, {}) is {a:?} and \
                 entry ({}, {}) is {b:?} kg m²; set both to {mean:?} if they differ by rounding",
                i + 1,
                j + 1,
                j + 1,
                i + 1
            ),
            Self::NotPositive { moments: m } => {
                write!(
                    f,
                    "every principal moment about the mass centre must be positive beyond rounding, got {m:?} kg m²; "
                )?;
                let nearest = ALLOWANCE * m[2];
                if m[0].abs() < nearest {
                    write!(f, "give a thin rod a small moment about its axis, such as {nearest:e}")
                } else {
                    write!(f, "check the units, and the signs of the products of inertia")
                }
            }
            Self::Triangle { moments: [a, b, c] } => write!(
                f,
                "no principal moment may exceed the sum of the other two (to {ALLOWANCE:e} of the largest), got \
                 {a:?} + {b:?} < {c:?} kg m²; no mass distribution has these moments: the largest can be at most {:?}",
                a + b
            ),
            Self::OffsetTooLarge { moments, offset, fits_about_com } => {
                write!(
                    f,
                    "inertia_about_origin is too small for the offset of the mass centre: m|com|² alone is {offset:?} \
                     kg m², and the principal moments left about the mass centre would be {moments:?}; "
                )?;
                if *fits_about_com {
                    write!(f, "if the tensor is about the mass centre, pass it as inertia_about_com")
                } else {
                    write!(f, "check the mass, the mass centre and the tensor")
                }
            }
            Self::OutOfRange { mass, com, moments } => write!(
                f,
                "the numbers leave the range of doubles: mass {mass:?} kg, com {com:?} m, principal moments about the \
                 mass centre {moments:?} kg m²; give SI numbers, moments within 1e-100 to 1e100 and masses within \
                 1e-300 to 1e300"
            ),
        }
    }
}

/// A mass of positive finite kg.
///
/// # Errors
/// [`BodyDefect::Mass`].
pub fn check_mass(mass: f64) -> Result<(), BodyDefect> {
    if mass.is_finite() && mass > 0.0 { Ok(()) } else { Err(BodyDefect::Mass(mass)) }
}

/// A mass centre of three finite numbers.
///
/// # Errors
/// [`BodyDefect::Com`].
pub fn check_com(com: [f64; 3]) -> Result<(), BodyDefect> {
    if com.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(BodyDefect::Com(com)) }
}

/// A body of its tensor about the mass centre.
///
/// # Errors
/// The first [`BodyDefect`] found.
pub fn from_tensor_about_com(
    mass: f64,
    com: [f64; 3],
    tensor: [[f64; 3]; 3],
) -> Result<Inertia<f64>, BodyDefect> {
    check_mass(mass)?;
    check_com(com)?;
    checked(mass, com, symmetric("inertia_about_com", tensor)?, ALLOWANCE * largest(tensor))
}

/// A body of its tensor about the origin of the body frame.
///
/// # Errors
/// The first [`BodyDefect`] found.
pub fn from_tensor_about_origin(
    mass: f64,
    com: [f64; 3],
    tensor: [[f64; 3]; 3],
) -> Result<Inertia<f64>, BodyDefect> {
    check_mass(mass)?;
    check_com(com)?;
    let about_origin = symmetric("inertia_about_origin", tensor)?;
    let r = Vec3::from_array(com);
    let about_com = about_origin - Sym3::of_unit_mass(r).scale(mass);
    let moments = principal_moments(about_com);
    let allowance = ALLOWANCE * largest(tensor);
    let offset = mass * r.dot(r);
    // Below the rounding of the offset, what is left of the tensor is no inertia.
    let nothing_left = moments[0] <= ROUNDING * offset;
    if nothing_left && offset > 0.0 && offset.is_finite() && principal_moments(about_origin)[0] > 0.0 {
        let fits_about_com = checked(mass, com, about_origin, allowance).is_ok();
        return Err(BodyDefect::OffsetTooLarge { moments, offset, fits_about_com });
    }
    checked(mass, com, about_com, allowance)
}

/// A body whose numbers were computed from those of other bodies, which rounding may have moved over the edge
/// of a rule.
///
/// # Errors
/// [`BodyDefect::OutOfRange`], [`BodyDefect::NotPositive`].
pub fn from_other_bodies(
    mass: f64,
    com: [f64; 3],
    tensor: [[f64; 3]; 3],
) -> Result<Inertia<f64>, BodyDefect> {
    checked(mass, com, Sym3::of(Mat3::lit(tensor)), f64::INFINITY)
}

/// A body, unless its moments are impossible or doubles cannot hold it and its inverse.
fn checked(
    mass: f64,
    com: [f64; 3],
    about_com: Sym3<f64>,
    allowance: f64,
) -> Result<Inertia<f64>, BodyDefect> {
    let body = Inertia::new(mass, Vec3::from_array(com), about_com);
    let moments = principal_moments(about_com);
    let [a, b, c] = moments;
    let out_of_range = Err(BodyDefect::OutOfRange { mass, com, moments });
    let finite = body.parameters().iter().chain(&moments).all(|x| x.is_finite());
    if !finite || !mass.is_normal() || !(1.0 / mass).is_normal() {
        return out_of_range;
    }
    if a <= ROUNDING * c.max(0.0) {
        return Err(BodyDefect::NotPositive { moments });
    }
    if c - (a + b) > allowance {
        return Err(BodyDefect::Triangle { moments });
    }
    // The terms of the determinant are as large as c³, their sum as small as abc.
    let det = a * b * c;
    if [c * c * c, det, 1.0 / det].iter().all(|x| x.is_normal()) { Ok(body) } else { out_of_range }
}

/// The symmetric tensor of nine finite entries.
fn symmetric(argument: &'static str, tensor: [[f64; 3]; 3]) -> Result<Sym3<f64>, BodyDefect> {
    if !tensor.iter().flatten().all(|x| x.is_finite()) {
        return Err(BodyDefect::NotFinite { argument, tensor });
    }
    for [i, j] in [[0, 1], [0, 2], [1, 2]] {
        let pair = [tensor[i][j], tensor[j][i]];
        if (pair[0] - pair[1]).abs() > ALLOWANCE * largest(tensor) {
            let mean = 0.5 * pair[0] + 0.5 * pair[1];
            return Err(BodyDefect::Asymmetric { argument, place: [i, j], pair, mean });
        }
    }
    Ok(Sym3::of(Mat3::lit(tensor)))
}

fn largest(tensor: [[f64; 3]; 3]) -> f64 {
    tensor.iter().flatten().fold(0.0, |m, x| f64::max(m, x.abs()))
}

/// The principal moments of a tensor, rising, by Jacobi rotations (Golub and Van Loan, Matrix Computations,
/// 4th ed., section 8.5).
pub fn principal_moments(tensor: Sym3<f64>) -> [f64; 3] {
    let mut a = tensor.full().rows.map(Vec3::to_array);
    // Convergence is quadratic: the fourth or fifth sweep already finds nothing to turn.
    for _ in 0..12 {
        for [p, q] in [[0, 1], [0, 2], [1, 2]] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = f64::signum(theta) / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            let (row_p, row_q) = (a[p], a[q]);
            a[p] = [0, 1, 2].map(|k| c * row_p[k] - s * row_q[k]);
            a[q] = [0, 1, 2].map(|k| s * row_p[k] + c * row_q[k]);
        }
    }
    let mut moments = [a[0][0], a[1][1], a[2][2]];
    moments.sort_by(f64::total_cmp);
    moments
}
