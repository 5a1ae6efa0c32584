//! A range of seeds in this process: what is found, and how far it came, in lines on the standard
//! output.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::{Subject, judge};

/// How often it tells how far it is.
const HEARTBEAT: Duration = Duration::from_millis(200);

/// A case that waits instead of computing is a hang after so many times the limit.
const WAITING: u32 = 20;

/// No seed is tried yet, or any more.
const IDLE: u64 = u64::MAX;
const DONE: u64 = u64::MAX - 1;

/// What a worker is to do.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// The first seed.
    pub from: u64,
    /// The seed after the last.
    pub to: u64,
    /// When a case counts as a hang: time of the processor, which other processes do not take.
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
    pub fn parse(text: &str) -> Option<Self> {
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
    let seed = AtomicU64::new(IDLE);
    std::thread::scope(|scope| {
        scope.spawn(|| watch(&seed, order.limit));
        let (mut told, mut fates) = (Instant::now(), BTreeMap::new());
        for k in order.from..order.to {
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
        seed.store(DONE, Ordering::Relaxed);
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

/// What this process has computed, where the system tells, in hundredths of a second; the time
/// since its start elsewhere.
fn computed(began: Instant) -> Duration {
    let told = std::fs::read_to_string("/proc/self/stat").ok().and_then(|text| {
        // Behind the program's name: the 14th and 15th word of all.
        let mut words = text.rsplit(')').next()?.split_whitespace().skip(11);
        let [user, system] = [words.next()?, words.next()?].map(|ticks| ticks.parse::<u64>().ok());
        Some(Duration::from_millis(10 * (user? + system?)))
    });
    told.unwrap_or_else(|| began.elapsed())
}

/// Ends the process when one seed takes longer than the limit.
fn watch(seed: &AtomicU64, limit: Duration) {
    let began = Instant::now();
    let times = || [computed(began), began.elapsed()];
    let (mut last, mut since) = (IDLE, times());
    loop {
        std::thread::sleep(Duration::from_millis(50));
        let now = seed.load(Ordering::Relaxed);
        if now == DONE {
            return;
        }
        if now != last {
            (last, since) = (now, times());
            continue;
        }
        let [used, passed] = times();
        if now != IDLE && (used - since[0] > limit || passed - since[1] > WAITING * limit) {
            // The parent goes on behind this seed, whether it learns why or not.
            let _ = Line::Found(now, format!("hang: longer than {} s", limit.as_secs_f64())).write();
            std::process::exit(1);
        }
    }
}
