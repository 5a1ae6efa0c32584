//! Sweeps, word by word: planned or refused in a line. None of their members is run.

use std::fmt;
use std::sync::atomic::AtomicBool;

use liftoff_models::models;
use liftoff_studio::sweep::{Sample, Sweep, SweepError};
use liftoff_tests::random::Source;

use crate::expression::check_message;
use crate::text::hostile;
use crate::{Fate, Finding, Subject};

/// What a sweep is built of: its method, and words for it that make sense for a bouncing ball.
const PARTS: [(&str, &[&str]); 5] = [
    ("vary", &["g=1:2:3", "e=0:0.9:4", "y=0.1:10:5:log", "q=0,0.5,1", "y=1:3", "m=1kg:2kg:2", "y=1m:2m:3"]),
    ("set", &["m=1+q", "g=9.81", "e=q/2", "m=3kg", "g=9.81 m/s^2"]),
    ("start", &["y=1+q", "y=1", "x'=q*2", "x'=3 m/s"]),
    ("energy-of", &["y=2", "y=1+q"]),
    (
        "observe",
        &[
            "end",
            "first impact",
            "first impact y'",
            "count impact",
            "t of last impact P",
            "max y",
            "min y'",
            "end E = 2",
        ],
    ),
];

const WORDS: [&str; 52] = [
    "y",
    "e",
    "x",
    "y'",
    "q",
    "m",
    "g",
    "=",
    ":",
    ",",
    "0",
    "1",
    "2",
    "1e308",
    "-",
    "4000001",
    "18446744073709551615",
    "log",
    "1e-320",
    "pi",
    "mm",
    "deg",
    "kg",
    " ",
    "first",
    "last",
    "count",
    "end",
    "max",
    "min",
    "impact",
    "open",
    "settle",
    "P",
    " of ",
    "t",
    "(",
    ")",
    "N(P)",
    "/0",
    "\n",
    "\0",
    "é",
    "'",
    "nan",
    "inf",
    "1e999",
    "::",
    "==",
    "sqrt(",
    "^",
    "+",
];

/// Sweeps of a bouncing ball.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sweeps;

/// A sweep as its parts, each a word and a text.
#[derive(Clone, Debug)]
pub struct Parts {
    parts: Vec<(&'static str, String)>,
    sample: Sample,
}

impl fmt::Display for Parts {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("liftoff sweep bouncing-ball")?;
        self.parts.iter().try_for_each(|(word, text)| write!(f, " --{word} {text:?}"))?;
        write!(f, " # {:?}", self.sample)
    }
}

impl Subject for Sweeps {
    type Case = Parts;

    fn generate(&self, seed: u64) -> Parts {
        let source = &mut Source::new(seed);
        let mut parts = Vec::new();
        for (word, whole) in PARTS {
            let most = if ["vary", "observe"].contains(&word) { 3 } else { 2 };
            let whole = || whole.iter().map(|&text| text.to_owned()).collect::<Vec<_>>();
            for _ in 0..source.below(most + 1).max(usize::from(most == 3 && source.chance(0.95))) {
                let text = if source.chance(0.5) {
                    source.choose(&whole())
                } else {
                    hostile(source, &whole(), &WORDS)
                };
                parts.push((word, text));
            }
        }
        let count = source.choose(&[0, 1, 7, 100, 4_000_000, usize::MAX]);
        let seed = source.below(1000) as u64;
        let sample = match source.below(6) {
            0 => Sample::Random { count, seed },
            1 => Sample::Sobol { count: count.min(10_000), seed: source.chance(0.5).then_some(seed) },
            _ => Sample::Grid,
        };
        Parts { parts, sample }
    }

    fn check(&self, Parts { parts, sample }: &Parts) -> Result<Fate, Finding> {
        let Ok(ball) = models().find("bouncing-ball") else { return Err(Finding("no ball".to_owned())) };
        let stop = AtomicBool::new(true);
        let built = parts.iter().try_fold(Sweep::new(ball), |sweep, (word, text)| match *word {
            "vary" => sweep.vary(text),
            "set" => sweep.set(text),
            "start" => sweep.start(text),
            "energy-of" => sweep.energy_of(text),
            _ => sweep.observe(text),
        });
        let planned: Result<_, SweepError> =
            built.and_then(|sweep| sweep.sample(*sample).cancel(&stop).run());
        match planned {
            Ok(table) => match table.rows.len() {
                0 => Ok(vec!["planned"]),
                rows => Err(Finding(format!("{rows} members were run"))),
            },
            Err(error) => {
                let written: String = parts.iter().map(|(_, text)| text.as_str()).collect();
                Ok(vec![check_message("refused", &written, &error.to_string())?])
            }
        }
    }
}
