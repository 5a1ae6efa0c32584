//! Springs, dampers, torsion springs and threads.

use super::Draft;
use super::canvas::{Fill, OUTLINE, Pen};
use super::plane::{Px, along, distance, left_of, minus, towards, unit};
use super::script::Script;
use crate::plot::Colour;
use core::f64::consts::TAU;
use liftoff_core::model::geometry::{Look, Spiral, Spring};

/// Half the breadth of a coil and of a dashpot.
const COIL: f64 = 6.5;
/// Turns of a coil.
const TURNS: u32 = 7;
/// Half the distance of a spring and its damper.
const APART: f64 = 9.0;
/// A thread.
const THREAD: Pen = Pen::new(Colour::Black, 1.3);

impl Draft<'_> {
    pub(super) fn springs(&mut self) {
        for spring in self.geometry.springs {
            self.spring(spring);
        }
        for spiral in self.geometry.spirals {
            self.spiral(spiral);
        }
    }

    fn spring(&mut self, spring: &Spring) {
        let [a, b] = spring.ends.map(|end| self.map_point(end));
        let across = left_of(unit(minus(b, a)));
        let both = spring.coil && spring.dashpot;
        let shift = if both { APART } else { 0.0 };
        let side = |k: f64| [along(a, across, k * shift), along(b, across, k * shift)];
        if spring.coil {
            self.coil(within(side(1.0), both));
        }
        if spring.dashpot {
            self.dashpot(within(side(-1.0), both));
        }
        if both {
            self.yokes([a, b], across);
        }
        if !spring.text.is_empty() {
            let at = along(a, minus(b, a), 0.5);
            self.placement(Script::formula(spring.text), at, shift + COIL + 4.0, across);
        }
    }

    /// What joins the ends of a spring and its damper to theirs.
    fn yokes(&mut self, [a, b]: [Px; 2], across: Px) {
        let ahead = unit(minus(b, a));
        for (end, inwards) in [(a, 1.0), (b, -1.0)] {
            let bar = along(end, ahead, inwards * yoke(a, b));
            self.canvas.line(vec![end, bar], THREAD);
            self.canvas.line(vec![along(bar, across, APART), along(bar, across, -APART)], THREAD);
        }
    }

    fn coil(&mut self, [a, b]: [Px; 2]) {
        let (ahead, all) = (unit(minus(b, a)), distance(a, b));
        let across = left_of(ahead);
        let (lead, turns) = (0.14 * all, f64::from(2 * TURNS));
        let mut points = vec![a, along(a, ahead, lead)];
        for i in 0..2 * TURNS {
            let on = along(a, ahead, lead + (all - 2.0 * lead) * (f64::from(i) + 0.5) / turns);
            points.push(along(on, across, if i % 2 == 0 { COIL } else { -COIL }));
        }
        points.extend([along(b, ahead, -lead), b]);
        self.canvas.line(points, Pen::new(Colour::Black, 1.5));
    }

    /// A piston in its cylinder.
    fn dashpot(&mut self, [a, b]: [Px; 2]) {
        let (ahead, all) = (unit(minus(b, a)), distance(a, b));
        let across = left_of(ahead);
        let at = |x: f64, y: f64| along(along(a, ahead, x * all), across, y * COIL);
        self.canvas.line(vec![a, at(0.4, 0.0)], THREAD);
        self.canvas.line(vec![at(0.62, 1.0), at(0.4, 1.0), at(0.4, -1.0), at(0.62, -1.0)], OUTLINE);
        self.canvas.line(vec![at(0.52, 0.75), at(0.52, -0.75)], OUTLINE);
        self.canvas.line(vec![at(0.52, 0.0), b], THREAD);
    }

    fn spiral(&mut self, spiral: &Spiral) {
        let (centre, from) = (self.map_point(spiral.point), self.configuration.direction(spiral.from));
        let at = |i: u32| {
            let turn = f64::from(i) / 24.0;
            along(centre, towards(from + TAU * turn), 6.0 + 4.5 * turn)
        };
        self.canvas.line((0..=48).map(at).collect(), Pen::new(Colour::Black, 1.1));
    }

    /// Straight from point to point, dashed where it is slack, over pegs.
    pub(super) fn threads(&mut self) {
        for thread in self.geometry.threads {
            let points: Vec<Px> = thread.path.iter().map(|&point| self.map_point(point)).collect();
            let straight: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
            let length = self.frame.long(self.configuration.number(thread.length));
            let slack = length > straight * (1.0 + 1e-6);
            let middle = along(points[0], minus(points[1], points[0]), 0.5);
            self.canvas.line(points, if slack { THREAD.dashed() } else { THREAD });
            if !thread.text.is_empty() {
                self.placement(Script::formula(thread.text), middle, 5.0, [0.0, -1.0]);
            }
        }
        for point in self.geometry.marked(Look::Peg) {
            self.canvas.circle(self.map_point(point), COIL, OUTLINE, Some(Fill::Pale));
        }
    }
}

/// How far from its end a yoke stands.
fn yoke(a: Px, b: Px) -> f64 {
    0.14 * distance(a, b)
}

fn within([a, b]: [Px; 2], both: bool) -> [Px; 2] {
    let (ahead, room) = (unit(minus(b, a)), if both { yoke(a, b) } else { 0.0 });
    [along(a, ahead, room), along(b, ahead, -room)]
}
