//! `Graph` and `Program`: expressions, and what runs them.

use crate::errors;
use crate::tables::AnyTable;
use freebody_core::expression::{self as core, Id, Operation, ProgramError, Shortest, Simplify};
use freebody_core::scalar::Elementary;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// Expressions by their numbers.
#[pyclass(module = "freebody._core")]
pub struct Graph(pub core::Graph);

/// The operation of one operand that Python calls `name`.
fn unary(name: &str) -> Option<Operation> {
    Some(match name {
        "neg" => Operation::Neg,
        "sqrt" => Operation::Sqrt,
        "abs" => Operation::Abs,
        "sin" => Operation::Sin,
        "cos" => Operation::Cos,
        "tan" => Operation::Elementary(Elementary::Tan),
        "asin" => Operation::Elementary(Elementary::Asin),
        "acos" => Operation::Elementary(Elementary::Acos),
        "atan" => Operation::Elementary(Elementary::Atan),
        "sinh" => Operation::Elementary(Elementary::Sinh),
        "cosh" => Operation::Elementary(Elementary::Cosh),
        "tanh" => Operation::Elementary(Elementary::Tanh),
        "exp" => Operation::Elementary(Elementary::Exp),
        "ln" => Operation::Elementary(Elementary::Ln),
        "floor" => Operation::Elementary(Elementary::Floor),
        _ => return None,
    })
}

/// The operation of two operands that Python calls `name`.
fn binary(name: &str) -> Option<Operation> {
    Some(match name {
        "add" => Operation::Add,
        "sub" => Operation::Sub,
        "mul" => Operation::Mul,
        "div" => Operation::Div,
        "atan2" => Operation::Atan2,
        "pow" => Operation::Pow,
        _ => return None,
    })
}

impl Graph {
    /// Refuses numbers of nodes that there are not.
    pub fn check(&self, py: Python<'_>, ids: &[Id]) -> PyResult<()> {
        match ids.iter().find(|id| !self.0.contains(**id)) {
            Some(id) => Err(errors::input(py, format!("there is no expression {id} in this graph"))),
            None => Ok(()),
        }
    }

    fn apply(&mut self, py: Python<'_>, operation: Operation, operands: &[Id]) -> PyResult<Id> {
        self.check(py, operands)?;
        Ok(self.0.apply(operation, operands))
    }
}

#[pymethods]
impl Graph {
    /// `simplify`: by algebra, or only where every double stays the same; `expand_angles`: write sine and cosine of
    /// a sum in those of its terms.
    #[new]
    #[pyo3(signature = (simplify, expand_angles=false))]
    fn new(simplify: bool, expand_angles: bool) -> Self {
        let mut graph = core::Graph::new(if simplify { Simplify::Algebraically } else { Simplify::Safely });
        graph.expand_angles = expand_angles;
        Self(graph)
    }

    /// A new symbol.
    fn symbol(&mut self, py: Python<'_>, name: &str, latex: &str) -> PyResult<Id> {
        if self.0.symbols().iter().any(|s| s.name == name) {
            return Err(errors::input(py, format!("there are two symbols of the name '{name}'; rename one")));
        }
        Ok(self.0.symbol(name, latex))
    }

    /// A constant.
    fn constant(&mut self, x: f64) -> Id {
        self.0.constant(x)
    }

    /// The value of an expression that is a constant.
    fn value(&self, py: Python<'_>, id: Id) -> PyResult<Option<f64>> {
        self.check(py, &[id])?;
        Ok(self.0.number(id))
    }

    /// An operation on one expression.
    fn unary(&mut self, py: Python<'_>, operation: &str, a: Id) -> PyResult<Id> {
        let known =
            unary(operation).ok_or_else(|| errors::input(py, format!("no operation '{operation}'")))?;
        self.apply(py, known, &[a])
    }

    /// An operation on two expressions.
    fn binary(&mut self, py: Python<'_>, operation: &str, a: Id, b: Id) -> PyResult<Id> {
        let known =
            binary(operation).ok_or_else(|| errors::input(py, format!("no operation '{operation}'")))?;
        self.apply(py, known, &[a, b])
    }

    /// `x` where `a <= b`, else `y`.
    fn select_le(&mut self, py: Python<'_>, a: Id, b: Id, x: Id, y: Id) -> PyResult<Id> {
        self.apply(py, Operation::SelectLe, &[a, b, x, y])
    }

    /// A table of as many variables at expressions.
    fn lookup(&mut self, py: Python<'_>, table: AnyTable<'_>, at: Vec<Id>) -> PyResult<Id> {
        self.check(py, &at)?;
        if at.len() != table.axes() {
            return Err(errors::input(py, format!("a table of {} variables", table.axes())));
        }
        Ok(match table {
            AnyTable::Table(t) => {
                let number = self.0.table(&t.table);
                self.0.apply(Operation::Lookup(number), &at)
            }
            AnyTable::Grid(t) => {
                let number = self.0.grid(&t.grid);
                self.0.apply(Operation::Lookup2(number), &at)
            }
            AnyTable::Lattice(t) => self.0.look_up(&t.lattice, &at),
        })
    }

    /// Chooses the shortest ways to write expressions: with what occurs several times computed once, or written out.
    fn settle(&mut self, py: Python<'_>, outputs: Vec<Id>, shared: bool) -> PyResult<()> {
        self.check(py, &outputs)?;
        self.0.settle(&outputs, if shared { Shortest::Shared } else { Shortest::WrittenOut });
        Ok(())
    }

    /// Operations if written out in full, and if shared ones are computed once.
    fn operation_count(&self, py: Python<'_>, outputs: Vec<Id>) -> PyResult<(f64, usize)> {
        self.check(py, &outputs)?;
        let count = self.0.operation_count(&outputs);
        Ok((count.written_out, count.shared))
    }

    /// The program that computes `outputs` of symbols.
    fn program(
        &self,
        py: Python<'_>,
        parameters: Vec<Id>,
        given: Vec<Id>,
        outputs: Vec<Id>,
    ) -> PyResult<Program> {
        for ids in [&parameters, &given, &outputs] {
            self.check(py, ids)?;
        }
        let made = core::Program::new(&self.0, &parameters, &given, &outputs);
        Ok(Program(Arc::new(made.map_err(|e| no_program(py, e))?)))
    }
}

/// What to raise for expressions that make no program.
pub fn no_program(py: Python<'_>, error: ProgramError) -> PyErr {
    errors::input(
        py,
        match error {
            ProgramError::NoValue(name) => format!("the symbol '{name}' has no value"),
            ProgramError::TooLong => "the expressions take more than 65535 operations; split them".to_owned(),
        },
    )
}

/// What tells damaged bytes from whole ones (Fowler, Noll, Vo, FNV-1a of 64 bits).
fn checksum(data: &[u8]) -> [u8; 8] {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
    data.iter().fold(0xcbf2_9ce4_8422_2325, step).to_le_bytes()
}

/// A traced function: plain data that runs over numbers, lanes and duals.
#[pyclass(frozen, eq, hash, from_py_object, module = "freebody._core")]
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Program(pub Arc<core::Program>);

#[pymethods]
impl Program {
    #[getter]
    fn parameter_count(&self) -> usize {
        self.0.parameter_count()
    }

    #[getter]
    fn given_count(&self) -> usize {
        self.0.given_count()
    }

    #[getter]
    fn output_count(&self) -> usize {
        self.0.output_count()
    }

    /// How many instructions a run takes.
    #[getter]
    fn instruction_count(&self) -> usize {
        self.0.instruction_count()
    }

    /// The program of what `__reduce__` made of it.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, data: &[u8]) -> PyResult<Self> {
        let whole = data.split_last_chunk::<8>().filter(|(data, sum)| checksum(data) == **sum);
        let read = whole.and_then(|(data, _)| postcard::from_bytes::<core::Program>(data).ok());
        let program = read.filter(core::Program::is_sound);
        Ok(Self(Arc::new(program.ok_or_else(|| errors::input(py, "these bytes are no program".to_owned()))?)))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let mut data = postcard::to_allocvec(&*self.0).map_err(|e| errors::input(py, e.to_string()))?;
        data.extend(checksum(&data));
        Ok((py.get_type::<Self>().getattr("from_bytes")?, (PyBytes::new(py, &data),)))
    }

    /// The results (n, outputs) for given numbers (n, given).
    fn run<'py>(
        &self,
        py: Python<'py>,
        parameters: Vec<f64>,
        given: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (n, k, m) = (given.shape()[0], self.0.given_count(), self.0.output_count());
        if given.shape()[1] != k || parameters.len() != self.0.parameter_count() {
            let wanted = self.0.parameter_count();
            return Err(errors::input(py, format!("a program of {wanted} parameters and {k} given numbers")));
        }
        let prepared = self.0.prepare(&parameters);
        let mut out = vec![0.0; n * m];
        let rows = given.as_slice()?;
        for i in 0..n {
            self.0.run(&prepared, &rows[i * k..(i + 1) * k], &mut out[i * m..(i + 1) * m]);
        }
        PyArray1::from_vec(py, out).reshape([n, m])
    }
}
