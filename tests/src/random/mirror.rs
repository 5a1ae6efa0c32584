//! Completing a drawn half to a mirror-symmetric whole: images of points on the line `axis = at`.
//!
//! Across a vertical line a direction θ goes to π − θ, across a horizontal one to −θ; left and
//! right of a bar change places, and so do above and below a bar across a horizontal line.

use super::builder::Builder;
use super::quantity::Quantity;
use super::spec::{Bar, Heading, Mirror, Pair, Shape, Spot, SupportSpec};

impl Builder<'_> {
    /// Now and then decides to reflect what has been drawn: three bars at most, only the root on
    /// the line, no point on an image.
    pub(super) fn halve(&mut self) {
        let axis = self.source.below(2);
        let plain = self.spec.bars.len() <= 3 && self.spec.chains.is_empty();
        let one = self.components.values().all(|&component| component == 0);
        let nominal = |at: &Pair| [at[0].nominal, at[1].nominal];
        let root = nominal(&self.spec.figure[&self.root])[axis];
        let others = || self.spec.figure.iter().filter(|(name, _)| **name != self.root);
        let apart = others().all(|(_, at)| {
            let mut image = nominal(at);
            image[axis] = 2.0 * root - image[axis];
            others().all(|(_, other)| {
                let other = nominal(other);
                (other[0] - image[0]).hypot(other[1] - image[1]) > 1e-3
            })
        });
        self.mirrored = (plain && one && apart && self.source.chance(0.2)).then_some(axis);
    }

    /// Adds the images of everything.
    pub(super) fn reflect(&mut self, axis: usize) {
        let at = self.spec.figure[&self.root][axis].clone();
        let half = self.spec.bars.len();
        let names = self.spec.figure.keys().filter(|name| **name != self.root);
        let images: Vec<_> = names.map(|name| (name.clone(), format!("{name}m"))).collect();
        let drawn = self.source.chance(0.4);
        let said = !drawn || self.source.chance(0.3);
        let mirror = Mirror { axis, at, half, root: self.root.clone(), images, said, drawn };
        self.reflect_bars(&mirror);
        let supports = std::mem::take(&mut self.spec.supports);
        for support in supports {
            let image = mirror.support(&support);
            self.spec.supports.push(support);
            self.spec.supports.extend(image);
        }
        self.spec.mirror = Some(mirror);
    }

    fn reflect_bars(&mut self, mirror: &Mirror) {
        let spec = &mut self.spec;
        for (point, image) in &mirror.images {
            let at = mirror.position(&spec.figure[point]);
            spec.figure.insert(image.clone(), at);
        }
        let bars: Vec<_> = spec.bars.iter().map(|bar| mirror.bar(bar)).collect();
        spec.bars.extend(bars);
        let spots: Vec<_> = spec.spots.iter().map(|spot| mirror.spot(spot)).collect();
        spec.spots.extend(spots);
        let off = |point: &&String| **point != mirror.root;
        let pins: Vec<_> = spec.pins.iter().filter(off).map(|p| mirror.point(p)).collect();
        spec.pins.extend(pins);
        let masses = spec.masses.iter().filter(|(point, _)| *point != mirror.root);
        let masses: Vec<_> = masses.map(|(point, m)| (mirror.point(point), m.clone())).collect();
        spec.masses.extend(masses);
    }
}

impl Mirror {
    fn point(&self, name: &str) -> String {
        let image = self.images.iter().find(|(point, _)| point == name);
        image.map_or_else(|| name.to_string(), |(_, image)| image.clone())
    }

    /// 2 at − x.
    fn across(&self, x: &Quantity) -> Quantity {
        match (self.at.is_zero(), x.is_zero()) {
            (true, true) => x.clone(),
            (true, false) => x.negated(),
            (false, true) => self.at.scaled(2, 1),
            (false, false) => self.at.scaled(2, 1).minus(x),
        }
    }

    fn position(&self, at: &Pair) -> Pair {
        let mut image = at.clone();
        image[self.axis] = self.across(&at[self.axis]);
        image
    }

    fn bar(&self, bar: &Bar) -> Bar {
        let Heading { p, q, r } = bar.heading;
        let heading = match self.axis {
            0 => Heading { p: -p, q, r },
            _ => Heading { p, q: -q, r },
        };
        let other_side = |(along, across): &(Quantity, Option<Quantity>)| {
            (along.clone(), across.as_ref().map(Quantity::negated))
        };
        Bar {
            name: format!("{}_m", bar.name),
            from: self.point(&bar.from),
            to: self.point(&bar.to),
            centre: bar.centre.as_ref().map(other_side),
            heading,
            corner: bar
                .corner
                .as_ref()
                .map(|(point, [along, across])| (self.point(point), [along.clone(), across.negated()])),
            ..bar.clone()
        }
    }

    fn spot(&self, spot: &Spot) -> Spot {
        Spot {
            name: self.point(&spot.name),
            bar: spot.bar + self.half,
            along: spot.along.clone(),
            across: spot.across.as_ref().map(Quantity::negated),
        }
    }

    /// The image of a support, where it is another.
    fn support(&self, support: &SupportSpec) -> Option<SupportSpec> {
        let point = self.point(&support.point);
        let line = matches!(support.shape, Shape::Floor(_) | Shape::Wall { .. });
        if line && point == support.point {
            return None;
        }
        let own = support.name == support.point && point != support.point;
        let name = if own { point.clone() } else { format!("{}_m", support.name) };
        let (shape, manner) = (self.shape(&support.shape), support.manner.clone());
        Some(SupportSpec { name, point, shape, manner })
    }

    fn shape(&self, shape: &Shape) -> Shape {
        let zero = Quantity::literal(0);
        let pi = Quantity::named("pi", std::f64::consts::PI, std::f64::consts::PI);
        match (shape, self.axis) {
            (Shape::Floor(height), 0) => Shape::Floor(height.clone()),
            (Shape::Floor(height), _) => {
                let height = self.across(height.as_ref().unwrap_or(&zero));
                Shape::Slope { angle: pi, through: Some([zero, height]) }
            }
            (Shape::Wall { at, side, .. }, 0) => Shape::Wall { at: self.across(at), side: -side, said: true },
            (Shape::Wall { at, side, .. }, _) => Shape::Wall { at: at.clone(), side: *side, said: true },
            (Shape::Slope { angle, through }, axis) => {
                let through = through.clone().unwrap_or_else(|| [zero.clone(), zero]);
                let angle = if axis == 0 { angle.negated() } else { pi.minus(angle) };
                Shape::Slope { angle, through: Some(self.position(&through)) }
            }
            (Shape::Circle { centre, radius, inside }, _) => {
                Shape::Circle { centre: self.position(centre), radius: radius.clone(), inside: *inside }
            }
            (Shape::Slot { angle, through, width }, _) => {
                Shape::Slot { angle: angle.negated(), through: self.position(through), width: width.clone() }
            }
            (Shape::Corner { bar, at, under }, axis) => {
                Shape::Corner { bar: bar + self.half, at: self.position(at), under: *under == (axis == 0) }
            }
        }
    }
}
