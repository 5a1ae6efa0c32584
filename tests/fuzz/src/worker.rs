//! A range of seeds in this process: what is found, and how far it came, in lines on the standard output.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::{Subject, judge};

/// How often it tells how far it is.
const HEARTBEAT: Duration = Duration::from_millis(200);

/// No seed is tried.
const IDLE: u64 = u64::MAX;

/// What a worker is to do.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// The first seed.
    pub from: u64,
    /// The seed after the last.
    pub to: u64,
    /// When a case counts as a hang.
    pub limit: Duration,
    /// Whether each seed is told before it is tried.
    pub trace: bool,
}

/// A line of a worker.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Line {
    /// All seeds below have been tried.
    Reached(u64),
    /// Something is wrong with a seed.
    Found(u64, String),
    /// So many more cases had this fate.
    Fate(u64, String),
}

impl Line {
    fn write(&self) -> io::Result<()> {
        let mut out = io::stdout().lock();
        match self {
            Self::Reached(seed) => writeln!(out, "reached {seed}")?,
            Self::Found(seed, text) => writeln!(out, "found {seed} {}", text.replace('\n', " "))?,
            Self::Fate(count, text) => writeln!(out, "fate {count} {text}")?,
        }
        out.flush()
    }

    /// The line that a worker wrote.
    pub fn read(text: &str) -> Option<Self> {
        let (word, rest) = text.split_once(' ')?;
        match word {
            "reached" => rest.parse().ok().map(Self::Reached),
            "found" | "fate" => {
                let (number, text) = rest.split_once(' ')?;
                let (number, text) = (number.parse().ok()?, text.to_owned());
                Some(if word == "found" { Self::Found(number, text) } else { Self::Fate(number, text) })
            }
            _ => None,
        }
    }
}

/// Tries the seeds; ends the process at a hang.
///
/// # Errors
/// Nobody reads what it writes.
pub fn run(subject: &(impl Subject + Sync), order: Order) -> io::Result<()> {
    std::panic::set_hook(Box::new(|_| ()));
    let (seed, began) = (AtomicU64::new(IDLE), Instant::now());
    let since = AtomicU64::new(0);
    std::thread::scope(|scope| {
        scope.spawn(|| watch(&seed, &since, began, order.limit));
        let (mut told, mut fates) = (Instant::now(), BTreeMap::new());
        for k in order.from..order.to {
            since.store(millis(began), Ordering::Relaxed);
            seed.store(k, Ordering::Relaxed);
            if order.trace || told.elapsed() > HEARTBEAT {
                tell(&mut fates, k)?;
                told = Instant::now();
            }
            match judge(subject, &subject.generate(k)) {
                Ok(words) => words.into_iter().for_each(|word| *fates.entry(word).or_default() += 1),
                Err(finding) => Line::Found(k, finding.0).write()?,
            }
        }
        seed.store(IDLE, Ordering::Relaxed);
        tell(&mut fates, order.to)
    })
}

/// What became of the cases since it told the last time, and how far it is.
fn tell(fates: &mut BTreeMap<&'static str, u64>, reached: u64) -> io::Result<()> {
    for (fate, count) in std::mem::take(fates) {
        Line::Fate(count, fate.to_owned()).write()?;
    }
    Line::Reached(reached).write()
}

fn millis(began: Instant) -> u64 {
    began.elapsed().as_millis() as u64
}

/// Ends the process when one seed takes longer than the limit.
fn watch(seed: &AtomicU64, since: &AtomicU64, began: Instant, limit: Duration) {
    let (mut last, mut started) = (IDLE, false);
    loop {
        std::thread::sleep(Duration::from_millis(20));
        let now = seed.load(Ordering::Relaxed);
        if now == IDLE && started {
            return;
        }
        started |= now != IDLE;
        let late =
            u128::from(millis(began).saturating_sub(since.load(Ordering::Relaxed))) > limit.as_millis();
        if now != IDLE && now == last && late {
            // The parent goes on behind this seed, whether it learns why or not.
            let _ = Line::Found(now, format!("hang: longer than {} s", limit.as_secs_f64())).write();
            std::process::exit(1);
        }
        last = now;
    }
}
