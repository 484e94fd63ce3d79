//! What a derivative and a Jacobian cost on each instruction set of the machine: `make bench`.

use freebody_core::algebra::{Sym3, Vec3};
use freebody_core::evaluate::Evaluator;
use freebody_core::expression::{Expression, Graph, Id, Program, Simplify};
use freebody_core::forces::{
    Axes, Coefficients, ConstantWrench, Force, LinearDamping, Places, Traced, UniformGravity,
};
use freebody_core::inertia::Inertia;
use freebody_core::integrators::{Block, Dop853, Lanes, Stepper, System, Tolerance};
use freebody_core::phase_space::{Chart, Dynamics, Form, FreeBody};
use freebody_core::scalar::isa::Isa;
use freebody_core::scalar::{Lane, Real};
use freebody_core::screw::Screw;
use std::hint::black_box;
use std::sync::Arc;
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
    FreeBody::new(inertia, forces, Chart::Quaternion, Form::QuasiVelocity).made_ready()
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

type E = Expression;
type Law<'a> = &'a dyn Fn(&[E], &[E]) -> Screw<E>;

/// Gravity, damping, a constant wrench and a fin as laws of a user, each for itself: about fifty operations.
///
/// The built-in forces beside them lack the fin.
fn four_laws() -> Vec<Force<f64>> {
    let cross = |a: Vec3<E>, b: Vec3<E>| a.cross(b);
    let gravity = |s: &[E], p: &[E]| {
        let weight = Vec3::from_slice(&s[10..]).scale(s[19] * p[0]);
        Screw::new(weight, cross(Vec3::from_slice(&s[20..]), weight))
    };
    let damping = |s: &[E], p: &[E]| {
        let drag: Vec<E> = s[13..19].iter().zip(p).map(|(v, d)| -(*d * *v)).collect();
        Screw::from_slice(&drag)
    };
    let constant = |_: &[E], p: &[E]| Screw::from_slice(p);
    let fin = |s: &[E], p: &[E]| {
        let v = Vec3::from_slice(&s[13..]);
        let lift = E::lit(0.5) * p[0] * v.dot(v) * p[1] * (v.z / v.x);
        Screw::at_point(Vec3::new(E::zero(), E::zero(), -lift), Vec3::from_slice(&p[2..]))
    };
    vec![
        law(&gravity, &[9.80665]),
        law(&damping, &[0.1, 0.2, 0.3, 0.01, 0.02, 0.03]),
        law(&constant, &[1.0, 2.0, -0.5, 0.1, -0.2, 0.3]),
        law(&fin, &[0.024, 5.0, -1.0, 0.1, 0.05]),
    ]
}

/// The same as the built-in forces: without the fin.
fn three_laws() -> Vec<Force<f64>> {
    let mut laws = four_laws();
    laws.truncate(3);
    laws
}

/// A law of what all laws are given and of parameters.
fn law(wrench: Law<'_>, parameters: &[f64]) -> Force<f64> {
    let mut graph = Graph::new(Simplify::Safely);
    let mut symbols = |kind: &str, n: usize| -> Vec<Id> {
        (0..n).map(|i| graph.symbol(&format!("{kind}{i}"), "")).collect()
    };
    let (given, values) = (symbols("s", Places::MOTION), symbols("p", parameters.len()));
    let outputs = graph.enter(|| {
        let of = |ids: &[Id]| -> Vec<E> { ids.iter().copied().map(Expression).collect() };
        let mut six = [E::zero(); 6];
        wrench(&of(&given), &of(&values)).store(&mut six);
        six.map(|e| e.0)
    });
    let program = Program::new(&graph, &values, &given, &outputs).unwrap();
    Force::Traced(Traced::new(Arc::new(program), parameters.to_vec(), Places::default()))
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

/// A body in lanes as the integrators want it.
struct InLanes<L>(FreeBody<L>, Vec<Block>);

impl<L: Lane> System<L> for InLanes<L> {
    fn size(&self) -> usize {
        STATES
    }
    #[inline(always)]
    fn derivative(&self, t: L, y: &[L], dy: &mut [L]) {
        L::call(
            #[inline(always)]
            || self.0.derivative(t, y, &[], dy),
        );
    }
    #[inline(always)]
    fn project(&self, y: &mut [L]) {
        self.0.project(y);
    }
    fn error_blocks(&self) -> &[Block] {
        &self.1
    }
}

/// A derivative in whole runs in lanes by dop853, with all the work of the method, for each trajectory.
fn running_in_lanes<L: Lane>(body: &FreeBody<f64>) -> f64 {
    let system = InLanes::<L>(body.lift(), Dynamics::<f64>::error_blocks(body));
    let mut best = f64::INFINITY;
    for _ in 0..SPELLS / 20 {
        let (mut steps, end) = (0, L::lit(10.0));
        let mut stepper = Stepper::<L, Dop853>::new(Tolerance { relative: 1e-9, absolute: 1e-9 });
        stepper.start(&system, Lanes::all::<L>(), L::zero(), &X.map(L::lit), end, None);
        let before = stepper.evaluations();
        let start = Instant::now();
        while steps < 40 {
            stepper.attempt(&system, end);
            stepper.commit(&system);
            steps += 1;
        }
        let evaluations = (stepper.evaluations() - before) as usize * L::N;
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / evaluations as f64);
    }
    best
}

fn in_lanes(isa: Isa, body: &FreeBody<f64>) -> [f64; 2] {
    use freebody_core::scalar;
    macro_rules! both {
        ($L:ty) => {
            [chained_in_lanes::<$L>(body), running_in_lanes::<$L>(body)]
        };
    }
    match isa {
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => both!(scalar::Avx512),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => both!(scalar::Avx2),
        #[cfg(target_arch = "x86_64")]
        Isa::Baseline => both!(scalar::Sse2),
        #[cfg(target_arch = "aarch64")]
        Isa::Neon => both!(scalar::Neon),
        _ => both!(f64),
    }
}

fn jacobian(ready: &Evaluator) -> f64 {
    let mut by_state = [0.0; STATES * STATES];
    nanoseconds(|| ready.jacobian(0.0, black_box(&X), &[], &mut by_state, &mut []))
}

fn main() {
    println!("{STATES} states, quaternion; ns, compiled, one thread, best of {SPELLS} spells");
    println!("                        derivative   chained  in lanes  in runs  jacobian");
    for isa in Isa::available() {
        for (name, forces) in [
            ("free", Vec::new()),
            ("three forces", three_forces()),
            ("three laws", three_laws()),
            ("four laws", four_laws()),
        ] {
            let body = body(forces);
            let ready = Evaluator::on(isa, &body);
            let [a, b, d] = [alone(&ready), chained(&ready), jacobian(&ready)];
            let [c, r] = in_lanes(isa, &body);
            println!("{:9} {name:13} {a:10.1} {b:9.1} {c:9.1} {r:8.1} {d:9.0}", format!("{isa:?}"));
        }
    }
}
