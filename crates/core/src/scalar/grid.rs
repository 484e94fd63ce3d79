//! Tabulated functions of two variables.

use super::table::{FACTORIAL, bits, check_abscissae, has_slopes, next_sample, place, rows, starts};
use super::{Interpolation, TableError};
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// The coefficients of a polynomial of two variables: `[k][l]` belongs to `dᵏ eˡ`.
pub type Patch = [[f64; 4]; 4];

/// A function of two variables given by samples on a rectangular grid; it keeps its border values outside.
///
/// It is the tensor product of two [`Table`](super::Table) rules. Its partial derivatives are grids too, so that
/// derivatives of any order are exact wherever they exist. Grids are equal if their patches are, bit for bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Grid(Arc<Patches>);

/// One polynomial of two variables in each rectangle.
#[derive(Debug, Serialize, Deserialize)]
struct Patches {
    x: Vec<f64>,
    y: Vec<f64>,
    patches: Vec<Patch>,
    // Built when first asked for: most grids never need a second derivative.
    #[serde(skip)]
    slopes: [OnceLock<Grid>; 2],
}

impl Grid {
    /// A grid through samples: `values` by rows, one row for each `x`, one column for each `y`; both rising.
    ///
    /// # Errors
    /// As of [`Table::new`](super::Table::new).
    pub fn new(
        x: &[f64],
        y: &[f64],
        values: &[f64],
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        let (m, n) = (x.len(), y.len());
        if values.is_empty() || values.len() != m * n {
            return Err(TableError::Length { abscissae: m * n, values: values.len() });
        }
        check_abscissae(x, interpolation).map_err(|error| by_rows(error, n))?;
        check_abscissae(y, interpolation)?;
        if let Some(index) = values.iter().position(|v| !v.is_finite()) {
            return Err(TableError::NotFinite { index });
        }

        // Along x in each column, then along y in each coefficient of that.
        let columns: Vec<_> = (0..n)
            .map(|j| {
                let column: Vec<_> = (0..m).map(|i| values[n * i + j]).collect();
                rows(x, &column, interpolation)
            })
            .collect();
        let (x_starts, y_starts) = (starts(x), starts(y));
        let mut patches = vec![[[0.0; 4]; 4]; x_starts.len() * y_starts.len()];
        for (i, strip) in patches.chunks_mut(y_starts.len()).enumerate() {
            for k in 0..4 {
                let along_y: Vec<_> = columns.iter().map(|column| column[i][k]).collect();
                for (patch, row) in strip.iter_mut().zip(rows(y, &along_y, interpolation)) {
                    patch[k] = row;
                }
            }
            let steep = |patch: &Patch| (0..4).any(|k| !has_slopes(&patch[k].map(|c| FACTORIAL[k] * c)));
            if let Some(j) = strip.iter().position(steep) {
                let (row, column) = (next_sample(x, x_starts[i]), next_sample(y, y_starts[j]));
                return Err(TableError::NotFinite { index: n * row + column });
            }
        }
        Ok(Self::of_patches(x_starts, y_starts, patches))
    }

    fn of_patches(x: Vec<f64>, y: Vec<f64>, patches: Vec<Patch>) -> Self {
        Self(Arc::new(Patches { x, y, patches, slopes: Default::default() }))
    }

    /// The value at a point.
    ///
    /// Not inlined: it has no part in the instruction set of its caller.
    #[inline(never)]
    pub fn value(&self, x: f64, y: f64) -> f64 {
        let p = &*self.0;
        let ((i, d), (j, e)) = (within(&p.x, x), within(&p.y, y));
        let [a, b, c, f] = p.patches[p.y.len() * i + j].map(|c| c[0] + e * (c[1] + e * (c[2] + e * c[3])));
        let value = a + d * (b + d * (c + d * f));
        if x.is_nan() || y.is_nan() { x + y } else { value }
    }

    /// The partial derivative by the first variable.
    pub fn slope_x(&self) -> &Grid {
        self.slope(0, |p| [1, 2, 3, 4].map(|k| p.get(k).map_or([0.0; 4], |row| row.map(|c| k as f64 * c))))
    }

    /// The partial derivative by the second variable.
    pub fn slope_y(&self) -> &Grid {
        self.slope(1, |p| p.map(|c| [c[1], 2.0 * c[2], 3.0 * c[3], 0.0]))
    }

    fn slope(&self, direction: usize, derivative: impl Fn(&Patch) -> Patch) -> &Grid {
        let p = &*self.0;
        p.slopes[direction].get_or_init(|| {
            let patches: Vec<_> = p.patches.iter().map(derivative).collect();
            if patches.iter().all(|patch| *patch == [[0.0; 4]; 4]) {
                return Self::of_patches(
                    vec![f64::NEG_INFINITY],
                    vec![f64::NEG_INFINITY],
                    vec![[[0.0; 4]; 4]],
                );
            }
            Self::of_patches(p.x.clone(), p.y.clone(), patches)
        })
    }

    /// The patches: where they begin along `x` and along `y`, and their coefficients by rows, one row for each
    /// beginning along `x`; `d` and `e` are the distances from there.
    ///
    /// Along each variable the first piece, from -∞ on, and the last are constant.
    pub fn patches(&self) -> (&[f64], &[f64], &[Patch]) {
        (&self.0.x, &self.0.y, &self.0.patches)
    }

    fn numbers(&self) -> [&[f64]; 3] {
        [&self.0.x, &self.0.y, self.0.patches.as_flattened().as_flattened()]
    }
}

impl PartialEq for Grid {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || bits(self.numbers()).eq(bits(other.numbers()))
    }
}

impl Eq for Grid {}

impl Hash for Grid {
    fn hash<H: Hasher>(&self, state: &mut H) {
        bits(self.numbers()).for_each(|b| b.hash(state));
    }
}

/// The piece that holds `x`, and how far into it; the outer pieces are constant, and may be endless.
fn within(starts: &[f64], x: f64) -> (usize, f64) {
    let i = place(starts, x);
    (i, if i == 0 || i + 1 == starts.len() { 0.0 } else { x - starts[i] })
}

/// A fault of a row, told of its first sample.
fn by_rows(error: TableError, columns: usize) -> TableError {
    match error {
        TableError::Order { index } => TableError::Order { index: index * columns },
        TableError::NotFinite { index } => TableError::NotFinite { index: index * columns },
        TableError::Length { .. } => error,
    }
}
