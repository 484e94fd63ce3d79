//! Each equation in its literal form against the blocks that run, and against itself backwards.

use super::{Random, inertia, rotation, screw, sequences, vector};
use crate::algebra::Vec3;
use crate::charts::{AngleChart, Sequence, angular_velocity_skew, partial_rotations};
use crate::generalized::{Generalized, acceleration_by_blocks, rotation_acceleration};
use crate::inertia::Inertia;
use crate::lagrange::{Lagrange, generalized_force};
use crate::newton_euler::{
    acceleration, acceleration_literal, inverse_dynamics, quasi_coordinate_acceleration, regressor,
};
use crate::phase_space::phase_velocity;
use crate::screw::{
    Screw, body_from_world, force_cross, force_cross_apply, line_matrix, world_from_body, wrench_transform,
    wrench_transform_inverse,
};

/// Forms against forms: some ten products of 6×6 matrices, of condition below a hundred, at 1e-16 a rounding.
const FORM: f64 = 1e-12;

fn six(s: Screw<f64>) -> [f64; 6] {
    let mut out = [0.0; 6];
    s.store(&mut out);
    out
}

fn largest(s: Screw<f64>) -> f64 {
    six(s).iter().fold(0.0, |m, x| f64::max(m, x.abs()))
}

#[track_caller]
fn assert_close(a: Screw<f64>, b: Screw<f64>, size: f64) {
    assert!(largest(a - b) <= FORM * size, "{a:?} is not {b:?}");
}

/// Angles at least 0.5 rad away from where the first and third axes align.
fn angles(random: &mut Random, sequence: Sequence) -> Vec3<f64> {
    let second = random.between(-1.0, 1.0);
    let second = if sequence.is_proper_euler() { second + 1.57 } else { second };
    Vec3::new(random.between(-3.0, 3.0), second, random.between(-3.0, 3.0))
}

#[test]
fn screws_are_carried_alike_by_blocks_and_matrices() {
    let mut random = Random(44);
    for _ in 0..100 {
        let (o, c, s) = (vector(&mut random), rotation(&mut random), screw(&mut random));
        let world = world_from_body(o, c, s);
        assert_close(wrench_transform(o, c).apply(s), world, 10.0);
        assert_close(body_from_world(o, c, world), s, 10.0);
        assert_close(wrench_transform_inverse(o, c).apply(world), s, 10.0);
        let line = Screw::at_point(s.linear, o);
        assert_close(line_matrix(o).apply(Screw::new(s.linear, s.linear)), line, 10.0);
    }
}

#[test]
fn quasi_velocity_forms_agree() {
    let mut random = Random(40);
    for _ in 0..100 {
        let (body, twist, wrench) = (inertia(&mut random), screw(&mut random), screw(&mut random));
        let rate = acceleration(&body, twist, wrench);
        let size = largest(rate) + largest(wrench);
        assert_close(acceleration_literal(&body, twist, wrench), rate, size);
        assert_close(quasi_coordinate_acceleration(&body, twist, wrench), rate, size);
        // Backwards: the wrench that this motion needs, and the same from the ten parameters.
        let needed = inverse_dynamics(&body, twist, rate);
        let terms = body.mass * (1.0 + largest(rate));
        assert_close(needed, wrench, terms);
        let columns = regressor(twist, rate);
        let sum = columns
            .iter()
            .zip(body.parameters())
            .fold(Screw::zero(), |sum, (column, p)| sum + column.scale(p));
        assert_close(sum, wrench, terms);
        let momentum = body.momentum(twist);
        assert_close(body.matrix().apply(twist), momentum, largest(momentum));
        let by_matrix = force_cross(twist).apply(momentum);
        assert_close(by_matrix, force_cross_apply(twist, momentum), largest(by_matrix));
        let energy = 0.5 * twist.dot(momentum);
        assert!((body.kinetic_energy(twist) - energy).abs() <= FORM * energy);
    }
}

#[test]
fn generalized_forms_agree_in_all_sequences() {
    let mut random = Random(41);
    for sequence in sequences() {
        for _ in 0..20 {
            let (body, q_dot, wrench) = (inertia(&mut random), screw(&mut random), screw(&mut random));
            let alpha = angles(&mut random, sequence);
            let chart = AngleChart::new(sequence, alpha);
            let blocks = acceleration_by_blocks(&body, &chart, q_dot, wrench);

            let g = Generalized::new(&body, sequence, alpha, q_dot);
            let size = largest(g.phi1.apply(q_dot)) + largest(g.a1_inverse.apply(wrench));
            assert_close(g.acceleration_2_4(q_dot, wrench), blocks, size);
            assert_close(g.acceleration_2_7(q_dot, wrench), blocks, size);
            assert_close(g.acceleration_2_8(q_dot, wrench), blocks, size);
            let lagrange = Lagrange::new(&body, &g);
            let force = generalized_force(&chart, wrench);
            assert_close(lagrange.acceleration_2_9(q_dot, force), blocks, size);
            assert_close(lagrange.acceleration_2_10(q_dot, force), blocks, size);

            let mut x = [0.0; 12];
            q_dot.store(&mut x[6..]);
            alpha.store(&mut x[3..]);
            let dx = phase_velocity(&body, sequence, &x, wrench);
            assert_close(Screw::from_slice(&dx[..6]), q_dot, 0.0);
            assert_close(Screw::from_slice(&dx[6..]), blocks, size);
        }
    }
}

/// (2.13) has the mass centre as pole.
#[test]
fn rotation_alone_agrees_in_all_sequences() {
    let mut random = Random(42);
    for sequence in sequences() {
        let turned = inertia(&mut random).about_com;
        let body = Inertia::new(1.0, Vec3::zero(), turned);
        let (alpha, alpha_dot) = (angles(&mut random, sequence), vector(&mut random));
        let wrench = Screw::new(Vec3::zero(), vector(&mut random));
        let chart = AngleChart::new(sequence, alpha);
        let blocks = acceleration_by_blocks(&body, &chart, Screw::new(Vec3::zero(), alpha_dot), wrench);
        let alone = rotation_acceleration(turned.full(), sequence, alpha, alpha_dot, wrench.angular);
        assert_close(Screw::new(Vec3::zero(), alone), blocks, largest(blocks) + largest(wrench));
    }
}

#[test]
fn charts_agree_with_their_matrices() {
    let mut random = Random(43);
    for sequence in sequences() {
        let (alpha, rate) = (angles(&mut random, sequence), vector(&mut random));
        let chart = AngleChart::new(sequence, alpha);
        let zero = Vec3::zero();
        let pair = |a: Vec3<f64>| Screw::new(zero, a);
        assert_eq!(partial_rotations(sequence, alpha)[3], chart.rotation);
        // ω by columns, by M1, by M0, and out of ⟨ω⟩.
        let w = chart.angular_velocity(rate);
        let w0 = chart.rotation.apply(w);
        assert_close(pair(chart.rate_matrix_body().apply(rate)), pair(w), 10.0);
        assert_close(pair(chart.rate_matrix_world().apply(rate)), pair(w0), 10.0);
        let skew = angular_velocity_skew(sequence, alpha, rate);
        assert_close(pair(Vec3::new(skew.rows[2].y, skew.rows[0].z, skew.rows[1].x)), pair(w0), 10.0);
        assert_close(pair(chart.rates(w)), pair(rate), 10.0);
        let convective = chart.rotation.apply(chart.convective_rate(rate));
        assert_close(pair(chart.rate_matrix_world_dot(rate).apply(rate)), pair(convective), 10.0);
        let q_dot = Screw::new(vector(&mut random), rate);
        let there = chart.velocity_map().apply(q_dot);
        assert_close(chart.velocity_map_inverse().apply(there), q_dot, 10.0);
        // (2.5): K q̇ = D⁻¹Ḋ q̇.
        let by_k = chart.convective_matrix(rate).apply(q_dot);
        let by_d = chart.velocity_map_inverse().apply(chart.velocity_map_dot(rate).apply(q_dot));
        assert_close(by_k, by_d, 100.0);
    }
}
