//! Weighted sums of stages, the inner loops of every step.

use super::method::Row;
use crate::scalar::Lane;

/// Components are worked on four at a time at least: enough independent chains to hide the latency of a fused
/// product, few enough to stay in registers.
const WIDTH: usize = 4;
/// Lanes have registers for more.
const WIDE: usize = 8;

/// How many numbers a vector of `n` components takes.
///
/// Single numbers are filled up with zeros to whole tiles, which the compiler turns into registers.
#[inline(always)]
pub(super) fn stride<T: Lane>(n: usize) -> usize {
    if T::N == 1 { n.next_multiple_of(WIDTH) } else { n }
}

/// Components `i` to `i + W` of a vector.
#[inline(always)]
fn tile<T: Lane, const W: usize>(x: &[T], i: usize) -> [T; W] {
    let end = i + W;
    *x[i..end].first_chunk().expect("W components")
}

/// Components `i` to `i + W` of `Σ w_j k_j`; each stage of `k` has `n` components.
#[inline(always)]
fn weighted<T: Lane, const W: usize>(row: Row, k: &[T], n: usize, i: usize) -> [T; W] {
    // The sum starts from its first term: starting from a copied vector, the copy is a call.
    let (j, w) = row[0];
    let mut sum = tile::<T, W>(k, j * n + i);
    for s in &mut sum {
        *s = T::lit(w) * *s;
    }
    for &(j, w) in &row[1..] {
        for (s, x) in sum.iter_mut().zip(tile::<T, W>(k, j * n + i)) {
            *s = T::lit(w).fma(x, *s);
        }
    }
    sum
}

/// `h Σ w_j k_j` in `W` components from `i` on, and `y` added to it if there is one.
#[inline(always)]
fn piece<T: Lane, const W: usize>(row: Row, h: T, y: Option<&[T]>, k: &[T], n: usize, i: usize) -> [T; W] {
    let mut sum = weighted::<T, W>(row, k, n, i);
    match y {
        Some(y) => {
            for (s, y) in sum.iter_mut().zip(tile::<T, W>(y, i)) {
                *s = h.fma(*s, y);
            }
        }
        None => {
            for s in &mut sum {
                *s = h * *s;
            }
        }
    }
    sum
}

/// `out = h Σ w_j k_j` in the components from `first` on, and `y` added to it if there is one.
#[inline(always)]
fn combine<T: Lane>(row: Row, h: T, y: Option<&[T]>, k: &[T], first: usize, out: &mut [T]) {
    let n = out.len();
    let mut i = first;
    // The wider the tile, the less of the time goes into finding the stages.
    while i + WIDE <= n {
        out[i..i + WIDE].copy_from_slice(&piece::<T, WIDE>(row, h, y, k, n, i));
        i += WIDE;
    }
    while i + WIDTH <= n {
        out[i..i + WIDTH].copy_from_slice(&piece::<T, WIDTH>(row, h, y, k, n, i));
        i += WIDTH;
    }
    while i < n {
        [out[i]] = piece::<T, 1>(row, h, y, k, n, i);
        i += 1;
    }
}

/// `out = y + h Σ w_j k_j` in the components from `first` on.
#[inline(always)]
pub(super) fn advance_from<T: Lane>(row: Row, h: T, y: &[T], k: &[T], first: usize, out: &mut [T]) {
    combine(row, h, Some(y), k, first, out);
}

/// `out = y + h Σ w_j k_j`.
#[inline(always)]
pub(super) fn advance<T: Lane>(row: Row, h: T, y: &[T], k: &[T], out: &mut [T]) {
    combine(row, h, Some(y), k, 0, out);
}

/// `out = h Σ w_j k_j`.
#[inline(always)]
pub(super) fn change<T: Lane>(row: Row, h: T, k: &[T], out: &mut [T]) {
    combine(row, h, None, k, 0, out);
}

/// `|x|²`.
#[inline(always)]
pub(super) fn squared_length<T: Lane>(x: &[T]) -> T {
    let mut sum = T::zero();
    for x in x {
        sum = x.fma(*x, sum);
    }
    sum
}
