//! From operations to machine code: which value is in which register.
//!
//! A value that is needed again after all others gives its register away; what stands in memory already gives it away
//! first, for an instruction can read memory itself.

use super::codes::Codes;
use super::memory::PIECES;
use super::plan::{Part, Plan};
use super::step::{Step, Value};
use crate::expression::registers::Piece;
use iced_x86::{Code, Encoder, IcedError, Instruction, MemoryOperand, Register};

/// The registers with the addresses of the places, the constants and the pieces of the given numbers.
const PLACES: Register = Register::RDI;
const CONSTANTS: Register = Register::RSI;
const TABLE: Register = Register::RDX;
/// That of the addresses of the pieces goes last, as one of them.
const GIVEN: [Register; PIECES] =
    [Register::RAX, Register::RCX, Register::R8, Register::R9, Register::R10, Register::R11, TABLE];

/// No step.
const NEVER: usize = usize::MAX;

/// The code of a program.
pub struct Assembled {
    pub code: Vec<u8>,
    /// Where each block starts.
    pub starts: Vec<usize>,
    /// How many places the program needs.
    pub places: usize,
}

/// The blocks of a plan; none where something has no code.
///
/// `given` are the lengths of the pieces of the given numbers.
pub fn assemble(plan: &Plan, codes: &'static Codes, given: &[usize], constants: usize) -> Option<Assembled> {
    let mut code = Vec::new();
    // The sign bits, and all others.
    for literal in [1 << 63, !(1 << 63)] {
        for _ in 0..codes.width / 8 {
            code.extend(u64::to_le_bytes(literal));
        }
    }
    let mut addresses = Vec::new();
    for (piece, length) in given.iter().enumerate() {
        addresses.extend((0..*length).map(|i| (GIVEN[piece], i)));
    }
    addresses.extend((0..constants).map(|i| (CONSTANTS, i)));
    let start = addresses.len();
    addresses.extend(plan.places[start..].iter().map(|_| (Register::None, 0)));
    let mut encoder = Encoder::new(64);
    let end = code.len();
    encoder.set_buffer(code);
    let mut a = Assembler {
        codes,
        encoder,
        end: end as u64,
        in_register: vec![None; addresses.len()],
        soon: vec![NEVER; addresses.len()],
        addresses,
        held: vec![None; codes.count],
        pinned: 0,
        count: usize::from(plan.count),
    };
    let mut starts = Vec::new();
    for part in &plan.parts {
        match part {
            Part::Block(steps) => {
                starts.push(a.end as usize);
                a.block(steps, &plan.places, given.len()).ok()?;
            }
            Part::Run { results, first, .. } => {
                for (i, value) in results.clone().enumerate() {
                    a.addresses[value] = (PLACES, usize::from(*first) + i);
                }
            }
        }
    }
    Some(Assembled { code: a.encoder.take_buffer(), starts, places: a.count })
}

/// Writes blocks, one step after another.
pub struct Assembler {
    pub codes: &'static Codes,
    encoder: Encoder,
    /// The length of the code.
    end: u64,
    /// Where each value stands in memory: a register and a number behind it; no register if it does not.
    addresses: Vec<(Register, usize)>,
    pub in_register: Vec<Option<usize>>,
    /// The next step that works on each value.
    soon: Vec<usize>,
    /// The value in each register.
    held: Vec<Option<Value>>,
    /// A bit for each register that the present step needs.
    pinned: u32,
    /// How many places there are.
    count: usize,
}

/// What can go wrong: an instruction that there is not.
pub type Done = Result<(), IcedError>;

impl Assembler {
    pub fn emit(&mut self, instruction: Result<Instruction, IcedError>) -> Done {
        self.end += self.encoder.encode(&instruction?, self.end)? as u64;
        Ok(())
    }

    pub fn register(&self, r: usize) -> Register {
        self.codes.first + r as u32
    }

    pub fn memory(&self, value: Value) -> MemoryOperand {
        let (base, number) = self.addresses[value];
        MemoryOperand::with_base_displ(base, (number * self.codes.width) as i64)
    }

    fn is_in_memory(&self, value: Value) -> bool {
        self.addresses[value].0 != Register::None
    }

    fn block(&mut self, steps: &[Step], places: &[Option<u16>], pieces: usize) -> Done {
        for (i, piece) in GIVEN[..pieces].iter().enumerate() {
            let from = MemoryOperand::with_base_displ(TABLE, (i * size_of::<Piece<'_, u8>>()) as i64);
            self.emit(Instruction::with2(Code::Mov_r64_rm64, *piece, from))?;
        }
        // After each step: when what it works on, and then its result, is next needed.
        let mut later = vec![([NEVER; 4], NEVER); steps.len()];
        for (i, step) in steps.iter().enumerate().rev() {
            later[i].1 = self.soon[step.result];
            for (k, value) in step.operands().iter().enumerate() {
                later[i].0[k] = self.soon[*value];
            }
            for value in step.operands() {
                self.soon[*value] = i;
            }
        }
        for (step, (operands, result)) in steps.iter().zip(later) {
            for (value, next) in step.operands().iter().zip(operands) {
                self.soon[*value] = next;
                self.pin(*value);
            }
            let register = self.step(step)?;
            self.release(step);
            self.pinned = 0;
            self.soon[step.result] = result;
            (self.held[register], self.in_register[step.result]) = (Some(step.result), Some(register));
            if let Some(place) = places[step.result] {
                self.store(step.result, usize::from(place))?;
            }
            if result == NEVER {
                self.drop(register);
            }
        }
        for register in 0..self.held.len() {
            self.drop(register);
        }
        if self.codes.width > 16 {
            self.emit(Ok(Instruction::with(Code::VEX_Vzeroupper)))?;
        }
        self.emit(Ok(Instruction::with(Code::Retnq)))
    }

    fn pin(&mut self, value: Value) {
        if let Some(r) = self.in_register[value] {
            self.pinned |= 1 << r;
        }
    }

    pub fn drop(&mut self, register: usize) {
        if let Some(value) = self.held[register].take() {
            self.in_register[value] = None;
        }
    }

    /// Gives back the registers of what is not needed any more.
    fn release(&mut self, step: &Step) {
        for value in step.operands() {
            if let (NEVER, Some(r)) = (self.soon[*value], self.in_register[*value]) {
                self.drop(r);
            }
        }
    }

    fn store(&mut self, value: Value, place: usize) -> Done {
        self.addresses[value] = (PLACES, place);
        if let Some(r) = self.in_register[value] {
            let (to, from) = (self.memory(value), self.register(r));
            self.emit(Instruction::with2(self.codes.store, to, from))?;
        }
        Ok(())
    }

    /// A register for something new, which the present step keeps.
    pub fn fresh(&mut self) -> Result<usize, IcedError> {
        let free = self.held.iter().enumerate().position(|(r, v)| v.is_none() && self.pinned >> r & 1 == 0);
        let register = match free {
            Some(r) => r,
            None => {
                let others = (0..self.held.len()).filter(|r| self.pinned >> r & 1 == 0);
                let farthest = others
                    .max_by_key(|r| self.held[*r].map(|value| (self.is_in_memory(value), self.soon[value])));
                let r = farthest.expect("more registers than a step has operands");
                if let Some(value) = self.held[r]
                    && !self.is_in_memory(value)
                {
                    self.count += 1;
                    self.store(value, self.count - 1)?;
                }
                self.drop(r);
                r
            }
        };
        self.pinned |= 1 << register;
        Ok(register)
    }

    /// The value in a register, which it keeps.
    pub fn loaded(&mut self, value: Value) -> Result<Register, IcedError> {
        if let Some(r) = self.in_register[value] {
            return Ok(self.register(r));
        }
        let r = self.fresh()?;
        let (to, from) = (self.register(r), self.memory(value));
        self.emit(Instruction::with2(self.codes.load, to, from))?;
        (self.held[r], self.in_register[value]) = (Some(value), Some(r));
        Ok(to)
    }

    pub fn is_loaded(&self, value: Value) -> bool {
        self.in_register[value].is_some()
    }

    /// Whether a later step works on a value.
    pub fn is_needed(&self, value: Value) -> bool {
        self.soon[value] != NEVER
    }

    /// Whether registers are free for more than a step needs.
    pub fn has_room(&self) -> bool {
        self.held.iter().filter(|v| v.is_none()).count() > 4
    }

    /// A register for the result of the last instruction of a step, which may be that of an operand.
    pub fn target(&mut self, step: &Step) -> Result<usize, IcedError> {
        let last = |v: &&Value| !self.is_needed(**v) && self.is_loaded(**v);
        match step.operands().iter().find(last) {
            Some(value) => Ok(self.in_register[*value].unwrap_or_default()),
            None => self.fresh(),
        }
    }
}
