//! The control law among the forces, and derivatives that were compiled elsewhere.

use super::orientation::Orientation;
use super::parts::Parts;
use super::{FreeBody, RigidState};
use crate::algebra::Vec3;
use crate::buffer::Buffer;
use crate::forces::{Acting, Force, Situation, Traced};
use crate::inertia::Inertia;
use crate::scalar::{Block, Real};
use crate::screw::Screw;

/// Up to this many numbers are passed on the stack.
const ON_STACK: usize = 48;

/// Writes u and behind it what a law commands; the rates of the law's states are written.
#[inline(always)]
pub fn command<T: Real>(law: &Traced<T>, s: &Situation<'_, T>, all: &mut [T], rates: &mut [T]) {
    let (given, commands) = all.split_at_mut(s.inputs.len());
    for (to, u) in given.iter_mut().zip(s.inputs) {
        *to = *u;
    }
    law.command(s, commands, rates);
}

/// Writes dx by a compiled f; false if this scalar is no plain number.
#[inline(always)]
pub fn elsewhere<T: Real>(block: &dyn Block, t: T, x: &[T], u: &[T], dx: &mut [T]) -> bool {
    T::call(
        #[inline(always)]
        || {
            let mut given = Buffer::<T, ON_STACK>::new(1 + x.len() + u.len());
            let given = given.slice();
            given[0] = t;
            for (to, v) in given[1..].iter_mut().zip(x.iter().chain(u)) {
                *to = *v;
            }
            T::outside(block, given, dx)
        },
    )
}

impl<T: Real> FreeBody<T> {
    /// What laws see in a state x of any chart and form.
    ///
    /// `inputs` hold u and room for what the control law commands, which is written; `rates` is room for those of the
    /// auxiliary states, `room` for the inertia with the contents.
    #[inline(always)]
    pub fn sight<'a>(
        &'a self,
        t: T,
        x: &'a [T],
        inputs: &'a mut [T],
        rates: &mut [T],
        room: &'a mut Option<Inertia<T>>,
    ) -> Situation<'a, T> {
        let x = Parts::of(x, self.sizes());
        let at = Orientation::read(self.chart, x.orientation);
        let rotation = at.rotation();
        let (position, twist) = (Vec3::from_slice(x.position), self.twist(&at, rotation, x));
        let states = x.auxiliary;
        let (u, commands) =
            inputs.split_at_mut(inputs.len() - self.control.as_ref().map_or(0, Traced::result_count));
        let mut inertia = &self.inertia;
        if let Some(left) = &self.left {
            let own = Situation { time: t, position, rotation, twist, inertia, inputs: u, states };
            inertia = room.insert(left.inertia(&own));
        }
        if let Some(law) = &self.control {
            let before = Situation { time: t, position, rotation, twist, inertia, inputs: u, states };
            law.command(&before, commands, rates);
        }
        Situation { time: t, position, rotation, twist, inertia, inputs, states }
    }

    /// The body, its control law and its left side without forces over another scalar, for who only looks at it.
    #[inline(always)]
    pub fn map_without_forces<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> FreeBody<U> {
        let inertia = self.inertia.map(f);
        let control = self.control.as_ref().map(
            #[inline(always)]
            |law| law.map(f),
        );
        let left = match &self.left {
            Some(left) => Some(left.map(f)),
            None => None,
        };
        FreeBody { control, left, ..FreeBody::new(inertia, Vec::new(), self.chart, self.form) }
    }
}

impl FreeBody<f64> {
    /// Whether a force or a law depends on the position; for what was compiled nobody knows.
    pub fn reads_position(&self) -> bool {
        // A body whose parameters were passed through something has its forces in one piece alone.
        let by_force = self.forces.iter().any(Force::reads_position)
            || self.acting.as_ref().is_some_and(Acting::reads_position);
        let by_contents = self.left.iter().flat_map(|left| &left.contents).any(|c| c.law.reads_position());
        by_force
            || by_contents
            || self.compiled.is_some()
            || self.control.as_ref().is_some_and(Traced::reads_position)
    }

    /// What the forces see in a motion.
    pub(super) fn situation<'a>(
        &self,
        t: f64,
        s: &RigidState,
        inertia: &'a Inertia<f64>,
        states: &'a [f64],
        inputs: &'a [f64],
    ) -> Situation<'a, f64> {
        let (position, rotation, twist) = (s.position, s.rotation(), s.twist);
        Situation { time: t, position, rotation, twist, inertia, inputs, states }
    }

    /// What the control law commands in a state.
    pub fn commands(&self, t: f64, x: &[f64], u: &[f64]) -> Vec<f64> {
        let (motion, states) = (self.rigid_state(x), self.auxiliary(x));
        let inertia = self.inertia_in(t, &motion, states, u);
        let s = self.situation(t, &motion, &inertia, states, u);
        self.all_inputs(&s, &mut vec![0.0; states.len()]).split_off(u.len())
    }

    /// u and behind it the commands.
    fn all_inputs(&self, s: &Situation<'_, f64>, rates: &mut [f64]) -> Vec<f64> {
        let mut all = s.inputs.to_vec();
        if let Some(law) = &self.control {
            all.resize(all.len() + law.result_count(), 0.0);
            command(law, s, &mut all, rates);
        }
        all
    }

    /// The wrench of each force, in body axes about the body origin.
    pub fn wrenches(&self, t: f64, x: &[f64], u: &[f64]) -> Vec<Screw<f64>> {
        self.wrenches_and_rates(t, x, u).0
    }

    /// The wrenches, the rates of the auxiliary states, and the commands.
    fn wrenches_and_rates(&self, t: f64, x: &[f64], u: &[f64]) -> (Vec<Screw<f64>>, Vec<f64>, Vec<f64>) {
        let (motion, states) = (self.rigid_state(x), self.auxiliary(x));
        let inertia = self.inertia_in(t, &motion, states, u);
        let mut rates = vec![0.0; states.len()];
        let mut all = self.all_inputs(&self.situation(t, &motion, &inertia, states, u), &mut rates);
        let s = self.situation(t, &motion, &inertia, states, &all);
        let wrenches = self.forces.iter().map(|f| f.about_origin(&s, &mut rates)).collect();
        (wrenches, rates, all.split_off(u.len()))
    }

    /// The place of the force that is not finite in a state, in its wrench, its contents or the rates of its states; one
    /// place behind them all stands the control law.
    pub fn culprit(&self, t: f64, x: &[f64], u: &[f64]) -> Option<usize> {
        if let Some(force) = self.lost_contents(t, x, u) {
            return Some(force);
        }
        let (wrenches, rates, commands) = self.wrenches_and_rates(t, x, u);
        let lost = |numbers: &[f64]| numbers.iter().any(|v| !v.is_finite());
        if let Some(law) = &self.control
            && (lost(&commands) || lost(&rates[law.places.states.clone()]))
        {
            return Some(self.forces.len());
        }
        self.forces.iter().zip(wrenches).position(|(force, wrench)| {
            let mut six = [0.0; 6];
            wrench.store(&mut six);
            lost(&six) || lost(&rates[force.states()])
        })
    }
}
