//! Why a derivative does not exist.

use crate::errors;
use crate::model::Model;
use freebody_core::phase_space::Chart;
use pyo3::prelude::*;

impl Model {
    /// Whether a state stands at the singularity of its angles.
    pub fn is_singular(&self, x: &[f64]) -> bool {
        // Nearer than a step of its own doubles, the second angle cannot be told from the singular one.
        let step = |angle: f64| f64::max(1e-15, f64::EPSILON * angle.abs());
        self.free_body.singularity_distance(x).is_some_and(|distance| distance < step(x[4]))
    }

    /// What to raise for such a state; `place` says where, "" or "at ...: ".
    pub fn singular(&self, py: Python<'_>, place: &str, x: &[f64]) -> PyErr {
        let name = if let Chart::Angles(sequence) = self.free_body.chart { sequence.name() } else { "" };
        errors::singular_chart(
            py,
            format!(
                "{place}the second angle of '{name}' is {} rad = {} deg, where the angle rates do not exist; use \
                 another sequence or attitude=\"quaternion\"",
                x[4],
                x[4].to_degrees()
            ),
        )
    }

    /// Why the derivative does not exist at finite arguments.
    pub fn diagnose(&self, py: Python<'_>, t: f64, x: &[f64], u: &[f64]) -> PyErr {
        if self.is_singular(x) {
            return self.singular(py, &format!("at t = {t} s "), x);
        }
        let culprit = match self.calling(|| self.free_body.culprit(t, x, u)) {
            Ok(culprit) => culprit,
            Err(raised) => return raised,
        };
        let forces = &self.free_body.forces;
        let source = match culprit {
            Some(i) => {
                let name = &self.law_names[i];
                let mut contents = self.free_body.left.iter().flat_map(|left| &left.contents);
                match forces.get(i) {
                    Some(_) if contents.any(|own| own.force == i) => {
                        format!(
                            "force '{name}', its wrench, its contents or its states' rates, is not finite"
                        )
                    }
                    Some(f) if f.states().is_empty() => format!("the wrench of force '{name}' is not finite"),
                    Some(_) => format!("force '{name}', its wrench or its states' rates, is not finite"),
                    None => format!("control law '{name}' is not finite"),
                }
            }
            None => "the motion or the sum of its wrenches is too large for doubles".to_owned(),
        };
        errors::non_finite(py, format!("the derivative is not finite at t = {t} s, x = {x:?}: {source}"))
    }
}
