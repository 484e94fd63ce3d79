//! Random expressions that run over every scalar.

use crate::scalar::tests::Random;
use crate::scalar::{Elementary, Real};

/// Steps, each on the values of the givens and of earlier steps.
pub struct Recipe {
    givens: usize,
    steps: Vec<(Step, [usize; 4])>,
}

#[derive(Clone, Copy, PartialEq)]
enum Step {
    Literal(f64),
    Add,
    Sub,
    Mul,
    Neg,
    Sin,
    Cos,
    /// a / (b² + 1)
    Quotient,
    /// √(a² + 1)
    Root,
    Tanh,
    Exp,
    Atan2,
    Abs,
    Min,
    Max,
    Select,
}

/// What a recipe is made of.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Sums, products, quotients, sines and cosines.
    Rational,
    /// With functions that have derivatives of every order.
    Smooth,
    /// With choices.
    Any,
}

const RATIONAL: [Step; 8] =
    [Step::Add, Step::Sub, Step::Mul, Step::Add, Step::Neg, Step::Sin, Step::Cos, Step::Quotient];
const SMOOTH: [Step; 3] = [Step::Root, Step::Tanh, Step::Exp];
const ANY: [Step; 5] = [Step::Atan2, Step::Abs, Step::Min, Step::Max, Step::Select];
/// Numbers that rules of folding look for.
const LITERALS: [f64; 8] = [0.0, 1.0, -1.0, 2.0, 0.5, -0.0, 3.0, -0.75];

impl Recipe {
    pub fn new(random: &mut Random, kind: Kind, givens: usize, length: usize) -> Self {
        let mut allowed = RATIONAL.to_vec();
        if kind != Kind::Rational {
            allowed.extend(SMOOTH);
        }
        if kind == Kind::Any {
            allowed.extend(ANY);
        }
        let mut below = |n: usize| (random.bits() % n as u64) as usize;
        let steps = (0..length).map(|i| {
            let step = match below(8) {
                0 => Step::Literal(LITERALS[below(LITERALS.len())]),
                _ => allowed[below(allowed.len())],
            };
            (step, [0; 4].map(|_| below(givens + i)))
        });
        Self { givens, steps: steps.collect() }
    }

    /// The values of all steps.
    #[inline(always)]
    pub fn run<T: Real>(&self, given: &[T]) -> Vec<T> {
        let mut x = given.to_vec();
        for (step, places) in &self.steps {
            let [a, b, c, d] = places.map(|p| x[p]);
            x.push(match step {
                Step::Literal(value) => T::lit(*value),
                Step::Add => a + b,
                Step::Sub => a - b,
                Step::Mul => a * b,
                Step::Neg => -a,
                Step::Sin => a.sin_cos().0,
                Step::Cos => a.sin_cos().1,
                Step::Quotient => a / (b * b + T::one()),
                Step::Root => (a * a + T::one()).sqrt(),
                Step::Tanh => a.elementary(Elementary::Tanh),
                Step::Exp => a.sin_cos().0.elementary(Elementary::Exp),
                // Off the cut, where the sign of a zero would choose the side.
                Step::Atan2 => a.atan2(b * b + T::lit(0.25)),
                Step::Abs => a.abs(),
                Step::Min => a.min(b),
                Step::Max => a.max(b),
                Step::Select => T::select_le(a, b, c, d),
            });
        }
        x.split_off(self.givens)
    }
}

/// How large the values on the way are: what rounding is measured by.
pub fn scale(values: &[f64]) -> f64 {
    values.iter().fold(1.0, |m, v| m.max(v.abs()))
}

pub fn point(random: &mut Random, n: usize) -> Vec<f64> {
    (0..n).map(|_| random.between(-1.5, 1.5)).collect()
}
