//! Tabulated functions of one variable.

use super::spline::spline;
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// What a third derivative multiplies each coefficient with at most.
pub(super) const FACTORIAL: [f64; 4] = [1.0, 1.0, 2.0, 6.0];

/// How a [`Table`] goes from one sample to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Each value holds until the next sample.
    Hold,
    /// Straight lines; two samples at one abscissa make a jump.
    Linear,
    /// A cubic spline with two continuous derivatives and "not-a-knot" ends; no abscissa stands twice.
    Cubic,
}

/// Why samples are no table. The samples of a grid are counted by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableError {
    /// No sample at all, or different numbers of abscissae and values.
    Length {
        /// How many abscissae came.
        abscissae: usize,
        /// How many values came.
        values: usize,
    },
    /// The abscissa of sample `index` is smaller than the one before it, or is repeated more often than the
    /// interpolation allows: twice, or once in a cubic spline.
    Order {
        /// Its index.
        index: usize,
    },
    /// Sample `index` is not finite, or the curve to it is too steep to have slopes.
    NotFinite {
        /// Its index.
        index: usize,
    },
}

/// A function given by samples; it keeps its first and last value outside them.
///
/// At a jump the value is the right-hand one. The slope is a table too, so that derivatives of any
/// order are exact wherever they exist. Tables are equal if their pieces are, bit for bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Table(Arc<Pieces>);

/// One polynomial from each start to the next.
#[derive(Debug, Serialize, Deserialize)]
struct Pieces {
    starts: Vec<f64>,
    rows: Vec<[f64; 4]>,
    breaks: Vec<f64>,
    slope: Option<Table>,
}

impl Table {
    /// A table through samples; abscissae in rising order.
    ///
    /// # Errors
    /// [`TableError`] when the samples are empty, of unequal length, unordered or not finite.
    pub fn new(x: &[f64], y: &[f64], interpolation: Interpolation) -> Result<Self, TableError> {
        if x.is_empty() || x.len() != y.len() {
            return Err(TableError::Length { abscissae: x.len(), values: y.len() });
        }
        check_abscissae(x, interpolation)?;
        if let Some(index) = y.iter().position(|y| !y.is_finite()) {
            return Err(TableError::NotFinite { index });
        }
        let starts = starts(x);
        let rows = rows(x, y, interpolation);
        if let Some(i) = rows.iter().position(|row| !has_slopes(row)) {
            return Err(TableError::NotFinite { index: next_sample(x, starts[i]) });
        }
        let smoothness = if interpolation == Interpolation::Cubic { 2 } else { 0 };
        Ok(Self::of_pieces(starts, rows, smoothness))
    }

    /// The table of these pieces and all its derivatives, of which the first `smoothness` go on over the
    /// inner breaks.
    fn of_pieces(starts: Vec<f64>, rows: Vec<[f64; 4]>, smoothness: usize) -> Self {
        let breaks = match starts[1..] {
            [first, .., last] if smoothness > 0 => vec![first, last],
            _ => starts[1..].to_vec(),
        };
        let slope = rows.iter().any(|row| !is_constant(row)).then(|| {
            let slopes = rows.iter().map(|c| [c[1], 2.0 * c[2], 3.0 * c[3], 0.0]).collect();
            Self::of_pieces(starts.clone(), slopes, smoothness.saturating_sub(1))
        });
        Self(Arc::new(Pieces { starts, rows, breaks, slope }))
    }

    /// The derivative of this table.
    pub fn slope(&self) -> &Table {
        static ZERO: OnceLock<Table> = OnceLock::new();
        let zero = || Self::of_pieces(vec![f64::NEG_INFINITY], vec![[0.0; 4]], 0);
        self.0.slope.as_ref().unwrap_or_else(|| ZERO.get_or_init(zero))
    }

    /// The value at `x`.
    ///
    /// Not inlined: it has no part in the instruction set of its caller.
    #[inline(never)]
    pub fn value(&self, x: f64) -> f64 {
        let p = &*self.0;
        let i = place(&p.starts, x);
        let c = &p.rows[i];
        // A constant piece may start or be asked at infinity, where zero times the distance is no number.
        let rise = if is_constant(c) {
            0.0
        } else {
            let d = x - p.starts[i];
            d * (c[1] + d * (c[2] + d * c[3]))
        };
        if x.is_nan() { x } else { c[0] + rise }
    }

    /// The abscissae where the function or its slope jumps: an integrator should step onto them.
    ///
    /// A cubic spline has them at its ends only.
    pub fn breaks(&self) -> &[f64] {
        &self.0.breaks
    }

    /// The pieces: where each begins, and its `[c0, c1, c2, c3]`, the value being
    /// `c0 + c1 d + c2 d² + c3 d³` at a distance `d` from there.
    ///
    /// The first piece, from -∞ on, and the last are constant.
    pub fn pieces(&self) -> (&[f64], &[[f64; 4]]) {
        (&self.0.starts, &self.0.rows)
    }

    fn numbers(&self) -> [&[f64]; 3] {
        [&self.0.starts, self.0.rows.as_flattened(), &self.0.breaks]
    }
}

impl PartialEq for Table {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || bits(self.numbers()).eq(bits(other.numbers()))
    }
}

impl Eq for Table {}

impl Hash for Table {
    fn hash<H: Hasher>(&self, state: &mut H) {
        bits(self.numbers()).for_each(|b| b.hash(state));
    }
}

/// Lengths and bits of lists of numbers.
pub(super) fn bits<const N: usize>(lists: [&[f64]; N]) -> impl Iterator<Item = u64> {
    lists
        .into_iter()
        .flat_map(|list| std::iter::once(list.len() as u64).chain(list.iter().map(|x| x.to_bits())))
}

/// Which piece holds `x`.
pub(super) fn place(starts: &[f64], x: f64) -> usize {
    starts.partition_point(|b| *b <= x).max(1) - 1
}

/// Finds the first abscissa that is not finite or not in order.
pub(super) fn check_abscissae(x: &[f64], interpolation: Interpolation) -> Result<(), TableError> {
    let allowed = if interpolation == Interpolation::Cubic { 1 } else { 2 };
    for index in 0..x.len() {
        if !x[index].is_finite() {
            return Err(TableError::NotFinite { index });
        }
        let repeated = index >= allowed && x[index] == x[index - allowed];
        if index > 0 && x[index] < x[index - 1] || repeated {
            return Err(TableError::Order { index });
        }
    }
    Ok(())
}

/// The sample after a break: the one that the piece from there leads to.
pub(super) fn next_sample(x: &[f64], from: f64) -> usize {
    x.partition_point(|x| *x <= from).min(x.len() - 1)
}

/// Where the pieces begin: the first, which holds the first value, at -∞, the others at the distinct abscissae.
pub(super) fn starts(x: &[f64]) -> Vec<f64> {
    let mut starts = vec![f64::NEG_INFINITY];
    starts.extend_from_slice(x);
    starts.dedup();
    starts
}

/// The coefficients of the pieces.
pub(super) fn rows(x: &[f64], y: &[f64], interpolation: Interpolation) -> Vec<[f64; 4]> {
    let (held, n) = (|i: usize| [y[i], 0.0, 0.0, 0.0], x.len());
    let mut rows = vec![held(0)];
    match interpolation {
        Interpolation::Cubic => rows.extend(spline(x, y)),
        _ => rows.extend((0..n - 1).filter(|i| x[*i] != x[i + 1]).map(|i| match interpolation {
            Interpolation::Linear => [y[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i]), 0.0, 0.0],
            _ => held(i),
        })),
    }
    rows.push(held(n - 1));
    rows
}

/// Whether all derivatives are finite.
pub(super) fn has_slopes(row: &[f64; 4]) -> bool {
    row.iter().zip(FACTORIAL).all(|(c, factorial)| (factorial * c).is_finite())
}

fn is_constant(row: &[f64; 4]) -> bool {
    row[1..] == [0.0; 3]
}
