//! Derivatives of functions of one and two numbers, against closed forms.

use super::Random;
use crate::scalar::{Dual, Elementary, Real};

type One = Dual<f64, 2>;
type Two = Dual<One, 2>;

/// The `i`-th of two variables, for two derivatives.
fn variable(x: f64, i: usize) -> Two {
    let seed = [f64::from(i == 0), f64::from(i == 1)];
    Two { value: One { value: x, slope: seed }, slope: seed.map(One::lit) }
}

/// A few roundings of the largest term.
#[track_caller]
fn assert_close(got: f64, expected: f64) {
    assert!((got - expected).abs() <= 2e-14 * expected.abs().max(1.0), "{got} is not {expected}");
}

/// Value, slope and second derivative of `f` at `x`.
fn of_one(f: Elementary, x: f64) -> [f64; 3] {
    let y = variable(x, 0).elementary(f);
    [y.value.value, y.slope[0].value, y.slope[0].slope[0]]
}

#[test]
fn functions_of_one_number() {
    use Elementary::*;
    let mut random = Random(50);
    for _ in 0..300 {
        let (x, part, positive) =
            (random.between(-3.0, 3.0), random.between(-0.9, 0.9), random.between(0.1, 5.0));
        let (one, root) = (1.0 + x * x, (1.0 - part * part).sqrt());
        let (tan, tanh) = (part.tan(), x.tanh());
        let known = [
            (Tan, part, [tan, 1.0 + tan * tan, 2.0 * tan * (1.0 + tan * tan)]),
            (Asin, part, [part.asin(), 1.0 / root, part / root.powi(3)]),
            (Acos, part, [part.acos(), -1.0 / root, -part / root.powi(3)]),
            (Atan, x, [x.atan(), 1.0 / one, -2.0 * x / (one * one)]),
            (Sinh, x, [x.sinh(), x.cosh(), x.sinh()]),
            (Cosh, x, [x.cosh(), x.sinh(), x.cosh()]),
            (Tanh, x, [tanh, 1.0 / x.cosh().powi(2), -2.0 * tanh / x.cosh().powi(2)]),
            (Exp, x, [x.exp(); 3]),
            (Ln, positive, [positive.ln(), 1.0 / positive, -1.0 / (positive * positive)]),
            (Floor, x, [x.floor(), 0.0, 0.0]),
        ];
        for (f, x, expected) in known {
            let got = of_one(f, x);
            for i in 0..3 {
                assert_close(got[i], expected[i]);
            }
        }
    }
}

#[test]
fn the_inverse_sine_near_one() {
    for step in [1e-3, 1e-8, 1e-14, f64::EPSILON] {
        for x in [1.0 - step, step - 1.0] {
            // 1 - x is exact, so is the product but for two roundings.
            let slope = 1.0 / ((1.0 - x.abs()) * (1.0 + x.abs())).sqrt();
            for (f, value, slope) in
                [(Elementary::Asin, x.asin(), slope), (Elementary::Acos, x.acos(), -slope)]
            {
                let got = of_one(f, x);
                assert_close(got[0], value);
                assert_close(got[1] / slope, 1.0);
                assert_close(got[2] / slope.powi(3), x);
            }
        }
    }
}

#[test]
fn the_angle_in_all_quadrants() {
    let mut random = Random(51);
    for quadrant in 0..4 {
        for _ in 0..100 {
            let sign = |bit: usize| if quadrant >> bit & 1 == 0 { 1.0 } else { -1.0 };
            let (y, x) = (sign(0) * random.between(0.5, 3.0), sign(1) * random.between(0.5, 3.0));
            let angle = variable(y, 0).atan2(variable(x, 1));
            let r2 = x * x + y * y;
            assert_close(angle.value.value, y.atan2(x));
            let slopes = [x / r2, -y / r2];
            let mixed = (y * y - x * x) / (r2 * r2);
            let second = [[-2.0 * x * y / (r2 * r2), mixed], [mixed, 2.0 * x * y / (r2 * r2)]];
            for i in 0..2 {
                assert_close(angle.slope[i].value, slopes[i]);
                assert_close(angle.value.slope[i], slopes[i]);
                for (got, expected) in angle.slope[i].slope.into_iter().zip(second[i]) {
                    assert_close(got, expected);
                }
            }
        }
    }
    // On the axes, where the angle itself jumps or the tangent is infinite.
    for (y, x, slopes) in
        [(2.0, 0.0, [0.0, -0.5]), (-2.0, 0.0, [0.0, 0.5]), (0.0, 2.0, [0.5, 0.0]), (0.0, -2.0, [-0.5, 0.0])]
    {
        let angle = variable(y, 0).atan2(variable(x, 1));
        assert_eq!([angle.slope[0].value, angle.slope[1].value], slopes);
    }
}

#[test]
fn powers_by_base_and_exponent() {
    let mut random = Random(52);
    for _ in 0..300 {
        let (x, y) = (random.between(0.3, 3.0), random.between(-2.0, 3.0));
        let power = variable(x, 0).pow(variable(y, 1));
        let (p, ln) = (x.powf(y), x.ln());
        assert_close(power.value.value, p);
        assert_close(power.slope[0].value, y * p / x);
        assert_close(power.slope[1].value, p * ln);
        assert_close(power.slope[0].slope[0], y * (y - 1.0) * p / (x * x));
        assert_close(power.slope[0].slope[1], p / x * (1.0 + y * ln));
        assert_close(power.slope[1].slope[0], p / x * (1.0 + y * ln));
        assert_close(power.slope[1].slope[1], p * ln * ln);
    }
}

#[test]
fn a_constant_exponent_has_derivatives_at_every_base() {
    for x in [-2.5, -1.0, 0.5, 2.0] {
        for n in [-3, -1, 0, 1, 2, 3, 5] {
            let (power, exponent) = (variable(x, 0).pow(Two::lit(f64::from(n))), f64::from(n));
            assert_close(power.value.value, x.powi(n));
            assert_close(power.slope[0].value, exponent * x.powi(n - 1));
            assert_close(power.slope[0].slope[0], exponent * (exponent - 1.0) * x.powi(n - 2));
        }
    }
    for (n, slope, second) in [(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (2.0, 0.0, 2.0), (3.0, 0.0, 0.0)] {
        let power = variable(0.0, 0).pow(Two::lit(n));
        assert_eq!([power.value.value, power.slope[0].value], [f64::from(n == 0.0), slope], "0^{n}");
        assert_eq!(power.slope[0].slope[0], second, "0^{n}");
    }
}
