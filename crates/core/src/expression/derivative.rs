//! Exact derivatives of expressions: their program, run over duals of expressions.

use super::graph::Graph;
use super::node::Id;
use super::program::{Program, ProgramError};
use super::scalar::Expression;
use crate::scalar::{Dual, Real};

impl Graph {
    /// The derivatives of `outputs` by the symbols `by`: by rows, one row an output.
    ///
    /// # Errors
    /// As of [`Program::new`].
    pub fn jacobian(&mut self, outputs: &[Id], by: &[Id]) -> Result<Vec<Id>, ProgramError> {
        let order = self.order(outputs);
        let given: Vec<Id> = order.into_iter().filter(|id| self.symbol_of(*id).is_some()).collect();
        let program = Program::new(self, &[], &given, outputs)?;
        let columns: Vec<Vec<Id>> = self.enter(|| {
            let prepared = program.prepare::<Dual<Expression, 1>>(&[]);
            let along = |symbol: &Id| {
                let seed = |id: &Id| Dual {
                    value: Expression(*id),
                    slope: [if id == symbol { Expression::one() } else { Expression::zero() }],
                };
                let point: Vec<_> = given.iter().map(seed).collect();
                let mut out = vec![Dual::lit(0.0); outputs.len()];
                program.run(&prepared, &point, &mut out);
                out.iter().map(|x| x.slope[0].0).collect()
            };
            by.iter().map(along).collect()
        });
        Ok((0..outputs.len()).flat_map(|row| columns.iter().map(move |c| c[row])).collect())
    }
}
