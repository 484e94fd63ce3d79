//! A list of instructions over registers: what a computer runs instead of a graph.
//!
//! Instructions of one code stand together in runs, and those of one run seldom depend on each other: so the
//! choice of the code is made once a run, and a processor works on several instructions at the same time.

use super::execute::execute;
use super::node::Operation;
use super::registers::{Piece, Values};
use crate::scalar::{Elementary, Grid, Lattice, Real, Table};
use serde::{Deserialize, Serialize};
use std::mem::MaybeUninit;

/// What an instruction does with its operands a, b, c, d.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub(super) enum Code {
    /// a b + c d
    MulMulAdd,
    /// a b − c d
    MulMulSub,
    /// a b + c
    MulAdd,
    /// a b − c
    MulSub,
    /// c − a b
    NegMulAdd,
    /// a b c
    Mul3,
    /// a + b + c
    Add3,
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    Sqrt,
    Abs,
    /// The sine, and as a second result the cosine.
    SinCos,
    Elementary(Elementary),
    Atan2,
    Pow,
    SelectLe,
    Lookup(u32),
    Lookup2(u32),
    Lookup3(u32),
    Lookup4(u32),
}

impl Code {
    /// How many operands it works on.
    pub fn arity(self) -> usize {
        match self {
            Self::Neg | Self::Sqrt | Self::Abs | Self::SinCos | Self::Elementary(_) | Self::Lookup(_) => 1,
            Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Atan2 | Self::Pow | Self::Lookup2(_) => 2,
            Self::MulAdd | Self::MulSub | Self::NegMulAdd | Self::Mul3 | Self::Add3 | Self::Lookup3(_) => 3,
            Self::MulMulAdd | Self::MulMulSub | Self::SelectLe | Self::Lookup4(_) => 4,
        }
    }

    /// How many results it has.
    pub fn results(self) -> usize {
        if self == Self::SinCos { 2 } else { 1 }
    }

    /// How long its result takes, roughly, in units of a short one's half.
    pub fn latency(self) -> usize {
        match self {
            Self::Div | Self::Sqrt => 4,
            Self::SinCos | Self::Elementary(_) | Self::Atan2 | Self::Pow => 10,
            _ => 2,
        }
    }

    /// That of an operation of the graph.
    pub fn of(operation: Operation) -> Self {
        match operation {
            Operation::Neg => Self::Neg,
            Operation::Add => Self::Add,
            Operation::Sub => Self::Sub,
            Operation::Mul => Self::Mul,
            Operation::Div => Self::Div,
            Operation::Sqrt => Self::Sqrt,
            Operation::Abs => Self::Abs,
            Operation::Sin | Operation::Cos => Self::SinCos,
            Operation::Elementary(f) => Self::Elementary(f),
            Operation::Atan2 => Self::Atan2,
            Operation::Pow => Self::Pow,
            Operation::SelectLe => Self::SelectLe,
            Operation::Lookup(n) => Self::Lookup(n),
            Operation::Lookup2(n) => Self::Lookup2(n),
            Operation::Lookup3(n) => Self::Lookup3(n),
            Operation::Lookup4(n) => Self::Lookup4(n),
            Operation::Constant(_) | Operation::Symbol(_) => {
                unreachable!("constants and symbols are registers")
            }
        }
    }
}

/// The numbers of the values that an instruction works on; its result is the next value.
pub(super) type Operands = [u16; 4];

/// Instructions on values: first the given numbers, then the constants, then the results in their order.
///
/// A tape is sound: made by `Tape::of`, or found so by [`Tape::is_sound`] when it comes from elsewhere.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub(super) struct Tape {
    pub given: usize,
    pub constants: usize,
    /// How many values there are in the end.
    pub values: u16,
    /// Each code with the number of its instructions.
    pub runs: Vec<(Code, usize)>,
    pub instructions: Vec<Operands>,
    /// The numbers of the results.
    pub results: Vec<u16>,
}

/// Tables, grids and lattices by their numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub(super) struct Tables {
    pub tables: Vec<Table>,
    pub grids: Vec<Grid>,
    pub lattices: Vec<Lattice>,
}

impl Tape {
    /// Whether all that is read is there by then.
    pub fn is_sound(&self, tables: &Tables) -> bool {
        let mut instructions = self.instructions.iter();
        let mut values = self.given + self.constants;
        for (code, count) in &self.runs {
            for _ in 0..*count {
                let Some(operands) = instructions.next() else { return false };
                if operands[..code.arity()].iter().any(|i| usize::from(*i) >= values) {
                    return false;
                }
                values += code.results();
            }
            let known = match code {
                Code::Lookup(n) => (*n as usize) < tables.tables.len(),
                Code::Lookup2(n) => (*n as usize) < tables.grids.len(),
                Code::Lookup3(n) => tables.lattices.get(*n as usize).is_some_and(|l| l.is_sound(3)),
                Code::Lookup4(n) => tables.lattices.get(*n as usize).is_some_and(|l| l.is_sound(4)),
                _ => true,
            };
            if !known {
                return false;
            }
        }
        let results = self.results.iter().all(|i| usize::from(*i) < values);
        instructions.next().is_none() && values == usize::from(self.values) && results
    }

    /// For each value whether an instruction or a result is it.
    pub fn read_values(&self) -> Vec<bool> {
        let mut read = vec![false; usize::from(self.values)];
        let mut instructions = self.instructions.iter();
        for (code, count) in &self.runs {
            for operands in instructions.by_ref().take(*count) {
                for i in &operands[..code.arity()] {
                    read[usize::from(*i)] = true;
                }
            }
        }
        for i in &self.results {
            read[usize::from(*i)] = true;
        }
        read
    }

    /// Writes the results for the given numbers.
    #[inline(always)]
    pub fn run<T: Real>(&self, constants: &[T], tables: &Tables, given: &[T], out: &mut [T]) {
        let mut places = Vec::new();
        places.resize_with(usize::from(self.values), MaybeUninit::uninit);
        self.go(&mut places, [Piece::of(given)], [given.len()], constants, tables);
        for (o, i) in out.iter_mut().zip(&self.results) {
            // SAFETY: `go` has written all values.
            *o = unsafe { places[usize::from(*i)].assume_init() };
        }
    }

    /// Computes the results of what is given in pieces of these lengths.
    #[inline(always)]
    pub fn run_in<T: Real, const P: usize>(
        &self,
        values: &mut Values<T>,
        given: [Piece<'_, T>; P],
        lengths: [usize; P],
        constants: &[T],
        tables: &Tables,
    ) {
        let (count, results) = (usize::from(self.values), self.results.len());
        let places = values.places(count + results);
        self.go(places, given, lengths, constants, tables);
        for (k, i) in self.results.iter().enumerate() {
            places[count + k] = places[usize::from(*i)];
        }
        // SAFETY: the values that stand there are among those that `go` has written.
        unsafe { values.now(count..count + results) };
    }

    /// Writes all values.
    #[inline(always)]
    fn go<T: Real, const P: usize>(
        &self,
        places: &mut [MaybeUninit<T>],
        given: [Piece<'_, T>; P],
        lengths: [usize; P],
        constants: &[T],
        tables: &Tables,
    ) {
        assert_eq!(lengths.iter().sum::<usize>(), self.given, "the numbers that this program is given");
        assert_eq!(constants.len(), self.constants, "the numbers that were prepared for this program");
        let mut n = 0;
        for (numbers, length) in given.into_iter().zip(lengths) {
            let (there, missing) = places[n..n + length].split_at_mut(numbers.len());
            for (place, x) in there.iter_mut().zip(numbers.slice()) {
                place.write(*x);
            }
            // What is not read may be missing.
            for place in missing {
                place.write(T::zero());
            }
            n += length;
        }
        for (place, x) in places[n..n + constants.len()].iter_mut().zip(constants) {
            place.write(*x);
        }
        n += constants.len();
        let mut rest = &self.instructions[..];
        for (code, count) in &self.runs {
            let (now, later) = rest.split_at(*count);
            rest = later;
            // SAFETY: a sound tape, as all are, has room for its values and reads only what is there.
            n = unsafe { execute(*code, now, n, places, tables) };
        }
    }
}
