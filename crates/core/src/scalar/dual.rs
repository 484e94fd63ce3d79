//! Numbers that carry exact derivatives.

use super::{Block, Elementary, Grid, Lattice, MAX_AXES, Real, Table};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivatives in `K` directions, over any [`Real`].
///
/// Over SIMD lanes either each lane is a state of its own, or all lanes hold one state and each a
/// direction of its own; only the seeds differ.
#[derive(Clone, Copy, Debug)]
pub struct Dual<T, const K: usize> {
    /// The value.
    pub value: T,
    /// The derivative in each direction.
    pub slope: [T; K],
}

impl<T: Real, const K: usize> Dual<T, K> {
    /// A number with zero derivative.
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Self { value, slope: [T::zero(); K] }
    }

    /// `f(value)` with derivative `df · slope`.
    #[inline(always)]
    fn chain(self, f: T, df: T) -> Self {
        let mut slope = self.slope;
        for s in &mut slope {
            *s = df * *s;
        }
        Self { value: f, slope }
    }

    /// The same with the slopes of `x`, times `df`, added.
    #[inline(always)]
    fn plus(self, x: Self, df: T) -> Self {
        let mut slope = self.slope;
        for (s, o) in slope.iter_mut().zip(x.slope) {
            *s = df.fma(o, *s);
        }
        Self { value: self.value, slope }
    }
}

impl<T: Real, const K: usize> Add for Dual<T, K> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mut slope = self.slope;
        for (s, o) in slope.iter_mut().zip(other.slope) {
            *s = *s + o;
        }
        Self { value: self.value + other.value, slope }
    }
}

impl<T: Real, const K: usize> Sub for Dual<T, K> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let mut slope = self.slope;
        for (s, o) in slope.iter_mut().zip(other.slope) {
            *s = *s - o;
        }
        Self { value: self.value - other.value, slope }
    }
}

impl<T: Real, const K: usize> Mul for Dual<T, K> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mut slope = self.slope;
        for (s, o) in slope.iter_mut().zip(other.slope) {
            *s = self.value.fma(o, *s * other.value);
        }
        Self { value: self.value * other.value, slope }
    }
}

impl<T: Real, const K: usize> Div for Dual<T, K> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let inverse = T::one() / other.value;
        let value = self.value / other.value;
        let mut slope = self.slope;
        for (s, o) in slope.iter_mut().zip(other.slope) {
            *s = (-value).fma(o, *s) * inverse;
        }
        Self { value, slope }
    }
}

impl<T: Real, const K: usize> Neg for Dual<T, K> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let mut slope = self.slope;
        for s in &mut slope {
            *s = -*s;
        }
        Self { value: -self.value, slope }
    }
}

impl<T: Real, const K: usize> Real for Dual<T, K> {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        Self::constant(T::lit(x))
    }
    #[inline(always)]
    fn fma(self, a: Self, b: Self) -> Self {
        let mut slope = b.slope;
        for ((s, x), y) in slope.iter_mut().zip(self.slope).zip(a.slope) {
            *s = self.value.fma(y, x.fma(a.value, *s));
        }
        Self { value: self.value.fma(a.value, b.value), slope }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::lit(0.5) / root)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        let sign = T::select_le(T::zero(), self.value, T::one(), T::lit(-1.0));
        self.chain(self.value.abs(), sign)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.value.sin_cos();
        (self.chain(s, c), self.chain(c, -s))
    }
    #[inline(always)]
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
        let mut slope = x.slope;
        for (s, o) in slope.iter_mut().zip(y.slope) {
            *s = T::select_le(a.value, b.value, *s, o);
        }
        Self { value: T::select_le(a.value, b.value, x.value, y.value), slope }
    }
    #[inline(always)]
    fn lookup(self, table: &Table) -> Self {
        self.chain(self.value.lookup(table), self.value.lookup(table.slope()))
    }
    #[inline(always)]
    fn lookup_2(self, y: Self, grid: &Grid) -> Self {
        let (by_x, by_y) = (grid.slope_x(), grid.slope_y());
        let along_x = self.chain(self.value.lookup_2(y.value, grid), self.value.lookup_2(y.value, by_x));
        along_x.plus(y, self.value.lookup_2(y.value, by_y))
    }
    #[inline(always)]
    fn lookup_n(at: &[Self], lattice: &Lattice) -> Self {
        let mut point = [T::zero(); MAX_AXES];
        for (p, x) in point.iter_mut().zip(at) {
            *p = x.value;
        }
        let point = &point[..at.len()];
        let mut sum = Self::constant(T::lookup_n(point, lattice));
        for (axis, x) in at.iter().enumerate() {
            if let Some(slope) = lattice.slope(axis) {
                sum = sum.plus(*x, T::lookup_n(point, slope));
            }
        }
        sum
    }
    #[inline(always)]
    fn elementary(self, f: Elementary) -> Self {
        let (x, one) = (self.value, T::one());
        let y = x.elementary(f);
        let slope = match f {
            Elementary::Tan => y.fma(y, one),
            Elementary::Asin => one / ((one - x) * (one + x)).sqrt(),
            Elementary::Acos => -(one / ((one - x) * (one + x)).sqrt()),
            Elementary::Atan => one / x.fma(x, one),
            Elementary::Sinh => x.elementary(Elementary::Cosh),
            Elementary::Cosh => x.elementary(Elementary::Sinh),
            Elementary::Tanh => (-y).fma(y, one),
            Elementary::Exp => y,
            Elementary::Ln => one / x,
            Elementary::Floor => T::zero(),
        };
        self.chain(y, slope)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let inverse = T::one() / self.value.fma(self.value, x.value * x.value);
        self.chain(self.value.atan2(x.value), x.value * inverse).plus(x, -(self.value * inverse))
    }
    #[inline(always)]
    fn pow(self, y: Self) -> Self {
        let (x, zero) = (self.value, T::zero());
        let power = x.pow(y.value);
        // A base that is not positive has no derivative by the exponent; a constant exponent needs none.
        let ln = T::select_le(x, zero, zero, x.elementary(Elementary::Ln));
        // At zero, the slope of a constant is zero times infinity.
        let lower = T::select_le(x.abs() + y.value.abs(), zero, zero, x.pow(y.value - T::one()));
        self.chain(power, y.value * lower).plus(y, power * ln)
    }
    fn outside(_: &dyn Block, _: &[Self], _: &mut [Self]) -> bool {
        false
    }
    #[inline(always)]
    fn call<R>(f: impl FnOnce() -> R) -> R {
        T::call(f)
    }
}
