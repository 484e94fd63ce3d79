//! What stands on the left of the equations besides the body: contents, added mass and spins.
//!
//! (Θ + M_A − Σ J a aᵀ) V* = F − Φ(V)ΘV, with Θ that of the body and of what it carries, M_A the added mass and J the
//! inertia of symmetric wheels about their axes a. A wheel's speed relative to the body loses a·ω*. Whatever else
//! comes with wheels, with a fluid and with flow is among the wrenches F and the rates that forces give.

use super::parts::Parts;
use super::{FreeBody, RigidState};
use crate::algebra::{Mat3, Sym3, Sym6, Vec3};
use crate::forces::{Situation, Traced};
use crate::inertia::Inertia;
use crate::newton_euler::momentum_world;
use crate::scalar::Real;
use crate::screw::Screw;

/// A symmetric wheel that turns about an axis of the body; its mass is part of the body.
#[derive(Clone, Copy, Debug)]
pub struct Spin<T> {
    /// Of length one, body axes.
    pub axis: Vec3<T>,
    /// About the axis, kg m².
    pub inertia: T,
    /// Which auxiliary state its speed relative to the body is, rad/s.
    pub state: usize,
}

/// Something that the body carries, as a law: mass, mass centre, inertia about it (xx, xy, xz, yy, yz, zz).
#[derive(Clone, Debug)]
pub struct Contents<T> {
    /// It sees the body alone and no commands.
    pub law: Traced<T>,
    /// The place of the force that it belongs to.
    pub force: usize,
}

/// What stands on the left besides the body.
#[derive(Clone, Debug)]
pub struct Left<T> {
    /// What the body carries.
    pub contents: Vec<Contents<T>>,
    /// The sum of all added mass, about the body origin.
    pub added_mass: Option<Sym6<T>>,
    /// The wheels.
    pub spins: Vec<Spin<T>>,
}

/// Mass, mass centre and inertia about it.
type Matter<T> = (T, Vec3<T>, Sym3<T>);

/// Two pieces of matter of one frame, of which the second may have no mass.
#[inline(always)]
fn joined<T: Real>((m, r, j): Matter<T>, (m2, r2, j2): Matter<T>) -> Matter<T> {
    let mass = m + m2;
    let (part, apart) = (m2 / mass, r2 - r);
    (mass, apart.scale_add(part, r), j + j2 + Sym3::of_unit_mass(apart).scale(m * part))
}

impl<T: Real> Left<T> {
    /// The inertia of body and contents; `s` has that of the body alone.
    #[inline(always)]
    pub fn inertia(&self, s: &Situation<'_, T>) -> Inertia<T> {
        if self.contents.is_empty() {
            return *s.inertia;
        }
        let mut all = (s.inertia.mass, s.inertia.com, s.inertia.about_com);
        for contents in &self.contents {
            let [mass, x, y, z, tensor @ ..] = contents.law.results::<10>(s);
            all = joined(all, (mass, Vec3::new(x, y, z), Sym3::from_array(tensor)));
        }
        Inertia::new(all.0, all.1, all.2)
    }

    /// V* of a wrench about the mass centre of `body`, which is joined with the contents already.
    ///
    /// Solved for the mass centre, as bodies alone are: a weight has no moment about it.
    #[inline(always)]
    pub(super) fn acceleration(&self, body: &Inertia<T>, twist: Screw<T>, wrench: Screw<T>) -> Screw<T> {
        let (v, w) = (twist.linear, twist.angular);
        let com_velocity = w.cross_add(body.com, v);
        let moment = body.about_com.apply(w).cross_add(w, wrench.angular);
        let mut tensor = body.about_com;
        for spin in &self.spins {
            let a = spin.axis;
            let (x, y) = (a.x * spin.inertia, a.y * spin.inertia);
            let wheel = [x * a.x, x * a.y, x * a.z, y * a.y, y * a.z, a.z * a.z * spin.inertia];
            tensor = tensor - Sym3::from_array(wheel);
        }
        match self.added_mass {
            None => {
                let turn = tensor.inverse().apply(moment);
                let rate = body.com.cross_add(turn, wrench.linear.scale(body.inverse_mass));
                Screw::new(com_velocity.cross_add(w, rate), turn)
            }
            Some(added) => {
                let (zero, m) = (T::zero(), body.mass);
                let own =
                    Sym6 { ll: Sym3::from_array([m, zero, zero, m, zero, m]), la: Mat3::zero(), aa: tensor };
                let force = com_velocity.cross(w).scale_add(m, wrench.linear);
                let rate = (own + added.about(body.com)).solve(Screw::new(force, moment));
                Screw::new(body.com.cross_add(rate.angular, rate.linear), rate.angular)
            }
        }
    }

    /// The parameters passed through `f`: of the added mass, of the wheels, of the contents.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> Left<U> {
        let added_mass = match self.added_mass {
            Some(added) => Some(added.map(f)),
            None => None,
        };
        let mut spins = Vec::with_capacity(self.spins.len());
        for spin in &self.spins {
            spins.push(Spin { axis: spin.axis.map(f), inertia: f(spin.inertia), state: spin.state });
        }
        let mut contents = Vec::with_capacity(self.contents.len());
        for own in &self.contents {
            contents.push(Contents { law: own.law.map(f), force: own.force });
        }
        Left { contents, added_mass, spins }
    }
}

impl<T: Real> FreeBody<T> {
    /// V* under whatever stands on the left; the rates of the auxiliary states are written. Apart from the way of
    /// bodies alone, which knows nothing of it.
    #[inline(always)]
    pub(super) fn solved_with(&self, left: &Left<T>, s: Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        let inertia = left.inertia(&s);
        let s = Situation { inertia: &inertia, ..s };
        let mut wrench = self.wrench::<true>(s, rates);
        wrench.linear = self.field(&s).scale_add(inertia.mass, wrench.linear);
        let rate = left.acceleration(&inertia, s.twist, wrench);
        for spin in &left.spins {
            rates[spin.state] = rates[spin.state] - spin.axis.dot(rate.angular);
        }
        rate
    }
}

impl FreeBody<f64> {
    /// The inertia of the body with its contents in a state x.
    pub fn inertia_at(&self, t: f64, x: &[f64], u: &[f64]) -> Inertia<f64> {
        self.inertia_in(t, &self.rigid_state(x), self.auxiliary(x), u)
    }

    /// The auxiliary states of a state x.
    pub(super) fn auxiliary<'a>(&self, x: &'a [f64]) -> &'a [f64] {
        Parts::of(x, self.sizes()).auxiliary
    }

    pub(super) fn inertia_in(&self, t: f64, s: &RigidState, states: &[f64], u: &[f64]) -> Inertia<f64> {
        let Some(left) = &self.left else { return self.inertia };
        left.inertia(&self.situation(t, s, &self.inertia, states, u))
    }

    /// The place of the force whose contents are not finite in a state.
    pub(super) fn lost_contents(&self, t: f64, x: &[f64], u: &[f64]) -> Option<usize> {
        let (s, states) = (self.rigid_state(x), self.auxiliary(x));
        let s = self.situation(t, &s, &self.inertia, states, u);
        let lost = |c: &&Contents<f64>| c.law.results::<10>(&s).iter().any(|v| !v.is_finite());
        self.left.iter().flat_map(|left| &left.contents).find(lost).map(|contents| contents.force)
    }

    /// The momentum of the wheels relative to the body, body axes, kg m²/s.
    fn spinning(&self, states: &[f64]) -> Vec3<f64> {
        let spins = self.left.iter().flat_map(|left| &left.spins);
        spins.fold(Vec3::zero(), |sum, spin| sum + spin.axis.scale(spin.inertia * states[spin.state]))
    }

    /// The kinetic energy, of contents and wheels too, and the sum of the potential energies, J.
    pub fn energies(&self, t: f64, x: &[f64], u: &[f64]) -> (f64, f64) {
        let (s, states) = (self.rigid_state(x), self.auxiliary(x));
        let inertia = self.inertia_in(t, &s, states, u);
        let situation = self.situation(t, &s, &inertia, states, u);
        let potential = self.forces.iter().filter_map(|f| f.potential_energy(&situation)).sum();
        let own = |spin: &Spin<f64>| 0.5 * spin.inertia * states[spin.state] * states[spin.state];
        let spins: f64 = self.left.iter().flat_map(|left| &left.spins).map(own).sum();
        let relative = spins + self.spinning(states).dot(s.twist.angular);
        (inertia.kinetic_energy(s.twist) + relative, potential)
    }

    /// The momentum about the world origin, of contents and wheels too, world axes. Konoplev (1.5)
    pub fn momentum_world(&self, t: f64, x: &[f64], u: &[f64]) -> Screw<f64> {
        let (s, states) = (self.rigid_state(x), self.auxiliary(x));
        let inertia = self.inertia_in(t, &s, states, u);
        let body = momentum_world(&inertia, s.position, s.rotation(), s.twist);
        Screw::new(body.linear, body.angular + s.rotation().apply(self.spinning(states)))
    }
}
