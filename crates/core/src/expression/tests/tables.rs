//! Tables in expressions.

use super::*;
use crate::scalar::{Grid, Interpolation, Lattice, Real, Table};

fn table() -> Table {
    Table::new(&[0.0, 1.0, 1.0, 2.5], &[1.0, 3.0, 2.0, -1.0], Interpolation::Linear).unwrap()
}

fn grid() -> Grid {
    Grid::new(&[0.0, 1.0], &[0.0, 2.0], &[1.0, 2.0, 4.0, -3.0], Interpolation::Linear).unwrap()
}

#[test]
fn programs_look_into_them() {
    let (mut graph, [x, y]) = with_symbols(Simplify::Safely, ["x", "y"]);
    let (table, grid) = (table(), grid());
    let outputs = graph.enter(|| ids(&[x.lookup(&table), x.lookup_2(y, &grid)]));
    for at in [[-1.0, 0.5], [0.3, 1.7], [1.0, 2.0], [1.7, -1.0], [9.0, 9.0]] {
        let expected = [table.value(at[0]), grid.value(at[0], at[1])];
        assert_eq!(values(&graph, &[x, y], &outputs, &at), expected);
    }
}

#[test]
fn their_slopes_are_tables() {
    let (mut graph, [x, y]) = with_symbols(Simplify::Algebraically, ["x", "y"]);
    let (table, grid) = (table(), grid());
    let outputs = graph.enter(|| ids(&[(x + y).lookup(&table), x.lookup_2(y, &grid)]));
    let slopes = graph.jacobian(&outputs, &ids(&[x, y])).unwrap();
    let at = [0.25, 0.5];
    let along = table.slope().value(0.75);
    let expected = [along, along, grid.slope_x().value(at[0], at[1]), grid.slope_y().value(at[0], at[1])];
    assert_eq!(values(&graph, &[x, y], &slopes, &at), expected);
}

#[test]
fn what_is_known_is_looked_up_at_once() {
    let (mut graph, [x, y]) = with_symbols(Simplify::Safely, ["x", "y"]);
    let held = Table::new(&[0.0, 1.0], &[5.0, 6.0], Interpolation::Hold).unwrap();
    let (table, grid) = (table(), grid());
    graph.enter(|| {
        let lit = Expression::lit;
        assert_eq!(lit(0.3).lookup(&table), lit(table.value(0.3)));
        assert_eq!(lit(0.3).lookup_2(lit(1.1), &grid), lit(grid.value(0.3, 1.1)));
        assert_eq!(x.lookup(held.slope()), lit(0.0));
        assert_eq!(x.lookup_2(y, grid.slope_x().slope_x()), lit(0.0));
        assert_eq!(x.lookup(&table), x.lookup(&table.clone()));
        assert_ne!(x.lookup(&table), x.lookup(&held));
    });
}

fn lattice(n: usize) -> Lattice {
    let axes: Vec<Vec<f64>> = (0..n).map(|k| vec![-1.0, 0.5 * k as f64, 2.0]).collect();
    let values = (0..3usize.pow(n as u32)).map(|i| (i as f64).sin()).collect();
    Lattice::new(axes, values, Interpolation::Linear).unwrap()
}

#[test]
fn lattices_are_looked_up_and_have_slopes() {
    for n in [3, 4] {
        let lattice = lattice(n);
        let (mut graph, symbols) = with_symbols(Simplify::Algebraically, ["x", "y", "z", "w"]);
        let given = &symbols[..n];
        let value = graph.enter(|| ids(&[Expression::lookup_n(given, &lattice)]));
        let slopes = graph.jacobian(&value, &ids(given)).unwrap();
        let mixed = graph.jacobian(&slopes, &ids(given)).unwrap();
        let outputs = [value, slopes, mixed].concat();
        for at in [[-1.0, 0.5, 0.2, 1.2], [0.3, 1.7, -0.5, 3.0], [1.0, 0.5, 1.0, -2.0]] {
            let at = &at[..n];
            let mut expected = vec![lattice.value(at)];
            expected.extend((0..n).map(|k| lattice.slope(k).unwrap().value(at)));
            for j in 0..n {
                let along = lattice.slope(j).unwrap();
                expected.extend((0..n).map(|k| along.slope(k).map_or(0.0, |s| s.value(at))));
            }
            assert_eq!(values(&graph, given, &outputs, at), expected);
        }
        graph.enter(|| {
            let at = [0.3, 1.1, -0.2, 0.7].map(Expression::lit);
            let known = lattice.value(&[0.3, 1.1, -0.2, 0.7][..n]);
            assert_eq!(Expression::lookup_n(&at[..n], &lattice), Expression::lit(known));
            assert_eq!(Expression::lookup_n(given, &lattice), Expression::lookup_n(given, &self::lattice(n)));
        });
    }
}
