//! What a derivative and a Jacobian cost on each instruction set of the machine: `make bench`.

use freebody_core::algebra::{Sym3, Vec3};
use freebody_core::evaluate::Evaluator;
use freebody_core::forces::{Axes, Coefficients, ConstantWrench, Force, LinearDamping, UniformGravity};
use freebody_core::inertia::Inertia;
use freebody_core::phase_space::{Chart, Dynamics, Form, FreeBody};
use freebody_core::scalar::Lane;
use freebody_core::scalar::isa::Isa;
use freebody_core::screw::Screw;
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 13;
const X: [f64; STATES] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 5.0, 0.5, -0.3, 0.8, -1.1, 1.7];
const STEP: f64 = 1e-9;

/// What else the machine does only adds to a time, so the best of many short spells counts.
const SPELLS: usize = 2000;
const CALLS: usize = 500;

/// The time of one call, ns.
fn nanoseconds(mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..SPELLS {
        let start = Instant::now();
        for _ in 0..CALLS {
            call();
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / CALLS as f64);
    }
    best
}

/// A body of twelve kilograms with its mass centre off the origin.
fn body(forces: Vec<Force<f64>>) -> FreeBody<f64> {
    let about_com = Sym3::from_array([0.42, 0.01, -0.02, 0.91, 0.03, 1.10]);
    let inertia = Inertia::new(12.5, Vec3::new(0.12, -0.05, 0.08), about_com);
    FreeBody { inertia, forces, chart: Chart::Quaternion, form: Form::QuasiVelocity }
}

fn three_forces() -> Vec<Force<f64>> {
    let vector = Vec3::new;
    let wrench = Screw::new(vector(1.0, 2.0, -0.5), vector(0.1, -0.2, 0.3));
    let damping = Screw::new(vector(0.1, 0.2, 0.3), vector(0.01, 0.02, 0.03));
    vec![
        Force::UniformGravity(UniformGravity { acceleration: vector(0.0, 0.0, 9.80665) }),
        Force::ConstantWrench(ConstantWrench { wrench, at: vector(0.1, 0.2, 0.3), axes: Axes::Body }),
        Force::LinearDamping(LinearDamping { coefficients: Coefficients::Diagonal(damping) }),
    ]
}

/// Derivatives of one state, each on its own.
fn alone(ready: &Evaluator) -> f64 {
    let mut dx = [0.0; STATES];
    nanoseconds(|| ready.derivative(0.0, black_box(&X), &[], &mut dx))
}

/// Derivatives of states that depend on the derivative before, as in a run.
fn chained(ready: &Evaluator) -> f64 {
    let (mut x, mut dx) = (X, [0.0; STATES]);
    nanoseconds(|| {
        ready.derivative(0.0, &x, &[], &mut dx);
        for (x, d) in x.iter_mut().zip(dx) {
            *x += STEP * d;
        }
    })
}

/// The same in the lanes of `L`, for each trajectory.
fn chained_in_lanes<L: Lane>(body: &FreeBody<f64>) -> f64 {
    let body = body.lift::<L>();
    let mut best = f64::INFINITY;
    for _ in 0..SPELLS {
        let spell = L::call(
            #[inline(always)]
            || {
                let (mut x, mut dx) = ([L::zero(); STATES], [L::zero(); STATES]);
                for (x, from) in x.iter_mut().zip(X) {
                    *x = L::lit(from);
                }
                let start = Instant::now();
                for _ in 0..CALLS {
                    body.derivative(L::zero(), black_box(&x), &[], &mut dx);
                    for (x, d) in x.iter_mut().zip(&dx) {
                        *x = L::lit(STEP).fma(*d, *x);
                    }
                }
                start.elapsed()
            },
        );
        best = best.min(spell.as_secs_f64() * 1e9 / (CALLS * L::N) as f64);
    }
    best
}

fn in_lanes(isa: Isa, body: &FreeBody<f64>) -> f64 {
    use freebody_core::scalar;
    match isa {
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => chained_in_lanes::<scalar::Avx512>(body),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => chained_in_lanes::<scalar::Avx2>(body),
        #[cfg(target_arch = "x86_64")]
        Isa::Baseline => chained_in_lanes::<scalar::Sse2>(body),
        #[cfg(target_arch = "aarch64")]
        Isa::Neon => chained_in_lanes::<scalar::Neon>(body),
        _ => chained_in_lanes::<f64>(body),
    }
}

fn jacobian(ready: &Evaluator) -> f64 {
    let mut by_state = [0.0; STATES * STATES];
    nanoseconds(|| ready.jacobian(0.0, black_box(&X), &[], &mut by_state, &mut []))
}

fn main() {
    println!("{STATES} states, quaternion; ns, compiled, one thread, best of {SPELLS} spells");
    println!("                        derivative   chained  in lanes  jacobian");
    for isa in Isa::available() {
        for (name, forces) in [("free", Vec::new()), ("three forces", three_forces())] {
            let body = body(forces);
            let ready = Evaluator::on(isa, &body);
            let times = [alone(&ready), chained(&ready), in_lanes(isa, &body), jacobian(&ready)];
            let [a, b, c, d] = times;
            println!("{:9} {name:13} {a:10.1} {b:9.1} {c:9.1} {d:9.0}", format!("{isa:?}"));
        }
    }
}
