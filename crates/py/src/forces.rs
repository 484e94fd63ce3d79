//! `Force`: the core's force elements, made from checked numbers.

use crate::errors;
use crate::graph::Program;
use crate::laws;
use freebody_core::algebra::{Mat6, Vec3};
use freebody_core::forces::{
    Axes, Coefficients, ConstantWrench, Field, Force as Element, HarmonicGravity, Harmonics, InputWrench,
    LinearDamping, PointMassGravity, QuadraticDamping, TabulatedWrench, UniformGravity,
};
use freebody_core::scalar::{Interpolation, Table};
use freebody_core::screw::Screw;
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::sync::Arc;

/// A force element of the core.
#[pyclass(frozen, from_py_object, module = "freebody._core")]
#[derive(Clone)]
pub struct Force(pub Element<f64>);

fn axes(world: bool) -> Axes {
    if world { Axes::World } else { Axes::Body }
}

#[pymethods]
impl Force {
    #[staticmethod]
    fn uniform_gravity(acceleration: [f64; 3]) -> Self {
        Self(Element::UniformGravity(UniformGravity { acceleration: Vec3::from_array(acceleration) }))
    }

    #[staticmethod]
    fn point_mass_gravity(mu: f64, center: [f64; 3], gradient_torque: bool) -> Self {
        let center = Vec3::from_array(center);
        Self(Element::PointMassGravity(PointMassGravity { mu, center, gradient_torque }))
    }

    /// `c` and `s` hold the normalised coefficients by rows, one row for each degree.
    #[staticmethod]
    fn harmonic_gravity(
        mu: f64,
        center: [f64; 3],
        radius: f64,
        c: PyReadonlyArray2<'_, f64>,
        s: PyReadonlyArray2<'_, f64>,
        rotation: [f64; 2],
        gradient_torque: bool,
    ) -> PyResult<Self> {
        let (count, c, s) = (c.shape()[0].min(s.shape()[0]), c.as_slice()?, s.as_slice()?);
        let mut field = Harmonics::zero(count - 1);
        for n in 0..count {
            for m in 0..=n {
                *field.at(n, m) = [c[n * count + m], s[n * count + m]];
            }
        }
        let field = Arc::new(Field::new(radius, field, gradient_torque));
        let ([rotation_rate, angle], center) = (rotation, Vec3::from_array(center));
        Ok(Self(Element::HarmonicGravity(HarmonicGravity { mu, center, field, rotation_rate, angle })))
    }

    #[staticmethod]
    fn constant_wrench(force: [f64; 3], moment: [f64; 3], world: bool, at: [f64; 3]) -> Self {
        let wrench = Screw::new(Vec3::from_array(force), Vec3::from_array(moment));
        Self(Element::ConstantWrench(ConstantWrench { wrench, at: Vec3::from_array(at), axes: axes(world) }))
    }

    /// `columns` holds the six components by rows, (6, n).
    #[staticmethod]
    fn tabulated_wrench(
        py: Python<'_>,
        times: PyReadonlyArray1<'_, f64>,
        columns: PyReadonlyArray2<'_, f64>,
        hold: bool,
        world: bool,
        at: [f64; 3],
    ) -> PyResult<Self> {
        let mut components = [const { None }; 6];
        let tables = tables(py, times, columns, hold)?;
        for (place, (table, zero)) in components.iter_mut().zip(tables) {
            *place = (!zero).then_some(table);
        }
        let at = Vec3::from_array(at);
        Ok(Self(Element::TabulatedWrench(TabulatedWrench { components, at, axes: axes(world) })))
    }

    /// Of 6 numbers on the diagonal, or of 36 by rows.
    #[staticmethod]
    fn damping(coefficients: Vec<f64>, quadratic: bool) -> Self {
        let coefficients = if coefficients.len() == 6 {
            Coefficients::Diagonal(Screw::from_slice(&coefficients))
        } else {
            Coefficients::Full(Mat6::from_slice(&coefficients))
        };
        Self(if quadratic {
            Element::QuadraticDamping(QuadraticDamping { coefficients })
        } else {
            Element::LinearDamping(LinearDamping { coefficients })
        })
    }

    #[staticmethod]
    fn input_wrench(world: bool, at: [f64; 3]) -> Self {
        let at = Vec3::from_array(at);
        Self(Element::InputWrench(InputWrench {
            places: InputWrench::<f64>::from_place(0),
            at,
            axes: axes(world),
        }))
    }

    /// A program whose outputs are the wrench and the rates of its states.
    #[staticmethod]
    fn traced(py: Python<'_>, program: Program, parameters: Vec<f64>, n_states: usize) -> PyResult<Self> {
        Ok(Self(Element::Traced(laws::traced(py, program, parameters, 6, n_states)?)))
    }

    /// A function from given numbers (23 + n_inputs, n) to wrenches (6, n).
    #[staticmethod]
    fn callback(function: Py<PyAny>, n_inputs: usize) -> Self {
        Self(Element::Callback(laws::callback(function, n_inputs)))
    }
}

/// One table for each row of `columns`, and whether it is zero throughout.
pub fn tables(
    py: Python<'_>,
    times: PyReadonlyArray1<'_, f64>,
    columns: PyReadonlyArray2<'_, f64>,
    hold: bool,
) -> PyResult<Vec<(Table, bool)>> {
    let (times, n) = (times.as_slice()?, columns.shape()[1]);
    let interpolation = if hold { Interpolation::Hold } else { Interpolation::Linear };
    let one = |values: &[f64]| {
        let table = Table::new(times, values, interpolation)
            .map_err(|e| errors::input(py, format!("times and values make no table: {e:?}")))?;
        Ok((table, values.iter().all(|v| *v == 0.0)))
    };
    columns.as_slice()?.chunks(n.max(1)).map(one).collect()
}
