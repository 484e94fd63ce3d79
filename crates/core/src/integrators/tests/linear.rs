//! Linear systems in lanes, and the coefficients of the method that stands on them.

use crate::integrators::lu::Lu;
use crate::integrators::{Method, Rodas5P, Row, Solve};
use crate::scalar::Lane;
use crate::scalar::isa::{Isa, with_lanes, with_scalar};

/// Numbers between -1 and 1, another one for every seed.
fn number(seed: usize) -> f64 {
    let mixed = (seed as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) as f64 / 2f64.powi(63) - 1.0
}

/// Entry (i, j) of matrix `m`: some have a zero first pivot, some rows of very different size.
fn entry(m: usize, n: usize, i: usize, j: usize) -> f64 {
    let plain = number((m * n + i) * n + j);
    match m % 3 {
        0 => plain,
        1 => plain * f64::from(u8::from(i + j != 0)),
        _ => plain * 10f64.powi(3 * (i % 5) as i32),
    }
}

fn solutions<L: Lane>(n: usize, matrices: &[usize]) -> Vec<Vec<f64>> {
    L::call(|| {
        let of = |f: &dyn Fn(usize) -> f64| L::from_lanes(|l| f(matrices[l % matrices.len()]));
        let mut lu = Lu::<L>::new();
        lu.matrix = (0..n * n).map(|k| of(&|m| entry(m, n, k / n, k % n))).collect();
        lu.factor(n);
        let mut b: Vec<L> = (0..n).map(|i| of(&|m| number(7 * m + i))).collect();
        lu.solve(&mut b);
        (0..matrices.len()).map(|l| b.iter().map(|x| x.get(l)).collect()).collect()
    })
}

#[test]
fn each_lane_solves_its_own_system() {
    for n in [1, 2, 5, 14] {
        for isa in Isa::available() {
            let (together, lanes) = with_lanes!(isa, L => {
                let all: Vec<usize> = (0..L::N).collect();
                (solutions::<L>(n, &all), L::N)
            });
            for (m, x) in together.iter().enumerate() {
                let alone = with_scalar!(isa, One => solutions::<One>(n, &[m]));
                assert_eq!(alone[0], *x, "matrix {m} of {n} among {lanes}");
                for i in 0..n {
                    let row: Vec<f64> = (0..n).map(|j| entry(m, n, i, j)).collect();
                    if n == 1 && row[0] == 0.0 {
                        continue;
                    }
                    let residual: f64 =
                        row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>() - number(7 * m + i);
                    let size: f64 = row.iter().zip(x).map(|(a, x)| (a * x).abs()).sum();
                    // Some n roundings, and the growth of the pivots.
                    assert!(residual.abs() < 1e-13 * size.max(1.0), "{residual} of {size}");
                }
            }
        }
    }
}

#[test]
fn a_singular_system_has_no_finite_solution() {
    let mut lu = Lu::<f64>::new();
    lu.matrix = vec![1.0, 2.0, 2.0, 4.0];
    lu.factor(2);
    let mut b = [1.0, 1.0];
    lu.solve(&mut b);
    assert!(b.iter().any(|x| !x.is_finite()));
}

const STAGES: usize = 8;
type Square = [[f64; STAGES]; STAGES];

fn dense(row: Row) -> [f64; STAGES] {
    let mut all = [0.0; STAGES];
    row.iter().for_each(|&(j, w)| all[j - 1] = w);
    all
}

/// `x Γ`, where `Γ⁻¹ = 1/γ - C`: by back substitution from the last stage, for `C` is strictly lower.
fn times_gamma(x: [f64; STAGES], gamma: f64, c: &Square) -> [f64; STAGES] {
    let mut z = [0.0; STAGES];
    for j in (0..STAGES).rev() {
        let later: f64 = (j + 1..STAGES).map(|i| z[i] * c[i][j]).sum();
        z[j] = gamma * (x[j] + later);
    }
    z
}

/// All conditions of a Rosenbrock-Wanner method up to order five: Hairer & Wanner II, IV.7, table 7.1 and (7.15).
///
/// A tree is written by its root: the elementary weights of `[τ]` with one branch take `β = α + γ`, with several `α`.
#[test]
fn rodas5p() {
    let Solve::Linear(method) = Rodas5P::SOLVE else { panic!("is linear") };
    let c: Square = std::array::from_fn(|i| dense(method.rows[i + 1]));
    let alpha: Square =
        std::array::from_fn(|i| times_gamma(dense(Rodas5P::STAGES[i + 1].a), method.gamma, &c));
    let gamma: Square = std::array::from_fn(|i| {
        let mut unit = [0.0; STAGES];
        unit[i] = 1.0;
        times_gamma(unit, method.gamma, &c)
    });
    let times = |m: &Square, x: [f64; STAGES]| -> [f64; STAGES] {
        m.map(|row| row.iter().zip(x).map(|(m, x)| m * x).sum())
    };
    let product =
        |x: [f64; STAGES], y: [f64; STAGES]| -> [f64; STAGES] { std::array::from_fn(|i| x[i] * y[i]) };
    let one = [1.0; STAGES];
    let a = |x| times(&alpha, x);
    let b = |x| {
        let (by_alpha, by_gamma) = (times(&alpha, x), times(&gamma, x));
        std::array::from_fn(|i| by_alpha[i] + by_gamma[i])
    };
    // Roundings of coefficients of some hundred.
    let near = |x: f64, y: f64, what: &str| assert!((x - y).abs() < 3e-13, "{what}: {x}, not {y}");
    for i in 0..STAGES {
        near(a(one)[i], Rodas5P::STAGES[i + 1].c, "a row of alpha");
        near(times(&gamma, one)[i], method.by_time[i + 1], "a row of gamma");
    }

    let (a1, b1) = (a(one), b(one));
    let (aa, ab) = (product(a1, a1), a(b1));
    let trees = [
        (1, one, 1.0),
        (2, b1, 2.0),
        (3, aa, 3.0),
        (3, b(b1), 6.0),
        (4, product(a1, aa), 4.0),
        (4, product(a1, ab), 8.0),
        (4, b(aa), 12.0),
        (4, b(b(b1)), 24.0),
        (5, product(aa, aa), 5.0),
        (5, product(aa, ab), 10.0),
        (5, product(a1, a(aa)), 15.0),
        (5, product(a1, a(b(b1))), 30.0),
        (5, product(ab, ab), 20.0),
        (5, b(product(a1, aa)), 20.0),
        (5, b(product(a1, ab)), 40.0),
        (5, b(b(aa)), 60.0),
        (5, b(b(b(b1))), 120.0),
    ];
    let weights = times_gamma(dense(Rodas5P::WEIGHTS), method.gamma, &c);
    let error = times_gamma(dense(Rodas5P::ERROR[0]), method.gamma, &c);
    let sum = |w: [f64; STAGES], x: [f64; STAGES]| -> f64 { product(w, x).iter().sum() };
    for (order, tree, density) in trees {
        near(sum(weights, tree), 1.0 / density, "a tree");
        if order < 5 {
            near(sum(error, tree), 0.0, "a tree that both solutions have");
        }
    }
    assert!(trees.iter().any(|(order, tree, _)| *order == 5 && sum(error, *tree).abs() > 1e-4));
    // Stiffly accurate: the last stage begins where the solution ends.
    for (i, w) in weights.iter().enumerate() {
        near(alpha[7][i] + gamma[7][i], *w, "the last row");
    }
}
