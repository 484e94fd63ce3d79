//! Expressions made ready to run over numbers, lanes and duals.

use super::graph::Graph;
#[cfg(target_arch = "x86_64")]
use super::native::Cache;
use super::node::{Id, Operation};
use super::registers::{Piece, Values};
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
    #[cfg(target_arch = "x86_64")]
    #[serde(skip)]
    native: Cache,
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
            #[cfg(target_arch = "x86_64")]
            native: Cache::default(),
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

    /// For each given number whether a result depends on it.
    pub fn reads(&self) -> Vec<bool> {
        let mut read = self.main.read_values();
        read.truncate(self.main.given);
        read
    }

    /// How many results it has.
    pub fn output_count(&self) -> usize {
        self.main.results.len()
    }

    /// Whether there is machine code of it for values of this type, which are given in pieces of these lengths.
    #[cfg(all(test, target_arch = "x86_64"))]
    pub(super) fn is_native<T: Real, const P: usize>(&self, lengths: [usize; P]) -> bool {
        self.native.of::<T, P>(&self.main, &self.tables, || lengths).is_some()
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

    /// Computes the results of numbers that are given in pieces of these lengths, which are the same at every run: the
    /// quick way, in machine code where there is some. Of a piece only what the program reads has to be there.
    ///
    /// Call where `T` is at home, inside [`Real::call`].
    #[inline(always)]
    pub fn run_in<T: Real, const P: usize>(
        &self,
        values: &mut Values<T>,
        given: [Piece<'_, T>; P],
        lengths: impl Fn() -> [usize; P],
        prepared: &[T],
    ) {
        #[cfg(target_arch = "x86_64")]
        if let Some(native) = self.native.of::<T, P>(&self.main, &self.tables, &lengths) {
            return native.run(values, &given, prepared, &self.tables);
        }
        T::call(
            #[inline(always)]
            || self.main.run_in(values, given, lengths(), prepared, &self.tables),
        );
    }

    /// Whether a program that comes from elsewhere reads only what is there.
    pub fn is_sound(&self) -> bool {
        let (first, last) = (&self.preparation, &self.main);
        let fits = first.constants == self.literals.len() && last.constants == first.results.len();
        fits && first.is_sound(&self.tables) && last.is_sound(&self.tables)
    }
}
