//! Laws that users write: as programs that run over every scalar, or as functions compiled elsewhere.

use super::places::{Reads, Seen};
use super::wrench::about_com;
use super::{Places, Situation, Source};
use crate::expression::{Expression, Graph, Id, Piece, Program, Simplify, Values};
use crate::scalar::{Block, Real};
use crate::screw::Screw;
use std::sync::Arc;

/// A law traced from a user's function, with its parameters.
///
/// As a force its outputs are the wrench about the body origin in body axes, as a control law the commands;
/// then come the rates of its own states.
#[derive(Clone, Debug)]
pub struct Traced<T> {
    program: Arc<Program>,
    parameters: Vec<T>,
    prepared: Vec<T>,
    reads: Reads,
    /// Where the law finds its inputs and states.
    pub places: Places,
}

impl<T: Real> Traced<T> {
    /// A program with its parameters, which takes what `places` give.
    #[inline(always)]
    pub fn new(program: Arc<Program>, parameters: Vec<T>, places: Places) -> Self {
        debug_assert_eq!(program.parameter_count(), parameters.len());
        debug_assert_eq!(program.given_count(), places.given_count());
        let prepared = program.prepare(&parameters);
        let (all, mut start) = (program.reads(), 0);
        let mut reads = Reads::default();
        for (read, length) in reads.iter_mut().zip(places.lengths()) {
            *read = all[start..start + length].contains(&true);
            start += length;
        }
        Self { program, parameters, prepared, reads, places }
    }

    /// The values of its parameters.
    pub fn parameters(&self) -> &[T] {
        &self.parameters
    }

    /// How many numbers come before the rates of the states: six of a force, the commands of a control law.
    pub fn result_count(&self) -> usize {
        self.program.output_count() - self.places.states.len()
    }

    /// Whether the law depends on the position.
    pub fn reads_position(&self) -> bool {
        self.reads[1]
    }

    /// Everything that the law computes; the rates of its states are written to their places among all of them.
    #[inline(always)]
    pub fn run(&self, s: &Situation<'_, T>, seen: &mut Seen<'_, T>, values: &mut Values<T>, rates: &mut [T]) {
        seen.write(s, self.reads, &self.places.inputs);
        let [time, position, rotation, twist, body, inputs] = seen.pieces().map(Piece::of);
        let states = Piece::of(&s.states[self.places.states.clone()]);
        let given = [time, position, rotation, twist, body, inputs, states];
        self.program.run_in(
            values,
            given,
            #[inline(always)]
            || self.places.lengths(),
            &self.prepared,
        );
        let rates = &mut rates[self.places.states.clone()];
        if !rates.is_empty() {
            rates.copy_from_slice(&values.results()[self.result_count()..]);
        }
    }

    /// Writes the commands of a control law, and the rates of its states.
    #[inline(always)]
    pub fn command(&self, s: &Situation<'_, T>, commands: &mut [T], rates: &mut [T]) {
        let mut values = Values::empty();
        self.run(s, &mut Seen::new(None), &mut values, rates);
        commands.copy_from_slice(&values.results()[..commands.len()]);
    }

    /// All results of a law without states.
    #[inline(always)]
    pub fn results<const N: usize>(&self, s: &Situation<'_, T>) -> [T; N] {
        let mut values = Values::empty();
        self.run(s, &mut Seen::new(None), &mut values, &mut []);
        *values.results().first_chunk().expect("as many as the law has")
    }

    /// The one result of a law without states.
    #[inline(always)]
    pub fn value(&self, s: &Situation<'_, T>) -> T {
        let [value] = self.results(s);
        value
    }

    /// The wrench about the mass centre; the rates of its states are written.
    #[inline(always)]
    pub fn about_com(&self, s: &Situation<'_, T>, rates: &mut [T]) -> Screw<T> {
        let mut values = Values::empty();
        self.run(s, &mut Seen::new(None), &mut values, rates);
        self.wrench(&values, s)
    }

    /// The wrench about the mass centre that a run has computed.
    #[inline(always)]
    pub fn wrench(&self, values: &Values<T>, s: &Situation<'_, T>) -> Screw<T> {
        about_com(Screw::from_slice(values.results()), s)
    }

    /// Several force laws as one, which gives the sum of their wrenches; none if it were too long for one program.
    ///
    /// What a program is given then is written once for all of them, and what they share is computed once.
    pub fn joined(laws: &[&Traced<f64>]) -> Option<Traced<f64>> {
        let first = laws.iter().map(|law| law.places.states.start).min()?;
        let end = laws.iter().map(|law| law.places.states.end).max()?;
        let own =
            |source: &Source| if let Source::State(k) = source { (first..end).contains(k) } else { false };
        let mut inputs: Vec<Source> = laws.iter().flat_map(|law| law.places.inputs.iter().copied()).collect();
        inputs.retain(|source| !own(source));
        inputs.sort_unstable();
        inputs.dedup();
        let places = Places { inputs, states: first..end };
        if places.inputs.len() + places.states.len() > Places::ROOM {
            return None;
        }
        let parameters: Vec<f64> = laws.iter().flat_map(|law| law.parameters.iter().copied()).collect();

        let mut graph = Graph::new(Simplify::Safely);
        let mut symbols = |kind: &str, n: usize| -> Vec<Id> {
            (0..n).map(|i| graph.symbol(&format!("{kind}{i}"), "")).collect()
        };
        let (given, values) =
            (symbols("given", places.given_count()), symbols("parameter", parameters.len()));
        let outputs = graph.enter(|| {
            let mut wrench = [Expression::zero(); 6];
            let mut rates = vec![Expression::zero(); places.states.len()];
            let mut numbers = values.iter();
            for law in laws {
                let p: Vec<_> =
                    numbers.by_ref().take(law.parameters.len()).map(|id| Expression(*id)).collect();
                let behind = Places::MOTION + places.inputs.len();
                let inputs = law.places.inputs.iter().map(|source| match source {
                    Source::State(k) if own(source) => behind + k - first,
                    _ => Places::MOTION + places.inputs.binary_search(source).unwrap_or_default(),
                });
                let states = law.places.states.clone().map(|state| behind + state - first);
                let seen = (0..Places::MOTION).chain(inputs).chain(states).map(|i| Expression(given[i]));
                let mut out = vec![Expression::zero(); law.program.output_count()];
                law.program.run(&law.program.prepare(&p), &seen.collect::<Vec<_>>(), &mut out);
                for (sum, x) in wrench.iter_mut().zip(&out) {
                    *sum = *sum + *x;
                }
                let rates = rates[law.places.states.start - first..].iter_mut();
                rates.zip(&out[6..]).for_each(|(rate, x)| *rate = *x);
            }
            wrench.iter().chain(&rates).map(|x| x.0).collect::<Vec<Id>>()
        });
        let program = Program::new(&graph, &values, &given, &outputs).ok()?;
        Some(Traced::new(Arc::new(program), parameters, places))
    }

    /// The parameters passed through `f`.
    #[inline(always)]
    pub fn map<U: Real>(&self, f: &mut impl FnMut(T) -> U) -> Traced<U> {
        let mut parameters = Vec::with_capacity(self.parameters.len());
        for p in &self.parameters {
            parameters.push(f(*p));
        }
        let prepared = self.program.prepare(&parameters);
        let (program, places) = (self.program.clone(), self.places.clone());
        Traced { program, parameters, prepared, reads: self.reads, places }
    }
}

/// A force that a function computes which knows numbers alone, and so has no derivatives.
#[derive(Clone, Debug)]
pub struct Callback {
    /// From what a law is given to the wrench about the body origin in body axes.
    pub block: Arc<dyn Block>,
    /// Where it finds its inputs; it has no states.
    pub places: Places,
}

impl Callback {
    /// The wrench about the mass centre; not a number over scalars that are more than numbers.
    #[inline(always)]
    pub fn about_com<T: Real>(&self, s: &Situation<'_, T>) -> Screw<T> {
        let mut seen = Seen::new(None);
        seen.write(s, [true; 5], &self.places.inputs);
        let given = seen.pieces().concat();
        let mut wrench = [T::lit(f64::NAN); 6];
        T::outside(&*self.block, &given, &mut wrench);
        about_com(Screw::from_slice(&wrench), s)
    }
}
