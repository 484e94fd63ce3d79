//! The machine code of a program, made when it first runs.

use super::Native;
use crate::expression::tape::{Tables, Tape};
use crate::scalar::{Machine, Real};
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// What was made of a program for each machine; no part of what the program is.
#[derive(Clone, Debug, Default)]
pub struct Cache([OnceLock<Option<Arc<Native>>>; Machine::COUNT]);

impl Cache {
    /// The machine code that runs over `T`, with the lengths of the pieces of what it is given.
    #[inline(always)]
    pub fn of<T: Real, const P: usize>(
        &self,
        tape: &Tape,
        tables: &Tables,
        lengths: impl Fn() -> [usize; P],
    ) -> Option<&Native> {
        let machine = T::MACHINE?;
        let made = &self.0[machine as usize];
        match made.get() {
            Some(native) => native.as_deref(),
            None => make(made, tape, tables, machine, &lengths()),
        }
    }
}

#[cold]
#[inline(never)]
fn make<'a>(
    made: &'a OnceLock<Option<Arc<Native>>>,
    tape: &Tape,
    tables: &Tables,
    machine: Machine,
    lengths: &[usize],
) -> Option<&'a Native> {
    made.get_or_init(|| Native::of(tape, tables, machine, lengths).map(Arc::new)).as_deref()
}

impl PartialEq for Cache {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Cache {}

impl Hash for Cache {
    fn hash<H: Hasher>(&self, _: &mut H) {}
}
