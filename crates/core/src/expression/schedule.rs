//! From a graph to a tape: which instructions, in which order, on which registers.

use super::graph::Graph;
use super::node::{Id, Operation};
use super::tape::{Code, Tape};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// An instruction before it has registers.
#[derive(Clone, Debug)]
struct Step {
    code: Code,
    /// What it computes: one node, or the sine and the cosine of one.
    results: Vec<Id>,
    operands: Vec<Id>,
}

impl Tape {
    /// The tape that computes `outputs`; `given` and `constants` are nodes whose values are there when it starts.
    ///
    /// None if it has more values than it can number.
    pub fn of(graph: &Graph, given: &[Id], constants: &[Id], outputs: &[Id]) -> Option<Self> {
        let ready: Vec<Id> = given.iter().chain(constants).copied().collect();
        let steps = in_runs(steps(graph, &ready, outputs), &ready);
        numbered(given.len(), &ready, &steps, outputs)
    }
}

/// Products that are only added to something go into one instruction with the sum.
fn steps(graph: &Graph, ready: &[Id], outputs: &[Id]) -> Vec<Step> {
    let mut is_ready = vec![false; graph.nodes.len()];
    for id in ready {
        is_ready[*id as usize] = true;
    }
    let order = graph.order_beyond(&is_ready, outputs);
    let mut uses = vec![0usize; graph.nodes.len()];
    for id in &order {
        for o in graph.node(*id).operands() {
            uses[*o as usize] += 1;
        }
    }
    for id in outputs {
        uses[*id as usize] += 1;
    }
    let mut fusion = Fusion { graph, is_ready, uses, swallowed: vec![false; graph.nodes.len()] };
    let mut fused = HashMap::new();
    // From the results down, so that what is swallowed swallows nothing itself.
    for id in order.iter().rev().filter(|id| !graph.node(**id).operands().is_empty()) {
        if !fusion.swallowed[*id as usize]
            && let Some(step) = fusion.of(*id)
        {
            fused.insert(*id, step);
        }
    }
    let swallowed = fusion.swallowed;
    let mut turns: BTreeMap<Id, usize> = BTreeMap::new();
    let mut steps: Vec<Step> = Vec::new();
    for id in order.into_iter().filter(|id| !swallowed[*id as usize]) {
        let node = graph.node(id);
        if let Some((code, operands)) = fused.remove(&id) {
            steps.push(Step { code, results: vec![id], operands });
            continue;
        }
        let code = Code::of(node.operation);
        if code != Code::SinCos {
            steps.push(Step { code, results: vec![id], operands: node.operands().to_vec() });
            continue;
        }
        // Sine and cosine of one angle come together; what stands for the one that nobody wants is the angle.
        let angle = node.operands[0];
        let place = *turns.entry(angle).or_insert_with(|| {
            steps.push(Step { code, results: vec![Id::MAX; 2], operands: vec![angle] });
            steps.len() - 1
        });
        steps[place].results[usize::from(node.operation == Operation::Cos)] = id;
    }
    steps
}

/// Operations that go into the one instruction that alone works on them.
struct Fusion<'a> {
    graph: &'a Graph,
    is_ready: Vec<bool>,
    uses: Vec<usize>,
    swallowed: Vec<bool>,
}

impl Fusion<'_> {
    /// The operands of a node that nothing else works on, if it is of this operation.
    fn lone(&self, id: Id, operation: Operation) -> Option<[Id; 2]> {
        let node = self.graph.node(id);
        let lone = node.operation == operation && self.uses[id as usize] == 1 && !self.is_ready[id as usize];
        lone.then(|| [node.operands[0], node.operands[1]])
    }

    /// The instruction of a node together with operands of it.
    fn of(&mut self, id: Id) -> Option<(Code, Vec<Id>)> {
        let node = self.graph.node(id);
        let [a, b, ..] = node.operands;
        let inner = if node.operation == Operation::Sub { Operation::Mul } else { node.operation };
        let (code, operands) = match node.operation {
            Operation::Add | Operation::Sub => {
                let add = node.operation == Operation::Add;
                match (self.lone(a, Operation::Mul), self.lone(b, Operation::Mul)) {
                    (Some([w, x]), Some([y, z])) if a != b => {
                        self.swallow(&[a, b]);
                        (if add { Code::MulMulAdd } else { Code::MulMulSub }, vec![w, x, y, z])
                    }
                    (Some([x, y]), _) => {
                        self.swallow(&[a]);
                        (if add { Code::MulAdd } else { Code::MulSub }, vec![x, y, b])
                    }
                    (_, Some([x, y])) => {
                        self.swallow(&[b]);
                        (if add { Code::MulAdd } else { Code::NegMulAdd }, vec![x, y, a])
                    }
                    _ if add => self.three(Code::Add3, inner, a, b)?,
                    _ => return None,
                }
            }
            Operation::Mul => self.three(Code::Mul3, inner, a, b)?,
            _ => return None,
        };
        Some((code, operands))
    }

    /// An operation on the result of the same operation.
    fn three(&mut self, code: Code, operation: Operation, a: Id, b: Id) -> Option<(Code, Vec<Id>)> {
        for (inner, other) in [(a, b), (b, a)] {
            if let Some([x, y]) = self.lone(inner, operation) {
                self.swallow(&[inner]);
                return Some((code, vec![x, y, other]));
            }
        }
        None
    }

    fn swallow(&mut self, ids: &[Id]) {
        for id in ids {
            self.swallowed[*id as usize] = true;
        }
    }
}

/// The same steps in runs of one code: the code goes first that the longest way to a result waits for.
fn in_runs(steps: Vec<Step>, ready: &[Id]) -> Vec<Step> {
    let mut maker: HashMap<Id, usize> = HashMap::new();
    for (i, step) in steps.iter().enumerate() {
        maker.extend(step.results.iter().map(|id| (*id, i)));
    }
    for id in ready {
        maker.remove(id);
    }
    // How many steps each still waits for, and who waits for it.
    let mut missing = vec![0; steps.len()];
    let mut waiting: Vec<Vec<usize>> = vec![Vec::new(); steps.len()];
    let mut open: BTreeMap<Code, BTreeSet<usize>> = BTreeMap::new();
    for (i, step) in steps.iter().enumerate() {
        for earlier in step.operands.iter().filter_map(|o| maker.get(o)) {
            missing[i] += 1;
            waiting[*earlier].push(i);
        }
        if missing[i] == 0 {
            open.entry(step.code).or_default().insert(i);
        }
    }
    // How long the way from each step to the results is.
    let mut ways = vec![0; steps.len()];
    for i in (0..steps.len()).rev() {
        let behind = waiting[i].iter().map(|later| ways[*later]).max().unwrap_or(0);
        ways[i] = behind + steps[i].code.latency();
    }
    let longest = |steps: &BTreeSet<usize>| steps.iter().map(|i| ways[*i]).max();
    let mut sorted = Vec::with_capacity(steps.len());
    while let Some((code, _)) = open.iter().max_by_key(|(_, steps)| longest(steps)) {
        let code = *code;
        for i in open.remove(&code).unwrap_or_default() {
            for later in &waiting[i] {
                missing[*later] -= 1;
                if missing[*later] == 0 {
                    open.entry(steps[*later].code).or_default().insert(*later);
                }
            }
            sorted.push(steps[i].clone());
        }
    }
    sorted
}

/// The tape of steps: each result is the next value.
fn numbered(given: usize, ready: &[Id], steps: &[Step], outputs: &[Id]) -> Option<Tape> {
    let mut tape = Tape { given, constants: ready.len() - given, ..Tape::default() };
    let mut places: HashMap<Id, u16> = HashMap::new();
    for id in ready {
        // What is given twice is read at its first place.
        places.entry(*id).or_insert(tape.values);
        tape.values = tape.values.checked_add(1)?;
    }
    for step in steps {
        let mut operands = [0; 4];
        for (o, id) in operands.iter_mut().zip(&step.operands) {
            *o = places[id];
        }
        tape.instructions.push(operands);
        match tape.runs.last_mut() {
            Some((code, count)) if *code == step.code => *count += 1,
            _ => tape.runs.push((step.code, 1)),
        }
        for id in &step.results {
            places.insert(*id, tape.values);
            tape.values = tape.values.checked_add(1)?;
        }
    }
    tape.results = outputs.iter().map(|id| places[id]).collect();
    Some(tape)
}
