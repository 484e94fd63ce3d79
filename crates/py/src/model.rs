//! `Model`: what it is made of, and what can be read off states.

use crate::body::RigidBody;
use crate::compiled::Compiled;
use crate::errors;
use crate::forces::Force;
use crate::laws::{Control, place};
use crate::left::{LeftArguments, left};
use freebody_core::algebra::Vec3;
use freebody_core::charts::Sequence;
use freebody_core::evaluate::Evaluator;
use freebody_core::forces::Force as Element;
use freebody_core::phase_space::{Chart, Dynamics, Form, FreeBody, RigidState};
use freebody_core::screw::Screw;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// The core of a model; `freebody.Model` adds names and checks.
#[pyclass(subclass, frozen, module = "freebody._core")]
pub struct Model {
    pub free_body: FreeBody<f64>,
    pub evaluator: Evaluator,
    /// Of the forces, and behind them of the control law.
    pub law_names: Vec<String>,
    pub states: usize,
    pub inputs: usize,
    /// The place of a force that Python computes.
    pub callback: Option<usize>,
}

type Array1<'py> = Bound<'py, PyArray1<f64>>;
type Array2<'py> = Bound<'py, PyArray2<f64>>;

impl Model {
    fn rows<'a>(&self, x: &'a PyReadonlyArray2<'_, f64>) -> PyResult<Vec<&'a [f64]>> {
        if x.shape()[1] != self.states {
            let allowed = format!("x: got shape {:?}; allowed is (n, {})", x.shape(), self.states);
            return Err(errors::input(x.py(), allowed));
        }
        Ok(x.as_slice()?.chunks(self.states).collect())
    }

    /// A function of each time, state and input.
    fn each<R>(
        &self,
        t: &PyReadonlyArray1<'_, f64>,
        x: &PyReadonlyArray2<'_, f64>,
        u: &PyReadonlyArray2<'_, f64>,
        f: impl Fn(f64, &[f64], &[f64]) -> R,
    ) -> PyResult<Vec<R>> {
        let (t, rows, u) = (t.as_slice()?, self.rows(x)?, u.as_slice()?);
        let inputs = |i: usize| &u[i * self.inputs..(i + 1) * self.inputs];
        Ok(t.iter().zip(rows).enumerate().map(|(i, (t, x))| f(*t, x, inputs(i))).collect())
    }
}

#[pymethods]
impl Model {
    #[new]
    fn new(
        py: Python<'_>,
        body: &RigidBody,
        forces: Vec<Force>,
        law_names: Vec<String>,
        sequence: Option<&str>,
        generalized: bool,
        input_places: Vec<Vec<i64>>,
        n_inputs: usize,
        control: Option<Control>,
        control_places: Vec<i64>,
        left_side: Option<LeftArguments<'_>>,
        compiled: Option<Compiled>,
    ) -> PyResult<Self> {
        let mut elements: Vec<Element<f64>> = forces.into_iter().map(|f| f.0).collect();
        let mut control = control.map(|c| c.0);
        place(&mut elements, input_places, control.as_mut().map(|c| (c, control_places)));
        let chart = match sequence.and_then(Sequence::parse) {
            Some(s) => Chart::Angles(s),
            None => Chart::Quaternion,
        };
        let form = if generalized { Form::Generalized } else { Form::QuasiVelocity };
        let compiled = compiled.map(|c| c.0);
        let left = left_side.map(|given| left(py, given)).transpose()?;
        let unjoined =
            FreeBody { control, left, compiled, ..FreeBody::new(body.inertia, elements, chart, form) };
        let free_body = unjoined.made_ready();
        let evaluator = Evaluator::new(&free_body);
        let states = Dynamics::<f64>::state_size(&free_body);
        let callback = free_body.forces.iter().position(|f| matches!(f, Element::Callback(_)));
        Ok(Self { free_body, evaluator, law_names, states, inputs: n_inputs, callback })
    }

    /// How many numbers a state has.
    #[getter]
    fn n_states(&self) -> usize {
        self.states
    }

    /// How many inputs the model has.
    #[getter]
    fn n_inputs(&self) -> usize {
        self.inputs
    }

    /// Where the parameters of each force, and behind them those of the control law, stand among all.
    fn parameter_places(&self) -> Vec<(usize, usize)> {
        self.free_body.parameter_places().into_iter().map(|p| (p.start, p.end)).collect()
    }

    /// Position (n, 3), quaternion (n, 4) and twist (n, 6) of states (n, n_states).
    fn motion<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<(Array2<'py>, Array2<'py>, Array2<'py>)> {
        let rows = self.rows(&x)?;
        let n = rows.len();
        let mut parts = (Vec::new(), Vec::new(), Vec::new());
        for row in rows {
            let s = self.free_body.rigid_state(row);
            parts.0.extend(s.position.to_array());
            parts.1.extend(s.quaternion);
            parts.2.extend(s.twist.linear.to_array());
            parts.2.extend(s.twist.angular.to_array());
        }
        let array = |v: Vec<f64>, k: usize| PyArray1::from_vec(py, v).reshape([n, k]);
        Ok((array(parts.0, 3)?, array(parts.1, 4)?, array(parts.2, 6)?))
    }

    /// What the control law commands (n, n_commands) at times (n,), states (n, n_states) and inputs (n, n_inputs).
    fn commands<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
        x: PyReadonlyArray2<'py, f64>,
        u: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Array2<'py>> {
        let all = self.each(&t, &x, &u, |t, x, u| self.free_body.commands(t, x, u))?;
        let n_commands = self.free_body.control.as_ref().map_or(0, |law| law.result_count());
        PyArray1::from_vec(py, all.concat()).reshape([all.len(), n_commands])
    }

    /// The state of a motion, its auxiliary part zero; of its many angle triples the one nearest to `angles`.
    fn state_of<'py>(
        &self,
        py: Python<'py>,
        position: [f64; 3],
        quaternion: [f64; 4],
        twist: [f64; 6],
        angles: [f64; 3],
    ) -> PyResult<Array1<'py>> {
        let state =
            RigidState { position: Vec3::from_array(position), quaternion, twist: Screw::from_slice(&twist) };
        let mut x = vec![0.0; self.states];
        let mut like = vec![0.0; self.states];
        if matches!(self.free_body.chart, Chart::Angles(_)) {
            like[3..6].copy_from_slice(&angles);
        }
        if self.free_body.form == Form::Generalized && self.is_singular(&like) {
            return Err(self.singular(py, "", &like));
        }
        self.free_body.write_state(&state, &like, &mut x);
        if !x.iter().all(|v| v.is_finite()) {
            return Err(errors::input(
                py,
                format!("the motion is too large for doubles: its state would be {x:?}"),
            ));
        }
        Ok(PyArray1::from_vec(py, x))
    }

    /// Kinetic and potential energy (n,) of states at times under inputs.
    fn energies<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
        x: PyReadonlyArray2<'py, f64>,
        u: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<(Array1<'py>, Array1<'py>)> {
        let all = self.each(&t, &x, &u, |t, x, u| self.free_body.energies(t, x, u))?;
        let (kinetic, potential): (Vec<f64>, Vec<f64>) = all.into_iter().unzip();
        Ok((PyArray1::from_vec(py, kinetic), PyArray1::from_vec(py, potential)))
    }

    /// Momentum (n, 6) about the world origin, world axes, of states at times under inputs.
    fn momenta<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
        x: PyReadonlyArray2<'py, f64>,
        u: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Array2<'py>> {
        let all = self.each(&t, &x, &u, |t, x, u| {
            let mut six = [0.0; 6];
            self.free_body.momentum_world(t, x, u).store(&mut six);
            six
        })?;
        PyArray1::from_vec(py, all.concat()).reshape([all.len(), 6])
    }

    /// Mass, mass centre and inertia about it (xx, xy, xz, yy, yz, zz), (n, 10), with contents, as for `momenta`.
    fn inertias<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
        x: PyReadonlyArray2<'py, f64>,
        u: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Array2<'py>> {
        let all = self.each(&t, &x, &u, |t, x, u| {
            let own = self.free_body.inertia_at(t, x, u);
            let (r, j) = (own.com.to_array(), own.about_com.to_array());
            [&[own.mass][..], &r, &j].concat()
        })?;
        PyArray1::from_vec(py, all.concat()).reshape([all.len(), 10])
    }

    /// Distance (n,) rad of states to the singularity of their angles; None without angles.
    fn singularity_distances<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Option<Array1<'py>>> {
        let rows = self.rows(&x)?;
        let all: Option<Vec<f64>> = rows.iter().map(|r| self.free_body.singularity_distance(r)).collect();
        Ok(all.filter(|a| !a.is_empty()).map(|a| PyArray1::from_vec(py, a)))
    }
}
