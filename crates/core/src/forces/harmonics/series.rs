//! Spherical harmonics of a field outside its sources, and their sums.
//!
//! With the distance r from the centre, the geocentric latitude φ and the longitude λ,
//! `V = (R/r)ⁿ⁺¹ P̄ₙₘ(sin φ) cos mλ` and `W` with the sine are polynomials of the Cartesian coordinates over powers of
//! r, computed by recursion without a singularity at the poles: Cunningham's, as in Montenbruck and Gill, Satellite
//! Orbits, 1st ed. (2000), section 3.2.4, here for fully normalised functions, which stay within the range of doubles.

use crate::algebra::Vec3;
use crate::scalar::Real;

/// The coefficients (C̄, S̄) of a field by degree n and order m ≤ n, fully normalised.
#[derive(Clone, Debug)]
pub struct Harmonics {
    degree: usize,
    /// At n (n + 1)/2 + m.
    pairs: Vec<[f64; 2]>,
}

impl Harmonics {
    /// All coefficients zero.
    pub fn zero(degree: usize) -> Self {
        Self { degree, pairs: vec![[0.0; 2]; (degree + 1) * (degree + 2) / 2] }
    }

    /// The coefficients of degree `n` and order `m`; zero beyond the degree of the field.
    pub fn get(&self, n: usize, m: usize) -> [f64; 2] {
        if n > self.degree { [0.0; 2] } else { self.pairs[n * (n + 1) / 2 + m] }
    }

    /// The coefficients of degree `n` and order `m`, to be set.
    pub fn at(&mut self, n: usize, m: usize) -> &mut [f64; 2] {
        &mut self.pairs[n * (n + 1) / 2 + m]
    }

    /// Degrees and orders up to this degree, order by order.
    fn places(degree: usize) -> impl Iterator<Item = (usize, usize)> {
        (0..=degree).flat_map(move |m| (m..=degree).map(move |n| (n, m)))
    }

    /// The derivatives by the Cartesian coordinates, times R: fields of the next degree.
    ///
    /// Montenbruck and Gill (2000), (3.33), with the factors of the normalisation.
    pub fn derivatives(&self) -> [Self; 3] {
        let [mut x, mut y, mut z] = [0; 3].map(|_| Self::zero(self.degree + 1));
        for (n, m) in Self::places(self.degree) {
            let [c, s] = self.get(n, m);
            // There is no sine of order zero.
            let s = if m == 0 { 0.0 } else { s };
            let (a, b) = (n as f64, m as f64);
            let size = (2.0 * a + 1.0) / (2.0 * a + 3.0);
            let up = (size * (a + b + 1.0) * (a + b + 2.0)).sqrt();
            let up = if m == 0 { up * 0.5f64.sqrt() } else { 0.5 * up };
            add(x.at(n + 1, m + 1), [-up * c, -up * s]);
            add(y.at(n + 1, m + 1), [up * s, -up * c]);
            if m > 0 {
                let down = 0.5 * (size * (a - b + 1.0) * (a - b + 2.0)).sqrt();
                let down = if m == 1 { down * 2.0f64.sqrt() } else { down };
                add(x.at(n + 1, m - 1), [down * c, down * s]);
                add(y.at(n + 1, m - 1), [down * s, -down * c]);
            }
            let level = (size * (a + b + 1.0) * (a - b + 1.0)).sqrt();
            add(z.at(n + 1, m), [-level * c, -level * s]);
        }
        [x, y, z]
    }
}

fn add(pair: &mut [f64; 2], [c, s]: [f64; 2]) {
    pair[0] += c;
    pair[1] += s;
}

/// Several fields that are summed together.
#[derive(Clone, Debug)]
pub struct Series<const K: usize> {
    /// From one sectorial function to the next.
    steps: Vec<f64>,
    /// Order by order; in each, degree by degree.
    columns: Vec<Vec<Row<K>>>,
}

#[derive(Clone, Debug)]
struct Row<const K: usize> {
    /// What the functions of the last two degrees are multiplied with.
    recursion: [f64; 2],
    /// The coefficients of each field.
    pairs: [[f64; 2]; K],
}

impl<const K: usize> Series<K> {
    /// Of these fields, up to the highest degree and order that any of them has.
    pub fn new(fields: [&Harmonics; K]) -> Self {
        let degree = fields.iter().map(|f| f.degree).max().unwrap_or(0);
        let used = |n: usize, m: usize| fields.iter().any(|f| f.get(n, m) != [0.0; 2]);
        let row = |n: usize, m: usize| {
            let (a, b) = (n as f64, m as f64);
            let size = (2.0 * a + 1.0) / ((a - b) * (a + b));
            let recursion = match n - m {
                0 => [0.0; 2],
                1 => [(size * (2.0 * a - 1.0)).sqrt(), 0.0],
                _ => {
                    let last = size * (a + b - 1.0) * (a - b - 1.0) / (2.0 * a - 3.0);
                    [(size * (2.0 * a - 1.0)).sqrt(), last.sqrt()]
                }
            };
            Row { recursion, pairs: fields.map(|f| f.get(n, m)) }
        };
        let last = |m: usize| (m..=degree).rev().find(|n| used(*n, m));
        let order = (0..=degree).rev().find(|m| last(*m).is_some());
        let orders = 0..order.map_or(0, |m| m + 1);
        let step = |m: usize| match m {
            0 => 1.0,
            1 => 3.0f64.sqrt(),
            _ => (1.0 + 0.5 / m as f64).sqrt(),
        };
        let column = |m: usize| last(m).map_or(Vec::new(), |last| (m..=last).map(|n| row(n, m)).collect());
        Self { steps: orders.clone().map(step).collect(), columns: orders.map(column).collect() }
    }

    /// Σ C̄ V + S̄ W of each field at a point: `direction` is R x/r² in the axes of the field, `ratio` is R/r.
    #[inline(always)]
    pub fn sums<T: Real>(&self, direction: Vec3<T>, ratio: T) -> [T; K] {
        let Vec3 { x, y, z } = direction;
        let (square, zero) = (ratio * ratio, T::zero());
        let mut sums = [zero; K];
        let (mut v_first, mut w_first) = (ratio, zero);
        for (m, (step, column)) in self.steps.iter().zip(&self.columns).enumerate() {
            if m > 0 {
                let (step, v, w) = (T::lit(*step), v_first, w_first);
                (v_first, w_first) = (step * (x * v - y * w), step * (x * w + y * v));
            }
            let (mut v, mut w, mut v_last, mut w_last) = (v_first, w_first, zero, zero);
            for (i, row) in column.iter().enumerate() {
                if i > 0 {
                    let near = T::lit(row.recursion[0]) * z;
                    let far = -(T::lit(row.recursion[1]) * square);
                    (v, v_last) = (near.fma(v, far * v_last), v);
                    (w, w_last) = (near.fma(w, far * w_last), w);
                }
                for (sum, [c, s]) in sums.iter_mut().zip(&row.pairs) {
                    *sum = T::lit(*c).fma(v, T::lit(*s).fma(w, *sum));
                }
            }
        }
        sums
    }
}
