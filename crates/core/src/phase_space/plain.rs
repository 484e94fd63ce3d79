//! The free rigid body as most runs have it, in straight code: in quaternions and quasi-velocities, under the usual
//! forces alone.

use super::pattern::STATES;
use super::{Chart, Form, FreeBody};
use crate::algebra::{Vec3, rotation_from_quaternion};
use crate::charts::quaternion_rate;
use crate::expression::Values;
use crate::forces::{Acting, Seen, Situation, Traced, Usual};
use crate::newton_euler::acceleration_about_com;
use crate::scalar::Real;
use crate::screw::Screw;

impl<T: Real> FreeBody<T> {
    /// Whether it is no more than [`FreeBody::plain_rate`] knows.
    pub(crate) fn is_plain(&self) -> bool {
        self.plain_forces().is_some_and(|acting| acting.law.is_none())
    }

    /// Its forces, if the one law of all laws is the only one that is not usual.
    #[inline(always)]
    pub(crate) fn plain_forces(&self) -> Option<&Acting<T>> {
        let acting = self.acting.as_ref()?;
        let alone = acting.others.is_empty() && self.control.is_none() && self.left.is_none();
        let plain = self.chart == Chart::Quaternion && self.form == Form::QuasiVelocity && alone;
        plain.then_some(acting)
    }

    /// dx = f(x, u) of a body that [`FreeBody::is_plain`]. Konoplev (3.2)
    #[inline(always)]
    pub(crate) fn plain_rate(&self, x: &[T; STATES], u: &[T], dx: &mut [T; STATES]) {
        if let Some(Acting { usual, .. }) = &self.acting {
            self.plain_rate_under::<true>(usual, x, u, dx);
        }
    }

    /// The same under forces that are not those of the body; the rate of the position may be left out.
    #[inline(always)]
    pub(crate) fn plain_rate_under<const POSITION: bool>(
        &self,
        usual: &Usual<T>,
        x: &[T; STATES],
        u: &[T],
        dx: &mut [T; STATES],
    ) {
        let s = self.plain_situation(&Given { t: T::zero(), x, states: &[], u });
        let rate = acceleration_about_com(&self.inertia, s.twist, usual.about_com(&s), usual.field(&s));
        write_kinematics::<T, POSITION>(&s, x, dx);
        rate.store(&mut dx[7..]);
    }

    /// dx = f(x, u, t) under the one law, if there is one, and usual forces that may not be those of the body, which
    /// has [`FreeBody::plain_forces`]; the rate of the position may be left out.
    ///
    /// Each way in code of its own: what the longer one needs on the stack costs the shorter one time.
    #[inline(always)]
    pub(crate) fn straight_rate<const POSITION: bool>(
        &self,
        usual: &Usual<T>,
        t: T,
        x: &[T],
        u: &[T],
        dx: &mut [T],
    ) {
        let (x, states) = x.split_first_chunk().expect("the state of a body");
        let (dx, rates) = dx.split_first_chunk_mut().expect("the rate of a body");
        match self.law() {
            None => T::call(
                #[inline(always)]
                || self.plain_rate_under::<POSITION>(usual, x, u, dx),
            ),
            Some(law) => T::call(
                #[inline(always)]
                || self.lawful_rate::<POSITION>(law, usual, &Given { t, x, states, u }, dx, rates),
            ),
        }
    }

    /// First the law, then all the rest out of memory: what stood in registers before would be written there for the
    /// law, which needs them all.
    #[inline(always)]
    fn lawful_rate<const POSITION: bool>(
        &self,
        law: &Traced<T>,
        usual: &Usual<T>,
        given: &Given<'_, T>,
        dx: &mut [T; STATES],
        rates: &mut [T],
    ) {
        let (mut seen, mut values) = (Seen::new(Some([&given.x[..3], &given.x[7..]])), Values::empty());
        law.run(&self.plain_situation(given), &mut seen, &mut values, rates);
        let mut s = self.plain_situation(given);
        if let Some(rotation) = seen.rotation() {
            s.rotation = rotation;
        }
        write_kinematics::<T, POSITION>(&s, given.x, dx);
        let wrench = usual.about_com(&s) + law.wrench(&values, &s);
        acceleration_about_com(&self.inertia, s.twist, wrench, usual.field(&s)).store(&mut dx[7..]);
    }

    #[inline(always)]
    fn plain_situation<'a>(&'a self, given: &Given<'a, T>) -> Situation<'a, T> {
        let [x, y, z, q0, q1, q2, q3, v @ .., p, q, r] = given.x;
        Situation {
            time: given.t,
            position: Vec3::new(*x, *y, *z),
            rotation: rotation_from_quaternion([*q0, *q1, *q2, *q3]),
            twist: Screw::new(Vec3::from_array(*v), Vec3::new(*p, *q, *r)),
            inertia: &self.inertia,
            inputs: given.u,
            states: given.states,
        }
    }
}

/// The rates of position and orientation.
#[inline(always)]
fn write_kinematics<T: Real, const POSITION: bool>(
    s: &Situation<'_, T>,
    x: &[T; STATES],
    dx: &mut [T; STATES],
) {
    if POSITION {
        s.rotation.apply(s.twist.linear).store(dx);
    }
    dx[3..7].copy_from_slice(&quaternion_rate([x[3], x[4], x[5], x[6]], s.twist.angular));
}

/// What f is given.
struct Given<'a, T> {
    t: T,
    x: &'a [T; STATES],
    /// The auxiliary states.
    states: &'a [T],
    u: &'a [T],
}
