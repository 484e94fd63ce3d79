//! What stands on the left besides the body, made from checked numbers.

use crate::graph::Program;
use crate::laws::{sources, traced};
use freebody_core::algebra::{Sym6, Vec3};
use freebody_core::phase_space::{Contents, Left, Spin};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

/// Added mass (6, 6) or none; of each wheel axis, inertia, and which auxiliary state its speed is; of all contents
/// program, parameters, sources of the inputs, and the place of their force.
pub type LeftArguments<'py> = (
    Option<PyReadonlyArray2<'py, f64>>,
    Vec<([f64; 3], f64, usize)>,
    Vec<(Program, Vec<f64>, Vec<i64>, usize)>,
);

/// Mass, mass centre, six numbers of a tensor.
const CONTENTS_RESULTS: usize = 10;

pub fn left(py: Python<'_>, (added_mass, spins, contents): LeftArguments<'_>) -> PyResult<Left<f64>> {
    let added_mass = match added_mass {
        Some(matrix) => Some(Sym6::from_slice(matrix.as_slice()?)),
        None => None,
    };
    let spin = |(axis, inertia, state): ([f64; 3], f64, usize)| Spin {
        axis: Vec3::from_array(axis),
        inertia,
        state,
    };
    let own = |(program, parameters, inputs, force): (Program, Vec<f64>, Vec<i64>, usize)| {
        let mut law = traced(py, program, parameters, CONTENTS_RESULTS, 0)?;
        law.places.inputs = sources(&inputs);
        PyResult::Ok(Contents { law, force })
    };
    let contents = contents.into_iter().map(own).collect::<PyResult<Vec<_>>>()?;
    Ok(Left { contents, added_mass, spins: spins.into_iter().map(spin).collect() })
}
