//! Expressions of a symmetric motion: equal if they agree at some instants of motions that are
//! symmetric and otherwise generic.

use core::f64::consts::{PI, TAU};

use super::agree;
use super::images::Images;
use crate::system::value::ParameterValues;
use crate::system::{CoordinateKind, Formula, Function, Operator, Reading, Reference};

/// Instants at each sample of the parameters.
const INSTANTS: usize = 3;

/// −f.
pub(super) fn negated(formula: &Formula) -> Formula {
    Formula::Apply(Function::Negate, Box::new(formula.clone()))
}

/// Whether two expressions agree in every symmetric motion.
pub(super) fn same(images: &Images, a: &Formula, b: &Formula) -> bool {
    a == b || compared(images, [a, b], |_, value| [value, 0.0])
}

/// Whether two angles agree up to full turns, with a half turn added to the first or not.
pub(super) fn same_angle(images: &Images, angles: [&Formula; 2], half_turn: bool) -> bool {
    compared(images, angles, |which, value| {
        let (sin, cos) = (value + if half_turn && which == 0 { PI } else { 0.0 }).sin_cos();
        [cos, sin]
    })
}

fn compared(images: &Images, formulas: [&Formula; 2], place: impl Fn(usize, f64) -> [f64; 2]) -> bool {
    let samples = images.pairing.samples.iter().enumerate();
    let instants: Vec<Instant> = samples
        .flat_map(|(k, numbers)| {
            (0..INSTANTS).map(move |i| Instant { images, numbers, seed: INSTANTS * k + i })
        })
        .collect();
    let [a, b] = [0, 1].map(|which| -> Vec<[f64; 2]> {
        instants.iter().map(|instant| place(which, instant.value(formulas[which]))).collect()
    });
    agree(&a, &b)
}

/// An instant of a symmetric motion.
struct Instant<'a> {
    images: &'a Images<'a>,
    numbers: &'a ParameterValues,
    seed: usize,
}

impl Instant<'_> {
    fn value(&self, formula: &Formula) -> f64 {
        match formula {
            Formula::Constant(series) => self.numbers.evaluate(series),
            Formula::Time | Formula::Slip => self.generic(0, 0),
            Formula::Switch(i) => self.generic(9, *i),
            Formula::Motion { reading, rate } => self.evaluate_reading(*reading, *rate),
            Formula::Apply(function, of) => {
                let x = self.value(of);
                match function {
                    Function::Negate => -x,
                    Function::Sqrt => x.sqrt(),
                    Function::Sin => x.sin(),
                    Function::Cos => x.cos(),
                    Function::Tan => x.tan(),
                    Function::Power(n) => x.powi(*n),
                    Function::Elementary(function) => function.apply(x),
                }
            }
            Formula::Join(operator, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match operator {
                    Operator::Add => a + b,
                    Operator::Subtract => a - b,
                    Operator::Multiply => a * b,
                    Operator::Divide => a / b,
                }
            }
        }
    }

    /// A positive number near 1, so that few roots are missed.
    fn generic(&self, kind: usize, index: usize) -> f64 {
        1.0 + 0.61 * (1.3 * ((kind + 7 * index + 2) * (2 * self.seed + 1)) as f64).sin()
    }

    fn evaluate_reading(&self, reading: Reading, rate: bool) -> f64 {
        match reading {
            Reading::Position(point, axis) => self.position(point, axis, rate),
            Reading::Direction(body) => self.direction(body, rate),
            Reading::Coordinate(index) => match &self.images.parts.coordinates[index].kind {
                CoordinateKind::Position { point, axis, sign } => {
                    f64::from(*sign) * self.position(*point, *axis, rate)
                }
                CoordinateKind::Angle { body, reference, sign } => {
                    let from = match reference {
                        Reference::Body(other) => self.direction(*other, rate),
                        Reference::Ground(_) if rate => 0.0,
                        Reference::Ground(angle) => {
                            let [sin, cos] =
                                [crate::algebra::Series::sin(angle), crate::algebra::Series::cos(angle)];
                            self.numbers.evaluate(&sin).atan2(self.numbers.evaluate(&cos))
                        }
                    };
                    let angle = f64::from(*sign) * (self.direction(*body, rate) - from);
                    if rate { angle } else { angle - TAU * (angle / TAU).round() }
                }
            },
        }
    }

    /// The one of a pair that is declared first moves freely, the other as its image.
    fn position(&self, point: usize, axis: usize, rate: bool) -> f64 {
        let pairing = self.images.pairing;
        if let Some(place) = pairing.structure.fixed(point) {
            return if rate { 0.0 } else { self.numbers.evaluate(&place[axis]) };
        }
        let at = if rate { 0.0 } else { self.numbers.evaluate(&pairing.line.at) };
        let image = pairing.points[point];
        let free = self.generic(1 + axis + 2 * usize::from(rate), point.min(image));
        match (axis == pairing.line.axis, point.cmp(&image)) {
            (true, core::cmp::Ordering::Equal) => at,
            (true, core::cmp::Ordering::Greater) => 2.0 * at - free,
            _ => free,
        }
    }

    fn direction(&self, body: usize, rate: bool) -> f64 {
        let image = self.images.bodies[body].0;
        let half = if self.images.half_turn(body) && !rate { PI } else { 0.0 };
        let free = self.generic(5 + usize::from(rate), body.min(image));
        match body.cmp(&image) {
            core::cmp::Ordering::Less => free,
            core::cmp::Ordering::Equal => half / 2.0,
            core::cmp::Ordering::Greater => half - free,
        }
    }
}
