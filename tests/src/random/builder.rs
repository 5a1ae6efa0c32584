//! Drawing the tree of a spec: where each bar begins, hinges at ends and on bars.

use std::collections::BTreeMap;

use super::parameters::Parameters;
use super::parts::Parts;
use super::quantity::Quantity;
use super::spec::{Gravity, Heading, Pair, Spec, Spot};
use super::splitmix::Source;
use super::vocabulary::{Vocabulary, occurs};

const POINTS: [&str; 8] = ["hip", "knee", "foot", "toe", "hand", "elbow", "neck", "head"];
const BARS: [&str; 8] = ["thigh", "shin", "sole", "arm", "rod", "boom", "strut", "lever"];
const HEADINGS: [(i32, i32, i32); 8] =
    [(1, 0, 1), (0, 1, 1), (3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13), (8, 15, 17), (15, 8, 17)];

/// A, B, …, Z, then P1, P2, ….
fn letters(index: usize) -> String {
    match u8::try_from(index) {
        Ok(index @ 0..26) => char::from(b'A' + index).to_string(),
        _ => format!("P{index}"),
    }
}

/// A spec in the making.
pub struct Builder<'a> {
    pub source: &'a mut Source,
    pub spec: Spec,
    /// Component of each point.
    pub components: BTreeMap<String, usize>,
    /// Pairs of bars drawn with the same or a mirrored heading.
    pub twins: Vec<(usize, usize)>,
    /// The first point.
    pub root: String,
    /// The axis of the mirror, if the whole is to be symmetric.
    pub mirrored: Option<usize>,
    pub vocabulary: Vocabulary,
    words: bool,
}

impl<'a> Builder<'a> {
    pub fn new(source: &'a mut Source, vocabulary: Vocabulary) -> Self {
        let share = source.choose(&[0.2, 0.6, 0.9]);
        let spec = Spec {
            parameters: Parameters { share, ..Parameters::default() },
            gravity: Gravity::None,
            bars: Vec::new(),
            chains: Vec::new(),
            spots: Vec::new(),
            masses: Vec::new(),
            pins: Vec::new(),
            supports: Vec::new(),
            ties: Vec::new(),
            coordinates: Vec::new(),
            mirror: None,
            parts: Parts::default(),
            figure: BTreeMap::new(),
        };
        let words = source.chance(0.3);
        Self {
            source,
            spec,
            components: BTreeMap::new(),
            twins: Vec::new(),
            root: String::new(),
            mirrored: None,
            vocabulary,
            words,
        }
    }

    /// One to six bars in one component, rarely two.
    pub fn bars(&mut self) {
        let count = 1 + self.source.below(6);
        let apart = if count > 1 && self.source.chance(0.08) { 1 + self.source.below(count - 1) } else { 0 };
        self.root = self.root(0);
        while self.spec.bars.len() < count {
            let start = self.spec.bars.len();
            let begins = start > 0 && apart == start && self.components.values().all(|&c| c == 0);
            let at = if begins { self.root(1) } else { self.choose_point() };
            match start {
                1.. if !begins && self.source.chance(0.06) => self.chain(&at),
                2.. if !begins && self.source.chance(0.12) => self.parallelogram(),
                _ => self.bar(&at),
            }
        }
    }

    fn root(&mut self, component: usize) -> String {
        let at = [0, 1].map(|_| self.spec.parameters.signed(self.source, "h"));
        self.point(at, component)
    }

    pub(super) fn point(&mut self, at: Pair, component: usize) -> String {
        let index = self.spec.figure.len();
        let name = match self.words {
            true if index < POINTS.len() => POINTS[index].to_string(),
            _ => letters(index),
        };
        self.components.insert(name.clone(), component);
        self.spec.figure.insert(name.clone(), at);
        name
    }

    /// An existing point, or a new one on a bar.
    pub(super) fn choose_point(&mut self) -> String {
        let known: Vec<_> = self.spec.figure.keys().cloned().collect();
        let single =
            |&index: &usize| self.spec.bars[index].chain.is_none() && self.spec.bars[index].corner.is_none();
        let bars: Vec<_> = (0..self.spec.bars.len()).filter(single).collect();
        if bars.is_empty() || !self.source.chance(0.2) {
            let point = self.source.choose(&known);
            self.give(&point);
            return point;
        }
        let bar = self.source.choose(&bars);
        self.spot(bar)
    }

    /// What hangs on a chain cannot be inferred without its points.
    fn give(&mut self, point: &str) {
        let ends = self.spec.bars.iter().filter(|bar| bar.to == point);
        for chain in ends.filter_map(|bar| bar.chain) {
            self.spec.chains[chain].drawn = true;
        }
    }

    /// A named point on a bar.
    fn spot(&mut self, index: usize) -> String {
        let bar = self.spec.bars[index].clone();
        let along = bar.length.scaled(1 + self.source.below(3) as i32, 4);
        let across = self.source.chance(0.3).then(|| Quantity::literal(self.source.choose(&[-20, 15, 30])));
        let depth = |across: &Option<Quantity>| across.as_ref().map_or(0.0, |q| q.value);
        let same = |spot: &&Spot| {
            spot.bar == index && spot.along.value == along.value && depth(&spot.across) == depth(&across)
        };
        if let Some(spot) = self.spec.spots.iter().find(same) {
            return spot.name.clone();
        }
        let zero = Quantity::literal(0);
        let first = &self.spec.figure[&bar.from];
        let at = bar.heading.walk(first, &along, across.as_ref().unwrap_or(&zero));
        let name = self.point(at, self.components[&bar.from]);
        self.spec.spots.push(Spot { name: name.clone(), bar: index, along, across });
        name
    }

    pub(super) fn heading(&mut self) -> Heading {
        let (p, q, r) = self.source.choose(&HEADINGS);
        let sign = |flip: bool| if flip { -1 } else { 1 };
        let (p, q) = (p * sign(self.source.chance(0.5)), q * sign(self.source.chance(0.5)));
        Heading { p, q, r }
    }

    /// A heading of its own, or now and then that of an earlier bar or its mirror image.
    fn heading_of_next(&mut self) -> Heading {
        let next = self.spec.bars.len();
        if next == 0 || !self.source.chance(0.2) {
            return self.heading();
        }
        let twin = self.source.below(next);
        let Heading { p, q, r } = self.spec.bars[twin].heading;
        if self.spec.bars[twin].chain.is_none() {
            self.twins.push((twin, next));
        }
        if self.source.chance(0.5) { Heading { p, q, r } } else { Heading { p: -p, q, r } }
    }

    pub(super) fn name(&self, from: &str, to: &str) -> String {
        match self.words || from.len() > 1 || to.len() > 1 {
            true => BARS[self.spec.bars.len() % BARS.len()].to_string() + self.suffix(),
            false => format!("{from}{to}"),
        }
    }

    fn suffix(&self) -> &'static str {
        if self.spec.bars.len() < BARS.len() { "" } else { "_b" }
    }

    /// The heading of a bar at the point, turned by quarters: what a weld can hold.
    fn turned(&mut self, at: &str) -> Option<Heading> {
        let bars = &self.spec.bars;
        let bar =
            (0..bars.len()).find(|&i| bars[i].chain.is_none() && (bars[i].from == at || bars[i].to == at));
        let index = bar.filter(|_| occurs(self.source, self.vocabulary.welds))?;
        let Heading { p, q, r } = self.spec.bars[index].heading;
        Some(self.source.choose(&[(p, q), (-q, p), (-p, -q), (q, -p)])).map(|(p, q)| Heading { p, q, r })
    }

    pub(super) fn bar(&mut self, at: &str) {
        let heading = match self.turned(at) {
            Some(heading) => heading,
            None => self.heading_of_next(),
        };
        let length = self.spec.parameters.positive(self.source, "l");
        let reversed = self.source.chance(0.3);
        let Heading { p, q, r } = heading;
        let outward = if reversed { Heading { p: -p, q: -q, r } } else { heading };
        let end = outward.walk(&self.spec.figure[at], &length, &Quantity::literal(0));
        let end = self.point(end, self.components[at]);
        let (from, to) = if reversed { (end, at.to_string()) } else { (at.to_string(), end) };
        self.push(from, to, length, heading);
    }
}
