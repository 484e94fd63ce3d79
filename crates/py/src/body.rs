//! `RigidBody`: mass properties about a body frame.

use crate::errors;
use freebody_core::algebra::{Mat3, Mat6, Vec3};
use freebody_core::inertia::{self, BodyDefect, Inertia};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// The core of a rigid body; `freebody.RigidBody` adds the ways to describe one.
#[pyclass(subclass, frozen, module = "freebody._core")]
pub struct RigidBody {
    pub inertia: Inertia<f64>,
    /// How errors and results call the body.
    #[pyo3(get)]
    pub name: String,
}

type Matrix = [[f64; 3]; 3];

#[pymethods]
impl RigidBody {
    /// `about` says where the tensor stands: "com", "origin", or "kept" for one about the mass centre that was
    /// computed from other bodies.
    #[new]
    fn new(
        py: Python<'_>,
        name: String,
        mass: f64,
        com: [f64; 3],
        tensor: Matrix,
        about: &str,
    ) -> PyResult<Self> {
        let made = match about {
            "com" => inertia::from_tensor_about_com(mass, com, tensor),
            "origin" => inertia::from_tensor_about_origin(mass, com, tensor),
            _ => inertia::from_other_bodies(mass, com, tensor),
        };
        let refuse = |d: BodyDefect| errors::body(py, format!("body '{name}': {d}"));
        Ok(Self { inertia: made.map_err(refuse)?, name })
    }

    /// Mass, kg.
    #[getter]
    fn mass(&self) -> f64 {
        self.inertia.mass
    }

    /// Mass centre from the body origin, body axes, (3,) m.
    #[getter]
    fn com<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.inertia.com.to_array())
    }

    /// Inertia tensor about the mass centre, body axes, (3, 3) kg m².
    #[getter]
    fn inertia_about_com<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        matrix3(py, &self.inertia.about_com.full())
    }

    /// Inertia tensor about the body origin, body axes, (3, 3) kg m².
    #[getter]
    fn inertia_about_origin<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        matrix3(py, &self.inertia.about_origin().full())
    }

    /// Principal moments about the mass centre, rising, (3,) kg m².
    #[getter]
    fn principal_moments<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &inertia::principal_moments(self.inertia.about_com))
    }

    /// The Mises inertia matrix Θ about the body origin, linear part first, (6, 6). Konoplev (1.6)
    #[getter]
    fn spatial_inertia<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix6(py, &self.inertia.matrix())
    }

    /// The inverse of `spatial_inertia`, in closed form, (6, 6).
    #[getter]
    fn inverse_spatial_inertia<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix6(py, &self.inertia.inverse_matrix())
    }

    /// Mass centre and tensor about it in another body frame.
    fn moved(&self, origin: [f64; 3], rotation: Matrix) -> ([f64; 3], Matrix) {
        described(&self.inertia.in_frame(Vec3::from_array(origin), Mat3::lit(rotation)))
    }

    /// Mass, mass centre and tensor about it of this body and another, joined.
    fn joined(&self, other: &Self) -> (f64, [f64; 3], Matrix) {
        let sum = self.inertia.joined(&other.inertia);
        let (com, tensor) = described(&sum);
        (sum.mass, com, tensor)
    }
}

fn described(body: &Inertia<f64>) -> ([f64; 3], Matrix) {
    (body.com.to_array(), body.about_com.full().rows.map(Vec3::to_array))
}

fn matrix3<'py>(py: Python<'py>, m: &Mat3<f64>) -> Bound<'py, PyArray2<f64>> {
    PyArray2::from_owned_array(py, numpy::ndarray::arr2(&m.rows.map(Vec3::to_array)))
}

fn matrix6<'py>(py: Python<'py>, m: &Mat6<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let mut flat = [0.0; 36];
    m.store(&mut flat);
    PyArray1::from_slice(py, &flat).reshape([6, 6])
}
