//! Which entries of the closed Jacobian change with the state.

/// The first columns, and rows, of orientation and velocities.
pub const TURN: usize = 3;
pub const LINEAR: usize = 7;
pub const ANGULAR: usize = 10;
/// The numbers of a state.
pub const STATES: usize = 13;

/// How many entries change with the state.
pub const VARYING: usize = 81;

/// The place of each entry among those that change, by rows; [`VARYING`] for the others.
pub const PLACES: [[usize; STATES]; STATES] = {
    let mut all = [[VARYING; STATES]; STATES];
    let (mut next, mut at) = (0, 0);
    while at < STATES * STATES {
        let (row, column) = (at / STATES, at % STATES);
        if varies(row, column) {
            all[row][column] = next;
            next += 1;
        }
        at += 1;
    }
    assert!(next == VARYING);
    all
};

/// Whether an entry changes with the state; with gravity, if it acts.
pub const fn varies(row: usize, column: usize) -> bool {
    match (row, column) {
        (_, STATES..) => false,
        (..TURN, TURN..ANGULAR) | (TURN..LINEAR, ANGULAR..) | (LINEAR..ANGULAR, TURN..LINEAR) => true,
        (TURN..LINEAR, TURN..LINEAR) | (LINEAR..ANGULAR, LINEAR..ANGULAR) => row != column,
        (LINEAR.., ANGULAR..) => true,
        _ => false,
    }
}
