//! Drawing welds, free particles, sliders, threads and prescribed motions.

use std::f64::consts::FRAC_PI_2;

use super::builder::Builder;
use super::expression::Expression;
use super::parts::{DriveSpec, SliderSpec, Target, Thread, Track, Weld};
use super::quantity::Quantity;
use super::spec::{Declared, Origin};
use super::vocabulary::occurs;

impl Builder<'_> {
    /// Everything beside bars, what is on them and straight supports; a mirror admits none of it.
    pub(super) fn parts(&mut self) {
        if self.mirrored.is_some() {
            return;
        }
        let vocabulary = self.vocabulary;
        self.welds();
        for _ in 0..2 {
            if occurs(self.source, vocabulary.particles) {
                let at = self.place_anywhere();
                self.particle(at);
            }
            if occurs(self.source, vocabulary.sliders) {
                self.slider();
            }
            if occurs(self.source, vocabulary.threads) {
                self.thread();
            }
        }
        if occurs(self.source, vocabulary.drives) {
            self.drive();
        }
        self.actions();
    }

    fn place_anywhere(&mut self) -> [Quantity; 2] {
        [0, 1].map(|_| self.spec.parameters.signed(self.source, "h"))
    }

    /// Welds of bars that share a point and stand at quarter turns, and of bars that stand upright
    /// or level.
    fn welds(&mut self) {
        let bars = self.spec.bars.len();
        for second in 0..bars {
            if self.spec.bars[second].chain.is_some() || self.is_held(second) {
                continue;
            }
            let firsts: Vec<_> = (0..second).filter(|&first| self.stands(first, second).is_some()).collect();
            let chance = self.vocabulary.welds;
            if !firsts.is_empty() && occurs(self.source, 4.0 * chance) {
                let first = self.source.choose(&firsts);
                let quarters = self.stands(first, second).unwrap_or(0);
                let said = self.source.chance(0.3);
                self.spec.parts.welds.push(Weld { first, second: Some(second), quarters, said });
            } else if !self.spec.bars[second].heading.slanted() && occurs(self.source, chance) {
                let quarters = (self.spec.bars[second].heading.angle() / FRAC_PI_2).round() as i32;
                self.spec.parts.welds.push(Weld { first: second, second: None, quarters, said: true });
            }
        }
    }

    /// The quarter turns from one bar to another that shares a point with it.
    fn stands(&self, first: usize, second: usize) -> Option<i32> {
        let (a, b) = (&self.spec.bars[first], &self.spec.bars[second]);
        let shared = [&a.from, &a.to].iter().any(|point| [&b.from, &b.to].contains(point));
        let (p, q) = (a.heading.p, a.heading.q);
        let turned = [(p, q), (-q, p), (-p, -q), (q, -p)];
        let other = (b.heading.p, b.heading.q);
        let quarters = turned.iter().position(|&heading| heading == other)?;
        (shared && a.chain.is_none() && a.heading.r == b.heading.r).then_some(quarters as i32)
    }

    /// Whether the direction of a bar is declared or tied to another.
    pub(super) fn is_held(&self, bar: usize) -> bool {
        use super::spec::Tie;
        let spec = &self.spec;
        let of = |index: usize| match &spec.coordinates[index] {
            Declared::Angle { bar, .. } => Some(*bar),
            Declared::Position { .. } => None,
        };
        let tied = spec.ties.iter().any(|&tie| match tie {
            Tie::Bars(a, b) => a == bar || b == bar,
            Tie::Coordinates(a, b) => of(a) == Some(bar) || of(b) == Some(bar),
        });
        let declared = spec.coordinates.iter().any(|declared| match declared {
            Declared::Angle { bar: own, origin, .. } => {
                *own == bar && !matches!(origin, Origin::Direction(0 | 1, _))
                    || matches!(origin, Origin::Bar(other) if *other == bar)
            }
            Declared::Position { .. } => false,
        });
        let welded = spec.parts.welds.iter().any(|weld| weld.first == bar || weld.second == Some(bar));
        tied || declared || welded
    }

    /// A bar whose direction is neither declared from a line nor held, so that its turns are
    /// counted.
    pub(super) fn free_bar(&mut self) -> Option<usize> {
        let bars: Vec<_> = (0..self.spec.bars.len()).filter(|&bar| !self.is_held(bar)).collect();
        (!bars.is_empty()).then(|| self.source.choose(&bars))
    }

    fn particle(&mut self, at: [Quantity; 2]) -> String {
        let point = self.point(at, 1 + self.spec.figure.len());
        let mass = self.spec.parameters.positive(self.source, "m");
        self.spec.parts.particles.push((point.clone(), mass));
        point
    }

    fn ground(&mut self, at: [Quantity; 2]) -> String {
        let point = self.point(at, 1 + self.spec.figure.len());
        self.spec.parts.grounds.push(point.clone());
        point
    }

    /// A point that may move: of a body or a particle.
    pub(super) fn moving(&mut self) -> String {
        let fixed =
            |point: &String| self.spec.pins.contains(point) || self.spec.parts.grounds.contains(point);
        let points: Vec<_> = self.points().into_iter().filter(|point| !fixed(point)).collect();
        if points.is_empty() { self.points()[0].clone() } else { self.source.choose(&points) }
    }

    fn slider(&mut self) {
        let index = self.spec.parts.sliders.len();
        let track = self.source.below(6);
        let (point, track) = match track {
            0..3 => {
                let point = self.moving();
                let [x, y] = self.spec.figure[&point].clone();
                let track = match track {
                    0 => Track::Horizontal(y),
                    1 => Track::Vertical(x),
                    _ => Track::Line(self.spec.parameters.angle(self.source), [x, y]),
                };
                (point, track)
            }
            _ => {
                let straight = |&bar: &usize| {
                    self.spec.bars[bar].chain.is_none() && self.spec.bars[bar].corner.is_none()
                };
                let bars: Vec<_> = (0..self.spec.bars.len()).filter(straight).collect();
                if bars.is_empty() {
                    return;
                }
                let bar = self.source.choose(&bars);
                (self.on_axis(bar, track), Track::Bar(bar))
            }
        };
        let taken = self.spec.parts.sliders.iter().any(|slider| slider.name == point);
        let name = if taken || self.source.chance(0.3) { format!("g{index}") } else { point.clone() };
        self.spec.parts.sliders.push(SliderSpec { name, point, track });
    }

    /// A new point on the axis of a bar: a particle, of the ground, or of a new bar.
    fn on_axis(&mut self, index: usize, kind: usize) -> String {
        let bar = self.spec.bars[index].clone();
        let along = bar.length.scaled(1 + self.source.below(4) as i32, 5);
        let at = bar.heading.walk(&self.spec.figure[&bar.from], &along, &Quantity::literal(0));
        match kind {
            3 => self.particle(at),
            4 => self.ground(at),
            _ => {
                let point = self.point(at, 1 + self.spec.figure.len());
                self.bar(&point);
                point
            }
        }
    }

    fn thread(&mut self) {
        let mut path = vec![self.moving()];
        let far = match self.source.below(3) {
            0 => {
                let at = self.place_anywhere();
                self.ground(at)
            }
            _ => self.moving(),
        };
        if far == path[0] {
            return;
        }
        if self.source.chance(0.4) {
            let at = self.place_anywhere();
            path.push(self.ground(at));
        }
        path.push(far);
        let place = |point: &String| self.spec.figure[point].each_ref().map(|x| x.nominal);
        let span = |pair: &[String]| {
            let ([x, y], [u, v]) = (place(&pair[0]), place(&pair[1]));
            (x - u).hypot(y - v)
        };
        let spans: Vec<_> = path.windows(2).map(span).collect();
        if spans.iter().any(|span| *span < 0.05) || self.rigid(&path) {
            return;
        }
        let slack = spans.iter().sum::<f64>() * 105.0 + 20.0;
        let length = Quantity::literal(slack as i32 + self.source.below(50) as i32);
        let manner = self.manner(false);
        let name = format!("rope{}", self.spec.parts.threads.len());
        self.spec.parts.threads.push(Thread { name, path, length, manner });
    }

    /// Whether two neighbours of a path are points of one body.
    pub(super) fn rigid(&self, path: &[String]) -> bool {
        let bodies = |point: &str| self.spec.on(point).into_iter().map(|(body, _)| body).collect::<Vec<_>>();
        path.windows(2).any(|pair| {
            let others = bodies(&pair[1]);
            pair[0] == pair[1] || bodies(&pair[0]).iter().any(|body| others.contains(body))
        })
    }

    fn drive(&mut self) {
        let target = match self.source.below(3) {
            0 if !self.spec.coordinates.is_empty() => {
                Target::Coordinate(self.source.below(self.spec.coordinates.len()))
            }
            1 => Target::Position(self.moving(), self.source.below(2)),
            _ => match self.free_bar() {
                Some(bar) => Target::Direction(bar),
                None => return,
            },
        };
        let swing = Expression::literal(10 + self.source.below(60) as i32);
        let pace = match self.source.chance(0.5) {
            true => Expression::Number(self.spec.parameters.positive(self.source, "omega")),
            false => Expression::literal(100 + self.source.below(200) as i32),
        };
        let middle = match &target {
            Target::Coordinate(_) => Expression::literal(20 + self.source.below(60) as i32),
            Target::Direction(bar) => {
                Expression::literal((100.0 * self.spec.bars[*bar].heading.angle()) as i32)
            }
            Target::Position(point, axis) => Expression::Number(self.spec.figure[point][*axis].clone()),
        };
        let value = middle.plus(swing.times(pace.times(Expression::Time).sin()));
        self.spec.parts.drives.push(DriveSpec { target, value });
    }
}
