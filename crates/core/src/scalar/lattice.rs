//! Tabulated functions of three and of four variables.

use super::table::{bits, check_abscissae};
use super::{Interpolation, TableError};
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// The most variables of a lattice.
pub const MAX_AXES: usize = 4;

/// What a [`Lattice`] does along one of its axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Rule {
    /// Each value holds until the next sample.
    Hold,
    /// Straight lines.
    Line,
    /// The slope of straight lines: it holds until the next sample, and is zero outside.
    Slope,
}

/// A function of three or four variables given by samples on a rectangular lattice; it keeps its border values
/// outside.
///
/// It is the tensor product of rules for one variable. Its partial derivatives are lattices too, over the same
/// samples, so that derivatives of any order are exact wherever they exist. Lattices are equal if samples and
/// rules are, bit for bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Lattice(Arc<Ruled>);

#[derive(Debug, Serialize, Deserialize)]
struct Ruled {
    samples: Arc<Samples>,
    rules: Vec<Rule>,
    #[serde(skip)]
    slopes: [OnceLock<Option<Lattice>>; MAX_AXES],
}

#[derive(Debug, Serialize, Deserialize)]
struct Samples {
    axes: Vec<Vec<f64>>,
    values: Vec<f64>,
}

impl Lattice {
    /// A lattice through samples: abscissae along three or four axes, in rising order, and `values` by rows, the
    /// last axis running fastest.
    ///
    /// # Errors
    /// As of [`Table::new`](super::Table::new).
    ///
    /// # Panics
    /// For another number of axes, and for [`Interpolation::Cubic`].
    pub fn new(
        axes: Vec<Vec<f64>>,
        values: Vec<f64>,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        assert!(matches!(axes.len(), 3 | MAX_AXES), "a lattice has three or four axes");
        let rule = match interpolation {
            Interpolation::Hold => Rule::Hold,
            Interpolation::Linear => Rule::Line,
            Interpolation::Cubic => panic!("a lattice has no splines"),
        };
        let abscissae = axes.iter().map(Vec::len).product();
        if values.is_empty() || values.len() != abscissae {
            return Err(TableError::Length { abscissae, values: values.len() });
        }
        for (k, axis) in axes.iter().enumerate() {
            let stride = stride(&axes, k);
            check_abscissae(axis, interpolation).map_err(|error| match error {
                TableError::Order { index } => TableError::Order { index: index * stride },
                TableError::NotFinite { index } => TableError::NotFinite { index: index * stride },
                TableError::Length { .. } => error,
            })?;
        }
        let not_finite = values.iter().position(|v| !v.is_finite());
        let steep = || if rule == Rule::Line { steep(&axes, &values, 0) } else { None };
        if let Some(index) = not_finite.or_else(steep) {
            return Err(TableError::NotFinite { index });
        }
        let rules = vec![rule; axes.len()];
        Ok(Self::of(Arc::new(Samples { axes, values }), rules))
    }

    fn of(samples: Arc<Samples>, rules: Vec<Rule>) -> Self {
        Self(Arc::new(Ruled { samples, rules, slopes: Default::default() }))
    }

    /// The value at a point of as many coordinates as there are axes.
    ///
    /// Not inlined: it has no part in the instruction set of its caller.
    #[inline(never)]
    pub fn value(&self, at: &[f64]) -> f64 {
        let Ruled { samples, rules, .. } = &*self.0;
        assert_eq!(at.len(), rules.len(), "the coordinates of a lattice");
        if let Some(nan) = at.iter().find(|x| x.is_nan()) {
            return *nan;
        }
        let mut cells = [Cell::default(); MAX_AXES];
        let mut places = [0; 1 << MAX_AXES];
        let mut count = 1;
        for (k, axis) in samples.axes.iter().enumerate() {
            let cell = Cell::of(axis, rules[k], at[k]);
            // From the last on, so that none is overwritten before it is read.
            for i in (0..count).rev() {
                let start = places[i] * axis.len();
                (places[2 * i], places[2 * i + 1]) = (start + cell.low, start + cell.high);
            }
            cells[k] = cell;
            count *= 2;
        }
        let mut corners = places.map(|place| samples.values[place]);
        for cell in cells[..at.len()].iter().rev() {
            count /= 2;
            for i in 0..count {
                let [low, high] = [corners[2 * i], corners[2 * i + 1]];
                corners[i] = cell.share * low + cell.weight * (high - low);
            }
        }
        corners[0]
    }

    /// The partial derivative along an axis; none where it is zero everywhere.
    pub fn slope(&self, axis: usize) -> Option<&Lattice> {
        let Ruled { samples, rules, slopes } = &*self.0;
        let made = slopes[axis].get_or_init(|| {
            let mut rules = rules.clone();
            if rules[axis] != Rule::Line || samples.is_level_along(axis) {
                return None;
            }
            rules[axis] = Rule::Slope;
            Some(Self::of(Arc::clone(samples), rules))
        });
        made.as_ref()
    }

    /// The abscissae along each axis, the values by rows, and the rule along each axis.
    pub fn samples(&self) -> (&[Vec<f64>], &[f64], &[Rule]) {
        (&self.0.samples.axes, &self.0.samples.values, &self.0.rules)
    }

    /// Whether a lattice that comes from elsewhere has what belongs to one of so many axes.
    pub fn is_sound(&self, axes: usize) -> bool {
        let (all, values, rules) = self.samples();
        let counts = all.iter().try_fold(1usize, |n, axis| n.checked_mul(axis.len()));
        all.len() == axes && rules.len() == axes && !values.is_empty() && counts == Some(values.len())
    }

    fn numbers(&self) -> impl Iterator<Item = u64> {
        let Samples { axes, values } = &*self.0.samples;
        axes.iter().chain([values]).flat_map(|list| bits([list]))
    }
}

impl Samples {
    /// Whether neighbours along an axis never differ.
    fn is_level_along(&self, axis: usize) -> bool {
        let (stride, n) = (stride(&self.axes, axis), self.axes[axis].len());
        self.values.chunks(stride * n).all(|block| block[stride..].iter().zip(block).all(|(b, a)| a == b))
    }
}

impl PartialEq for Lattice {
    fn eq(&self, other: &Self) -> bool {
        let same = |a: &Ruled, b: &Ruled| Arc::ptr_eq(&a.samples, &b.samples);
        self.0.rules == other.0.rules && (same(&self.0, &other.0) || self.numbers().eq(other.numbers()))
    }
}

impl Eq for Lattice {}

impl Hash for Lattice {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.rules.hash(state);
        self.numbers().for_each(|b| b.hash(state));
    }
}

/// Where a coordinate lies along its axis: `share · low + weight (high − low)` of the samples there.
#[derive(Clone, Copy, Default)]
struct Cell {
    low: usize,
    high: usize,
    share: f64,
    weight: f64,
}

impl Cell {
    fn of(axis: &[f64], rule: Rule, x: f64) -> Self {
        let high = axis.partition_point(|b| *b <= x);
        let low = high.saturating_sub(1);
        let share = if rule == Rule::Slope { 0.0 } else { 1.0 };
        if rule == Rule::Hold || high == 0 || high == axis.len() {
            return Self { low, high: low, share, weight: 0.0 };
        }
        let width = axis[high] - axis[low];
        let weight = if rule == Rule::Slope { 1.0 / width } else { (x - axis[low]) / width };
        Self { low, high, share, weight }
    }
}

/// How far neighbours along an axis lie from each other in the list of values.
fn stride(axes: &[Vec<f64>], axis: usize) -> usize {
    axes[axis + 1..].iter().map(Vec::len).product()
}

/// The first sample to which a difference quotient along some of the axes from `first` on leads that is not finite.
fn steep(axes: &[Vec<f64>], values: &[f64], first: usize) -> Option<usize> {
    (first..axes.len()).find_map(|k| {
        let (axis, stride) = (&axes[k], stride(axes, k));
        let mut slopes = vec![0.0; values.len()];
        for (i, slope) in slopes.iter_mut().enumerate() {
            let low = i / stride % axis.len();
            if low + 1 < axis.len() && axis[low] < axis[low + 1] {
                *slope = (values[i + stride] - values[i]) * (1.0 / (axis[low + 1] - axis[low]));
            }
        }
        let here = slopes.iter().position(|s| !s.is_finite()).map(|i| i + stride);
        here.or_else(|| steep(axes, &slopes, k + 1))
    })
}
