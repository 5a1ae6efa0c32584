//! `cargo run --release -p liftoff-fuzz -- declaration --minutes 10`.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::{Args, Parser, Subcommand};
use liftoff_fuzz::campaign::Campaign;
use liftoff_fuzz::declaration::Declarations;
use liftoff_fuzz::expression::Expressions;
use liftoff_fuzz::journal::Journals;
use liftoff_fuzz::metamorphic::Scenes;
use liftoff_fuzz::run::Runs;
use liftoff_fuzz::sweep::Sweeps;
use liftoff_fuzz::worker::{self, Order};
use liftoff_fuzz::{Subject, judge};

/// Feeds liftoff with hostile input
#[derive(Parser)]
struct Fuzz {
    #[command(subcommand)]
    subject: Which,
}

#[derive(Subcommand)]
enum Which {
    /// Declarations: valid, mutated, arbitrary, through the derive macro and `explain FILE`
    Declaration(Bounds),
    /// Runs of all models: random parameters, starts, plans, methods, tolerances, and other ways to
    /// the same motion
    Run(Bounds),
    /// Expressions, conditions and formulas
    Expression(Bounds),
    /// Sweeps, planned and not run
    Sweep(Bounds),
    /// Journals of a sweep
    Journal(Bounds),
    /// Scenes in equal forms, held to the laws of mechanics
    Metamorphic(Bounds),
}

/// How long and how much.
#[derive(Args, Clone, Debug)]
struct Bounds {
    /// For how many minutes
    #[arg(long, default_value_t = 1.0)]
    minutes: f64,
    /// At most so many cases
    #[arg(long, default_value_t = u64::MAX)]
    cases: u64,
    /// The first seed
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Prints the case of the seed, and what is wrong with it
    #[arg(long)]
    show: bool,
    /// How many processes at once; as many as there are cores, if not given
    #[arg(long)]
    jobs: Option<usize>,
    /// Seconds after which a case is a hang; more where the machine is loaded
    #[arg(long, default_value_t = 300.0)]
    limit: f64,
    /// What a process may use of memory, MiB
    #[arg(long, default_value_t = 2048)]
    memory: u64,
    #[arg(long, hide = true)]
    from: Option<u64>,
    #[arg(long, hide = true, default_value_t = 0)]
    to: u64,
    #[arg(long, hide = true)]
    trace: bool,
}

fn main() -> ExitCode {
    match Fuzz::parse().subject {
        Which::Declaration(bounds) => run("declaration", &Declarations::default(), 20_000, &bounds),
        Which::Run(bounds) => run("run", &Runs, 1000, &bounds),
        Which::Expression(bounds) => run("expression", &Expressions::default(), 20_000, &bounds),
        Which::Sweep(bounds) => run("sweep", &Sweeps, 20_000, &bounds),
        Which::Journal(bounds) => run("journal", &Journals::default(), 20_000, &bounds),
        Which::Metamorphic(bounds) => run("metamorphic", &Scenes, 200, &bounds),
    }
}

fn run(name: &'static str, subject: &(impl Subject + Sync), range: u64, bounds: &Bounds) -> ExitCode {
    let limit = Duration::from_secs_f64(bounds.limit);
    if bounds.show {
        let case = subject.generate(bounds.seed);
        println!("{case}");
        println!("{}", subject.details(&case));
        return match judge(subject, &case) {
            Ok(fate) => {
                println!("{}", fate.join(", "));
                ExitCode::SUCCESS
            }
            Err(finding) => failed(&finding.0),
        };
    }
    if let Some(from) = bounds.from {
        let order = Order { from, to: bounds.to, limit, trace: bounds.trace };
        return worker::run(subject, order).map_or(ExitCode::FAILURE, |()| ExitCode::SUCCESS);
    }
    let campaign = Campaign {
        subject: name,
        seed: bounds.seed,
        time: Duration::from_secs_f64(60.0 * bounds.minutes),
        cases: bounds.cases,
        jobs: bounds.jobs.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from)),
        limit,
        memory: 1024 * bounds.memory,
        range,
    };
    let began = Instant::now();
    match campaign.run(|seed, text| println!("seed {seed}: {text}")) {
        Err(error) => failed(&format!("no worker: {error}")),
        Ok(outcome) => {
            let rate = outcome.cases as f64 / began.elapsed().as_secs_f64();
            for (fate, count) in &outcome.fates {
                println!("{count:9} {fate}");
            }
            println!("{} cases, {rate:.0} a second, {} findings", outcome.cases, outcome.findings.len());
            if outcome.findings.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
    }
}

fn failed(text: &str) -> ExitCode {
    eprintln!("{text}");
    ExitCode::FAILURE
}
