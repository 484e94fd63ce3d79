use freebody_core::{
    algebra::*, evaluate::Evaluator, forces::*, inertia::Inertia, phase_space::*, scalar::isa::Isa,
    screw::Screw,
};
use std::time::Instant;
fn main() {
    let inertia = Inertia::new(
        12.5,
        Vec3::new(0.12, -0.05, 0.08),
        Sym3::from_array([1.2, 0.05, -0.02, 1.9, 0.04, 2.4]),
    );
    let forces = vec![
        Force::UniformGravity(UniformGravity { acceleration: Vec3::new(0., 0., 9.81) }),
        Force::ConstantWrench(ConstantWrench {
            wrench: Screw::new(Vec3::new(3., -1., 2.), Vec3::new(0.4, -0.3, 0.2)),
            at: Vec3::new(0., 0., 0.),
            axes: Axes::Body,
        }),
        Force::LinearDamping(LinearDamping {
            coefficients: Coefficients::Diagonal(Screw::new(Vec3::new(2., 3., 4.), Vec3::new(0.5, 0.6, 0.7))),
        }),
    ];
    for f in [vec![], forces.clone(), {
        let mut f = forces.clone();
        f.push(Force::InputWrench(InputWrench { first: 0, at: Vec3::zero(), axes: Axes::Body }));
        f
    }] {
        let b = FreeBody { inertia, forces: f.clone(), chart: Chart::Quaternion, form: Form::QuasiVelocity };
        let u = vec![0.0; <FreeBody<f64> as Dynamics<f64>>::input_size(&b)];
        for isa in Isa::available() {
            let e = Evaluator::on(isa, &b);
            let mut x = vec![0., 0., 0., 1., 0., 0., 0., 5., 0.5, -0.3, 0.8, -1.1, 1.7];
            let mut dx = vec![0.0; 13];
            let n = 2_000_000;
            let t0 = Instant::now();
            for _ in 0..n {
                e.derivative(0.0, std::hint::black_box(&x), &u, &mut dx);
            }
            let thr = t0.elapsed().as_nanos() as f64 / n as f64;
            let t0 = Instant::now();
            for _ in 0..n {
                e.derivative(0.0, &x, &u, &mut dx);
                for i in 0..13 {
                    x[i] += 1e-7 * dx[i];
                }
            }
            let chain = t0.elapsed().as_nanos() as f64 / n as f64;
            let (mut a, mut bb) = (vec![0.0; 169], vec![0.0; 13 * u.len()]);
            let t0 = Instant::now();
            for _ in 0..n / 10 {
                e.jacobian(0.0, std::hint::black_box(&x), &u, &mut a, &mut bb);
            }
            let jac = t0.elapsed().as_nanos() as f64 / (n / 10) as f64;
            println!(
                "{} forces, {isa:?}: {thr:.1} ns independent, {chain:.1} ns chained, jacobian {jac:.0} ns",
                f.len()
            );
        }
    }
}
