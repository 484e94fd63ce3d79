//! The instructions of each operation.
//!
//! The last operand of most can stay in memory, and what is computed goes into the register of an operand that is not
//! needed any more.

use super::registers::{Assembler, Done};
use super::step::{Kind, Step, Value};
use iced_x86::{Code, IcedError, Instruction, MemoryOperand, Register};

/// A register to choose by, where values cannot be.
const MASK: Register = Register::K1;
/// The comparison ≤, false for what is no number.
const LE: u32 = 0x12;

impl Assembler {
    /// One step; the register of its result.
    pub fn step(&mut self, step: &Step) -> Result<usize, IcedError> {
        // What is read again is loaded, as long as there is room.
        for value in step.operands() {
            if !self.is_loaded(*value) && self.is_needed(*value) && self.has_room() {
                self.loaded(*value)?;
            }
        }
        let (codes, [a, b, c, d]) = (self.codes, step.all);
        match step.kind {
            Kind::Copy => {
                self.loaded(a)?;
                let r = self.in_register[a].unwrap_or_default();
                // The copy is only ever stored: nothing works on it.
                self.drop(r);
                Ok(r)
            }
            Kind::Sqrt => {
                let to = self.target(step)?;
                self.two(codes.sqrt, to, a)?;
                Ok(to)
            }
            Kind::Neg => self.with_literal(codes.xor, step, 0),
            Kind::Abs => self.with_literal(codes.and, step, codes.width),
            Kind::Add => self.three(codes.add, step, true),
            Kind::Mul => self.three(codes.mul, step, true),
            Kind::Sub => self.three(codes.sub, step, false),
            Kind::Div => self.three(codes.div, step, false),
            Kind::SelectLe => self.select(step, [a, b, c, d]),
            Kind::MulAdd | Kind::MulSub | Kind::NegMulAdd => self.fused(codes.fused(step.kind), [a, b, c]),
        }
    }

    fn two(&mut self, code: Code, to: usize, from: Value) -> Done {
        let to = self.register(to);
        let instruction = match self.in_register[from] {
            Some(r) => Instruction::with2(code, to, self.register(r)),
            None => Instruction::with2(code, to, self.memory(from)),
        };
        self.emit(instruction)
    }

    fn with_literal(&mut self, code: Code, step: &Step, literal: usize) -> Result<usize, IcedError> {
        let from = self.loaded(step.all[0])?;
        let to = self.target(step)?;
        let literal = MemoryOperand::with_base_displ(Register::RIP, literal as i64);
        self.emit(Instruction::with3(code, self.register(to), from, literal))?;
        Ok(to)
    }

    /// An instruction whose last operand may be in memory.
    fn last(&mut self, code: Code, to: Register, first: Register, last: Value) -> Done {
        let instruction = match self.in_register[last] {
            Some(r) => Instruction::with3(code, to, first, self.register(r)),
            None => Instruction::with3(code, to, first, self.memory(last)),
        };
        self.emit(instruction)
    }

    fn three(&mut self, code: Code, step: &Step, either_way: bool) -> Result<usize, IcedError> {
        let [mut a, mut b, ..] = step.all;
        if either_way && !self.is_loaded(a) && self.is_loaded(b) {
            (a, b) = (b, a);
        }
        let first = self.loaded(a)?;
        let to = self.target(step)?;
        self.last(code, self.register(to), first, b)?;
        Ok(to)
    }

    /// x where a ≤ b, else y.
    fn select(&mut self, step: &Step, [a, b, x, y]: [Value; 4]) -> Result<usize, IcedError> {
        let codes = self.codes;
        let mask = if codes.masks {
            MASK
        } else {
            let r = self.fresh()?;
            self.register(r)
        };
        let first = self.loaded(a)?;
        let comparison = match self.in_register[b] {
            Some(r) => Instruction::with4(codes.compare, mask, first, self.register(r), LE),
            None => Instruction::with4(codes.compare, mask, first, self.memory(b), LE),
        };
        self.emit(comparison)?;
        let other = self.loaded(y)?;
        let to = self.target(step)?;
        let into = self.register(to);
        let blend = match (self.in_register[x], codes.masks) {
            (Some(r), true) => Instruction::with3(codes.blend, into, other, self.register(r)),
            (None, true) => Instruction::with3(codes.blend, into, other, self.memory(x)),
            (Some(r), false) => Instruction::with4(codes.blend, into, other, self.register(r), mask),
            (None, false) => Instruction::with4(codes.blend, into, other, self.memory(x), mask),
        };
        let mut blend = blend?;
        if codes.masks {
            blend.set_op_mask(mask);
        }
        self.emit(Ok(blend))?;
        Ok(to)
    }

    /// a b and c added, into the register of one of them.
    fn fused(
        &mut self,
        [f132, f213, f231]: [Code; 3],
        [mut a, mut b, c]: [Value; 3],
    ) -> Result<usize, IcedError> {
        let last = |value: Value| !self.is_needed(value) && self.is_loaded(value);
        let (into_sum, to) = if last(c) {
            (true, self.in_register[c])
        } else if last(a) || last(b) {
            if !last(a) {
                (a, b) = (b, a);
            }
            (false, self.in_register[a])
        } else if self.is_loaded(c) && !(self.is_loaded(a) && self.is_loaded(b)) {
            if self.is_loaded(a) {
                (a, b) = (b, a);
            }
            (false, None)
        } else {
            (true, None)
        };
        let to = match to {
            Some(r) => r,
            None => {
                let r = self.fresh()?;
                self.two(self.codes.load, r, if into_sum { c } else { a })?;
                r
            }
        };
        let into = self.register(to);
        if into_sum {
            if !self.is_loaded(a) && self.is_loaded(b) {
                (a, b) = (b, a);
            }
            let first = self.loaded(a)?;
            self.last(f231, into, first, b)?;
        } else if self.is_loaded(b) || !self.is_loaded(c) {
            let first = self.loaded(b)?;
            self.last(f213, into, first, c)?;
        } else {
            let first = self.loaded(c)?;
            self.last(f132, into, first, b)?;
        }
        Ok(to)
    }
}
