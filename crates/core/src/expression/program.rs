//! Expressions made ready to run over numbers, lanes and duals.

use super::graph::Graph;
use super::node::{Id, Operation};
use super::registers::Values;
use super::tape::{Tables, Tape};
use crate::scalar::Real;
use serde::{Deserialize, Serialize};

/// A function of parameters and given numbers, traced from expressions: plain data.
///
/// What depends on parameters and constants alone is computed once, by [`Program::prepare`].
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Program {
    /// The bits of the constants that it is made of.
    literals: Vec<u64>,
    preparation: Tape,
    main: Tape,
    tables: Tables,
}

/// Why expressions make no program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProgramError {
    /// A symbol that is neither a parameter nor given, by its name.
    NoValue(String),
    /// More values than a tape can number.
    TooLong,
}

impl Program {
    /// The program that computes `outputs` of the symbols `parameters` and `given`.
    ///
    /// # Errors
    /// [`ProgramError`] when a symbol has no value or the program is too long.
    pub fn new(graph: &Graph, parameters: &[Id], given: &[Id], outputs: &[Id]) -> Result<Self, ProgramError> {
        let order = graph.order(outputs);
        // Whether a node depends on parameters and constants alone.
        let mut fixed = vec![false; graph.nodes.len()];
        let mut literals = Vec::new();
        for id in &order {
            let node = graph.node(*id);
            fixed[*id as usize] = match node.operation {
                Operation::Symbol(n) => {
                    if !parameters.contains(id) && !given.contains(id) {
                        let name = graph.symbols[n as usize].name.clone();
                        return Err(ProgramError::NoValue(name));
                    }
                    parameters.contains(id)
                }
                Operation::Constant(_) => {
                    literals.push(*id);
                    true
                }
                _ => node.operands().iter().all(|o| fixed[*o as usize]),
            };
        }
        // Of those the ones that others work on, or that are wanted themselves.
        let mut wanted: Vec<Id> = outputs.iter().copied().filter(|id| fixed[*id as usize]).collect();
        for id in order.iter().filter(|id| !fixed[**id as usize]) {
            wanted.extend(graph.node(*id).operands().iter().filter(|o| fixed[**o as usize]));
        }
        wanted.sort_unstable();
        wanted.dedup();
        let number = |id: &Id| graph.number(*id).expect("a constant");
        let made = Self {
            preparation: Tape::of(graph, parameters, &literals, &wanted).ok_or(ProgramError::TooLong)?,
            main: Tape::of(graph, given, &wanted, outputs).ok_or(ProgramError::TooLong)?,
            literals: literals.iter().map(|id| number(id).to_bits()).collect(),
            tables: Tables {
                tables: graph.tables.clone(),
                grids: graph.grids.clone(),
                lattices: graph.lattices.clone(),
            },
        };
        debug_assert!(made.is_sound());
        Ok(made)
    }

    /// How many parameters it has.
    pub fn parameter_count(&self) -> usize {
        self.preparation.given
    }

    /// How many numbers are given to it at every run.
    pub fn given_count(&self) -> usize {
        self.main.given
    }

    /// Whether a result depends on given number `i`.
    pub fn reads(&self, i: usize) -> bool {
        self.main.reads(i)
    }

    /// How many results it has.
    pub fn output_count(&self) -> usize {
        self.main.results.len()
    }

    /// How many instructions a run takes.
    pub fn instruction_count(&self) -> usize {
        self.main.instructions.len()
    }

    /// Everything that depends on parameters and constants alone, for [`Program::run`].
    pub fn prepare<T: Real>(&self, parameters: &[T]) -> Vec<T> {
        T::call(
            #[inline(always)]
            || {
                let mut prepared = Vec::with_capacity(self.preparation.results.len());
                prepared.resize(self.preparation.results.len(), T::zero());
                let mut literals = Vec::with_capacity(self.literals.len());
                for bits in &self.literals {
                    literals.push(T::lit(f64::from_bits(*bits)));
                }
                self.preparation.run(&literals, &self.tables, parameters, &mut prepared);
                prepared
            },
        )
    }

    /// Writes the results for the given numbers.
    ///
    /// Call inside [`Real::call`].
    #[inline(always)]
    pub fn run<T: Real>(&self, prepared: &[T], given: &[T], out: &mut [T]) {
        self.main.run(prepared, &self.tables, given, out);
    }

    /// Adds to the given numbers all that is computed of them: the quick way.
    ///
    /// Call inside [`Real::call`].
    #[inline(always)]
    pub fn run_on<T: Real>(&self, values: &mut Values<T>, prepared: &[T]) {
        self.main.run_on(values, prepared, &self.tables);
    }

    /// Result number `k` of a run.
    #[inline(always)]
    pub fn result<T: Real>(&self, values: &Values<T>, k: usize) -> T {
        values.get(self.main.results[k])
    }

    /// Whether a program that comes from elsewhere reads only what is there.
    pub fn is_sound(&self) -> bool {
        let (first, last) = (&self.preparation, &self.main);
        let fits = first.constants == self.literals.len() && last.constants == first.results.len();
        fits && first.is_sound(&self.tables) && last.is_sound(&self.tables)
    }
}
