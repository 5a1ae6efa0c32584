//! One kind of run in a loop, for profilers and counters of instructions:
//!
//! ```text
//! cargo bench -p liftoff-tests --bench runs --no-run
//! valgrind --tool=callgrind --toggle-collect='*measured*' target/release/deps/runs-… stick-slip dop853 1e-9 10
//! ```
//!
//! A model's name with its default run, `NAME+sensitivity` with its derivatives by the first four
//! parameters besides, `NAME+compiled` with these by equations compiled for them ([`compiled`] has
//! the names), or `stick-slip`, the run of the friction benchmark, or `by-hand`, the same in event
//! code by hand; a method; a tolerance; how many runs.

#[path = "speed/stick_slip.rs"]
mod stick_slip;

use liftoff::method::MethodId;
use liftoff_analysis::{Sensitivities, Variable};
use liftoff_compiled::{CompassWalker, SliderCrank, Trebuchet, Zigzag};
use liftoff_core::scalar::Dual4;
use liftoff_core::system::{ModelOn, varied};
use std::hint::black_box;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let [name, method, tolerance, repeats] = &words[..] else { return Ok(()) };
    let (tolerance, repeats): (f64, usize) = (tolerance.parse()?, repeats.parse()?);
    if name == "by-hand" {
        measured(repeats, &|| {
            black_box(stick_slip::by_hand(&stick_slip::BELT, tolerance));
        });
        return Ok(());
    }
    if let Some(name) = name.strip_suffix("+sensitivity") {
        return sensitivity(name, (method.parse()?, tolerance), repeats, None);
    }
    if let Some(name) = name.strip_suffix("+compiled") {
        return sensitivity(name, (method.parse()?, tolerance), repeats, Some(compiled(name)?));
    }
    let simulation = if name == "stick-slip" {
        stick_slip::simulation(tolerance)?
    } else {
        let entry = liftoff_compiled::models().find(name)?;
        entry.simulation(&entry.default_run().tolerance(tolerance))?
    };
    let simulation = simulation.method(method.parse::<MethodId>()?);
    measured(repeats, &|| drop(black_box(simulation.run())));
    Ok(())
}

type Equations = fn(&[Dual4]) -> ModelOn<Dual4>;

fn compiled(name: &str) -> Result<Equations, String> {
    Ok(match name {
        "compass-walker" => varied::<CompassWalker>,
        "slider-crank" => varied::<SliderCrank>,
        "trebuchet" => varied::<Trebuchet>,
        "zigzag" => varied::<Zigzag>,
        _ => return Err(format!("{name} is not compiled for derivatives")),
    })
}

fn sensitivity(
    name: &str,
    (method, tolerance): (MethodId, f64),
    repeats: usize,
    compiled: Option<Equations>,
) -> Result<(), Box<dyn std::error::Error>> {
    let entry = liftoff_compiled::models().find(name)?;
    let spec = entry.default_run().tolerance(tolerance);
    let simulation = entry.simulation(&spec)?.method(method);
    let parameters = &simulation.model().parameters;
    let variable = |(i, (name, &value)): (usize, (&&str, &f64))| Variable {
        name: (*name).to_owned(),
        parameter: Some(i),
        value,
        unit: if value == 0.0 { 1.0 } else { value.abs() },
    };
    let variables: Vec<Variable> =
        entry.layout().parameters.iter().zip(parameters).enumerate().map(variable).take(4).collect();
    let equations = |values: &[Dual4]| match compiled {
        Some(equations) => Ok(equations(values)),
        None => entry.varied(values).map_err(|error| error.to_string()),
    };
    let start = |variable: &Variable, value: f64| {
        let mut spec = spec.clone();
        let known = spec.parameters.iter_mut().filter(|(known, _)| *known == variable.name);
        known.for_each(|(_, old)| *old = value);
        let simulation = entry.simulation(&spec).map_err(|error| error.to_string())?;
        simulation.start_state().map_err(|error| error.to_string())
    };
    equations(&parameters.iter().map(|&value| Dual4::new(value, [0.0; 4])).collect::<Vec<_>>())?;
    measured(repeats, &|| {
        let run = simulation.run().expect("a run");
        drop(black_box(Sensitivities::compute(&run, equations, &variables, start)));
    });
    Ok(())
}

#[inline(never)]
fn measured(repeats: usize, run: &dyn Fn()) {
    (0..repeats).for_each(|_| run());
}
