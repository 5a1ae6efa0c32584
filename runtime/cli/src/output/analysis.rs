//! What `equilibrium` and `linearise` print.

use crate::CommandError;
use crate::output::json::pretty;
use core::fmt::Write;
use liftoff::__private::expression::{significant, unrounded};
use liftoff_analysis::{BySymmetry, LimitEnd, Linearisation, Load, LoadLimit, Mode, Stability};
use liftoff_core::model::Layout;
use liftoff_studio::analyses::Rest;
use liftoff_studio::animation::ModeShape;
use serde_json::{Map, Value, json};

/// Digits of what is printed.
const DIGITS: usize = 6;
/// Rates below this part of the largest are rounding.
const ROUNDED: f64 = 1e-9;

/// What stands where there are no modes.
const STILL: &str = "  nothing can move\n";

/// How much is said of an equilibrium.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Detail {
    /// Forces of joints, and each mode with its shape.
    All,
    /// The rates of the modes alone.
    Rates,
}

/// All equilibria, each with its position, its reactions, its modes, and how far a load of this
/// name may go.
pub fn equilibria_text(layout: &Layout, found: &[Rest], load_name: Option<&str>, detail: Detail) -> String {
    let each = found.iter().enumerate().map(|(i, Rest { equilibrium: rest, limit: end })| {
        let closed =
            if rest.closed.is_empty() { "free".to_owned() } else { rest.closed.join(", ") + " closed" };
        let positions = layout.coordinates.iter().zip(&rest.positions);
        let positions: Vec<_> = positions.map(|(c, q)| format!("{} = {}", c.name, number(*q))).collect();
        let loads: Vec<_> = rest.loads.iter().flat_map(load).collect();
        let mut text = format!(
            "{}: {closed}, {}\n  {}\n",
            i + 1,
            describe_stability(rest.stability()),
            positions.join("  ")
        );
        if !loads.is_empty() {
            let _ = writeln!(text, "  {}", loads.join("  "));
        }
        let forces = rest.joint_forces.iter();
        let forces: Vec<_> = forces.map(|(name, force)| format!("{name} = {}", number(*force))).collect();
        if !forces.is_empty() && detail == Detail::All {
            let _ = writeln!(text, "  {}", forces.join("  "));
        }
        let limit = load_name.map_or_else(String::new, |name| format!("  {name} {}\n", limit(end.as_ref())));
        let modes = match detail {
            Detail::All => modes_text(layout, &rest.linear),
            Detail::Rates => rates_text(&rest.linear),
        };
        text + &modes + &limit
    });
    each.collect()
}

/// The rates of the modes in a line.
fn rates_text(linear: &Linearisation) -> String {
    let modes = linear.modes();
    let largest = largest(modes.iter());
    let rates: Vec<String> = modes.iter().map(|mode| rate(mode, largest)).collect();
    if rates.is_empty() { STILL.to_owned() } else { format!("  {}\n", rates.join("; ")) }
}

fn limit(limit: Option<&LoadLimit>) -> String {
    match limit {
        Some(limit) if limit.end == LimitEnd::Unfollowed => {
            format!("may go to {} at least: {}", number(limit.value), limit.end)
        }
        Some(limit) => format!("may go to {}: there {}", number(limit.value), limit.end),
        None => "may go as far as it is followed".to_owned(),
    }
}

/// The symmetric modes, the antisymmetric ones, and how much faster these grow.
pub fn by_symmetry_text(layout: &Layout, parts: &BySymmetry) -> String {
    let [symmetric, antisymmetric] = [&parts.symmetric, &parts.antisymmetric].map(Linearisation::modes);
    let largest = largest(symmetric.iter().chain(&antisymmetric));
    let [symmetric, antisymmetric] = [symmetric, antisymmetric].map(|modes| lines(layout, &modes, largest));
    let faster = parts.growth_ratio().map_or_else(String::new, |ratio| {
        format!("the antisymmetric motion grows {} times as fast as the symmetric one\n", number(ratio))
    });
    format!("symmetric\n{symmetric}antisymmetric\n{antisymmetric}{faster}")
}

/// The modes of vibration to be drawn, each with what is printed of it.
pub fn mode_shapes(linear: &Linearisation) -> Vec<ModeShape> {
    let modes = linear.modes();
    let largest = largest(modes.iter());
    modes.iter().map(|mode| mode_shape(rate(mode, largest), mode)).collect()
}

/// The same of the symmetric, then of the antisymmetric ones.
pub fn mode_shapes_by_symmetry(parts: &BySymmetry) -> Vec<ModeShape> {
    let [symmetric, antisymmetric] = [&parts.symmetric, &parts.antisymmetric].map(Linearisation::modes);
    let largest = largest(symmetric.iter().chain(&antisymmetric));
    let named = [("symmetric", symmetric), ("antisymmetric", antisymmetric)];
    let part = |(name, modes): (&str, Vec<Mode>)| {
        modes
            .iter()
            .map(|mode| mode_shape(format!("{name}: {}", rate(mode, largest)), mode))
            .collect::<Vec<_>>()
    };
    named.map(part).concat()
}

fn mode_shape(words: String, mode: &Mode) -> ModeShape {
    ModeShape { words, shape: mode.shape.iter().map(|x| [x.re, x.im]).collect() }
}

/// One line for each mode: how fast, how damped, and in which proportion the coordinates move.
pub fn modes_text(layout: &Layout, linear: &Linearisation) -> String {
    let modes = linear.modes();
    lines(layout, &modes, largest(modes.iter()))
}

fn largest<'a>(modes: impl Iterator<Item = &'a Mode>) -> f64 {
    modes.map(Mode::frequency).fold(0.0, f64::max)
}

fn lines(layout: &Layout, modes: &[Mode], largest: f64) -> String {
    if modes.is_empty() {
        return STILL.to_owned();
    }
    modes.iter().map(|mode| format!("  {}: {}\n", rate(mode, largest), shape(layout, mode))).collect()
}

fn rate(mode: &Mode, largest: f64) -> String {
    let (frequency, growth) = (mode.frequency(), mode.growth());
    let hertz = || format!("{} rad/s ({} Hz)", number(frequency), number(frequency / core::f64::consts::TAU));
    match mode.rate {
        _ if frequency <= ROUNDED * largest || frequency == 0.0 => "neutral".to_owned(),
        rate if rate.im == 0.0 && growth > 0.0 => format!("grows at {} 1/s", number(growth)),
        rate if rate.im == 0.0 => format!("decays at {} 1/s", number(-growth)),
        _ if growth.abs() <= ROUNDED * frequency => hertz(),
        _ => format!("{}, damping ratio {}", hertz(), number(mode.damping_ratio())),
    }
}

fn shape(layout: &Layout, mode: &Mode) -> String {
    let parts = layout.coordinates.iter().zip(&mode.shape).map(|(coordinate, x)| {
        let (re, im) = (unrounded(x.re, 1e6), unrounded(x.im, 1e6));
        let sign = if im < 0.0 { "−" } else { "+" };
        let im = if im == 0.0 { String::new() } else { format!(" {sign} {}i", number(im.abs())) };
        format!("{} {}{im}", coordinate.name, number(re))
    });
    parts.collect::<Vec<_>>().join(", ")
}

fn load(load: &Load) -> Vec<String> {
    let name = load.contact;
    let normal = format!("N({name}) = {}", range(load.normal));
    let friction = load.friction.map(|force| format!("R({name}) = {}", range(force)));
    [normal].into_iter().chain(friction).collect()
}

fn range([least, largest]: [f64; 2]) -> String {
    let size = least.abs().max(largest.abs());
    if size.is_finite() && largest - least <= ROUNDED * size {
        return number(0.5 * (least + largest));
    }
    format!("{} … {}", number(unrounded(least, 1e6 * size)), number(unrounded(largest, 1e6 * size)))
}

fn number(x: f64) -> String {
    if x.is_infinite() { (if x < 0.0 { "−∞" } else { "∞" }).to_owned() } else { significant(x, DIGITS) }
}

fn describe_stability(stability: Stability) -> String {
    match stability {
        Stability::Fixed => "fixed by its contacts".to_owned(),
        Stability::Stable => "stable".to_owned(),
        Stability::Neutral => "neutral".to_owned(),
        Stability::Unstable(1) => "unstable: 1 mode grows".to_owned(),
        Stability::Unstable(count) => format!("unstable: {count} modes grow"),
    }
}

/// The same with all digits.
pub fn equilibria_json(layout: &Layout, found: &[Rest], has_load: bool) -> Result<String, CommandError> {
    let each: Vec<Value> = found
        .iter()
        .map(|Rest { equilibrium: rest, limit }| {
            let loads: Vec<Value> = rest
                .loads
                .iter()
                .map(|load| json!({ "contact": load.contact, "normal": load.normal, "friction": load.friction }))
                .collect();
            let mut told = json!({
                "closed": rest.closed,
                "stability": describe_stability(rest.stability()),
                "position": named(layout, rest.positions.iter().map(|q| json!(q))),
                "loads": loads,
                "modes": modes(layout, &rest.linear),
            });
            if !rest.joint_forces.is_empty() {
                let forces = rest.joint_forces.iter().map(|(name, force)| ((*name).to_owned(), json!(force)));
                told["joint_forces"] = forces.collect::<Map<_, _>>().into();
            }
            if has_load {
                told["limit"] = json!(limit.as_ref().map(|limit| json!({ "value": limit.value, "end": limit.end.to_string() })));
            }
            told
        })
        .collect();
    pretty(&each)
}

/// The modes with the matrices of ẋ = A x + B Q, x = (ξ, ξ̇), and Z of δq = Z ξ, row by row.
pub fn linear_json(layout: &Layout, linear: &Linearisation) -> Result<String, CommandError> {
    pretty(&matrices(layout, linear))
}

/// The same of the symmetric and of the antisymmetric motions.
pub fn by_symmetry_json(layout: &Layout, parts: &BySymmetry) -> Result<String, CommandError> {
    pretty(&json!({
        "symmetric": matrices(layout, &parts.symmetric),
        "antisymmetric": matrices(layout, &parts.antisymmetric),
    }))
}

fn matrices(layout: &Layout, linear: &Linearisation) -> Value {
    let rows = |matrix: &nalgebra::DMatrix<f64>| -> Vec<Vec<f64>> {
        matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
    };
    json!({
        "modes": modes(layout, linear),
        "A": rows(&linear.state_matrix()),
        "B": rows(&linear.input_matrix()),
        "Z": rows(linear.basis()),
    })
}

fn modes(layout: &Layout, linear: &Linearisation) -> Vec<Value> {
    let each = linear.modes().into_iter().map(|mode| {
        let shape = mode.shape.iter().map(|x| json!([x.re, x.im]));
        json!({ "rate": [mode.rate.re, mode.rate.im], "shape": named(layout, shape) })
    });
    each.collect()
}

fn named(layout: &Layout, values: impl Iterator<Item = Value>) -> Map<String, Value> {
    layout.coordinates.iter().map(|coordinate| coordinate.name.to_owned()).zip(values).collect()
}
