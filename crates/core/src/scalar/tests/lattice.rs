//! Lattices.

use super::{Random, same};
use crate::scalar::{Dual, Fused, Grid, Interpolation, Lane, Lattice, Real, Rule, Table, TableError};
use std::hash::{BuildHasher, RandomState};

fn axes() -> Vec<Vec<f64>> {
    vec![vec![-1.0, 0.0, 0.5, 2.0], vec![0.0, 1.0, 4.0], vec![-2.0, 1.0], vec![0.0, 0.5, 1.0, 1.5, 3.0]]
}

fn random_lattice(n: usize, interpolation: Interpolation, random: &mut Random) -> (Vec<f64>, Lattice) {
    let axes = axes()[..n].to_vec();
    let count = axes.iter().map(Vec::len).product();
    let values: Vec<_> = (0..count).map(|_| random.between(-1.0, 1.0)).collect();
    (values.clone(), Lattice::new(axes, values, interpolation).unwrap())
}

/// A point within the axes and around them.
fn point(n: usize, random: &mut Random) -> Vec<f64> {
    axes()[..n].iter().map(|a| random.between(a[0] - 1.0, a[a.len() - 1] + 1.0)).collect()
}

#[test]
fn products_of_lines_are_given_back_with_all_their_derivatives() {
    let mut random = Random(40);
    for n in [3, 4] {
        let line = |k: usize, x: f64| 1.0 + (k as f64 - 1.5) * x;
        let axes = axes()[..n].to_vec();
        let count: usize = axes.iter().map(Vec::len).product();
        let mut values = vec![1.0; count];
        for (i, v) in values.iter_mut().enumerate() {
            let mut rest = i;
            for (k, axis) in axes.iter().enumerate().rev() {
                *v *= line(k, axis[rest % axis.len()]);
                rest /= axis.len();
            }
        }
        let lattice = Lattice::new(axes.clone(), values, Interpolation::Linear).unwrap();
        for _ in 0..200 {
            let at: Vec<_> = axes.iter().map(|a| random.between(a[0], a[a.len() - 1])).collect();
            // Every derivative by each variable at most once: bit k of `by` is that by variable k.
            for by in 0..1 << n {
                let mut f = &lattice;
                let mut expected = 1.0;
                for (k, x) in at.iter().enumerate() {
                    if by >> k & 1 == 1 {
                        f = f.slope(k).unwrap();
                        expected *= k as f64 - 1.5;
                        assert!(f.slope(k).is_none());
                    } else {
                        expected *= line(k, *x);
                    }
                }
                // Values up to a few hundred, and differences of them over gaps of a half.
                assert!((f.value(&at) - expected).abs() < 1e-11, "{by} at {at:?}");
            }
        }
    }
}

#[test]
fn along_sampled_lines_and_planes_it_is_a_table_and_a_grid() {
    let mut random = Random(41);
    let all = axes();
    for interpolation in [Interpolation::Hold, Interpolation::Linear] {
        let (values, lattice) = random_lattice(3, interpolation, &mut random);
        for (i, x) in all[0].iter().enumerate() {
            let plane = Grid::new(&all[1], &all[2], &values[6 * i..6 * (i + 1)], interpolation).unwrap();
            for _ in 0..50 {
                let [y, z] = [random.between(-1.0, 5.0), random.between(-3.0, 2.0)];
                assert!((lattice.value(&[*x, y, z]) - plane.value(y, z)).abs() < 1e-14);
            }
            for (j, y) in all[1].iter().enumerate() {
                for (k, z) in all[2].iter().enumerate() {
                    assert_eq!(lattice.value(&[*x, *y, *z]), values[(i * 3 + j) * 2 + k]);
                }
                let row = &values[(i * 3 + j) * 2..(i * 3 + j + 1) * 2];
                let line = Table::new(&all[2], row, interpolation).unwrap();
                let z = random.between(-3.0, 2.0);
                assert!((lattice.value(&[*x, *y, z]) - line.value(z)).abs() < 1e-15);
                let slope = lattice.slope(2).map_or(0.0, |s| s.value(&[*x, *y, z]));
                assert!((slope - line.slope().value(z)).abs() < 1e-15);
            }
        }
    }
}

#[test]
fn outside_the_border_values_hold() {
    let mut random = Random(42);
    for n in [3, 4] {
        let (_, lattice) = random_lattice(n, Interpolation::Linear, &mut random);
        for _ in 0..300 {
            let at = point(n, &mut random);
            let near: Vec<_> = at.iter().zip(axes()).map(|(x, a)| x.clamp(a[0], a[a.len() - 1])).collect();
            assert_eq!(lattice.value(&at), lattice.value(&near));
            for k in 0..n {
                let slope = lattice.slope(k).unwrap().value(&at);
                if at[k] != near[k] {
                    assert_eq!(slope, 0.0);
                }
            }
            for k in 0..n {
                let mut nan = at.clone();
                nan[k] = f64::NAN;
                assert!(lattice.value(&nan).is_nan());
                nan[k] = f64::INFINITY;
                assert_eq!(lattice.slope(k).unwrap().value(&nan), 0.0);
                assert!(lattice.value(&nan).is_finite());
            }
        }
    }
}

#[test]
fn a_jump_takes_two_samples_and_a_level_axis_has_no_slope() {
    let axes = vec![vec![0.0, 1.0, 1.0, 2.0], vec![3.0], vec![0.0, 1.0]];
    let values = vec![0.0, 0.0, 1.0, 1.0, 5.0, 5.0, 6.0, 6.0];
    let lattice = Lattice::new(axes, values, Interpolation::Linear).unwrap();
    for (x, value, slope) in [(0.5, 0.5, 1.0), (1.0, 5.0, 1.0), (1.5, 5.5, 1.0), (2.0, 6.0, 0.0)] {
        assert_eq!(lattice.value(&[x, 9.0, 0.3]), value);
        assert_eq!(lattice.slope(0).unwrap().value(&[x, 9.0, 0.3]), slope);
    }
    assert!(lattice.slope(1).is_none() && lattice.slope(2).is_none());
}

#[test]
fn a_dual_takes_the_slopes_and_a_lane_is_one_number() {
    type Two = Dual<Dual<f64, 2>, 2>;
    let mut random = Random(43);
    let (_, lattice) = random_lattice(3, Interpolation::Linear, &mut random);
    for _ in 0..200 {
        let at = point(3, &mut random);
        let variable = |v: f64, i: usize| Two {
            value: Dual { value: v, slope: [f64::from(i == 0), f64::from(i == 1)] },
            slope: [Dual::lit(f64::from(i == 0)), Dual::lit(f64::from(i == 1))],
        };
        // At (u, 2v, z): the slopes by u and v follow by the chain rule.
        let v = variable(0.5 * at[1], 1);
        let f = Two::lookup_n(&[variable(at[0], 0), v + v, Two::lit(at[2])], &lattice);
        let (by_x, by_y) = (lattice.slope(0).unwrap(), lattice.slope(1).unwrap());
        let expected = [
            (f.value.value, lattice.value(&at)),
            (f.slope[0].value, by_x.value(&at)),
            (f.slope[1].value, 2.0 * by_y.value(&at)),
            (f.slope[0].slope[1], 2.0 * by_x.slope(1).unwrap().value(&at)),
            (f.slope[0].slope[0], 0.0),
            (f.slope[1].slope[1], 0.0),
        ];
        for (got, expected) in expected {
            assert_eq!(got, expected);
        }
    }
    let (_, lattice) = random_lattice(4, Interpolation::Linear, &mut random);
    #[cfg(target_arch = "x86_64")]
    lanes_agree::<crate::scalar::Sse2>(&lattice, &mut random);
    lanes_agree::<f64>(&lattice, &mut random);
    lanes_agree::<Fused>(&lattice, &mut random);
}

fn lanes_agree<T: Lane>(lattice: &Lattice, random: &mut Random) {
    T::call(
        #[inline(always)]
        || {
            for _ in 0..50 {
                let points: Vec<Vec<f64>> = (0..T::N).map(|_| point(4, random)).collect();
                let at: [T; 4] = std::array::from_fn(|k| T::from_lanes(|l| points[l][k]));
                let got = T::lookup_n(&at, lattice);
                for (l, point) in points.iter().enumerate() {
                    assert!(same(got.get(l), lattice.value(point)));
                }
            }
        },
    );
}

#[test]
fn lattices_are_equal_by_content() {
    let mut random = Random(44);
    let (values, one) = random_lattice(3, Interpolation::Linear, &mut random);
    let again = Lattice::new(axes()[..3].to_vec(), values.clone(), Interpolation::Linear).unwrap();
    let hasher = RandomState::new();
    assert_eq!(one, again);
    assert_eq!(hasher.hash_one(&one), hasher.hash_one(&again));
    assert_ne!(one, Lattice::new(axes()[..3].to_vec(), values, Interpolation::Hold).unwrap());
    assert_ne!(&one, one.slope(0).unwrap());
    assert_eq!(one.slope(0).unwrap().slope(2), again.slope(2).unwrap().slope(0));
    assert_eq!(one.slope(1).unwrap().samples().2, [Rule::Line, Rule::Slope, Rule::Line]);
    assert!(one.is_sound(3) && !one.is_sound(4));
}

#[test]
fn samples_that_are_no_lattice_are_refused() {
    let error = |x: &[f64], v: &[f64]| {
        let axes = vec![x.to_vec(), vec![0.0, 1.0], vec![0.0]];
        Lattice::new(axes, v.to_vec(), Interpolation::Linear).unwrap_err()
    };
    assert_eq!(error(&[], &[]), TableError::Length { abscissae: 0, values: 0 });
    assert_eq!(error(&[0.0, 1.0], &[0.0; 3]), TableError::Length { abscissae: 4, values: 3 });
    assert_eq!(error(&[0.0, 1.0, 0.5], &[0.0; 6]), TableError::Order { index: 4 });
    assert_eq!(error(&[0.0, 1.0, 1.0, 1.0], &[0.0; 8]), TableError::Order { index: 6 });
    assert_eq!(error(&[0.0, f64::NAN], &[0.0; 4]), TableError::NotFinite { index: 2 });
    assert_eq!(error(&[0.0, 1.0], &[0.0, 0.0, f64::INFINITY, 0.0]), TableError::NotFinite { index: 2 });
    assert_eq!(error(&[0.0, 1e-310], &[0.0, 0.0, 0.0, 1.0]), TableError::NotFinite { index: 2 });
    assert_eq!(error(&[0.0, 1e-200], &[0.0, 1e200, 0.0, 0.0]), TableError::NotFinite { index: 3 });
}
