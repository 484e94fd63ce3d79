//! The free rigid body as most runs have it, in straight code: in quaternions and quasi-velocities, under the usual
//! forces alone.

use super::pattern::STATES;
use super::{Chart, Form, FreeBody};
use crate::algebra::{Vec3, rotation_from_quaternion};
use crate::charts::quaternion_rate;
use crate::forces::{Acting, Situation, Usual};
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
    fn plain_forces(&self) -> Option<&Acting<T>> {
        let acting = self.acting.as_ref()?;
        let alone = acting.others.is_empty() && self.control.is_none() && self.left.is_none();
        let plain = self.chart == Chart::Quaternion && self.form == Form::QuasiVelocity && alone;
        plain.then_some(acting)
    }

    /// dx = f(x, u) of a body that [`FreeBody::is_plain`]. Konoplev (3.2)
    #[inline(always)]
    pub(crate) fn plain_rate(&self, x: &[T; STATES], u: &[T], dx: &mut [T; STATES]) {
        if let Some(Acting { usual, .. }) = &self.acting {
            self.plain_rate_under(usual, x, u, dx);
        }
    }

    /// The same under forces that are not those of the body.
    #[inline(always)]
    pub(crate) fn plain_rate_under(&self, usual: &Usual<T>, x: &[T; STATES], u: &[T], dx: &mut [T; STATES]) {
        let given = Given { t: T::zero(), x, states: &[], u };
        self.rate_with(
            usual,
            given,
            dx,
            #[inline(always)]
            |_, wrench| wrench,
        );
    }

    /// dx = f(x, u, t) of a body that is plain but for a law; whether this is one.
    #[inline(always)]
    pub(super) fn write_lawful_rate(&self, t: T, x: &[T], u: &[T], dx: &mut [T]) -> bool {
        let Some(Acting { usual, law: Some(law), .. }) = self.plain_forces() else { return false };
        let (Some((x, states)), Some((dx, rates))) = (x.split_first_chunk(), dx.split_first_chunk_mut())
        else {
            return false;
        };
        T::call(
            #[inline(always)]
            || {
                self.rate_with(
                    usual,
                    Given { t, x, states, u },
                    dx,
                    #[inline(always)]
                    |s, wrench| wrench + law.about_com(s, rates),
                );
            },
        );
        true
    }

    /// Under the usual forces, to whose wrench about the mass centre `more` adds what there is.
    #[inline(always)]
    fn rate_with(
        &self,
        usual: &Usual<T>,
        Given { t: time, x, states, u: inputs }: Given<'_, T>,
        dx: &mut [T; STATES],
        more: impl FnOnce(&Situation<'_, T>, Screw<T>) -> Screw<T>,
    ) {
        let [x, y, z, q0, q1, q2, q3, v @ .., p, q, r] = x;
        let orientation = [*q0, *q1, *q2, *q3];
        let twist = Screw::new(Vec3::from_array(*v), Vec3::new(*p, *q, *r));
        let rotation = rotation_from_quaternion(orientation);
        let inertia = &self.inertia;
        let position = Vec3::new(*x, *y, *z);
        let s = Situation { time, position, rotation, twist, inertia, inputs, states };
        let wrench = more(&s, usual.about_com(&s));
        let rate = acceleration_about_com(inertia, twist, wrench, usual.field(&s));
        rotation.apply(twist.linear).store(dx);
        dx[3..7].copy_from_slice(&quaternion_rate(orientation, twist.angular));
        rate.store(&mut dx[7..]);
    }
}

/// What f is given.
struct Given<'a, T> {
    t: T,
    x: &'a [T; STATES],
    /// The auxiliary states.
    states: &'a [T],
    u: &'a [T],
}
