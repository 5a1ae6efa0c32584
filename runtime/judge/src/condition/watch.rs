//! Conditions along a motion: their series, on a tape whose positions are what they read.

use super::{Condition, Expression, Function, Operator};
use crate::expansion::Expansion;
use crate::motion::{NotJudged, Number};
use crate::scene::Scene;
use crate::tape::{Inputs, Level, Node, Series, Tape, whole};
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};

/// What a condition reads of a motion.
#[derive(Clone, Debug, PartialEq)]
enum Source {
    Value(Node, usize),
    Reactions(Vec<usize>),
}

/// Conditions in the arithmetic of a scene.
pub(crate) struct Watch {
    tape: Tape<Number>,
    sources: Vec<Source>,
    differences: Vec<Node>,
}

impl Watch {
    /// Fails where a name is not in the declaration.
    pub fn new(scene: &Scene<Number>, conditions: &[Condition]) -> Result<Self, NotJudged> {
        let mut sources = Vec::new();
        conditions.iter().try_for_each(|condition| gather(scene, &condition.difference, &mut sources))?;
        let mut reader = Reader { scene, tape: Tape::new(sources.len()), sources: &sources };
        let differences: Result<Vec<Node>, NotJudged> =
            conditions.iter().map(|condition| reader.node(&condition.difference)).collect();
        let (differences, tape) = (differences?, reader.tape);
        Ok(Self { tape, differences, sources })
    }

    /// The series of the differences along a motion.
    pub fn series(&self, expansion: &Expansion<Number>) -> Vec<Vec<Number>> {
        if self.differences.is_empty() {
            return Vec::new();
        }
        let terms = expansion.inputs.rates.first().map_or(1, Vec::len).saturating_sub(1).max(1);
        let read = |source: &Source| {
            let mut series = match source {
                Source::Value(node, order) => derivative(expansion.series.coefficients(*node), *order),
                Source::Reactions(contacts) => reactions(expansion, contacts),
            };
            series.resize(terms, Number::ZERO);
            series
        };
        let positions = self.sources.iter().map(read).collect();
        let inputs = Inputs { t: expansion.inputs.t, positions, rates: vec![Vec::new(); self.sources.len()] };
        let mut series = Series::new(&self.tape);
        (0..terms).for_each(|k| series.extend(&self.tape, Level::Position, k, &inputs));
        self.differences.iter().map(|&node| series.coefficients(node).to_vec()).collect()
    }
}

fn derivative(series: &[Number], order: usize) -> Vec<Number> {
    let once = |c: Vec<Number>| -> Vec<Number> {
        c.iter().enumerate().skip(1).map(|(k, &c)| c * whole(k as i64)).collect()
    };
    (0..order).fold(series.to_vec(), |series, _| once(series))
}

fn reactions(expansion: &Expansion<Number>, contacts: &[usize]) -> Vec<Number> {
    let mut sum: Vec<Number> = Vec::new();
    for &contact in contacts {
        let own = expansion.reaction(contact);
        sum.resize(sum.len().max(own.len()), Number::ZERO);
        sum.iter_mut().zip(own).for_each(|(sum, &part)| *sum = *sum + part);
    }
    sum
}

/// What is read, each once.
fn gather(scene: &Scene<Number>, of: &Expression, sources: &mut Vec<Source>) -> Result<(), NotJudged> {
    match of {
        Expression::Apply(_, x) | Expression::Power(x, _) => return gather(scene, x, sources),
        Expression::Join(_, a, b) => {
            gather(scene, a, sources)?;
            return gather(scene, b, sources);
        }
        Expression::Kinetic => {
            let speeds = (0..scene.n()).map(|i| Source::Value(scene.tape.position(i), 1));
            speeds.for_each(|speed| note(sources, speed));
        }
        _ => {
            if let Some(source) = source(scene, of)? {
                note(sources, source);
            }
        }
    }
    Ok(())
}

fn note(sources: &mut Vec<Source>, source: Source) {
    if !sources.contains(&source) {
        sources.push(source);
    }
}

/// What a single reading is.
fn source(scene: &Scene<Number>, of: &Expression) -> Result<Option<Source>, NotJudged> {
    let unknown = |name: &str| NotJudged::Name(name.to_owned());
    let contact = |name: &String| {
        let place = scene.contacts.iter().position(|contact| contact.name == *name);
        place.ok_or_else(|| unknown(name))
    };
    Ok(match of {
        Expression::Coordinate { index, order } => {
            let value = scene.readings.get(*index).and_then(|row| row.value);
            Some(Source::Value(value.ok_or_else(|| unknown("a coordinate"))?, *order))
        }
        Expression::Point { name, axis, order } => {
            let place = scene.names.iter().position(|other| other == name).ok_or_else(|| unknown(name))?;
            Some(Source::Value(scene.points[place][*axis], *order))
        }
        Expression::Gap(name) => {
            let value = scene.contacts[contact(name)?].row.value;
            Some(Source::Value(value.ok_or_else(|| unknown(name))?, 0))
        }
        Expression::Reaction(names) => {
            Some(Source::Reactions(names.iter().map(contact).collect::<Result<_, _>>()?))
        }
        Expression::Potential => Some(Source::Value(scene.potential, 0)),
        _ => None,
    })
}

struct Reader<'a> {
    scene: &'a Scene<Number>,
    tape: Tape<Number>,
    sources: &'a [Source],
}

impl Reader<'_> {
    fn node(&mut self, of: &Expression) -> Result<Node, NotJudged> {
        Ok(match of {
            Expression::Number(x) => self.tape.number(Number::from_f64(*x)),
            Expression::Pi => self.tape.number(DoubleDouble::pi()),
            Expression::Time => self.tape.time(),
            Expression::Kinetic => self.kinetic(),
            Expression::Apply(function, x) => {
                let x = self.node(x)?;
                self.applied(*function, x)
            }
            Expression::Join(operator, a, b) => {
                let (a, b) = (self.node(a)?, self.node(b)?);
                match operator {
                    Operator::Add => self.tape.add(a, b),
                    Operator::Subtract => self.tape.subtract(a, b),
                    Operator::Multiply => self.tape.multiply(a, b),
                    Operator::Divide => self.tape.divide(a, b),
                }
            }
            Expression::Power(x, n) => {
                let (one, x) = (Tape::<Number>::ONE, self.node(x)?);
                let power = (0..n.unsigned_abs()).fold(one, |power, _| self.tape.multiply(power, x));
                if *n < 0 { self.tape.divide(one, power) } else { power }
            }
            _ => match source(self.scene, of)? {
                Some(source) => self.translate(&source),
                None => Tape::<Number>::ZERO,
            },
        })
    }

    fn translate(&self, source: &Source) -> Node {
        let place = self.sources.iter().position(|other| other == source);
        place.map_or(Tape::<Number>::ZERO, |i| self.tape.position(i))
    }

    /// ½ Σ m v².
    fn kinetic(&mut self) -> Node {
        let mut sum = Tape::<Number>::ZERO;
        for i in 0..self.scene.n() {
            let speed = self.translate(&Source::Value(self.scene.tape.position(i), 1));
            let half = self.tape.number(self.scene.masses[i] / whole(2));
            let square = self.tape.multiply(speed, speed);
            let part = self.tape.multiply(half, square);
            sum = self.tape.add(sum, part);
        }
        sum
    }

    fn applied(&mut self, function: Function, x: Node) -> Node {
        match function {
            Function::Negate => self.tape.negate(x),
            Function::Sqrt => self.tape.root(x),
            Function::Sin => self.tape.sin_cos(x)[0],
            Function::Cos => self.tape.sin_cos(x)[1],
            Function::Tan => {
                let [sin, cos] = self.tape.sin_cos(x);
                self.tape.divide(sin, cos)
            }
        }
    }
}
