//! One compiled derivative and one Jacobian on each instruction set of the machine: `make bench`.

use freebody_core::algebra::{Sym3, Vec3};
use freebody_core::evaluate::Evaluator;
use freebody_core::forces::{Force, UniformGravity};
use freebody_core::inertia::Inertia;
use freebody_core::phase_space::{Chart, Form, FreeBody};
use freebody_core::scalar::isa::Isa;
use std::hint::black_box;
use std::time::Instant;

const REPEATS: usize = 7;

/// The time of one call in ns: the best of several repeats, for what else the machine does only adds to it.
fn nanoseconds(calls: usize, mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        for _ in 0..calls {
            call();
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / calls as f64);
    }
    best
}

fn main() {
    let about_com = Sym3::from_array([0.42, 0.01, -0.02, 0.91, 0.03, 1.10]);
    let gravity = UniformGravity { acceleration: Vec3::new(0.0, 0.0, 9.80665) };
    let body = FreeBody {
        inertia: Inertia::new(12.5, Vec3::new(0.12, -0.05, 0.08), about_com),
        forces: vec![Force::UniformGravity(gravity)],
        chart: Chart::Quaternion,
        form: Form::QuasiVelocity,
    };
    let x = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 5.0, 0.5, -0.3, 0.8, -1.1, 1.7];
    let (mut dx, mut by_state) = ([0.0; 13], [0.0; 169]);
    println!("13 states, uniform gravity; compiled, one thread");
    for isa in Isa::available() {
        let ready = Evaluator::on(isa, &body);
        let derivative = nanoseconds(1_000_000, || ready.derivative(0.0, black_box(&x), &[], &mut dx));
        // Chained: each state depends on the derivative before, as in a run.
        let mut state = x;
        let chained = nanoseconds(1_000_000, || {
            ready.derivative(0.0, &state, &[], &mut dx);
            for (s, d) in state.iter_mut().zip(dx) {
                *s += 1e-9 * d;
            }
        });
        let jacobian =
            nanoseconds(100_000, || ready.jacobian(0.0, black_box(&x), &[], &mut by_state, &mut []));
        println!(
            "{isa:?}: derivative {derivative:.1} ns, chained {chained:.1} ns, jacobian {jacobian:.0} ns"
        );
    }
}
