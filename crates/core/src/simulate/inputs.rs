//! The control u over time.

use crate::scalar::{Real, Table};

/// The inputs of a run: constants, and what tables over time add to them.
#[derive(Clone, Debug, Default)]
pub struct Inputs {
    /// One number for each input.
    pub constants: Vec<f64>,
    /// One table for each input, or none.
    pub tables: Vec<Table>,
}

impl Inputs {
    /// The same numbers all the time.
    pub fn constant(constants: Vec<f64>) -> Self {
        Self { constants, tables: Vec::new() }
    }

    /// Tables alone.
    pub fn tabulated(tables: Vec<Table>) -> Self {
        Self { constants: vec![0.0; tables.len()], tables }
    }

    /// u(t).
    pub fn at(&self, t: f64) -> Vec<f64> {
        let mut u = self.constants.clone();
        add_tables(&self.tables, t, &mut u);
        u
    }

    /// Times at which an input or its slope jumps.
    pub fn breaks(&self) -> Vec<f64> {
        self.tables.iter().flat_map(|t| t.breaks().iter().copied()).collect()
    }
}

/// Adds what tables have at time t.
#[inline(always)]
pub(super) fn add_tables<T: Real>(tables: &[Table], t: T, u: &mut [T]) {
    for (u, table) in u.iter_mut().zip(tables) {
        *u = *u + t.lookup(table);
    }
}
