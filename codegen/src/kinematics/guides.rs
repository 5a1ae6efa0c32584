//! Sliders and prescribed motions as joints.
//!
//! | held | equation |
//! |---|---|
//! | a point r on a line through p with normal n | `n · (r − p) = 0` |
//! | on the axis of a body | the same with the body's first point and left normal |
//! | on a circle of radius R about c | `(R² − |r − c|²)/2R = 0` |
//! | a driven coordinate | `q − f(t) = 0` |
//! | a driven distance, d₀ that of the figure | `(d² − f(t)²)/2d₀ = 0` |

use core::f64::consts::{FRAC_PI_2, TAU};

use super::{Joint, JointKind, Kinematics, evaluate_reading, wrapped};
use crate::algebra::{Angle, Rational, Series, Symbol};
use crate::system::{CoordinateKind, Drive, Driven, Guide, Reading, Reference, Slider, System};

impl Kinematics {
    /// Appends the sliders, then the drives that hold throughout.
    pub(super) fn guide(&mut self, system: &System) {
        // Those with friction are contacts.
        for (i, slider) in system.sliders.iter().enumerate().filter(|(_, slider)| !slider.rubs) {
            let equation = self.off_guide(system, slider);
            let repeated = self.joints.iter().any(|j| proportional(&j.equation, &equation));
            if !(repeated && system.mirror.is_some()) {
                let name = format!("slider {}", slider.name);
                self.joints.push(Joint { name, equation, kind: JointKind::Slider(i), span: slider.span });
            }
        }
        // Those on a condition are contacts.
        for (i, drive) in system.drives.iter().enumerate().filter(|(_, drive)| !drive.switched) {
            let driven = self.driven(system, &drive.driven).0;
            let image = |other: &Drive| proportional(&self.driven(system, &other.driven).0, &driven);
            // Of a drive and its mirror image one is enough: they share what they drive.
            if system.mirror.is_none() || !system.drives[..i].iter().any(image) {
                let equation = &driven - &Series::symbol(Symbol::opaque(i));
                let name = format!("drive {}", drive.name);
                self.joints.push(Joint { name, equation, kind: JointKind::Drive(i), span: drive.span });
            }
        }
    }

    fn off_guide(&self, system: &System, slider: &Slider) -> Series {
        let at = &self.points[slider.point];
        match &slider.guide {
            Guide::Line { through, direction } => height(at, through, direction),
            Guide::Circle { centre, radius, inverse } => {
                let [x, y] = [0, 1].map(|axis| &at[axis] - &centre[axis]);
                let inside = &(radius * radius) - &(&(&x * &x) + &(&y * &y));
                (&inside * inverse).scale(Rational::HALF)
            }
            Guide::Axis(body) => {
                let first = system.local(*body, system.bodies[*body].from);
                height(at, &self.compute_position(system, *body, &first), &self.directions[*body])
            }
        }
    }

    /// What a drive prescribes as a series, of a distance d its `d²/2d₀`, and a constant angle to
    /// be added to it.
    pub fn driven(&self, system: &System, driven: &Driven) -> (Series, Angle) {
        match driven {
            Driven::Reading(reading) => self.derive_reading(system, *reading),
            Driven::Distance { ends, inverse } => {
                ((&self.squared_distance(*ends) * inverse).scale(Rational::HALF), Angle::zero())
            }
            Driven::Turn { from, body } => split(&(&self.directions[*body] - &self.directions[*from])),
            Driven::Along { point, body } => {
                let first = system.local(*body, system.bodies[*body].from);
                let span = span(&self.compute_position(system, *body, &first), &self.points[*point]);
                let direction = &self.directions[*body];
                let along = &(&Series::cos(direction) * &span[0]) + &(&Series::sin(direction) * &span[1]);
                (along, Angle::zero())
            }
        }
    }

    /// The full turns to be added to the direction of a body, or to its difference from that of
    /// another, which puts it within half a turn in the nominal figure: quarter turns are kept modulo
    /// four, and what is counted from the left is less than a turn.
    pub fn lost_turns(&self, system: &System, from: Option<usize>, to: usize) -> i64 {
        let from = from.map_or_else(Angle::zero, |from| self.directions[from].clone());
        let angle = &self.directions[to] - &from;
        // Numbers of angles have quarter turns from 0 to 3.
        let quarters = angle.signed_quarters() - i64::from(angle.quarter_turns());
        let shown = system.samples.first().map_or(0.0, |numbers| {
            let value = |symbol| match symbol {
                Symbol::Coordinate { index, .. } => {
                    evaluate_reading(system, numbers, &self.coordinates[usize::from(index)].reading)
                }
                _ => numbers.evaluate(&Series::symbol(symbol)),
            };
            angle.evaluate(&value) + FRAC_PI_2 * quarters as f64
        });
        ((wrapped(shown) - shown) / TAU).round() as i64
    }

    /// d², of two points.
    pub fn squared_distance(&self, [a, b]: [usize; 2]) -> Series {
        let [x, y] = span(&self.points[a], &self.points[b]);
        &(&x * &x) + &(&y * &y)
    }

    /// What is read off the motion as a series, and a constant angle to be added to it.
    pub fn derive_reading(&self, system: &System, reading: Reading) -> (Series, Angle) {
        match reading {
            Reading::Position(point, axis) => (self.points[point][axis].clone(), Angle::zero()),
            Reading::Direction(body) => split(&self.directions[body]),
            Reading::Coordinate(i) => match &system.coordinates[i].kind {
                CoordinateKind::Position { point, axis, sign } => {
                    (self.points[*point][*axis].scale(Rational::integer((*sign).into())), Angle::zero())
                }
                CoordinateKind::Angle { body, reference, sign } => {
                    let from = match reference {
                        Reference::Ground(angle) => angle,
                        Reference::Body(other) => &self.directions[*other],
                    };
                    split(&(&self.directions[*body] - from).scale((*sign).into()))
                }
            },
        }
    }
}

fn span(from: &[Series; 2], to: &[Series; 2]) -> [Series; 2] {
    [0, 1].map(|axis| &to[axis] - &from[axis])
}

/// Whether two series are equal but for a rational factor.
pub(super) fn proportional(a: &Series, b: &Series) -> bool {
    let leading = |series: &Series| series.terms().next().map(|(_, c)| c);
    let unit = |series: &Series| leading(series).map(|c| series.scale(c.recip()));
    unit(a) == unit(b)
}

/// Σ kᵢ qᵢ and the rest, which is constant.
fn split(angle: &Angle) -> (Series, Angle) {
    let moving = |symbol: Symbol| symbol.derivative().is_some();
    let (own, rest) = angle.terms().iter().partition::<Vec<_>, _>(|(symbol, _)| moving(*symbol));
    let series = own.iter().map(|&(symbol, k)| Series::symbol(symbol).scale(Rational::integer(k.into())));
    let rest = rest.iter().fold(Angle::quarters(angle.quarter_turns().into()), |sum, &(symbol, k)| {
        &sum + &Angle::from_symbol(symbol).scale(k.into())
    });
    (series.sum(), rest)
}

/// `n · (r − p)` with `n = (−sin δ, cos δ)`.
pub(crate) fn height(r: &[Series; 2], p: &[Series; 2], direction: &Angle) -> Series {
    let across = &Series::cos(direction) * &(&r[1] - &p[1]);
    &across - &(&Series::sin(direction) * &(&r[0] - &p[0]))
}
