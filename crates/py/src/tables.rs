//! `Table`, `Grid` and `Lattice`: the core's tabulated functions, made from checked samples.

use crate::errors;
use freebody_core::scalar::{self, Interpolation, TableError};
use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArrayDyn,
};
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};
use std::hash::{Hash, Hasher};

/// A function of one variable; equal to another that has the same pieces.
#[pyclass(frozen, eq, hash, module = "freebody._core")]
pub struct Table {
    pub table: scalar::Table,
    samples: [Vec<f64>; 2],
    interpolation: String,
    /// How often the function through the samples is differentiated.
    order: usize,
}

/// A function of two variables; equal to another that has the same patches.
#[pyclass(frozen, eq, hash, module = "freebody._core")]
pub struct Grid {
    pub grid: scalar::Grid,
    samples: [Vec<f64>; 3],
    interpolation: String,
}

/// A function of three or four variables; equal to another that has the same samples.
#[pyclass(frozen, eq, hash, module = "freebody._core")]
pub struct Lattice {
    pub lattice: scalar::Lattice,
    interpolation: String,
}

/// A table of any number of variables.
#[derive(FromPyObject)]
pub enum AnyTable<'py> {
    Table(PyRef<'py, Table>),
    Grid(PyRef<'py, Grid>),
    Lattice(PyRef<'py, Lattice>),
}

impl AnyTable<'_> {
    /// How many variables it has.
    pub fn axes(&self) -> usize {
        match self {
            Self::Table(_) => 1,
            Self::Grid(_) => 2,
            Self::Lattice(t) => t.lattice.samples().0.len(),
        }
    }
}

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;
type Array<'py> = Bound<'py, PyArrayDyn<f64>>;
/// A class and the arguments that make the same object again.
type Recipe<'py, A> = (Bound<'py, PyType>, A);

#[pymethods]
impl Table {
    #[new]
    #[pyo3(signature = (x, y, interpolation, order=0))]
    fn new(
        py: Python<'_>,
        x: PyReadonlyArray1<'_, f64>,
        y: PyReadonlyArray1<'_, f64>,
        interpolation: String,
        order: usize,
    ) -> PyResult<Self> {
        let samples = [x.as_slice()?.to_vec(), y.as_slice()?.to_vec()];
        let kind = kind(py, &interpolation)?;
        let whole = scalar::Table::new(&samples[0], &samples[1], kind).map_err(|e| refusal(py, e))?;
        // The fourth derivative of a cubic, and all that follow, are zero.
        let table = (0..order.min(4)).fold(&whole, |table, _| table.slope()).clone();
        Ok(Self { table, samples, interpolation, order })
    }

    fn value<'py>(&self, py: Python<'py>, x: PyReadonlyArray1<'py, f64>) -> PyResult<Array1<'py>> {
        let values: Vec<_> = x.as_slice()?.iter().map(|x| self.table.value(*x)).collect();
        Ok(PyArray1::from_vec(py, values))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Recipe<'py, (Array1<'py>, Array1<'py>, &str, usize)> {
        let [x, y] = self.samples.each_ref().map(|s| PyArray1::from_slice(py, s));
        (py.get_type::<Self>(), (x, y, &self.interpolation, self.order))
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

#[pymethods]
impl Lattice {
    #[new]
    fn new(
        py: Python<'_>,
        axes: Vec<PyReadonlyArray1<'_, f64>>,
        values: PyReadonlyArrayDyn<'_, f64>,
        interpolation: String,
    ) -> PyResult<Self> {
        let kind = kind(py, &interpolation)?;
        if !matches!(axes.len(), 3 | 4) || kind == Interpolation::Cubic {
            return Err(errors::input(py, "a lattice has three or four axes and no splines".to_owned()));
        }
        let axes = axes.iter().map(|axis| Ok(axis.as_slice()?.to_vec())).collect::<PyResult<_>>()?;
        let made = scalar::Lattice::new(axes, values.as_slice()?.to_vec(), kind);
        Ok(Self { lattice: made.map_err(|e| refusal(py, e))?, interpolation })
    }

    #[pyo3(signature = (*at))]
    fn value<'py>(&self, py: Python<'py>, at: Vec<PyReadonlyArray1<'py, f64>>) -> PyResult<Array1<'py>> {
        let at: Vec<&[f64]> = at.iter().map(|x| Ok(x.as_slice()?)).collect::<PyResult<_>>()?;
        let n = at.first().map_or(0, |x| x.len());
        if at.len() != self.lattice.samples().0.len() || at.iter().any(|x| x.len() != n) {
            return Err(errors::input(py, "as many coordinates as axes, of equal length".to_owned()));
        }
        let value = |i: usize| {
            let point: Vec<f64> = at.iter().map(|x| x[i]).collect();
            self.lattice.value(&point)
        };
        Ok(PyArray1::from_vec(py, (0..n).map(value).collect()))
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<Recipe<'py, (Bound<'py, PyTuple>, Array<'py>, &str)>> {
        let (axes, values, _) = self.lattice.samples();
        let shape: Vec<usize> = axes.iter().map(Vec::len).collect();
        let axes = PyTuple::new(py, axes.iter().map(|axis| PyArray1::from_slice(py, axis)))?;
        let values = PyArray1::from_slice(py, values).reshape(shape)?;
        Ok((py.get_type::<Self>(), (axes, values, &self.interpolation)))
    }
}

/// What is equal if its function is.
macro_rules! by_content {
    ($class:ident, $function:ident) => {
        impl PartialEq for $class {
            fn eq(&self, other: &Self) -> bool {
                self.$function == other.$function
            }
        }

        impl Hash for $class {
            fn hash<H: Hasher>(&self, state: &mut H) {
                self.$function.hash(state);
            }
        }
    };
}
by_content!(Table, table);
by_content!(Grid, grid);
by_content!(Lattice, lattice);

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
