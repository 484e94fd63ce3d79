//! What all threads need to know of the runs, made once.

use super::Batch;
use crate::phase_space::{Chart, Dynamics, Form, FreeBody};
use crate::simulate::limits;

/// The model as it runs, and when it must pause.
pub struct Setup<'a> {
    pub batch: &'a Batch<'a>,
    /// The model in quaternions and quasi-velocities.
    pub body: FreeBody<f64>,
    /// Whether the model has its state so itself.
    pub same: bool,
    pub runs: usize,
    /// How many numbers a state of the model has.
    pub states: usize,
    pub parameters: Vec<f64>,
    /// The times where something jumps, and the end.
    pub limits: Vec<f64>,
}

impl<'a> Setup<'a> {
    pub fn new(batch: &'a Batch<'a>) -> Self {
        let asked = batch.body;
        let same = (asked.chart, asked.form) == (Chart::Quaternion, Form::QuasiVelocity);
        let mut body = asked.in_quaternions();
        if asked.form != Form::QuasiVelocity {
            // What was compiled has the velocities of the model.
            body.compiled = None;
        }
        body.form = Form::QuasiVelocity;
        let states = Dynamics::<f64>::state_size(asked);
        let limits = limits(asked, batch.inputs, batch.span);
        let parameters = body.parameters();
        Self { batch, body, same, runs: batch.starts.len() / states.max(1), states, parameters, limits }
    }

    /// The state of a run at the start, as the model has its state.
    pub fn start(&self, run: usize) -> &[f64] {
        &self.batch.starts[run * self.states..][..self.states]
    }

    /// Writes a state of the model as it runs.
    pub fn write_running(&self, x: &[f64], y: &mut Vec<f64>) {
        y.clear();
        if self.same {
            y.extend_from_slice(x);
            return;
        }
        convert(self.batch.body, x, &self.body, None, y);
    }

    /// Writes a running state as the model has it, of many angle triples the one nearest to those of `like`.
    pub fn write_asked(&self, y: &[f64], like: &[f64], x: &mut Vec<f64>) {
        x.clear();
        if self.same {
            x.extend_from_slice(y);
            return;
        }
        convert(&self.body, y, self.batch.body, Some(like), x);
    }

    /// All parameters of a run.
    pub fn write_parameters(&self, run: usize, all: &mut Vec<f64>) {
        let places = self.batch.places;
        all.clone_from(&self.parameters);
        for (place, value) in places.iter().zip(&self.batch.values[run * places.len()..]) {
            all[*place] = *value;
        }
    }

    /// The constant inputs of a run.
    pub fn constants(&self, run: usize) -> &[f64] {
        let nominal = &self.batch.inputs.constants;
        let n = nominal.len();
        if self.batch.constants.is_empty() { nominal } else { &self.batch.constants[run * n..][..n] }
    }
}

fn convert(from: &FreeBody<f64>, x: &[f64], to: &FreeBody<f64>, like: Option<&[f64]>, y: &mut Vec<f64>) {
    y.resize(to.rigid_size(), 0.0);
    let zero;
    let like = match like {
        Some(like) => like,
        None => {
            zero = vec![0.0; to.rigid_size()];
            &zero
        }
    };
    to.write_state(&from.rigid_state(x), like, y);
    y.extend_from_slice(&x[from.rigid_size()..]);
}
