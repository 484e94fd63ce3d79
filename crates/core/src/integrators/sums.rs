//! Weighted sums of stages, the inner loops of every step.

use super::RIGID;
use super::method::Row;
use crate::scalar::Lane;

/// Components are worked on four at a time at least: enough independent chains to hide the latency of a fused
/// product, few enough to stay in registers.
const WIDTH: usize = 4;
/// Lanes have registers for more.
const WIDE: usize = 8;

/// Components `i` to `i + W` of a vector.
#[inline(always)]
fn part<T, const W: usize>(x: &[T], i: usize) -> &[T; W] {
    x[i..i + W].first_chunk().expect("W components")
}

/// `sum + h Σ w_j k_j` in `W` components, each weight rounded with `h`; `k` has those of a stage.
#[inline(always)]
pub(super) fn added<'a, T: Lane, const W: usize>(
    mut sum: [T; W],
    row: Row,
    h: T,
    k: impl Fn(usize) -> &'a [T; W],
) -> [T; W] {
    for &(j, w) in row {
        let (k, w) = (k(j), h * T::lit(w));
        for (s, k) in sum.iter_mut().zip(k) {
            *s = w.fma(*k, *s);
        }
    }
    sum
}

/// `h Σ w_j k_j` in `W` components, and `y` added to it if there is one.
///
/// Nothing but the sum is rounded with `h`: were each weight, a method that keeps the energy would lose it, little by
/// little.
#[inline(always)]
fn tile<'a, T: Lane, const W: usize>(
    row: Row,
    h: T,
    y: Option<&[T; W]>,
    k: impl Fn(usize) -> &'a [T; W],
) -> [T; W] {
    // The sum starts from its first term: starting from a copied vector, the copy is a call.
    let (j, w) = row[0];
    let mut sum = *k(j);
    for s in &mut sum {
        *s = T::lit(w) * *s;
    }
    for &(j, w) in &row[1..] {
        for (s, k) in sum.iter_mut().zip(k(j)) {
            *s = T::lit(w).fma(*k, *s);
        }
    }
    match y {
        Some(y) => {
            for (s, y) in sum.iter_mut().zip(y) {
                *s = h.fma(*s, *y);
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

/// The same from component `i` on of vectors of any length.
#[inline(always)]
fn piece<T: Lane, const W: usize>(row: Row, h: T, y: Option<&[T]>, k: &[T], n: usize, i: usize) -> [T; W] {
    let y = match y {
        Some(y) => Some(part(y, i)),
        None => None,
    };
    tile(
        row,
        h,
        y,
        #[inline(always)]
        |j| part(k, j * n + i),
    )
}

/// `out = h Σ w_j k_j`, and `y` added to it if there is one.
#[inline(always)]
fn combine<T: Lane>(row: Row, h: T, y: Option<&[T]>, k: &[T], out: &mut [T]) {
    let n = out.len();
    if let Ok(out) = <&mut [T; RIGID]>::try_from(&mut *out) {
        return rigid(row, h, y, k, out);
    }
    let mut i = 0;
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

/// The same for the state that most runs have: where the compiler knows its size, nothing but products is left.
#[inline(always)]
fn rigid<T: Lane>(row: Row, h: T, y: Option<&[T]>, k: &[T], out: &mut [T; RIGID]) {
    let k = k.as_chunks::<RIGID>().0;
    let mut most = 0;
    for (j, _) in row {
        most = most.max(*j);
    }
    assert!(most < k.len(), "as many stages as the method has");
    let y = match y {
        Some(y) => Some(part(y, 0)),
        None => None,
    };
    *out = tile(
        row,
        h,
        y,
        #[inline(always)]
        |j| &k[j],
    );
}

/// `out = y + h Σ w_j k_j`.
#[inline(always)]
pub(super) fn advance<T: Lane>(row: Row, h: T, y: &[T], k: &[T], out: &mut [T]) {
    combine(row, h, Some(y), k, out);
}

/// `out = h Σ w_j k_j`.
#[inline(always)]
pub(super) fn change<T: Lane>(row: Row, h: T, k: &[T], out: &mut [T]) {
    combine(row, h, None, k, out);
}

/// `|x|²`; of three or four components without a loop.
#[inline(always)]
pub(super) fn squared_length<T: Lane>(x: &[T]) -> T {
    match *x {
        [a, b, c] => a.fma(a, b.fma(b, c * c)),
        [a, b, c, d] => a.fma(a, b.fma(b, c.fma(c, d * d))),
        _ => {
            let mut sum = T::zero();
            for x in x {
                sum = x.fma(*x, sum);
            }
            sum
        }
    }
}
