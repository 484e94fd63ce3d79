//! `Table` and `Grid`: the core's tabulated functions, made from checked samples.

use crate::errors;
use freebody_core::scalar::{self, Interpolation, TableError};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyType;
use std::hash::{Hash, Hasher};

/// A function of one variable; equal to another that has the same pieces.
#[pyclass(frozen, eq, hash, module = "freebody._core")]
pub struct Table {
    pub table: scalar::Table,
    samples: [Vec<f64>; 2],
    interpolation: String,
}

/// A function of two variables; equal to another that has the same patches.
#[pyclass(frozen, eq, hash, module = "freebody._core")]
pub struct Grid {
    pub grid: scalar::Grid,
    samples: [Vec<f64>; 3],
    interpolation: String,
}

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;
/// A class and the arguments that make the same object again.
type Recipe<'py, A> = (Bound<'py, PyType>, A);

#[pymethods]
impl Table {
    #[new]
    fn new(
        py: Python<'_>,
        x: PyReadonlyArray1<'_, f64>,
        y: PyReadonlyArray1<'_, f64>,
        interpolation: String,
    ) -> PyResult<Self> {
        let samples = [x.as_slice()?.to_vec(), y.as_slice()?.to_vec()];
        let kind = kind(py, &interpolation)?;
        let table = scalar::Table::new(&samples[0], &samples[1], kind).map_err(|e| refusal(py, e))?;
        Ok(Self { table, samples, interpolation })
    }

    fn value<'py>(&self, py: Python<'py>, x: PyReadonlyArray1<'py, f64>) -> PyResult<Array1<'py>> {
        let values: Vec<_> = x.as_slice()?.iter().map(|x| self.table.value(*x)).collect();
        Ok(PyArray1::from_vec(py, values))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Recipe<'py, (Array1<'py>, Array1<'py>, &str)> {
        let [x, y] = self.samples.each_ref().map(|s| PyArray1::from_slice(py, s));
        (py.get_type::<Self>(), (x, y, &self.interpolation))
    }
}

#[pymethods]
impl Grid {
    #[new]
    fn new(
        py: Python<'_>,
        x: PyReadonlyArray1<'_, f64>,
        y: PyReadonlyArray1<'_, f64>,
        values: PyReadonlyArray2<'_, f64>,
        interpolation: String,
    ) -> PyResult<Self> {
        let samples = [x.as_slice()?.to_vec(), y.as_slice()?.to_vec(), values.as_slice()?.to_vec()];
        let [x, y, v] = &samples;
        let grid = scalar::Grid::new(x, y, v, kind(py, &interpolation)?).map_err(|e| refusal(py, e))?;
        Ok(Self { grid, samples, interpolation })
    }

    fn value<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray1<'py, f64>,
        y: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Array1<'py>> {
        let points = x.as_slice()?.iter().zip(y.as_slice()?);
        Ok(PyArray1::from_vec(py, points.map(|(x, y)| self.grid.value(*x, *y)).collect()))
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<Recipe<'py, (Array1<'py>, Array1<'py>, Array2<'py>, &str)>> {
        let [x, y, values] = self.samples.each_ref().map(|s| PyArray1::from_slice(py, s));
        let values = values.reshape([self.samples[0].len(), self.samples[1].len()])?;
        Ok((py.get_type::<Self>(), (x, y, values, &self.interpolation)))
    }
}

impl PartialEq for Table {
    fn eq(&self, other: &Self) -> bool {
        self.table == other.table
    }
}

impl Hash for Table {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.table.hash(state);
    }
}

impl PartialEq for Grid {
    fn eq(&self, other: &Self) -> bool {
        self.grid == other.grid
    }
}

impl Hash for Grid {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.grid.hash(state);
    }
}

fn kind(py: Python<'_>, name: &str) -> PyResult<Interpolation> {
    match name {
        "hold" => Ok(Interpolation::Hold),
        "linear" => Ok(Interpolation::Linear),
        "cubic" => Ok(Interpolation::Cubic),
        _ => Err(errors::input(py, format!("interpolation: got '{name}'; allowed are hold, linear, cubic"))),
    }
}

fn refusal(py: Python<'_>, error: TableError) -> PyErr {
    errors::input(
        py,
        match error {
            TableError::NotFinite { index } => format!(
                "values: the curve to sample {index} (counted by rows) is too steep for doubles; put the samples \
             further apart"
            ),
            _ => format!("x and values make no table: {error:?}"),
        },
    )
}
