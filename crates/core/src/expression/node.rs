//! What a node of the graph is: an operation and the nodes that it works on.

use crate::scalar::{Elementary, Real};

/// A node by its number in its graph.
pub type Id = u32;

/// An operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Operation {
    /// A number, by its bits.
    Constant(u64),
    /// A symbol, by its number.
    Symbol(u32),
    /// −a
    Neg,
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a b
    Mul,
    /// a / b
    Div,
    /// √a
    Sqrt,
    /// |a|
    Abs,
    /// sin a
    Sin,
    /// cos a
    Cos,
    /// A function of one number.
    Elementary(Elementary),
    /// The angle of the point (b, a).
    Atan2,
    /// a to the power b
    Pow,
    /// c where a ≤ b, else d
    SelectLe,
    /// A table, by its number, at a.
    Lookup(u32),
    /// A grid, by its number, at (a, b).
    Lookup2(u32),
    /// A lattice of three axes, by its number, at (a, b, c).
    Lookup3(u32),
    /// A lattice of four axes, by its number, at (a, b, c, d).
    Lookup4(u32),
}

impl Operation {
    /// How many nodes it works on.
    pub fn arity(self) -> usize {
        match self {
            Self::Constant(_) | Self::Symbol(_) => 0,
            Self::Neg | Self::Sqrt | Self::Abs | Self::Sin | Self::Cos => 1,
            Self::Elementary(_) | Self::Lookup(_) => 1,
            Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Atan2 | Self::Pow | Self::Lookup2(_) => 2,
            Self::Lookup3(_) => 3,
            Self::SelectLe | Self::Lookup4(_) => 4,
        }
    }

    /// Whether the order of the two operands does not matter.
    pub fn commutes(self) -> bool {
        matches!(self, Self::Add | Self::Mul)
    }

    /// Whether f(−a) = −f(a).
    pub fn is_odd(self) -> bool {
        use Elementary::{Asin, Atan, Sinh, Tan, Tanh};
        matches!(self, Self::Sin | Self::Elementary(Tan | Asin | Atan | Sinh | Tanh))
    }

    /// Whether f(−a) = f(a).
    pub fn is_even(self) -> bool {
        matches!(self, Self::Abs | Self::Cos | Self::Elementary(Elementary::Cosh))
    }

    /// The result for numbers; none for what is no function of numbers alone.
    pub fn value(self, x: [f64; 4]) -> Option<f64> {
        let [a, b, c, d] = x;
        Some(match self {
            Self::Constant(bits) => f64::from_bits(bits),
            Self::Neg => -a,
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::Sqrt => a.sqrt(),
            Self::Abs => a.abs(),
            Self::Sin => a.sin_cos().0,
            Self::Cos => a.sin_cos().1,
            // As in a program, where these functions are not those of the library.
            Self::Elementary(f) => a.elementary(f),
            Self::Atan2 => Real::atan2(a, b),
            Self::Pow => Real::pow(a, b),
            Self::SelectLe => f64::select_le(a, b, c, d),
            Self::Symbol(_) => return None,
            Self::Lookup(_) | Self::Lookup2(_) | Self::Lookup3(_) | Self::Lookup4(_) => return None,
        })
    }
}

/// An operation and what it works on; places beyond its arity are zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Node {
    /// The operation.
    pub operation: Operation,
    /// The operands.
    pub operands: [Id; 4],
}

impl Node {
    /// A node.
    pub fn new(operation: Operation, operands: &[Id]) -> Self {
        debug_assert_eq!(operands.len(), operation.arity());
        let mut all = [0; 4];
        all[..operands.len()].copy_from_slice(operands);
        Self { operation, operands: all }
    }

    /// The nodes that it works on.
    pub fn operands(&self) -> &[Id] {
        &self.operands[..self.operation.arity()]
    }
}
