//! What `Graph` does beyond single operations: forms of the paper, models, derivatives, and text.

use crate::errors;
use crate::graph::{Graph, no_program};
use crate::model::Model;
use freebody_core::algebra::{Mat3, Sym3, Vec3};
use freebody_core::catalog;
use freebody_core::charts::Sequence;
use freebody_core::expression::{self, Expression, Function, Group, Id, Language, Left, Line, Output};
use freebody_core::forces::Situation;
use freebody_core::inertia::Inertia;
use freebody_core::phase_space::{Dynamics, FreeBody};
use freebody_core::scalar::Real;
use freebody_core::screw::Screw;
use pyo3::prelude::*;

/// A body by its expressions: mass, mass centre, upper triangle of the tensor by rows, and whether the tensor is
/// about the origin.
type Body = ([Id; 10], bool);

/// Inside `enter`.
fn inertia((ids, about_origin): Body) -> Inertia<Expression> {
    let [mass, x, y, z, tensor @ ..] = ids.map(Expression);
    let (com, tensor) = (Vec3::new(x, y, z), Sym3::from_array(tensor));
    if about_origin { Inertia::of_origin(mass, com, tensor) } else { Inertia::new(mass, com, tensor) }
}

/// A model, each law for itself, over expressions, with its own body or another. Inside `enter`.
fn written(model: &Model, body: Option<Body>) -> FreeBody<Expression> {
    let each = FreeBody { acting: None, ..model.free_body.clone() };
    let lifted = each.map(&mut Expression::lit);
    FreeBody { inertia: body.map_or(lifted.inertia, inertia), ..lifted }
}

fn expressions(ids: &[Id]) -> Vec<Expression> {
    ids.iter().copied().map(Expression).collect()
}

fn ids(expressions: &[Expression]) -> Vec<Id> {
    expressions.iter().map(|e| e.0).collect()
}

#[pymethods]
impl Graph {
    /// A form of the paper by its name in the catalogue, of arguments flattened by rows.
    fn form(
        &mut self,
        py: Python<'_>,
        name: &str,
        angles: Option<&str>,
        body: Option<Body>,
        arguments: Vec<Vec<Id>>,
    ) -> PyResult<Vec<Id>> {
        for argument in &arguments {
            self.check(py, argument)?;
        }
        let sequence = angles.and_then(Sequence::parse);
        let result = self.0.enter(|| {
            let entry = catalog::find(name, sequence, body.map(inertia))?;
            let given: Vec<Vec<Expression>> = arguments.iter().map(|a| expressions(a)).collect();
            let slices: Vec<&[Expression]> = given.iter().map(Vec::as_slice).collect();
            let fits = slices.iter().map(|s| s.len()).eq(entry.arguments.iter().copied());
            let mut out = vec![Expression::zero(); entry.result];
            fits.then(|| {
                (entry.row)(&slices, &mut out);
                ids(&out)
            })
        });
        result.ok_or_else(|| errors::input(py, format!("there is no form '{name}' of these arguments")))
    }

    /// The derivative f(x, u, t) of a model, with its own body or another.
    fn derivative(
        &mut self,
        py: Python<'_>,
        model: &Model,
        body: Option<Body>,
        t: Id,
        x: Vec<Id>,
        u: Vec<Id>,
    ) -> PyResult<Vec<Id>> {
        for given in [&[t][..], &x, &u] {
            self.check(py, given)?;
        }
        Ok(self.0.enter(|| {
            let lifted = written(model, body);
            let mut dx = vec![Expression::zero(); x.len()];
            lifted.derivative(Expression(t), &expressions(&x), &expressions(&u), &mut dx);
            ids(&dx)
        }))
    }

    /// The wrench of a model about its origin in body axes, with its own body or another.
    ///
    /// `situation`: position (3), rotation (9) by rows, twist (6); `states`: the auxiliary ones.
    fn wrench(
        &mut self,
        py: Python<'_>,
        model: &Model,
        body: Option<Body>,
        t: Id,
        situation: [Id; 18],
        u: Vec<Id>,
        states: Vec<Id>,
    ) -> PyResult<Vec<Id>> {
        for given in [&[t][..], &situation, &u, &states] {
            self.check(py, given)?;
        }
        Ok(self.0.enter(|| {
            let lifted = written(model, body);
            let (s, u, states) = (expressions(&situation), expressions(&u), expressions(&states));
            let mut rates = states.clone();
            let situation = Situation {
                time: Expression(t),
                position: Vec3::from_slice(&s[..3]),
                rotation: Mat3::from_slice(&s[3..12]),
                twist: Screw::from_slice(&s[12..]),
                inertia: &lifted.inertia,
                inputs: &u,
                states: &states,
            };
            let wrenches = lifted.forces.iter().map(|f| f.about_origin(&situation, &mut rates));
            let mut six = [Expression::zero(); 6];
            wrenches.fold(Screw::zero(), |a, b| a + b).store(&mut six);
            ids(&six)
        }))
    }

    /// The symbols that expressions are made of.
    fn symbols_in(&self, py: Python<'_>, outputs: Vec<Id>) -> PyResult<Vec<Id>> {
        self.check(py, &outputs)?;
        Ok(self.0.order(&outputs).into_iter().filter(|id| self.0.symbol_of(*id).is_some()).collect())
    }

    /// The derivatives of expressions by symbols, by rows.
    fn jacobian(&mut self, py: Python<'_>, outputs: Vec<Id>, by: Vec<Id>) -> PyResult<Vec<Id>> {
        self.check(py, &outputs)?;
        self.check(py, &by)?;
        self.0.jacobian(&outputs, &by).map_err(|e| no_program(py, e))
    }

    /// A function in a language: "c", "numpy", "jax", "casadi" or "sympy".
    ///
    /// `groups`: name, symbols, and whether it is one number; `outputs`: name, entries, and columns of a matrix.
    fn code(
        &self,
        py: Python<'_>,
        language: &str,
        name: &str,
        comment: Vec<String>,
        groups: Vec<(String, Vec<Id>, bool)>,
        outputs: Vec<(String, Vec<Id>, Option<usize>)>,
    ) -> PyResult<String> {
        let language = match language {
            "c" => Language::C,
            "numpy" => Language::NumPy,
            "jax" => Language::Jax,
            "casadi" => Language::CasAdi,
            "sympy" => Language::SymPy,
            _ => return Err(errors::input(py, format!("there is no printer for '{language}'"))),
        };
        for ids in groups.iter().map(|g| &g.1).chain(outputs.iter().map(|o| &o.1)) {
            self.check(py, ids)?;
        }
        let group = |(name, symbols, scalar)| Group { name, symbols, scalar };
        let output = |(name, entries, columns)| Output { name, entries, columns };
        let groups: Vec<Group> = groups.into_iter().map(group).collect();
        let outputs: Vec<Output> = outputs.into_iter().map(output).collect();
        let f = Function { graph: &self.0, name, comment: &comment, groups: &groups, outputs: &outputs };
        Ok(f.print(language))
    }

    /// The function in C over many columns at once: of `given` symbols.
    fn block(&self, py: Python<'_>, name: &str, given: Vec<Id>, outputs: Vec<Id>) -> PyResult<String> {
        self.check(py, &given)?;
        self.check(py, &outputs)?;
        let groups = [Group { name: "given".to_owned(), symbols: given, scalar: false }];
        let outputs = [Output { name: "out".to_owned(), entries: outputs, columns: None }];
        let f = Function { graph: &self.0, name, comment: &[], groups: &groups, outputs: &outputs };
        Ok(f.print_block())
    }

    /// Equations in LaTeX: each a name or an expression, and what it is equal to.
    fn latex(&self, py: Python<'_>, lines: Vec<(Bound<'_, PyAny>, Id)>, common: bool) -> PyResult<String> {
        let mut all = Vec::new();
        for (left, right) in lines {
            let left = match left.extract::<Id>() {
                Ok(id) => Left::Expression(id),
                Err(_) => Left::Name(left.extract()?),
            };
            if let Left::Expression(id) = left {
                self.check(py, &[id])?;
            }
            self.check(py, &[right])?;
            all.push(Line { left, right });
        }
        Ok(expression::latex(&self.0, &all, common))
    }
}
