//! Tabulated functions of one variable.

use std::sync::Arc;

/// How a [`Table`] goes from one sample to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Each value holds until the next sample.
    Hold,
    /// Straight lines; two samples at one abscissa make a jump.
    Linear,
}

/// Why samples are no table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableError {
    /// No sample at all, or different numbers of abscissae and values.
    Length {
        /// How many abscissae came.
        abscissae: usize,
        /// How many values came.
        values: usize,
    },
    /// Abscissa `index` is smaller than the one before it, or is repeated more than twice.
    Order {
        /// Its index.
        index: usize,
    },
    /// Sample `index` is not finite, or the line to it is too steep to have a slope.
    NotFinite {
        /// Its index.
        index: usize,
    },
}

/// A function given by samples; it keeps its first and last value outside them.
///
/// At a jump the value is the right-hand one. The slope is a table too, so that derivatives of any
/// order are exact wherever they exist.
#[derive(Clone, Debug)]
pub struct Table(Arc<Pieces>);

/// One polynomial `value + slope (x - x0)` from each break to the next.
#[derive(Debug)]
struct Pieces {
    breaks: Vec<f64>,
    value: Vec<f64>,
    rate: Vec<f64>,
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
        for i in 0..x.len() {
            if !(x[i].is_finite() && y[i].is_finite()) {
                return Err(TableError::NotFinite { index: i });
            }
            let thrice = i > 1 && x[i] == x[i - 2];
            if i > 0 && x[i] < x[i - 1] || thrice {
                return Err(TableError::Order { index: i });
            }
        }
        let n = x.len();
        // The piece before the first sample holds the first value.
        let mut breaks = vec![f64::NEG_INFINITY];
        let mut value = vec![y[0]];
        let mut rate = vec![0.0];
        for i in 0..n {
            let jumps = i + 1 < n && x[i + 1] == x[i];
            if jumps {
                continue;
            }
            breaks.push(x[i]);
            value.push(y[i]);
            rate.push(match interpolation {
                Interpolation::Linear if i + 1 < n => (y[i + 1] - y[i]) / (x[i + 1] - x[i]),
                _ => 0.0,
            });
            if rate.last().is_some_and(|r| !r.is_finite()) {
                return Err(TableError::NotFinite { index: i + 1 });
            }
        }
        let zeros = vec![0.0; breaks.len()];
        let slope = rate.iter().any(|r| *r != 0.0).then(|| {
            Self(Arc::new(Pieces { breaks: breaks.clone(), value: rate.clone(), rate: zeros, slope: None }))
        });
        Ok(Self(Arc::new(Pieces { breaks, value, rate, slope })))
    }

    /// The derivative of this table.
    pub fn slope(&self) -> &Table {
        static ZERO: std::sync::OnceLock<Table> = std::sync::OnceLock::new();
        self.0.slope.as_ref().unwrap_or_else(|| {
            ZERO.get_or_init(|| {
                Self(Arc::new(Pieces {
                    breaks: vec![f64::NEG_INFINITY],
                    value: vec![0.0],
                    rate: vec![0.0],
                    slope: None,
                }))
            })
        })
    }

    /// The value at `x`.
    ///
    /// Not inlined: it has no part in the instruction set of its caller.
    #[inline(never)]
    pub fn value(&self, x: f64) -> f64 {
        let p = &*self.0;
        let i = p.breaks.partition_point(|b| *b <= x).max(1) - 1;
        // A flat piece may start or be asked at infinity, where zero times the distance is no number.
        let rise = if p.rate[i] == 0.0 { 0.0 } else { p.rate[i] * (x - p.breaks[i]) };
        if x.is_nan() { x } else { p.value[i] + rise }
    }

    /// The abscissae where the function or its slope jumps: an integrator should step onto them.
    pub fn breaks(&self) -> &[f64] {
        &self.0.breaks[1..]
    }
}
