//! Tables in expressions.

use super::*;
use crate::scalar::{Grid, Interpolation, Real, Table};

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
