//! The free body as a system that can be integrated.

use super::laws::elsewhere;
use super::orientation::quaternion_of;
use super::parts::{Parts, Sizes};
use super::{Chart, Dynamics, Form, FreeBody};
use crate::algebra::normalized;
use crate::charts::{angular_velocity, quaternion_rate};
use crate::forces::Force;
use crate::integrators::{Block as ErrorBlock, ErrorScale};
use crate::scalar::Real;

impl<T: Real> Dynamics<T> for FreeBody<T> {
    #[inline(always)]
    fn state_size(&self) -> usize {
        let mut n = match &self.acting {
            Some(acting) => acting.states_end(),
            None => self.forces.iter().map(|f| f.states().end).max().unwrap_or(0),
        };
        if let Some(law) = &self.control {
            n = n.max(law.places.states.end);
        }
        self.rigid_size() + n
    }

    #[inline(always)]
    fn input_size(&self) -> usize {
        let n = match &self.acting {
            Some(acting) => acting.inputs_end(),
            None => self.forces.iter().map(Force::inputs_end).max().unwrap_or(0),
        };
        match &self.control {
            Some(law) => law.places.inputs_end().max(n.saturating_sub(law.result_count())),
            None => n,
        }
    }

    #[inline(always)]
    fn derivative(&self, t: T, x: &[T], u: &[T], dx: &mut [T]) {
        if let Some([block, _]) = &self.compiled
            && elsewhere(&**block, t, x, u, dx)
        {
            return;
        }
        if let Some(acting) = self.plain_forces() {
            return self.straight_rate::<true>(&acting.usual, t, x, u, dx);
        }
        // Each in code of its own: what the longer ones need on the stack costs the shorter ones time.
        let sizes = self.sizes();
        if self.left.is_some() {
            T::call(
                #[inline(always)]
                || self.rate::<true, true>(t, Parts::of(x, sizes), u, Parts::of_mut(dx, sizes)),
            );
        } else if self.has_laws() {
            T::call(
                #[inline(always)]
                || self.rate::<true, false>(t, Parts::of(x, sizes), u, Parts::of_mut(dx, sizes)),
            );
        } else {
            T::call(
                #[inline(always)]
                || self.rate::<false, false>(t, Parts::of(x, sizes), u, Parts::of_mut(dx, sizes)),
            );
        }
    }

    /// The unit quaternion back to length one, and its rate back to the tangent.
    #[inline(always)]
    fn project(&self, x: &mut [T]) {
        if self.chart != Chart::Quaternion {
            return;
        }
        let q = normalized(quaternion_of(&x[3..7]));
        x[3..7].copy_from_slice(&q);
        if self.form == Form::Generalized {
            let w = angular_velocity(q, quaternion_of(&x[10..14]));
            x[10..14].copy_from_slice(&quaternion_rate(q, w));
        }
    }

    fn error_blocks(&self) -> Vec<ErrorBlock> {
        let Sizes { orientation, turning } = self.sizes();
        let n = 3 + orientation;
        let radian = if self.chart == Chart::Quaternion { 0.5 } else { 1.0 };
        let mut blocks = vec![
            ErrorBlock { start: 0, len: 3, scale: ErrorScale::Relative },
            ErrorBlock { start: 3, len: orientation, scale: ErrorScale::Fixed(radian) },
            ErrorBlock { start: n, len: 3, scale: ErrorScale::Relative },
            ErrorBlock { start: n + 3, len: turning, scale: ErrorScale::Relative },
        ];
        for start in self.rigid_size()..self.state_size() {
            blocks.push(ErrorBlock { start, len: 1, scale: ErrorScale::Relative });
        }
        blocks
    }
}
