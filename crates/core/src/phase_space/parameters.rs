//! The parameters of a body and its forces as one list of numbers.

use super::FreeBody;
use std::ops::Range;

/// Mass, mass centre, and the inertia about it (xx, xy, xz, yy, yz, zz) come first.
pub const BODY_PARAMETERS: usize = 10;

impl FreeBody<f64> {
    /// All parameters in the order in which [`FreeBody::map`] passes them on.
    pub fn parameters(&self) -> Vec<f64> {
        let mut all = Vec::new();
        self.map(&mut |p| {
            all.push(p);
            p
        });
        all
    }

    /// The same body with other parameters in that order, with those of its joined laws one by one, too.
    pub fn with_parameters(&self, all: &[f64]) -> Self {
        let mut next = all.iter();
        let mut body: Self = self.map(&mut |p| next.next().copied().unwrap_or(p));
        body.forces.clear();
        for (force, place) in self.forces.iter().zip(self.parameter_places()) {
            let mut own = all[place].iter();
            body.forces.push(force.map(&mut |p| own.next().copied().unwrap_or(p)));
        }
        body
    }

    /// Where the parameters of each force stand among all, and behind them those of the control law.
    pub fn parameter_places(&self) -> Vec<Range<usize>> {
        // Every parameter becomes its own number; where the numbers are found again is their place.
        let mut next = 0.0;
        let mut number = |_: f64| {
            next += 1.0;
            next
        };
        let mut numbered = self.clone();
        numbered.forces = self.forces.iter().map(|f| f.map(&mut number)).collect();
        numbered.control = self.control.as_ref().map(|law| law.map(&mut number));
        if self.acting.is_some() {
            numbered = numbered.made_ready();
        }
        let all = numbered.parameters().split_off(BODY_PARAMETERS);
        let mut places = Vec::new();
        let mut place = |own: &[f64]| {
            let first = own.first().and_then(|first| all.iter().position(|n| n == first));
            let first = BODY_PARAMETERS + first.unwrap_or(0);
            places.push(first..first + own.len());
        };
        for force in &numbered.forces {
            let mut own = Vec::new();
            force.map(&mut |n: f64| {
                own.push(n);
                n
            });
            place(&own);
        }
        if let Some(law) = &numbered.control {
            place(law.parameters());
        }
        places
    }
}
