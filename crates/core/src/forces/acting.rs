//! The forces of a model made ready to run: the usual ones apart, the laws of users as one, and the others.

use super::{Force, Situation, Traced, Usual};
use crate::inertia::Inertia;
use crate::scalar::Real;
use crate::screw::Screw;

/// All forces of a model.
#[derive(Clone, Debug)]
pub struct Acting<T> {
    /// The usual ones.
    pub usual: Usual<T>,
    /// All traced forces as one.
    pub law: Option<Traced<T>>,
    /// The others; traced ones among them if they could not be joined.
    pub others: Vec<Force<T>>,
}

impl Acting<f64> {
    /// Of the forces on a body, whose mass centre may be moving in it.
    pub fn new(forces: &[Force<f64>], body: &Inertia<f64>, moving: bool) -> Self {
        let laws: Vec<_> =
            forces.iter().filter_map(|f| if let Force::Traced(law) = f { Some(law) } else { None }).collect();
        let law = Traced::<f64>::joined(&laws);
        let (mut usual, mut others) = (Usual::<f64>::default(), Vec::new());
        for force in forces {
            let joined = law.is_some() && matches!(force, Force::Traced(_));
            // The usual ones act at arms that do not change.
            let fixed = matches!(force, Force::ConstantWrench(_) | Force::InputWrench(_));
            if !joined && (moving && fixed || !usual.take(force, body)) {
                others.push(force.clone());
            }
        }
        Self { usual, law, others }
    }
}

impl Acting<f64> {
    /// Whether one of them depends on the position.
    pub fn reads_position(&self) -> bool {
        self.others.iter().any(Force::reads_position) || self.law.as_ref().is_some_and(Traced::reads_position)
    }
}

impl<T: Real> Acting<T> {
    /// The sum of all wrenches but that of the law and the usual weight, in body axes about the mass centre.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        let sum = self.usual.about_com(s);
        if self.others.is_empty() { sum } else { sum + total(&self.others, s, rates) }
    }

    /// The place behind the last input that they read.
    pub fn inputs_end(&self) -> usize {
        let law = self.law.as_ref().map_or(0, |law| law.places.inputs_end());
        let others = self.others.iter().map(Force::inputs_end).max().unwrap_or(0);
        self.usual.inputs_end().max(law).max(others)
    }

    /// The place behind the last of their states.
    pub fn states_end(&self) -> usize {
        let law = self.law.as_ref().map_or(0, |law| law.places.states.end);
        self.others.iter().map(|f| f.states().end).max().unwrap_or(0).max(law)
    }

    /// The parameters passed through `f`: those of the usual forces, of the others, of the law; those of the body went
    /// before.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U, body: &Inertia<U>) -> Acting<U> {
        let usual = self.usual.map(f, body);
        let mut others = Vec::with_capacity(self.others.len());
        for force in &self.others {
            others.push(force.map(f));
        }
        let law = self.law.as_ref().map(
            #[inline(always)]
            |law| law.map(f),
        );
        Acting { usual, law, others }
    }
}

/// The sum of the wrenches of forces of any kind, in body axes about the mass centre; in code of its own.
///
/// Situation and wrench are copied, so that the originals can stay in registers.
#[inline(always)]
pub fn total<T: Real>(forces: &[Force<T>], s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
    let (s, mut six) = (*s, [T::zero(); 6]);
    T::call(
        #[inline(always)]
        || {
            let mut sum = Screw::zero();
            for f in forces {
                sum = sum + f.about_com(&s, rates);
            }
            sum.store(&mut six);
        },
    );
    Screw::from_slice(&six)
}
