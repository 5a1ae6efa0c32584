//! Drawing single bars, chains and parallelograms.

use super::builder::Builder;
use super::quantity::Quantity;
use super::spec::{Bar, Chain, Heading};
use super::vocabulary::occurs;

impl Builder<'_> {
    pub(super) fn push(&mut self, from: String, to: String, length: Quantity, heading: Heading) {
        let name = self.name(&from, &to);
        let mut bar = self.matter(name, [from, to], length, heading);
        if occurs(self.source, self.vocabulary.triangles) {
            self.triangle(&mut bar);
        }
        self.spec.bars.push(bar);
    }

    /// A third corner, with the matter of a uniform triangle or another.
    fn triangle(&mut self, bar: &mut Bar) {
        if bar.mass.is_zero() {
            bar.mass = self.spec.parameters.positive(self.source, "m");
        }
        let along = bar.length.scaled(1 + self.source.below(3) as i32, 4);
        let across = Quantity::literal(self.source.choose(&[-90, -40, 50, 120]));
        let at = bar.heading.walk(&self.spec.figure[&bar.from], &along, &across);
        let corner = self.point(at, self.components[&bar.from]);
        bar.corner = Some((corner, [along, across]));
        if bar.inertia.is_some() || bar.centre.is_some() {
            let inertia = bar.inertia.take();
            bar.inertia = Some(inertia.unwrap_or_else(|| self.spec.parameters.positive(self.source, "j")));
            let (along, across) = bar.centre.take().unwrap_or_else(|| (bar.length.scaled(1, 2), None));
            bar.centre = Some((along, Some(across.unwrap_or_else(|| Quantity::literal(20)))));
        }
    }

    fn matter(&mut self, name: String, [from, to]: [String; 2], length: Quantity, heading: Heading) -> Bar {
        let (source, parameters) = (&mut *self.source, &mut self.spec.parameters);
        if source.chance(0.02) {
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
                corner: None,
            };
        }
        let mass = parameters.positive(source, "m");
        let inertia = source.chance(0.25).then(|| parameters.positive(source, "j"));
        let centre = source.chance(0.3).then(|| {
            let along = length.scaled(1 + source.below(3) as i32, 3);
            (along, source.chance(0.5).then(|| parameters.signed(source, "c")))
        });
        Bar { name, from, to, mass, length, inertia, centre, heading, chain: None, corner: None }
    }

    pub(super) fn chain(&mut self, at: &str) {
        let chain = Chain {
            name: format!("link{}", ["", "_x", "_y"][self.spec.chains.len() % 3]),
            links: 2 + self.source.below(2),
            last: self.source.chance(0.4).then(|| "tip".to_string()),
            drawn: self.source.chance(0.6),
        };
        if self.spec.chains.len() > 1 || self.components.contains_key("tip") {
            return;
        }
        let length = self.spec.parameters.positive(self.source, "l");
        let heading = self.heading();
        let mut bar = self.matter(String::new(), [String::new(), at.to_string()], length, heading);
        bar.chain = Some(self.spec.chains.len());
        for link in 1..=chain.links {
            let last = chain.last.clone().filter(|_| link == chain.links);
            let to = last.unwrap_or_else(|| format!("{}_{link}", chain.name));
            bar.from = std::mem::replace(&mut bar.to, to.clone());
            bar.name = format!("{}{link}", chain.name);
            let place = heading.walk(&self.spec.figure[&bar.from], &bar.length, &Quantity::literal(0));
            self.components.insert(to.clone(), self.components[&bar.from]);
            self.spec.figure.insert(to, place);
            self.spec.bars.push(bar.clone());
        }
        self.spec.chains.push(chain);
    }

    /// Closes a loop over two bars that follow each other, with two bars equal to them.
    pub(super) fn parallelogram(&mut self) {
        let bars = &self.spec.bars;
        let follows = |&(i, j): &(usize, usize)| {
            bars[i].to == bars[j].from && bars[i].chain.is_none() && bars[j].chain.is_none()
        };
        let pairs = (0..bars.len()).flat_map(|i| (0..bars.len()).map(move |j| (i, j)));
        let candidates: Vec<_> = pairs.filter(follows).collect();
        if candidates.is_empty() {
            return;
        }
        let (i, j) = self.source.choose(&candidates);
        let (first, second) = (self.spec.bars[i].clone(), self.spec.bars[j].clone());
        let cross = first.heading.p * second.heading.q - first.heading.q * second.heading.p;
        if cross == 0 {
            return;
        }
        let zero = Quantity::literal(0);
        let at = second.heading.walk(&self.spec.figure[&first.from], &second.length, &zero);
        let corner = self.point(at, self.components[&first.from]);
        self.push(first.from, corner.clone(), second.length, second.heading);
        self.push(corner, second.to, first.length, first.heading);
    }
}
