//! From a tape to blocks of simple operations, with what stays interpreted between them.
//!
//! Each block computes what the next run needs and nothing more, depth first: so few values are alive at a time, and
//! the processor finds by itself what it can work on at once.

use super::step::{Kind, Step, Value};
use crate::expression::tape::{Code, Operands, Tape};
use std::collections::HashMap;
use std::ops::Range;

/// A part of a program.
#[derive(Debug)]
pub enum Part {
    Block(Vec<Step>),
    /// Instructions on places in memory; their results, values next to each other, come to the places from `first` on.
    Run {
        code: Code,
        instructions: Vec<Operands>,
        results: Range<Value>,
        first: u16,
    },
}

/// What a program does, part by part.
#[derive(Debug)]
pub struct Plan {
    pub parts: Vec<Part>,
    /// Where values stand in memory, of those that have to: the results first, in their order.
    pub places: Vec<Option<u16>>,
    /// How many places there are.
    pub count: u16,
}

impl Plan {
    /// Of a sound tape; none if it needs too many places.
    pub fn of(tape: &Tape) -> Option<Self> {
        let given = tape.given + tape.constants;
        let values = usize::from(tape.values);
        let mut planner = Planner {
            tape,
            given,
            instructions: Vec::new(),
            makers: vec![usize::MAX; values],
            homes: vec![0; values],
            copies: HashMap::new(),
            block: Vec::new(),
            plan: Plan {
                parts: Vec::new(),
                places: vec![None; values],
                count: u16::try_from(tape.results.len()).ok()?,
            },
        };
        planner.run()?;
        Some(planner.plan)
    }
}

/// An instruction of the tape that is not computed yet.
struct Waiting {
    code: Code,
    operands: Operands,
    result: Value,
    done: bool,
}

struct Planner<'a> {
    tape: &'a Tape,
    /// How many values are there from the start.
    given: usize,
    instructions: Vec<Waiting>,
    /// Which instruction makes each value.
    makers: Vec<usize>,
    /// In which part each value is made.
    homes: Vec<usize>,
    /// Copies in memory of what is there from the start.
    copies: HashMap<Value, u16>,
    block: Vec<Step>,
    plan: Plan,
}

/// Whether an instruction stays interpreted.
fn is_interpreted(code: Code) -> bool {
    use Code::*;
    matches!(code, SinCos | Elementary(_) | Atan2 | Pow | Lookup(_) | Lookup2(_) | Lookup3(_) | Lookup4(_))
}

impl Planner<'_> {
    fn run(&mut self) -> Option<()> {
        let tape = self.tape;
        let mut result = self.given;
        let mut operands = tape.instructions.iter();
        for (code, count) in &tape.runs {
            for operands in operands.by_ref().take(*count) {
                let results = result..result + code.results();
                self.makers[results.clone()].fill(self.instructions.len());
                self.instructions.push(Waiting { code: *code, operands: *operands, result, done: false });
                result = results.end;
            }
        }
        for (k, value) in tape.results.iter().enumerate() {
            let value = usize::from(*value);
            if self.is_native(value) && self.plan.places[value].is_none() {
                self.plan.places[value] = Some(k as u16);
            }
        }
        let mut start = 0;
        for (code, count) in &tape.runs {
            let end = start + count;
            if is_interpreted(*code) {
                // What works on a result of the same run comes after it.
                let mut first = start;
                for i in start..end {
                    let operands = &self.instructions[i].operands[..code.arity()];
                    if operands.iter().any(|o| (first..i).contains(&self.makers[usize::from(*o)])) {
                        self.interpret(*code, first..i)?;
                        first = i;
                    }
                }
                self.interpret(*code, first..end)?;
            }
            start = end;
        }
        for (k, value) in tape.results.iter().enumerate() {
            let value = usize::from(*value);
            self.demand(value)?;
            if self.plan.places[value] != Some(k as u16) {
                self.copy(value, k as u16)?;
            }
        }
        self.close();
        Some(())
    }

    /// Whether a value is computed in a block.
    fn is_native(&self, value: Value) -> bool {
        self.instructions.get(self.makers[value]).is_some_and(|i| !is_interpreted(i.code))
    }

    fn interpret(&mut self, code: Code, run: Range<usize>) -> Option<()> {
        let mut instructions = Vec::with_capacity(run.len());
        for i in run.clone() {
            let mut operands = self.instructions[i].operands;
            for o in &mut operands[..code.arity()] {
                let value = usize::from(*o);
                self.demand(value)?;
                *o = self.in_memory(value)?;
            }
            instructions.push(operands);
        }
        self.close();
        let (first, start) = (self.plan.count, self.instructions[run.start].result);
        let results = start..start + run.len() * code.results();
        for value in results.clone() {
            self.plan.places[value] = Some(self.new_place()?);
            self.homes[value] = self.plan.parts.len();
        }
        self.plan.parts.push(Part::Run { code, instructions, results, first });
        Some(())
    }

    fn close(&mut self) {
        if !self.block.is_empty() {
            self.plan.parts.push(Part::Block(std::mem::take(&mut self.block)));
        }
    }

    fn new_place(&mut self) -> Option<u16> {
        let place = self.plan.count;
        self.plan.count = place.checked_add(1)?;
        Some(place)
    }

    /// The place of a value that instructions between the blocks work on.
    fn in_memory(&mut self, value: Value) -> Option<u16> {
        if value >= self.given {
            if self.plan.places[value].is_none() {
                self.plan.places[value] = Some(self.new_place()?);
            }
            return self.plan.places[value];
        }
        if let Some(place) = self.copies.get(&value) {
            return Some(*place);
        }
        let place = self.new_place()?;
        self.copies.insert(value, place);
        self.copy(value, place)?;
        Some(place)
    }

    fn copy(&mut self, value: Value, place: u16) -> Option<()> {
        let result = self.new_value();
        self.plan.places[result] = Some(place);
        self.push(Kind::Copy, [value, 0, 0, 0], result)
    }

    fn new_value(&mut self) -> Value {
        self.plan.places.push(None);
        self.homes.push(0);
        self.plan.places.len() - 1
    }

    /// Has a value computed, and before it what it is made of.
    fn demand(&mut self, value: Value) -> Option<()> {
        let mut stack = Vec::new();
        let mut next = Some(value);
        loop {
            if let Some(value) = next.take()
                && self.is_native(value)
                && !self.instructions[self.makers[value]].done
            {
                stack.push((self.makers[value], 0));
            }
            let Some((i, seen)) = stack.last_mut() else { return Some(()) };
            let Waiting { code, operands, .. } = &self.instructions[*i];
            if *seen < code.arity() {
                next = Some(usize::from(operands[*seen]));
                *seen += 1;
            } else {
                let i = *i;
                stack.pop();
                self.instructions[i].done = true;
                self.lower(i)?;
            }
        }
    }

    /// The operations of one instruction, with the roundings that it has.
    fn lower(&mut self, i: usize) -> Option<()> {
        let Waiting { code, operands, result, .. } = self.instructions[i];
        let [a, b, c, d] = operands.map(usize::from);
        let mut two = |first: Kind, [x, y]: [Value; 2], second: Kind, then: &dyn Fn(Value) -> [Value; 4]| {
            let between = self.new_value();
            self.push(first, [x, y, 0, 0], between)?;
            self.push(second, then(between), result)
        };
        let kind = match code {
            Code::MulMulAdd => return two(Kind::Mul, [c, d], Kind::MulAdd, &|cd| [a, b, cd, 0]),
            Code::MulMulSub => return two(Kind::Mul, [c, d], Kind::MulSub, &|cd| [a, b, cd, 0]),
            Code::Mul3 => return two(Kind::Mul, [a, b], Kind::Mul, &|ab| [ab, c, 0, 0]),
            Code::Add3 => return two(Kind::Add, [a, b], Kind::Add, &|ab| [ab, c, 0, 0]),
            Code::MulAdd => Kind::MulAdd,
            Code::MulSub => Kind::MulSub,
            Code::NegMulAdd => Kind::NegMulAdd,
            Code::Add => Kind::Add,
            Code::Sub => Kind::Sub,
            Code::Mul => Kind::Mul,
            Code::Div => Kind::Div,
            Code::Neg => Kind::Neg,
            Code::Sqrt => Kind::Sqrt,
            Code::Abs => Kind::Abs,
            Code::SelectLe => Kind::SelectLe,
            _ => return None,
        };
        self.push(kind, [a, b, c, d], result)
    }

    fn push(&mut self, kind: Kind, operands: [Value; 4], result: Value) -> Option<()> {
        let here = self.plan.parts.len();
        let step = Step { kind, all: operands, result };
        for value in step.operands() {
            if *value >= self.given && self.homes[*value] != here {
                self.in_memory(*value)?;
            }
        }
        self.homes[result] = here;
        self.block.push(step);
        Some(())
    }
}
