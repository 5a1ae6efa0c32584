//! The ladder of scenes: what each costs, derived and by hand.
//!
//! Operations, machine code and time of the right-hand side; machine code of the whole program and
//! the time to compile it, all that it depends on ready; what it links of the runtime.

use std::hint::black_box;
use std::time::{Duration, Instant};

use liftoff_codegen::program::Id;
use liftoff_codegen::{analyse, expand};
use liftoff_core::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};
use liftoff_ladder::measure::{Binary, Function, has_code};
use liftoff_ladder::{
    DroppedBar, FallingBar, FreeBar, Pendulum, SlungBar, SprungPendulum, StandingBar, by_hand,
};
use serde_json::{Value, json};

use crate::Result;

const STATES: usize = 64;
const REPEATS: usize = 2000;

/// Modules of the runtime that a program may have code of.
const MODULES: [&str; 12] = [
    "liftoff_core::integrate",
    "liftoff_core::kernel",
    "liftoff_core::project",
    "liftoff::event",
    "liftoff::event::detection",
    "liftoff::numerics::root_isolation",
    "liftoff::contact",
    "liftoff::simulation::phase_run",
    "liftoff::integration::singular",
    "liftoff::simulation",
    "liftoff::assembly",
    "liftoff::expression",
];

/// One row for each scene.
pub fn rows() -> Result<Vec<Value>> {
    let anchored = Anchored::new(&Binary::running()?);
    [
        row(&anchored, "free_bar", &FreeBar::SCENE, 0, by_hand::free_bar::rates),
        row(&anchored, "falling_bar", &FallingBar::SCENE, 0, by_hand::falling_bar::rates),
        row(&anchored, "pendulum", &Pendulum::SCENE, 0, by_hand::pendulum::rates),
        row(&anchored, "standing_bar", &StandingBar::SCENE, 1, by_hand::standing_bar::rates),
        row(&anchored, "dropped_bar", &DroppedBar::SCENE, 0, by_hand::dropped_bar::rates),
        row(&anchored, "sprung_pendulum", &SprungPendulum::SCENE, 0, by_hand::sprung_pendulum::rates),
        row(&anchored, "slung_bar", &SlungBar::SCENE, 1, by_hand::slung_bar::rates),
    ]
    .into_iter()
    .collect()
}

fn row<M: BarSystem, const K: usize>(
    anchored: &Anchored,
    scene: &str,
    model: &M,
    set: u64,
    rates: fn(&[f64; K]) -> [f64; K],
) -> Result<Value> {
    let declaration: proc_macro2::TokenStream = M::LAYOUT.declaration.parse()?;
    let analysis = analyse(declaration.clone())?;
    let phase = analysis.functions.phases.iter().find(|phase| phase.set.closed == set);
    let cost = phase.map(|phase| {
        let outputs: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
        analysis.functions.program.cost(&outputs)
    });
    let expansion = shortest(5, || drop(black_box(expand(declaration.clone()))));
    let measured = M::phase(ContactSet::from_bits(set), Form::Reduced, Measure { model, anchored, rates });
    let by_hand = format!("{scene}_by_hand");
    let (derived, compiled) = Binary::released(scene)?;
    let (written, compiled_by_hand) = Binary::released(&by_hand)?;
    let functions = derived.functions();
    let linked: Vec<&str> = MODULES.into_iter().filter(|module| has_code(&functions, module)).collect();
    Ok(json!({
        "scene": scene,
        "closed_form": phase.is_some(),
        "operations": cost.map(|cost| cost.flops()),
        "counts": cost.map(|cost| cost.to_string()),
        "ns": measured.ns[0],
        "ns_by_hand": measured.ns[1],
        "code_bytes": measured.bytes[0],
        "code_bytes_by_hand": measured.bytes[1],
        "text_bytes": derived.text(),
        "text_bytes_by_hand": written.text(),
        "expand_ms": milliseconds(expansion),
        "compile_ms": milliseconds(compiled),
        "compile_ms_by_hand": milliseconds(compiled_by_hand),
        "linked": linked.join(" "),
        "dependencies": dependencies(!linked.contains(&"liftoff::simulation")),
    }))
}

/// Packages that a program needs at run time besides its own: what cargo lists of the runtime,
/// macros left out.
fn dependencies(core: bool) -> Option<usize> {
    let features: &[&str] = if core { &["--no-default-features", "--features", "libm"] } else { &[] };
    let mut tree = std::process::Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    tree.args([
        "tree",
        "--package",
        "liftoff-dynamics",
        "--edges",
        "normal,no-proc-macro",
        "--prefix",
        "none",
    ])
    .args(features);
    let listed = String::from_utf8(tree.output().ok()?.stdout).ok()?;
    let mut packages: Vec<&str> = listed.lines().filter_map(|line| line.split(' ').next()).collect();
    packages.sort_unstable();
    packages.dedup();
    Some(packages.len())
}

/// The functions of this program, found by their addresses while it runs.
struct Anchored {
    functions: Vec<Function>,
    offset: u64,
}

#[inline(never)]
fn anchor() {
    black_box(());
}

impl Anchored {
    fn new(binary: &Binary) -> Self {
        let functions = binary.functions();
        let here = functions.iter().find(|function| function.name.contains("6scenes6anchor"));
        let offset = here.map_or(0, |here| (anchor as fn() as usize as u64).wrapping_sub(here.address));
        Self { functions, offset }
    }

    /// Bytes of the function that begins at an address.
    fn size(&self, address: usize) -> Option<u64> {
        let address = (address as u64).wrapping_sub(self.offset);
        self.functions.iter().find(|function| function.address == address).map(|function| function.size)
    }
}

/// Derived, by hand.
struct Measured {
    ns: [f64; 2],
    bytes: [Option<u64>; 2],
}

struct Measure<'a, M, const K: usize> {
    model: &'a M,
    anchored: &'a Anchored,
    rates: fn(&[f64; K]) -> [f64; K],
}

impl<M: BarSystem, const K: usize> PhaseVisitor<M, f64> for Measure<'_, M, K> {
    type Output = Measured;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Measured {
        let constants = self.model.constants::<f64>();
        let (states, own) = (states::<N>(), states::<K>());
        // Called, both of them.
        let (derivative, rates) = (black_box(phase.derivative), black_box(self.rates));
        let mut ns = [f64::INFINITY; 2];
        // In turn, so that both see the machine in the same states.
        for _ in 0..REPEATS {
            let derived = elapsed(&states, |state| derivative(&constants, &phase.set, state));
            let by_hand = elapsed(&own, rates);
            ns = [ns[0].min(derived), ns[1].min(by_hand)];
        }
        let bytes = [phase.derivative as usize, self.rates as usize].map(|f| self.anchored.size(f));
        Measured { ns, bytes }
    }
}

/// States with 0.2 to 0.8 in each entry.
fn states<const N: usize>() -> [[f64; N]; STATES] {
    let value = |i: usize, j: usize| 0.2 + 0.6 * ((1 + i * N + j) as f64 * 0.618).fract();
    core::array::from_fn(|i| core::array::from_fn(|j| value(i, j)))
}

/// ns per evaluation on independent states.
fn elapsed<const N: usize>(states: &[[f64; N]; STATES], f: impl Fn(&[f64; N]) -> [f64; N]) -> f64 {
    let start = Instant::now();
    for state in states {
        black_box(f(black_box(state)));
    }
    start.elapsed().as_nanos() as f64 / STATES as f64
}

fn shortest(repeats: usize, mut f: impl FnMut()) -> Duration {
    let run = |_| {
        let start = Instant::now();
        f();
        start.elapsed()
    };
    (0..repeats).map(run).min().unwrap_or_default()
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}
