//! Samples of a phase in its steps. Each place is evaluated once for all that asks for it: the
//! nodes of the fits at the beginning of a step, and in a phase with multipliers, where reactions
//! are solutions of the augmented equations, each place between them.

use std::collections::HashMap;

use super::sample::{Quantities, Sample, Scratch};
use super::step::StepView;
use crate::context::Numbers;
use crate::model::{Form, Layout};
use crate::numerics::root_isolation::NODES;

/// So many places between the nodes of a step are kept.
const MOST: usize = 4096;

/// The samples of a phase.
pub(crate) struct Samples {
    layout: &'static Layout,
    /// What is evaluated at the nodes, and its samples at the first of them.
    at_nodes: Quantities,
    nodes: Vec<Sample>,
    /// The node that is asked for next, where they are in order.
    next: usize,
    /// The reduced states at the start of this step and at the end of the last one.
    start: Numbers,
    end: Numbers,
    /// What is evaluated between the nodes for all that follows from reactions, and its samples by
    /// place.
    between_nodes: Quantities,
    between: HashMap<u64, Sample>,
    /// At a place that is not kept.
    single: Sample,
    pub(super) scratch: Scratch,
}

impl Samples {
    pub(super) fn new(layout: &'static Layout) -> Self {
        Self {
            layout,
            at_nodes: Quantities::NONE,
            nodes: Vec::new(),
            next: 0,
            start: Numbers::new(),
            end: Numbers::new(),
            between_nodes: Quantities::NONE,
            between: HashMap::new(),
            single: Sample::new(layout),
            scratch: Scratch::new(layout),
        }
    }

    /// Evaluates what a phase begins with.
    pub(super) fn begin(&mut self, start: &StepView<'_>, asked: Quantities) {
        self.at_nodes = asked;
        self.nodes.resize_with(1, || Sample::new(self.layout));
        start.sample(0.0, asked, &mut self.nodes[0], &mut self.scratch);
    }

    /// Evaluates at all nodes of a step what some guards follow from; what the last step ended with
    /// is not computed again.
    pub(super) fn begin_step(
        &mut self,
        step: &StepView<'_>,
        asked: impl Iterator<Item = Quantities> + Clone,
    ) {
        let before = self.at_nodes;
        self.at_nodes = asked.clone().fold(Quantities::NONE, Quantities::and);
        self.between.clear();
        self.between_nodes = Quantities::NONE;
        if self.at_nodes == Quantities::NONE {
            return;
        }
        if step.form() == Form::Multipliers {
            let mut sharing = asked.filter(|asked| is_shared(*asked));
            if let (Some(first), Some(second)) = (sharing.next(), sharing.next()) {
                self.between_nodes = sharing.fold(first.and(second), Quantities::and);
            }
        }
        self.nodes.resize_with(NODES.len(), || Sample::new(self.layout));
        step.reduced(0.0, &mut self.start);
        let continues = before == self.at_nodes && !self.start.is_empty() && self.start == self.end;
        if continues {
            let last = NODES.iter().rposition(|theta| *theta == 1.0).unwrap_or(0);
            self.nodes.swap(0, last);
        }
        for (theta, node) in NODES.iter().zip(&mut self.nodes).skip(usize::from(continues)) {
            step.sample(*theta, self.at_nodes, node, &mut self.scratch);
        }
        step.reduced(1.0, &mut self.end);
    }

    /// At the nodes of the step, if that is evaluated there.
    pub(super) fn at_nodes(&self, asked: Quantities) -> Option<&[Sample; NODES.len()]> {
        self.nodes.as_slice().try_into().ok().filter(|_| self.at_nodes.contains(asked))
    }

    /// At a place of the step.
    pub(super) fn evaluate(&mut self, step: &StepView<'_>, theta: f64, asked: Quantities) -> &Sample {
        if self.at_nodes.contains(asked)
            && let Some(node) = self.find_node(theta)
        {
            return &self.nodes[node];
        }
        let Self { layout, between_nodes, between, single, scratch, .. } = self;
        if !(is_shared(asked) && between_nodes.contains(asked)) {
            step.sample(theta, asked, single, scratch);
            return single;
        }
        if between.len() >= MOST {
            between.clear();
        }
        between.entry(theta.to_bits()).or_insert_with(|| {
            let mut sample = Sample::new(layout);
            step.sample(theta, *between_nodes, &mut sample, scratch);
            sample
        })
    }

    fn find_node(&mut self, theta: f64) -> Option<usize> {
        let nodes = &NODES[..self.nodes.len()];
        let found = match nodes.get(self.next) {
            Some(next) if *next == theta => self.next,
            _ => nodes.iter().position(|node| *node == theta)?,
        };
        self.next = (found + 1) % NODES.len();
        Some(found)
    }
}

/// Whether it is kept between the nodes: the margin of a grip keeps its own last value.
fn is_shared(asked: Quantities) -> bool {
    asked.contains(Quantities::REACTIONS) && !asked.contains(Quantities::GRIP)
}
