//! Two masses that hang from a soft spring and swing up and down, joined by a very stiff one
//! without damping. With m = l = g = 1 and the soft stiffness 1 their deviations from rest obey
//! z̈ = −K z, K = ((1 + k, −k), (−k, k)), of which the frequencies are ω² = ½ (1 + 2k + √(1 + 4k²))
//! and k/ω². What the doubles of the start have of the fast one is in the closed form.

use liftoff_core::scalar::{DoubleDouble, Real};
use liftoff_studio::registry::{Entry, MethodId, MotionError, PrecisionSpec};
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::source::embedded;
use liftoff_studio::work_precision::WorkPrecisionRow;
use std::time::Duration;

const SCENE: &str = "/// Two masses below each other, on a soft spring and a stiff one.
    #[derive(BarSystem)] #[gravity(g)] #[particle(P, mass = m)] #[particle(Q, mass = m)] #[ground(O = (0, 0))]
    #[slider(P = vertical(0))] #[slider(Q = vertical(0))] #[figure(P = (0, -l), Q = (0, -2 * l))]
    #[spring(OP, stiffness = c, length = l)] #[spring(PQ, stiffness = k, length = l)]
    #[coordinate(y = -y(P))] #[coordinate(z = -y(Q))]
    struct StiffSpring { m: f64, l: f64, g: f64, c: f64, k: f64 }";
/// In units of the soft one.
const STIFFNESS: f64 = 1e10;
const END: f64 = 6.0;
/// At rest, each mass stretches the soft spring by 1.
const REST: f64 = 3.0;
const AMPLITUDE: f64 = 0.5;

/// The methods that are not held to the fast oscillation, as long as a tolerance does not resolve
/// it.
pub fn request(measuring: Duration) -> PrecisionSpec {
    PrecisionSpec {
        methods: vec![MethodId::Auto, MethodId::Radau],
        tolerances: vec![1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10],
        measuring,
    }
}

/// Errors against run times.
pub fn measure(measuring: Duration) -> Result<Vec<WorkPrecisionRow>, MotionError> {
    let request = request(measuring);
    let (model, start, spec) = hanging(STIFFNESS);
    let measured = model.precision_against(&spec, &request, |t| swing(STIFFNESS, start, t))?;
    Ok(measured.into_iter().map(|measured| WorkPrecisionRow::new(model.name(), measured)).collect())
}

/// The model, where it starts from rest, but for rounding in the slow mode, and its run.
fn hanging(k: f64) -> (Entry, [f64; 2], RunSpec) {
    let start = [REST + AMPLITUDE, REST + AMPLITUDE + 1.0 + (1.0 + 0.5 * AMPLITUDE) / k];
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0), ("c", 1.0), ("k", k)])
        .start(&[("y", start[0]), ("z", start[1])])
        .until(&format!("t = {END}"))
        .tolerance(1e-6);
    (embedded("stiff-spring", SCENE, RunSpec::with(&[])), start, spec)
}

/// Across and down of both masses, then their speeds, by normal modes (1, 1 + 1/k − ω²/k).
fn swing(k: f64, start: [f64; 2], t: f64) -> Vec<DoubleDouble> {
    let on = DoubleDouble::from_f64;
    let (one, k) = (on(1.0), on(k));
    let rest = [on(REST), on(REST) + one + one / k];
    let fast = on(0.5) * (one + k + k + (one + on(4.0) * k * k).sqrt());
    let squares = [k / fast, fast];
    let shapes = squares.map(|square| one + (one - square) / k);
    let [y, z] = [on(start[0]) - rest[0], on(start[1]) - rest[1]];
    // y = a + b, z = s₀ a + s₁ b.
    let second = (z - shapes[0] * y) / (shapes[1] - shapes[0]);
    let modes = [(y - second, 0), (second, 1)].map(|(amplitude, i)| {
        let frequency = squares[i].sqrt();
        let (sine, cosine) = (frequency * on(t)).sin_cos();
        [amplitude * cosine, -amplitude * frequency * sine, shapes[i]]
    });
    let sum = |part: usize| modes[0][part] + modes[1][part];
    let shaped = |part: usize| modes[0][2] * modes[0][part] + modes[1][2] * modes[1][part];
    let entries = [rest[0] + sum(0), rest[1] + shaped(0), sum(1), shaped(1)];
    entries.into_iter().flat_map(|entry| [on(0.0), entry]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use liftoff_core::scalar::Scalar;

    /// Where the spring is soft enough, a run at a tight tolerance finds the same.
    #[test]
    fn a_run_follows_the_closed_form() {
        let k = 1e3;
        let (model, start, spec) = hanging(k);
        let run = model.simulation(&spec.tolerance(1e-13)).expect("a simulation").run().expect("a run");
        for (x, known) in run.final_state().into_iter().zip(swing(k, start, END)) {
            // Some hundred steps, each at its tolerance.
            assert!((x - known.to_f64()).abs() < 1e-10, "{x}, not {}", known.to_f64());
        }
    }
}
