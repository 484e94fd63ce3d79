//! The control u over time.

use crate::scalar::{Real, Table};

/// The inputs of a run.
#[derive(Clone, Debug)]
pub enum Inputs {
    /// The same numbers all the time.
    Constant(Vec<f64>),
    /// One table over time for each input.
    Tables(Vec<Table>),
}

impl Inputs {
    /// How many inputs there are.
    pub fn size(&self) -> usize {
        match self {
            Self::Constant(u) => u.len(),
            Self::Tables(u) => u.len(),
        }
    }

    /// Writes u(t).
    #[inline(always)]
    pub fn write<T: Real>(&self, t: T, u: &mut [T]) {
        match self {
            Self::Constant(values) => {
                for (u, v) in u.iter_mut().zip(values) {
                    *u = T::lit(*v);
                }
            }
            Self::Tables(tables) => {
                for (u, table) in u.iter_mut().zip(tables) {
                    *u = t.lookup(table);
                }
            }
        }
    }

    /// u(t).
    pub fn at(&self, t: f64) -> Vec<f64> {
        let mut u = vec![0.0; self.size()];
        self.write(t, &mut u);
        u
    }

    /// Times at which an input or its slope jumps.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Constant(_) => Vec::new(),
            Self::Tables(tables) => tables.iter().flat_map(|t| t.breaks().iter().copied()).collect(),
        }
    }
}
