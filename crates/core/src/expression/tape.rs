//! A list of instructions over registers: what a computer runs instead of a graph.
//!
//! Instructions of one code stand together in runs, and those of one run do not depend on each other: so the
//! choice of the code is made once a run, and a processor works on several instructions at the same time.

use super::node::Operation;
use super::registers::{Registers, SMALL, Values};
use crate::scalar::{Elementary, Grid, Lattice, Real, Table};
use serde::{Deserialize, Serialize};

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
    fn arity(self) -> usize {
        match self {
            Self::Neg | Self::Sqrt | Self::Abs | Self::SinCos | Self::Elementary(_) | Self::Lookup(_) => 1,
            Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Atan2 | Self::Pow | Self::Lookup2(_) => 2,
            Self::MulAdd | Self::MulSub | Self::NegMulAdd | Self::Mul3 | Self::Add3 | Self::Lookup3(_) => 3,
            Self::MulMulAdd | Self::MulMulSub | Self::SelectLe | Self::Lookup4(_) => 4,
        }
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
                values += if *code == Code::SinCos { 2 } else { 1 };
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

    /// Whether an instruction or a result is value `i`.
    pub fn reads(&self, i: usize) -> bool {
        let is = |number: &u16| usize::from(*number) == i;
        let mut instructions = self.instructions.iter();
        let worked_on = self.runs.iter().any(|(code, count)| {
            let mut run = instructions.by_ref().take(*count);
            run.any(|operands| operands[..code.arity()].iter().any(is))
        });
        worked_on || self.results.iter().any(is)
    }

    /// Writes the results for the given numbers.
    #[inline(always)]
    pub fn run<T: Real>(&self, constants: &[T], tables: &Tables, given: &[T], out: &mut [T]) {
        let mut values = Vec::with_capacity(usize::from(self.values));
        values.extend_from_slice(given);
        self.go(&mut values, given.len(), constants, tables);
        for (o, i) in out.iter_mut().zip(&self.results) {
            *o = values[usize::from(*i)];
        }
    }

    /// Adds all that is computed to the given numbers; the results are among it.
    #[inline(always)]
    pub fn run_on<T: Real>(&self, values: &mut Values<T>, constants: &[T], tables: &Tables) {
        let count = if usize::from(self.values) <= SMALL {
            let (places, given) = values.on_stack();
            self.go(places, given, constants, tables)
        } else {
            let (places, given) = values.on_heap(usize::from(self.values));
            self.go(places, given, constants, tables)
        };
        // SAFETY: `go` has put so many.
        unsafe { values.now(count) };
    }

    /// Runs behind the `given` values; how many values there are then.
    #[inline(always)]
    fn go<T: Real, R: Registers<T>>(
        &self,
        r: &mut R,
        given: usize,
        constants: &[T],
        tables: &Tables,
    ) -> usize {
        assert_eq!(given, self.given, "the numbers that this program is given");
        assert_eq!(constants.len(), self.constants, "the numbers that were prepared for this program");
        r.put_all(given, constants);
        let mut n = given + constants.len();
        // SAFETY (of both): `given` values and the constants have been put, each `put` adds one to `n`, and a sound
        // tape, as all are, has room for its values and reads only what is there.
        macro_rules! get {
            ($i:expr) => {
                unsafe { r.get($i, n) }
            };
        }
        macro_rules! put {
            ($n:expr, $x:expr) => {{
                let x = $x;
                unsafe { r.put($n, x) }
            }};
        }
        let mut rest = &self.instructions[..];
        for (code, count) in &self.runs {
            let (now, later) = rest.split_at(*count);
            rest = later;
            macro_rules! each {
                ($a:ident => $result:expr) => {
                    for i in now {
                        let $a = get!(i[0]);
                        put!(n, $result);
                        n += 1;
                    }
                };
                ($a:ident, $b:ident => $result:expr) => {
                    for i in now {
                        let ($a, $b) = (get!(i[0]), get!(i[1]));
                        put!(n, $result);
                        n += 1;
                    }
                };
                ($a:ident, $b:ident, $c:ident => $result:expr) => {
                    for i in now {
                        let ($a, $b, $c) = (get!(i[0]), get!(i[1]), get!(i[2]));
                        put!(n, $result);
                        n += 1;
                    }
                };
                ($a:ident, $b:ident, $c:ident, $d:ident => $result:expr) => {
                    for i in now {
                        let ($a, $b) = (get!(i[0]), get!(i[1]));
                        let ($c, $d) = (get!(i[2]), get!(i[3]));
                        put!(n, $result);
                        n += 1;
                    }
                };
            }
            match code {
                Code::MulMulAdd => each!(a, b, c, d => a.fma(b, c * d)),
                Code::MulMulSub => each!(a, b, c, d => a.fma(b, -(c * d))),
                Code::Mul3 => each!(a, b, c => a * b * c),
                Code::Add3 => each!(a, b, c => a + b + c),
                Code::MulAdd => each!(a, b, c => a.fma(b, c)),
                Code::MulSub => each!(a, b, c => a.fma(b, -c)),
                Code::NegMulAdd => each!(a, b, c => (-a).fma(b, c)),
                Code::Add => each!(a, b => a + b),
                Code::Sub => each!(a, b => a - b),
                Code::Mul => each!(a, b => a * b),
                Code::Div => each!(a, b => a / b),
                Code::Neg => each!(a => -a),
                Code::Sqrt => each!(a => a.sqrt()),
                Code::Abs => each!(a => a.abs()),
                Code::SinCos => {
                    for i in now {
                        let (s, c) = get!(i[0]).sin_cos();
                        put!(n, s);
                        put!(n + 1, c);
                        n += 2;
                    }
                }
                Code::Elementary(f) => each!(a => a.elementary(*f)),
                Code::Atan2 => each!(a, b => a.atan2(b)),
                Code::Pow => each!(a, b => a.pow(b)),
                Code::SelectLe => each!(a, b, x, y => T::select_le(a, b, x, y)),
                Code::Lookup(n) => each!(a => a.lookup(&tables.tables[*n as usize])),
                Code::Lookup2(n) => each!(a, b => a.lookup_2(b, &tables.grids[*n as usize])),
                Code::Lookup3(n) => each!(a, b, c => T::lookup_n(&[a, b, c], &tables.lattices[*n as usize])),
                Code::Lookup4(n) => {
                    each!(a, b, c, d => T::lookup_n(&[a, b, c, d], &tables.lattices[*n as usize]));
                }
            }
        }
        n
    }
}
