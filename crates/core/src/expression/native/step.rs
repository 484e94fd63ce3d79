//! The operations that the machine has.

/// The given numbers, the constants, the results of instructions, then what else comes in between.
pub type Value = usize;

/// What one instruction of the machine computes of a, b, c, d; a product that is part of a sum is not rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Copy,
    Neg,
    Abs,
    Sqrt,
    Add,
    Sub,
    Mul,
    Div,
    /// a b + c
    MulAdd,
    /// a b − c
    MulSub,
    /// c − a b
    NegMulAdd,
    SelectLe,
}

impl Kind {
    fn arity(self) -> usize {
        match self {
            Self::Copy | Self::Neg | Self::Abs | Self::Sqrt => 1,
            Self::Add | Self::Sub | Self::Mul | Self::Div => 2,
            Self::MulAdd | Self::MulSub | Self::NegMulAdd => 3,
            Self::SelectLe => 4,
        }
    }
}

/// One operation of a block.
#[derive(Clone, Debug)]
pub struct Step {
    pub kind: Kind,
    /// What it works on, and behind it anything.
    pub all: [Value; 4],
    pub result: Value,
}

impl Step {
    /// What it works on.
    pub fn operands(&self) -> &[Value] {
        &self.all[..self.kind.arity()]
    }
}
