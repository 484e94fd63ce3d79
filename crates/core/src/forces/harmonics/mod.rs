//! Gravity by spherical harmonics.

mod series;

pub use series::Harmonics;

use super::Situation;
use crate::algebra::{Mat3, Sym3, Vec3};
use crate::scalar::Real;
use crate::screw::Screw;
use series::Series;
use std::sync::Arc;

/// The gravity field of a planet, in axes fixed in it.
///
/// The potential is U = μ/R Σ (C̄ V + S̄ W), positive.
#[derive(Debug)]
pub struct Field {
    /// Reference radius R, m.
    radius: f64,
    /// C̄ of degree zero, apart: what is large is added last, and a point mass is itself.
    central: f64,
    potential: Series<1>,
    /// By x, y and z.
    pull: Series<3>,
    /// By xx, xy, xz, yy and yz; zz follows, for the trace is zero.
    gradient: Option<Series<5>>,
}

impl Field {
    /// A field with its reference radius, m; with its gradient or without.
    pub fn new(radius: f64, mut field: Harmonics, with_gradient: bool) -> Self {
        let central = std::mem::take(&mut field.at(0, 0)[0]);
        let [x, y, z] = field.derivatives();
        let gradient = with_gradient.then(|| {
            let ([xx, xy, xz], [_, yy, yz]) = (x.derivatives(), y.derivatives());
            Series::new([&xx, &xy, &xz, &yy, &yz])
        });
        Self { radius, central, potential: Series::new([&field]), pull: Series::new([&x, &y, &z]), gradient }
    }
}

/// Attraction by a planet, acting at the mass centre, with or without the torque of its gradient over the body.
///
/// The planet turns about the third world axis through its centre.
#[derive(Clone, Debug)]
pub struct HarmonicGravity<T> {
    /// Gravitational parameter GM, m³/s².
    pub mu: T,
    /// Position of the centre, world axes, m.
    pub center: Vec3<T>,
    /// The field in axes of the planet; with a gradient, its torque acts.
    pub field: Arc<Field>,
    /// Rate of the planet, rad/s.
    pub rotation_rate: f64,
    /// Angle of the planet at time zero, from the world axes, rad.
    pub angle: f64,
}

/// Where the mass centre is, seen from the planet.
struct Place<T> {
    /// World axes.
    offset: Vec3<T>,
    /// World from planet axes.
    turn: Mat3<T>,
    inverse_square: T,
    inverse: T,
    /// R x/r² in axes of the planet, and R/r.
    direction: Vec3<T>,
    ratio: T,
}

impl<T: Real> HarmonicGravity<T> {
    #[inline(always)]
    fn place(&self, s: &Situation<'_, T>) -> Place<T> {
        let offset = s.com_position() - self.center;
        let inverse_square = T::one() / offset.dot(offset);
        let inverse = inverse_square.sqrt();
        let (sin, cos) = T::lit(self.rotation_rate).fma(s.time, T::lit(self.angle)).sin_cos();
        let (zero, one) = (T::zero(), T::one());
        let turn = Mat3::from_rows(
            Vec3::new(cos, -sin, zero),
            Vec3::new(sin, cos, zero),
            Vec3::new(zero, zero, one),
        );
        let radius = T::lit(self.field.radius);
        let direction = turn.transpose_apply(offset).scale(radius * inverse_square);
        Place { offset, turn, inverse_square, inverse, direction, ratio: radius * inverse }
    }

    /// The attraction m ∇U and the torque of its gradient.
    ///
    /// The torque is that of the whole gradient ∂²U, of all degrees: ∫ ρ × (∂²U ρ) dm.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>) -> Screw<T> {
        let p = self.place(s);
        let radius = T::lit(self.field.radius);
        let strength = self.mu * p.inverse_square * p.inverse * T::lit(self.field.central);
        let sums = self.field.pull.sums(p.direction, p.ratio);
        let scale = self.mu / (radius * radius);
        let acceleration = p.offset.scale(-strength) + p.turn.apply(Vec3::from_array(sums).scale(scale));
        let pull = s.rotation.transpose_apply(acceleration).scale(s.inertia.mass);
        let Some(gradient) = &self.field.gradient else { return Screw::new(pull, Vec3::zero()) };

        let tensor = s.inertia.about_com;
        let r = s.rotation.transpose_apply(p.offset);
        let central = r.cross(tensor.apply(r)).scale(T::lit(3.0) * strength * p.inverse_square);
        let [xx, xy, xz, yy, yz] = gradient.sums(p.direction, p.ratio);
        let axes = Mat3::from_rows(
            s.rotation.transpose_apply(p.turn.column(0)),
            s.rotation.transpose_apply(p.turn.column(1)),
            s.rotation.transpose_apply(p.turn.column(2)),
        );
        let in_body = Sym3::from_array([xx, xy, xz, yy, yz, -(xx + yy)]).turned(axes).full();
        // The sum of e × (J ∂²U e) over the body axes e.
        let [a, b, c] = [
            tensor.apply(in_body.column(0)),
            tensor.apply(in_body.column(1)),
            tensor.apply(in_body.column(2)),
        ];
        let other = Vec3::new(b.z - c.y, c.x - a.z, a.y - b.x).scale(scale / radius);
        Screw::new(pull, central + other)
    }

    /// −m U at this moment, zero at infinity; the small part that belongs to the gradient is left out as its force
    /// is. While the planet turns, it depends on time.
    pub fn potential_energy(&self, s: &Situation<'_, T>) -> T {
        let p = self.place(s);
        let [other] = self.field.potential.sums(p.direction, p.ratio);
        let sum = p.inverse * T::lit(self.field.central) + other / T::lit(self.field.radius);
        -(self.mu * s.inertia.mass * sum)
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> HarmonicGravity<U> {
        let (mu, center) = (f(self.mu), self.center.map(f));
        let (rotation_rate, angle) = (self.rotation_rate, self.angle);
        HarmonicGravity { mu, center, field: Arc::clone(&self.field), rotation_rate, angle }
    }
}
