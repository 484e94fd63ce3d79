//! Memory that holds machine code.

use crate::expression::registers::Piece;
use memmap2::{Mmap, MmapMut};
use std::mem::MaybeUninit;

/// How many pieces of given numbers a block can read.
pub const PIECES: usize = 7;

/// What a block is: it is called with the places of a program, its constants, and the pieces of what it is given.
type Block = unsafe extern "sysv64" fn(*mut u8, *const u8, *const u8);

/// Machine code that can run.
#[derive(Debug)]
pub struct Memory(Mmap);

impl Memory {
    /// Holds a copy; none where memory cannot be made executable.
    pub fn new(code: &[u8]) -> Option<Self> {
        let mut memory = MmapMut::map_anon(code.len()).ok()?;
        memory.copy_from_slice(code);
        memory.make_exec().ok().map(Self)
    }

    /// Runs the block that starts at an offset.
    ///
    /// # Safety
    /// A block for registers of the type `T` starts there, and all that it reads and writes is there.
    #[inline(always)]
    pub unsafe fn run<T, const P: usize>(
        &self,
        start: usize,
        places: &mut [MaybeUninit<T>],
        constants: &[T],
        given: &[Piece<'_, T>; P],
    ) {
        // SAFETY: the caller says that this is such a block.
        let block: Block = unsafe { std::mem::transmute(self.0.as_ptr().add(start)) };
        // SAFETY: as the caller says.
        unsafe { block(places.as_mut_ptr().cast(), constants.as_ptr().cast(), given.as_ptr().cast()) }
    }
}
