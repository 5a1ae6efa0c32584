//! Drawing the bars of a scheme: trees with hinges at ends and on bars, chains, parallelograms.

use std::collections::BTreeMap;

use super::parameters::Parameters;
use super::quantity::Quantity;
use super::scheme::{Bar, Chain, Gravity, Heading, Pair, Scheme, Spot};
use super::splitmix::Source;

const POINTS: [&str; 8] = [
    "hip", "knee", "foot", "toe", "hand", "elbow", "neck", "head",
];
const BARS: [&str; 8] = [
    "thigh", "shin", "sole", "arm", "rod", "boom", "strut", "lever",
];
const HEADINGS: [(i32, i32, i32); 8] = [
    (1, 0, 1),
    (0, 1, 1),
    (3, 4, 5),
    (4, 3, 5),
    (5, 12, 13),
    (12, 5, 13),
    (8, 15, 17),
    (15, 8, 17),
];

/// A scheme in the making.
pub struct Builder<'a> {
    pub draw: &'a mut Source,
    pub scheme: Scheme,
    /// Component of each point.
    pub components: BTreeMap<String, usize>,
    /// Pairs of bars drawn with the same or a mirrored heading.
    pub twins: Vec<(usize, usize)>,
    words: bool,
}

impl<'a> Builder<'a> {
    pub fn new(draw: &'a mut Source) -> Self {
        let share = draw.of(&[0.2, 0.6, 0.9]);
        let scheme = Scheme {
            parameters: Parameters {
                share,
                ..Parameters::default()
            },
            gravity: Gravity::None,
            bars: Vec::new(),
            chains: Vec::new(),
            spots: Vec::new(),
            masses: Vec::new(),
            pins: Vec::new(),
            supports: Vec::new(),
            ties: Vec::new(),
            coordinates: Vec::new(),
            figure: BTreeMap::new(),
        };
        let words = draw.chance(0.3);
        Self {
            draw,
            scheme,
            components: BTreeMap::new(),
            twins: Vec::new(),
            words,
        }
    }

    /// One to six bars in one component, rarely two.
    pub fn bars(&mut self) {
        let count = 1 + self.draw.below(6);
        let apart = if count > 1 && self.draw.chance(0.08) {
            1 + self.draw.below(count - 1)
        } else {
            0
        };
        self.root(0);
        while self.scheme.bars.len() < count {
            let start = self.scheme.bars.len();
            let begins = start > 0 && apart == start && self.components.values().all(|&c| c == 0);
            let at = if begins { self.root(1) } else { self.place() };
            match start {
                1.. if !begins && self.draw.chance(0.06) => self.chain(&at),
                2.. if !begins && self.draw.chance(0.12) => self.parallelogram(),
                _ => self.bar(&at),
            }
        }
    }

    fn root(&mut self, component: usize) -> String {
        let at = [0, 1].map(|_| self.scheme.parameters.signed(self.draw, "h"));
        self.point(at, component)
    }

    fn point(&mut self, at: Pair, component: usize) -> String {
        let index = self.scheme.figure.len();
        let name = match self.words {
            true if index < POINTS.len() => POINTS[index].to_string(),
            _ => char::from(b'A' + index as u8).to_string(),
        };
        self.components.insert(name.clone(), component);
        self.scheme.figure.insert(name.clone(), at);
        name
    }

    /// An existing point, or a new one on a bar.
    fn place(&mut self) -> String {
        let known: Vec<_> = self.scheme.figure.keys().cloned().collect();
        let single = |&index: &usize| self.scheme.bars[index].chain.is_none();
        let bars: Vec<_> = (0..self.scheme.bars.len()).filter(single).collect();
        if bars.is_empty() || !self.draw.chance(0.2) {
            let point = self.draw.of(&known);
            self.give(&point);
            return point;
        }
        let bar = self.draw.of(&bars);
        self.spot(bar)
    }

    /// What hangs on a chain cannot be inferred without its points.
    fn give(&mut self, point: &str) {
        let ends = self.scheme.bars.iter().filter(|bar| bar.to == point);
        for chain in ends.filter_map(|bar| bar.chain) {
            self.scheme.chains[chain].drawn = true;
        }
    }

    /// A named point on a bar.
    fn spot(&mut self, index: usize) -> String {
        let bar = self.scheme.bars[index].clone();
        let along = bar.length.scaled(1 + self.draw.below(3) as i32, 4);
        let across = self
            .draw
            .chance(0.3)
            .then(|| Quantity::literal(self.draw.of(&[-20, 15, 30])));
        let zero = Quantity::literal(0);
        let first = &self.scheme.figure[&bar.from];
        let at = bar
            .heading
            .walk(first, &along, across.as_ref().unwrap_or(&zero));
        let name = self.point(at, self.components[&bar.from]);
        self.scheme.spots.push(Spot {
            name: name.clone(),
            bar: index,
            along,
            across,
        });
        name
    }

    fn heading(&mut self) -> Heading {
        let (p, q, r) = self.draw.of(&HEADINGS);
        let sign = |flip: bool| if flip { -1 } else { 1 };
        let (p, q) = (
            p * sign(self.draw.chance(0.5)),
            q * sign(self.draw.chance(0.5)),
        );
        Heading { p, q, r }
    }

    /// A heading of its own, or now and then that of an earlier bar or its mirror image.
    fn heading_of_next(&mut self) -> Heading {
        let next = self.scheme.bars.len();
        if next == 0 || !self.draw.chance(0.2) {
            return self.heading();
        }
        let twin = self.draw.below(next);
        let Heading { p, q, r } = self.scheme.bars[twin].heading;
        if self.scheme.bars[twin].chain.is_none() {
            self.twins.push((twin, next));
        }
        if self.draw.chance(0.5) {
            Heading { p, q, r }
        } else {
            Heading { p: -p, q, r }
        }
    }

    fn name(&self, from: &str, to: &str) -> String {
        match self.words || from.len() > 1 || to.len() > 1 {
            true => BARS[self.scheme.bars.len() % BARS.len()].to_string() + self.suffix(),
            false => format!("{from}{to}"),
        }
    }

    fn suffix(&self) -> &'static str {
        if self.scheme.bars.len() < BARS.len() {
            ""
        } else {
            "_b"
        }
    }

    fn bar(&mut self, at: &str) {
        let heading = self.heading_of_next();
        let length = self.scheme.parameters.positive(self.draw, "l");
        let reversed = self.draw.chance(0.3);
        let Heading { p, q, r } = heading;
        let outward = if reversed {
            Heading { p: -p, q: -q, r }
        } else {
            heading
        };
        let end = outward.walk(&self.scheme.figure[at], &length, &Quantity::literal(0));
        let end = self.point(end, self.components[at]);
        let (from, to) = if reversed {
            (end, at.to_string())
        } else {
            (at.to_string(), end)
        };
        self.push(from, to, length, heading);
    }

    fn push(&mut self, from: String, to: String, length: Quantity, heading: Heading) {
        let name = self.name(&from, &to);
        let bar = self.matter(name, [from, to], length, heading);
        self.scheme.bars.push(bar);
    }

    fn matter(
        &mut self,
        name: String,
        [from, to]: [String; 2],
        length: Quantity,
        heading: Heading,
    ) -> Bar {
        let (draw, parameters) = (&mut *self.draw, &mut self.scheme.parameters);
        if draw.chance(0.02) {
            let mass = Quantity::literal(0);
            return Bar {
                name,
                from,
                to,
                mass,
                length,
                inertia: None,
                centre: None,
                heading,
                chain: None,
            };
        }
        let mass = parameters.positive(draw, "m");
        let inertia = draw.chance(0.25).then(|| parameters.positive(draw, "j"));
        let centre = draw.chance(0.3).then(|| {
            let along = length.scaled(1 + draw.below(3) as i32, 3);
            (
                along,
                draw.chance(0.5).then(|| parameters.signed(draw, "c")),
            )
        });
        Bar {
            name,
            from,
            to,
            mass,
            length,
            inertia,
            centre,
            heading,
            chain: None,
        }
    }

    fn chain(&mut self, at: &str) {
        let chain = Chain {
            name: format!("link{}", ["", "_x", "_y"][self.scheme.chains.len() % 3]),
            links: 2 + self.draw.below(2),
            last: self.draw.chance(0.4).then(|| "tip".to_string()),
            drawn: self.draw.chance(0.6),
        };
        if self.scheme.chains.len() > 1 || self.components.contains_key("tip") {
            return;
        }
        let length = self.scheme.parameters.positive(self.draw, "l");
        let heading = self.heading();
        let mut bar = self.matter(
            String::new(),
            [String::new(), at.to_string()],
            length,
            heading,
        );
        bar.chain = Some(self.scheme.chains.len());
        for link in 1..=chain.links {
            let last = chain.last.clone().filter(|_| link == chain.links);
            let to = last.unwrap_or_else(|| format!("{}_{link}", chain.name));
            bar.from = std::mem::replace(&mut bar.to, to.clone());
            bar.name = format!("{}{link}", chain.name);
            let place = heading.walk(
                &self.scheme.figure[&bar.from],
                &bar.length,
                &Quantity::literal(0),
            );
            self.components
                .insert(to.clone(), self.components[&bar.from]);
            self.scheme.figure.insert(to, place);
            self.scheme.bars.push(bar.clone());
        }
        self.scheme.chains.push(chain);
    }

    /// Closes a loop over two bars that follow each other, with two bars equal to them.
    fn parallelogram(&mut self) {
        let bars = &self.scheme.bars;
        let follows = |&(i, j): &(usize, usize)| {
            bars[i].to == bars[j].from && bars[i].chain.is_none() && bars[j].chain.is_none()
        };
        let pairs = (0..bars.len()).flat_map(|i| (0..bars.len()).map(move |j| (i, j)));
        let candidates: Vec<_> = pairs.filter(follows).collect();
        if candidates.is_empty() {
            return;
        }
        let (i, j) = self.draw.of(&candidates);
        let (first, second) = (self.scheme.bars[i].clone(), self.scheme.bars[j].clone());
        let cross = first.heading.p * second.heading.q - first.heading.q * second.heading.p;
        if cross == 0 {
            return;
        }
        let zero = Quantity::literal(0);
        let at = second
            .heading
            .walk(&self.scheme.figure[&first.from], &second.length, &zero);
        let corner = self.point(at, self.components[&first.from]);
        self.push(first.from, corner.clone(), second.length, second.heading);
        self.push(corner, second.to, first.length, first.heading);
    }
}
