//! The values of laws along a motion, with their rates.

use crate::forces::Traced;
use crate::phase_space::FreeBody;
use crate::scalar::{Dual, Lane, Real};
use crate::simulate::Motion;
use std::ops::Range;

/// A value and its rate along the motion.
pub type Reading<T> = Dual<T, 1>;

/// Laws, and what they need to look at a motion.
pub struct Seer<T> {
    laws: Vec<Traced<Reading<T>>>,
    /// Without its forces; none before the first motion.
    body: Option<FreeBody<Reading<T>>>,
    /// Room for a state with its rate, all inputs, and the rates of the auxiliary states.
    along: Vec<Reading<T>>,
    inputs: Vec<Reading<T>>,
    auxiliary: Vec<Reading<T>>,
}

impl<T: Lane> Seer<T> {
    /// Of the same laws in all lanes; call inside [`Real::call`].
    #[inline(always)]
    pub fn new<'a>(laws: impl Iterator<Item = &'a Traced<f64>>) -> Self {
        let mut lifted = Vec::new();
        for law in laws {
            lifted.push(law.map(&mut Reading::lit));
        }
        Self { laws: lifted, body: None, along: Vec::new(), inputs: Vec::new(), auxiliary: Vec::new() }
    }

    /// Takes over the parameters of a motion.
    #[inline(always)]
    pub fn renew(&mut self, motion: &Motion<'_, T>) {
        self.body = Some(motion.body.map_without_forces(&mut Reading::constant));
    }

    /// Reads all laws at (t, y), where the state has the rate `dy`.
    #[inline(always)]
    pub fn read(&mut self, motion: &Motion<'_, T>, t: T, y: &[T], dy: &[T], out: &mut [Reading<T>]) {
        let all = 0..self.laws.len();
        self.run(motion, t, (y, dy), all, out);
    }

    /// The same of one law.
    #[inline(always)]
    pub fn read_one(&mut self, motion: &Motion<'_, T>, t: T, y: &[T], dy: &[T], law: usize) -> Reading<T> {
        let mut out = [Reading::zero()];
        self.run(motion, t, (y, dy), law..law + 1, &mut out);
        out[0]
    }

    #[inline(always)]
    fn run(
        &mut self,
        motion: &Motion<'_, T>,
        t: T,
        (y, dy): (&[T], &[T]),
        laws: Range<usize>,
        out: &mut [Reading<T>],
    ) {
        T::call(
            #[inline(always)]
            || {
                let Some(body) = &mut self.body else { return };
                (body.chart, body.form) = (motion.body.chart, motion.body.form);
                self.along.clear();
                for (y, dy) in y.iter().zip(dy) {
                    self.along.push(Reading { value: *y, slope: [*dy] });
                }
                let (u, zero) = (motion.input_count(), Reading::zero());
                let commands = body.control.as_ref().map_or(0, Traced::result_count);
                self.inputs.resize(u + commands, zero);
                self.auxiliary.resize(y.len() - body.rigid_size(), zero);
                motion.inputs_along(t, &mut self.inputs[..u]);
                let t = Reading { value: t, slope: [T::one()] };
                let mut room = None;
                let sight = body.sight(t, &self.along, &mut self.inputs, &mut self.auxiliary, &mut room);
                for (law, out) in self.laws[laws].iter().zip(out) {
                    *out = law.value(&sight);
                }
            },
        );
    }
}
