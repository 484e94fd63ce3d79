//! Which rows of the results hold which entries of the closed form.

use crate::phase_space::{ClosedJacobian, PLACES, STATES, VARYING};
use crate::scalar::Lane;
use std::array;
use std::mem::take;

/// Some entries of (∂f/∂x ∂f/∂u), a row each, by rows of the matrix.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Row and column of each.
    pub entries: Vec<(usize, usize)>,
    /// The rows of those that do not change, with their numbers.
    constant: Vec<(usize, f64)>,
    /// The rows of those that do.
    varying: [usize; VARYING],
}

impl Layout {
    /// Of all entries.
    pub fn dense(closed: &ClosedJacobian) -> Self {
        let columns = 0..STATES + closed.inputs();
        Self::of(closed, (0..STATES).flat_map(|i| columns.clone().map(move |j| (i, j))).collect())
    }

    /// Without those that are zero at all states.
    pub fn sparse(closed: &ClosedJacobian) -> Self {
        let mut entries = Self::dense(closed).entries;
        entries.retain(|(i, j)| place(*i, *j).is_some() || closed.constant(*i, *j) != 0.0);
        Self::of(closed, entries)
    }

    fn of(closed: &ClosedJacobian, entries: Vec<(usize, usize)>) -> Self {
        let (mut constant, mut varying) = (Vec::new(), [0; VARYING]);
        for (row, (i, j)) in entries.iter().enumerate() {
            let place = place(*i, *j);
            if let Some(place) = place {
                varying[place] = row;
            }
            if place.is_none_or(|place| closed.still().any(|still| still == place)) {
                constant.push((row, closed.constant(*i, *j)));
            }
        }
        Self { entries, constant, varying }
    }

    /// Fills the rows of the entries that do not change; the others are left.
    pub fn fill<'a, L: Lane>(&self, mut rows: Vec<&'a mut [f64]>) -> [&'a mut [f64]; VARYING] {
        L::call(
            #[inline(always)]
            || {
                for (row, number) in &self.constant {
                    fill(rows[*row], L::lit(*number));
                }
            },
        );
        array::from_fn(|k| take(&mut rows[self.varying[k]]))
    }
}

/// The place of an entry among those that change.
fn place(row: usize, column: usize) -> Option<usize> {
    PLACES[row].get(column).copied().filter(|place| *place < VARYING)
}

/// Writes one number to all places.
#[inline(always)]
fn fill<L: Lane>(row: &mut [f64], value: L) {
    let Some(last) = row.len().checked_sub(L::N) else { return row.fill(value.get(0)) };
    value.store(row);
    // From here on stores that lie in one cache line each.
    for at in (row.as_ptr().align_offset(align_of::<L>())..last).step_by(L::N) {
        value.store(&mut row[at..at + L::N]);
    }
    value.store(&mut row[last..]);
}
