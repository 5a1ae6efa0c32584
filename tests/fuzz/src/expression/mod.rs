//! Expressions, conditions and formulas with the names of a model: read or refused in a line; what
//! is read has values, and ends a run or does not.

mod grammar;

use std::fmt;

use liftoff::__private::expression::Formula;
use liftoff::{Budget, Condition, Output, Trajectory};
use liftoff_models::models;
use liftoff_studio::registry::Entry;
use liftoff_tests::random::Source;

use crate::text::hostile;
use crate::{Fate, Finding, Subject};

/// Models with contacts, springs, loops, drives and none of these.
const MODELS: [&str; 6] =
    ["pendulum", "bouncing-ball", "ladder", "spring-pendulum", "slider-crank", "zigzag"];

const WHOLE: [&str; 22] = [
    "sin(3*phi) - 0.5*cos(phi)",
    "phi = pi/2",
    "y < -l",
    "N(A) < 0.1",
    "x^2 + y^2 = 1",
    "abs(phi' - 1) = 1e-8",
    "1/(phi - 0.3) = 1e4",
    "tan(20*phi) = 30",
    "sqrt(abs(y - 1)) = 1e-3",
    "E - T - V",
    "t = 0.01",
    "phi'' * m * l^2",
    "gap(A) = 1e-3",
    "R(A)/N(A)",
    "vx(A)*ax(A) + vy(A)*ay(A)",
    "75deg",
    "1 - lambda",
    "10*lambda mm",
    "-x^2 * sqrt(2)/2",
    "9.81 m/s^2",
    "max(sin(t), cos(t)) = 0.5",
    "exp(10*(y - 1)) = 2",
];

const WORDS: [&str; 72] = [
    "phi",
    "x",
    "y",
    "phi'",
    "x'",
    "y''",
    "t",
    "m",
    "l",
    "g",
    "k",
    "E",
    "T",
    "V",
    "pi",
    "lambda",
    "N(A)",
    "N(P)",
    "N(",
    "R(A)",
    "gap(P)",
    "x(P)",
    "y(B)",
    "vx(P)",
    "ay(P)",
    "ratio(A)",
    "force(OP)",
    "px",
    "+",
    "-",
    "*",
    "/",
    "^",
    "^2",
    "^0.5",
    "^(-1)",
    "^1e9",
    "(",
    ")",
    ",",
    "=",
    "<",
    ">",
    "==",
    "0",
    "1",
    "2",
    "0.5",
    "1e8",
    "1e308",
    "1e-320",
    "1e999",
    "1e",
    ".",
    "..",
    "sin(",
    "cos(",
    "tan(",
    "sqrt(",
    "abs(",
    "min(",
    "max(",
    "exp(",
    "deg",
    "mm",
    "kg",
    "/s",
    " ",
    "'",
    "''",
    "é",
    "\n",
];

/// A short motion of a model.
struct Short {
    model: &'static Entry,
    run: Trajectory,
}

/// Expressions.
pub struct Expressions(Vec<Short>);

impl Default for Expressions {
    fn default() -> Self {
        let short = |name: &&str| {
            let model = models().find(name).ok()?;
            Some(Short { model, run: model.run(&model.default_run().limit(0.1).tolerance(1e-6)).ok()? })
        };
        Self(MODELS.iter().filter_map(short).collect())
    }
}

/// A text, and the model that has its names.
#[derive(Clone, Debug)]
pub struct Written {
    model: usize,
    text: String,
}

impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {:?}", MODELS[self.model], self.text)
    }
}

impl Subject for Expressions {
    type Case = Written;

    fn generate(&self, seed: u64) -> Written {
        let source = &mut Source::new(seed);
        let model = source.below(self.0.len());
        let text = match source.below(4) {
            0 => hostile(source, &WHOLE.map(str::to_owned), &WORDS),
            _ => {
                let valid = grammar::condition(self.0[model].run.layout(), source);
                if source.chance(0.5) { valid } else { hostile(source, &[valid], &WORDS) }
            }
        };
        Written { model, text }
    }

    fn check(&self, Written { model, text }: &Written) -> Result<Fate, Finding> {
        let Short { model, run } = &self.0[*model];
        let mut fate = Fate::new();
        fate.push(match Formula::parse(text, &["lambda", "x"]) {
            Ok(formula) => {
                let _ = (formula.value(&[0.25, 2.0]), formula.value(&[]));
                "formula"
            }
            Err(error) => check_message("no formula", text, &error.to_string())?,
        });
        fate.push(match Output::parse(run.layout(), text) {
            Ok(output) => {
                let _ = (run.value(&output, 0.0), run.range(&output));
                "output"
            }
            Err(error) => check_message("no output", text, &error.to_string())?,
        });
        fate.push(match Condition::parse(run.layout(), text) {
            Ok(_) => ended(model, text)?,
            Err(error) => check_message("no condition", text, &error.to_string())?,
        });
        Ok(fate)
    }
}

/// One line that says something, but for the ends of lines in what it quotes.
pub(crate) fn check_message(fate: &'static str, text: &str, error: &str) -> Result<&'static str, Finding> {
    if error.trim().is_empty() || error.contains('\n') && !text.contains('\n') {
        return Err(Finding(format!("the error {error:?} is no line")));
    }
    Ok(fate)
}

/// A run with the condition to its end: its events are finite, whatever the condition.
fn ended(model: &Entry, text: &str) -> Result<&'static str, Finding> {
    let spec = model.default_run().limit(0.1).tolerance(1e-6);
    let simulation =
        model.simulation(&spec).and_then(|s| s.until(text).map_err(liftoff_studio::registry::input));
    let Ok(simulation) = simulation else { return Ok("condition that is refused") };
    let budget = Budget { steps: 5000, events: 500, memory: 1 << 28, ..Budget::default() };
    let (fate, events) = match simulation.budget(budget).run() {
        Ok(run) => ("condition that ran", run.events().to_vec()),
        Err(error) => {
            check_message("", text, &error.to_string())?;
            ("condition that stopped", error.trajectory().events().to_vec())
        }
    };
    match events.iter().find(|event| !event.t.is_finite() || event.state.iter().any(|x| !x.is_finite())) {
        Some(event) => Err(Finding(format!("not finite: {event}"))),
        None => Ok(fate),
    }
}
