//! The figure in numbers, where it can be drawn.

use super::{Figure, NEAR, Place, Scope, Structure};
use crate::system::value::ParameterValues;

/// At so many samples of the parameters a decision is taken.
pub(crate) const SAMPLES: usize = 6;

/// The figure at one sample of the parameters.
#[derive(Clone, Debug)]
pub(in crate::system) struct Sample {
    /// Values of the parameters and constants.
    pub numbers: ParameterValues,
    /// The position of every point.
    pub points: Vec<[f64; 2]>,
}

impl Sample {
    pub(super) fn new(numbers: ParameterValues, positions: &[Place]) -> Self {
        let points = positions.iter().map(|place| numbers.pair(place)).collect();
        Self { numbers, points }
    }

    /// The largest coordinate of a point.
    pub fn extent(&self) -> f64 {
        self.points.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
    }

    /// What is wrong with a body here.
    pub(super) fn fault(&self, structure: &Structure, body: usize) -> Option<Fault> {
        let bar = &structure.bodies[body];
        let drawn = self.drawn(structure, body);
        if !drawn.is_finite() {
            Some(Fault::NoNumber)
        } else if drawn < NEAR * self.extent().max(NEAR) {
            Some(Fault::NoLength)
        } else if self.turned_over(structure, body) {
            Some(Fault::TurnedOver)
        } else {
            (self.numbers.evaluate(&bar.length) <= 0.0).then_some(Fault::NoLength)
        }
    }

    /// The distance of a body's first two points.
    pub(super) fn drawn(&self, structure: &Structure, body: usize) -> f64 {
        let [a, b] = [self.points[structure.bodies[body].from], self.points[structure.bodies[body].to]];
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    /// Whether three points of a body go round the other way than in its frame.
    fn turned_over(&self, structure: &Structure, body: usize) -> bool {
        let members = structure.members(body);
        let area = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        members.windows(3).any(|three| {
            let [own, there] = [
                area([0, 1, 2].map(|i| self.numbers.pair(&three[i].1))),
                area([0, 1, 2].map(|i| self.points[three[i].0])),
            ];
            own.abs() > NEAR && there.abs() > NEAR && own.signum() != there.signum()
        })
    }
}

/// Why a body cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// A root of a negative number, a division by zero.
    NoNumber,
    /// Its first two points are one.
    NoLength,
    /// It is drawn as in a mirror.
    TurnedOver,
}

impl Fault {
    pub(super) fn text(self, kind: &str, bar: &str) -> String {
        match self {
            Self::NoNumber => {
                format!("the figure of {kind} `{bar}` is not a number with any of the parameters tried")
            }
            Self::NoLength => format!("both ends of {kind} `{bar}` are at one place in the figure"),
            Self::TurnedOver => format!(
                "the figure draws body `{bar}` turned over, as in a mirror; list its points in the other direction"
            ),
        }
    }
}

impl Figure {
    /// Values of all parameters and constants with which the figure can be drawn.
    pub fn numbers(&self, scope: &Scope, structure: &Structure) -> Vec<ParameterValues> {
        let all = Self::drawable(scope, structure, &self.positions);
        let samples = if all.is_empty() { &self.samples } else { &all };
        samples.iter().map(|sample| sample.numbers.clone()).collect()
    }

    /// The first samples of the parameters with which all bodies can be drawn.
    pub(super) fn drawable(scope: &Scope, structure: &Structure, positions: &[Place]) -> Vec<Sample> {
        let samples = scope.of_figure().map(|numbers| Sample::new(numbers, positions));
        let sound =
            |sample: &Sample| (0..structure.bodies.len()).all(|b| sample.fault(structure, b).is_none());
        samples.filter(sound).take(SAMPLES).collect()
    }
}
