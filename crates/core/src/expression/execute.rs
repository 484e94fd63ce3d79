//! What each instruction does.

use super::tape::{Code, Operands, Tables};
use crate::scalar::Real;
use std::mem::MaybeUninit;

/// Computes the results of one run of instructions into the places from number `n` on; the number behind them.
///
/// # Safety
/// There are places for the results, and what the instructions work on stands in its places.
#[inline(always)]
pub(super) unsafe fn execute<T: Real>(
    code: Code,
    instructions: &[Operands],
    mut n: usize,
    places: &mut [MaybeUninit<T>],
    tables: &Tables,
) -> usize {
    macro_rules! get {
        ($i:expr) => {{
            let i = usize::from($i);
            debug_assert!(i < n, "a value is read before it is there");
            // SAFETY: the caller says that it is there.
            unsafe { places.get_unchecked(i).assume_init() }
        }};
    }
    macro_rules! put {
        ($x:expr) => {{
            let x = $x;
            debug_assert!(n < places.len(), "there is no room for more values");
            // SAFETY: the caller says that there is a place.
            unsafe { places.get_unchecked_mut(n).write(x) };
            n += 1;
        }};
    }
    macro_rules! each {
        ($a:ident => $result:expr) => {
            for i in instructions {
                let $a = get!(i[0]);
                put!($result);
            }
        };
        ($a:ident, $b:ident => $result:expr) => {
            for i in instructions {
                let ($a, $b) = (get!(i[0]), get!(i[1]));
                put!($result);
            }
        };
        ($a:ident, $b:ident, $c:ident => $result:expr) => {
            for i in instructions {
                let ($a, $b, $c) = (get!(i[0]), get!(i[1]), get!(i[2]));
                put!($result);
            }
        };
        ($a:ident, $b:ident, $c:ident, $d:ident => $result:expr) => {
            for i in instructions {
                let ($a, $b) = (get!(i[0]), get!(i[1]));
                let ($c, $d) = (get!(i[2]), get!(i[3]));
                put!($result);
            }
        };
    }
    match code {
        Code::MulMulAdd => each!(a, b, c, d => a.fma(b, c * d)),
        Code::MulMulSub => each!(a, b, c, d => a.fma(b, -(c * d))),
        Code::Mul3 => each!(a, b, c => a * b * c),
        Code::Add3 => each!(a, b, c => a + b + c),
        Code::MulAdd => each!(a, b, c => a.fma(b, c)),
        Code::MulSub => each!(a, b, c => a.fma(b, -c)),
        Code::NegMulAdd => each!(a, b, c => (-a).fma(b, c)),
        Code::Add => each!(a, b => a + b),
        Code::Sub => each!(a, b => a - b),
        Code::Mul => each!(a, b => a * b),
        Code::Div => each!(a, b => a / b),
        Code::Neg => each!(a => -a),
        Code::Sqrt => each!(a => a.sqrt()),
        Code::Abs => each!(a => a.abs()),
        Code::SinCos => {
            for i in instructions {
                let (s, c) = get!(i[0]).sin_cos();
                put!(s);
                put!(c);
            }
        }
        Code::Elementary(f) => each!(a => a.elementary(f)),
        Code::Atan2 => each!(a, b => a.atan2(b)),
        Code::Pow => each!(a, b => a.pow(b)),
        Code::SelectLe => each!(a, b, x, y => T::select_le(a, b, x, y)),
        Code::Lookup(n) => each!(a => a.lookup(&tables.tables[n as usize])),
        Code::Lookup2(n) => each!(a, b => a.lookup_2(b, &tables.grids[n as usize])),
        Code::Lookup3(n) => each!(a, b, c => T::lookup_n(&[a, b, c], &tables.lattices[n as usize])),
        Code::Lookup4(n) => {
            each!(a, b, c, d => T::lookup_n(&[a, b, c, d], &tables.lattices[n as usize]));
        }
    }
    n
}
