//! How far apart two evaluations of one formula can lie that differ in nothing but their roundings.

use crate::scalar::{Block, Elementary, Grid, Lattice, Real, Table};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, and a bound on the difference of two evaluations of it.
///
/// The running error analysis of Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.3:
/// every rounding adds half a unit in the last place of its result in each of the two evaluations, every
/// operation passes on what its arguments bring. Here an operation adds two units, which covers the terms of
/// second order, and products that one evaluation rounds and the other does not.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    pub value: f64,
    pub bound: f64,
}

/// Two units in the last place, at most.
const TWO_ULP: f64 = 2.0 * f64::EPSILON;

impl Bounded {
    /// A number with what an operation makes of the bounds of its arguments.
    ///
    /// Calls here and below: speed is nothing, and formulas of so many operations take long to compile inlined.
    #[inline(never)]
    fn of(value: f64, passed_on: f64) -> Self {
        Self { value, bound: passed_on + TWO_ULP * value.abs() }
    }
}

impl Add for Bounded {
    type Output = Self;
    #[inline(never)]
    fn add(self, o: Self) -> Self {
        Self::of(self.value + o.value, self.bound + o.bound)
    }
}

impl Sub for Bounded {
    type Output = Self;
    #[inline(never)]
    fn sub(self, o: Self) -> Self {
        Self::of(self.value - o.value, self.bound + o.bound)
    }
}

impl Mul for Bounded {
    type Output = Self;
    #[inline(never)]
    fn mul(self, o: Self) -> Self {
        let passed_on = self.value.abs() * o.bound + o.value.abs() * self.bound + self.bound * o.bound;
        Self::of(self.value * o.value, passed_on)
    }
}

impl Div for Bounded {
    type Output = Self;
    #[inline(never)]
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self::of(value, (self.bound + value.abs() * o.bound) / (o.value.abs() - o.bound))
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Real for Bounded {
    fn lit(x: f64) -> Self {
        Self { value: x, bound: 0.0 }
    }
    #[inline(never)]
    fn fma(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::of(root, self.bound / root)
    }
    fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
    fn sin_cos(self) -> (Self, Self) {
        // Each evaluation is right to two units: `scalar::tests::trigonometry`.
        let (s, c) = self.value.sin_cos();
        let of = |x: f64| Self::of(x, self.bound + TWO_ULP * x.abs());
        (of(s), of(c))
    }
    fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
        if a.value <= b.value { x } else { y }
    }
    fn lookup(self, table: &Table) -> Self {
        Self::of(table.value(self.value), table.slope().value(self.value).abs() * self.bound)
    }
    fn lookup_2(self, _: Self, _: &Grid) -> Self {
        unreachable!("no form looks into a grid")
    }
    fn lookup_n(_: &[Self], _: &Lattice) -> Self {
        unreachable!("no form looks into a lattice")
    }
    fn elementary(self, _: Elementary) -> Self {
        unreachable!("no form has such a function")
    }
    fn atan2(self, _: Self) -> Self {
        unreachable!("no form has such a function")
    }
    fn pow(self, _: Self) -> Self {
        unreachable!("no form has such a function")
    }
    fn outside(_: &dyn Block, _: &[Self], _: &mut [Self]) -> bool {
        false
    }
    fn call<R>(f: impl FnOnce() -> R) -> R {
        f()
    }
}
