//! Which numbers can be a rigid body, and what is wrong with those that cannot.

use super::Inertia;
use crate::algebra::{Mat3, Sym3, Vec3};
use std::fmt;

/// How far a rule may be missed, relative to the largest entry of the tensor as given: entries typed or
/// exported with nine digits pass, and so do rods and discs at the edge of the triangle inequality.
const ALLOWANCE: f64 = 1e-9;

/// Why numbers are not the mass properties of a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyDefect {
    /// The mass is not a positive finite number.
    Mass(f64),
    /// A component of the mass centre is not finite.
    Com([f64; 3]),
    /// An entry of the tensor is not finite.
    NotFinite([[f64; 3]; 3]),
    /// The tensor is not symmetric.
    Asymmetric {
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
}

impl fmt::Display for BodyDefect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mass(m) => write!(
                f,
                "mass must be a positive finite number of kg, got {m}; give the mass in kg, greater than 0"
            ),
            Self::Com(r) => write!(
                f,
                "com must be three finite numbers in m, got {r:?}; give the mass centre from the body origin"
            ),
            Self::NotFinite(j) => write!(f, "the inertia tensor must be finite, got {j:?} kg m²"),
            Self::Asymmetric { place: [i, j], pair: [a, b], mean } => write!(
                f,
                "the inertia tensor must be symmetric (to {ALLOWANCE:e} of its largest entry), but entry ({}, {}) is \
                 {a} and entry ({}, {}) is {b} kg m²; set both to {mean} if they differ by rounding",
                i + 1,
                j + 1,
                j + 1,
                i + 1
            ),
            Self::NotPositive { moments: m } => write!(
                f,
                "every principal moment about the mass centre must be positive, got {m:?} kg m²; check the signs of \
                 the products of inertia, and give a thin rod a small moment about its axis (at least {:.3e})",
                ALLOWANCE * m[2].abs()
            ),
            Self::Triangle { moments: [a, b, c] } => write!(
                f,
                "no principal moment may exceed the sum of the other two (to {ALLOWANCE:e} of the largest), got \
                 {a} + {b} < {c} kg m²; no mass distribution has these moments: the largest can be at most {}",
                a + b
            ),
            Self::OffsetTooLarge { moments, offset, fits_about_com } => {
                write!(
                    f,
                    "inertia_about_origin is too small for the offset of the mass centre: m|com|² alone is {offset} \
                     kg m², and the principal moments left about the mass centre would be {moments:?}; "
                )?;
                if *fits_about_com {
                    write!(f, "if the tensor is about the mass centre, pass it as inertia_about_com")
                } else {
                    write!(f, "check the mass, the mass centre and the tensor")
                }
            }
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
    let j = symmetric(tensor)?;
    check_moments(principal_moments(j), ALLOWANCE * largest(tensor))?;
    Ok(Inertia::new(mass, Vec3::from_array(com), j))
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
    let about_origin = symmetric(tensor)?;
    let r = Vec3::from_array(com);
    let about_com = about_origin - Sym3::of_unit_mass(r).scale(mass);
    let moments = principal_moments(about_com);
    let allowance = ALLOWANCE * largest(tensor);
    let offset = mass * r.dot(r);
    // Below this, what is left of the tensor is its own rounding.
    if moments[0] <= 4.0 * f64::EPSILON * offset && offset > 0.0 {
        let fits_about_com = check_moments(principal_moments(about_origin), allowance).is_ok();
        return Err(BodyDefect::OffsetTooLarge { moments, offset, fits_about_com });
    }
    check_moments(moments, allowance)?;
    Ok(Inertia::new(mass, r, about_com))
}

/// The symmetric tensor of nine finite entries.
fn symmetric(tensor: [[f64; 3]; 3]) -> Result<Sym3<f64>, BodyDefect> {
    if !tensor.iter().flatten().all(|x| x.is_finite()) {
        return Err(BodyDefect::NotFinite(tensor));
    }
    for [i, j] in [[0, 1], [0, 2], [1, 2]] {
        let pair = [tensor[i][j], tensor[j][i]];
        if (pair[0] - pair[1]).abs() > ALLOWANCE * largest(tensor) {
            return Err(BodyDefect::Asymmetric { place: [i, j], pair, mean: 0.5 * (pair[0] + pair[1]) });
        }
    }
    Ok(Sym3::of(Mat3::lit(tensor)))
}

fn largest(tensor: [[f64; 3]; 3]) -> f64 {
    tensor.iter().flatten().fold(0.0, |m, x| f64::max(m, x.abs()))
}

fn check_moments(moments: [f64; 3], allowance: f64) -> Result<(), BodyDefect> {
    let [a, b, c] = moments;
    if a <= 0.0 {
        Err(BodyDefect::NotPositive { moments })
    } else if c - (a + b) > allowance {
        Err(BodyDefect::Triangle { moments })
    } else {
        Ok(())
    }
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
            for k in 0..3 {
                (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
            }
        }
    }
    let mut moments = [a[0][0], a[1][1], a[2][2]];
    moments.sort_by(f64::total_cmp);
    moments
}
