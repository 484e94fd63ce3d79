//! Linear systems, one in every lane.

use crate::scalar::Lane;

/// Rows `first` and `second` change places in the lanes where `marked` is one.
#[derive(Clone, Copy, Debug)]
struct Swap<T> {
    first: usize,
    second: usize,
    marked: T,
}

impl<T: Lane> Swap<T> {
    #[inline(always)]
    fn swap(&self, a: &mut T, b: &mut T) {
        let (x, y) = (*a, *b);
        *a = T::select_le(T::one(), self.marked, y, x);
        *b = T::select_le(T::one(), self.marked, x, y);
    }
}

/// A square matrix as the product of a lower and an upper triangle, rows exchanged for the largest pivot, in each
/// lane by its own numbers alone.
///
/// Golub & Van Loan, *Matrix Computations*, 4th ed., 3.4.
#[derive(Debug)]
pub(super) struct Lu<T> {
    /// By rows; after [`Lu::factor`] the factors, with the inverses of the pivots in the diagonal.
    pub matrix: Vec<T>,
    swaps: Vec<Swap<T>>,
}

impl<T: Lane> Lu<T> {
    pub fn new() -> Self {
        Self { matrix: Vec::new(), swaps: Vec::new() }
    }

    /// Replaces the matrix, `n` by `n`, by its factors; not finite where it is singular.
    #[inline(always)]
    pub fn factor(&mut self, n: usize) {
        self.swaps.clear();
        for k in 0..n {
            self.bring_pivot(n, k);
            let (done, below) = self.matrix.split_at_mut((k + 1) * n);
            let top = &mut done[k * n..];
            let inverse = T::one() / top[k];
            top[k] = inverse;
            for row in below.chunks_exact_mut(n) {
                let factor = row[k] * inverse;
                row[k] = factor;
                for (x, t) in row[k + 1..].iter_mut().zip(&top[k + 1..]) {
                    *x = (-factor).fma(*t, *x);
                }
            }
        }
    }

    /// Brings the row with the largest number in column `k` from below to row `k`.
    #[inline(always)]
    fn bring_pivot(&mut self, n: usize, k: usize) {
        let (zero, one) = (T::zero(), T::one());
        let (mut largest, mut place) = (self.matrix[k * n + k].abs(), T::lit(k as f64));
        for i in k + 1..n {
            let size = self.matrix[i * n + k].abs();
            place = T::select_le(size, largest, place, T::lit(i as f64));
            largest = T::select_le(size, largest, largest, size);
        }
        if T::all_le(place, T::lit(k as f64)) {
            return;
        }
        for i in k + 1..n {
            let marked = T::select_le((place - T::lit(i as f64)).abs(), T::lit(0.5), one, zero);
            if T::all_le(marked, zero) {
                continue;
            }
            let swap = Swap { first: k, second: i, marked };
            let (upper, lower) = self.matrix.split_at_mut(i * n);
            for (a, b) in upper[k * n..].iter_mut().zip(&mut lower[..n]) {
                swap.swap(a, b);
            }
            self.swaps.push(swap);
        }
    }

    /// Replaces the right side `b` by the solution.
    #[inline(always)]
    pub fn solve(&self, b: &mut [T]) {
        let n = b.len();
        for swap in &self.swaps {
            let (upper, lower) = b.split_at_mut(swap.second);
            swap.swap(&mut upper[swap.first], &mut lower[0]);
        }
        // By columns: the products of one column wait for none but the one before.
        for k in 0..n {
            let (done, below) = b.split_at_mut(k + 1);
            for (b, row) in below.iter_mut().zip(self.matrix.chunks_exact(n).skip(k + 1)) {
                *b = (-row[k]).fma(done[k], *b);
            }
        }
        for k in (0..n).rev() {
            let x = b[k] * self.matrix[k * n + k];
            b[k] = x;
            for (b, row) in b[..k].iter_mut().zip(self.matrix.chunks_exact(n)) {
                *b = (-row[k]).fma(x, *b);
            }
        }
    }
}
