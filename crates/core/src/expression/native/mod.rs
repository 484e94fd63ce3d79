//! Tapes as machine code, for the registers of x86-64.
//!
//! A tape keeps its values in memory and goes there for every operand of every instruction; here they stay in
//! registers. The operations are the same with the same roundings, and so are the results, bit for bit. What is no
//! single instruction, functions and tables, stays interpreted, between blocks of machine code.

mod cache;
mod codes;
mod instructions;
mod memory;
mod plan;
mod registers;
mod step;

pub use cache::Cache;

use super::execute::execute;
use super::registers::{Piece, Values};
use super::tape::{Code, Operands, Tables, Tape};
use crate::scalar::{Machine, Real};
use codes::Codes;
use memory::{Memory, PIECES};
use plan::{Part, Plan};
use registers::assemble;

/// A program in machine code.
#[derive(Debug)]
pub struct Native {
    memory: Memory,
    stages: Vec<Stage>,
    /// How many places it needs, the results first.
    places: usize,
    results: usize,
    constants: usize,
    pieces: usize,
    /// How many numbers of each piece it reads.
    needed: [usize; PIECES],
    /// The bytes of a value.
    width: usize,
}

#[derive(Debug)]
enum Stage {
    /// Machine code, by its start.
    Block(usize),
    Run {
        code: Code,
        instructions: Vec<Operands>,
        first: usize,
    },
}

impl Native {
    /// Of a tape that is given its numbers in pieces of these lengths; none where that cannot be.
    fn of(tape: &Tape, tables: &Tables, machine: Machine, lengths: &[usize]) -> Option<Self> {
        let fits = lengths.len() <= PIECES && lengths.iter().sum::<usize>() == tape.given;
        if !fits || !tape.is_sound(tables) {
            return None;
        }
        let (plan, codes) = (Plan::of(tape)?, Codes::of(machine));
        let assembled = assemble(&plan, codes, lengths, tape.constants)?;
        let mut starts = assembled.starts.into_iter();
        let mut stages = Vec::with_capacity(plan.parts.len());
        for part in plan.parts {
            stages.push(match part {
                Part::Block(_) => Stage::Block(starts.next()?),
                Part::Run { code, instructions, first, .. } => {
                    Stage::Run { code, instructions, first: usize::from(first) }
                }
            });
        }
        let reads = tape.read_values();
        let mut reads = &reads[..];
        let mut needed = [0; PIECES];
        for (needed, length) in needed.iter_mut().zip(lengths) {
            let (own, others) = reads.split_at(*length);
            *needed = own.iter().rposition(|read| *read).map_or(0, |last| last + 1);
            reads = others;
        }
        Some(Self {
            memory: Memory::new(&assembled.code)?,
            stages,
            places: assembled.places,
            results: tape.results.len(),
            constants: tape.constants,
            pieces: lengths.len(),
            needed,
            width: codes.width,
        })
    }

    /// Computes the results.
    #[inline(always)]
    pub fn run<T: Real, const P: usize>(
        &self,
        values: &mut Values<T>,
        given: &[Piece<'_, T>; P],
        constants: &[T],
        tables: &Tables,
    ) {
        let fits = size_of::<T>() == self.width && P == self.pieces;
        assert!(fits, "a program is made for values of one kind in the same pieces");
        assert!(constants.len() == self.constants, "the numbers that were prepared for this program");
        let there = given.iter().zip(&self.needed).all(|(numbers, needed)| numbers.len() >= *needed);
        assert!(there, "a number that this program reads is not given");
        let places = values.places(self.places);
        for stage in &self.stages {
            match stage {
                // SAFETY: the code was made of a sound tape for values of this width, which `Machine` says `T` has; it
                // reads the constants, what is needed of each piece, and places that it has written, of which there
                // are as many as it needs.
                Stage::Block(start) => unsafe { self.memory.run(*start, places, constants, given) },
                Stage::Run { code, instructions, first } => T::call(
                    #[inline(always)]
                    // SAFETY: the blocks before have written what the instructions read.
                    || unsafe {
                        execute(*code, instructions, *first, places, tables);
                    },
                ),
            }
        }
        // SAFETY: the last block has written the results.
        unsafe { values.now(0..self.results) };
    }
}
