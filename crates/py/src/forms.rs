//! Every numbered matrix and form of the paper, evaluated row by row on arrays.

use crate::body::RigidBody;
use crate::errors;
use freebody_core::algebra::{Mat3, quaternion_from_rotation};
use freebody_core::catalog::{self, Entry, Row};
use freebody_core::charts::Sequence;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Forms that exist for numbers only: they choose by value.
fn of_numbers(name: &str, sequence: Option<Sequence>) -> Option<Entry<f64>> {
    let m3 = |x: &[f64]| Mat3::from_slice(x);
    let (arguments, result, row): (&[usize], usize, Row<f64>) = match (name, sequence) {
        ("quaternion_from_rotation", None) => {
            (&[9], 4, Box::new(move |a, out| out.copy_from_slice(&quaternion_from_rotation(&m3(a[0])))))
        }
        ("singularity_distance", Some(s)) => {
            (&[3], 1, Box::new(move |a, out| out[0] = s.singularity_distance([a[0][0], a[0][1], a[0][2]])))
        }
        ("angles_from_rotation", Some(s)) => {
            (&[9], 3, Box::new(move |a, out| out.copy_from_slice(&s.angles_of(&m3(a[0]), [0.0; 3]))))
        }
        _ => return None,
    };
    Some(Entry { arguments, result, row })
}

/// Evaluates a form on rows: arguments (n, k) each, matrices flattened by rows; result (n, m).
#[pyfunction]
#[pyo3(signature = (name, angles, body, args))]
pub fn form<'py>(
    py: Python<'py>,
    name: &str,
    angles: Option<&str>,
    body: Option<&Bound<'py, RigidBody>>,
    args: Vec<PyReadonlyArray2<'py, f64>>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let unknown = || errors::input(py, format!("there is no form '{name}' of these arguments"));
    let sequence = match angles {
        Some(a) => Some(Sequence::parse(a).ok_or_else(|| {
            errors::input(py, format!("angles must be one of {:?}, got '{a}'", Sequence::names()))
        })?),
        None => None,
    };
    let inertia = body.map(|b| b.get().inertia);
    let found = match body {
        None => of_numbers(name, sequence).or_else(|| catalog::find(name, sequence, None)),
        Some(_) => catalog::find(name, sequence, inertia),
    };
    let Entry { arguments, result, row } = found.ok_or_else(unknown)?;
    let n = args.first().map_or(1, |a| a.shape()[0]);
    let fits = args.len() == arguments.len() && args.iter().zip(arguments).all(|(a, k)| a.shape() == [n, *k]);
    if !fits {
        return Err(errors::input(py, format!("'{name}' takes arrays of (n, k) with k = {arguments:?}")));
    }
    let slices = args.iter().map(|a| a.as_slice()).collect::<Result<Vec<_>, _>>()?;
    let mut out = vec![0.0; n * result];
    for (i, o) in out.chunks_exact_mut(result).enumerate() {
        let rows: Vec<&[f64]> = slices.iter().zip(arguments).map(|(s, k)| &s[i * k..(i + 1) * k]).collect();
        row(&rows, o);
    }
    PyArray1::from_vec(py, out).reshape([n, result])
}
