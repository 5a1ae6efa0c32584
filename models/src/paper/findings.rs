//! What follows from the runs, one statement each with its numbers.

use super::ReportError;
use super::falling_pair;
use super::figure::decimals;
use super::published;
use super::reading::{at, time_of};
use super::strict;
use super::threshold::threshold;
use crate::models;
use liftoff::expression::superscript;
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};
use std::f64::consts::FRAC_PI_3;

/// A statement with its anchor on the page, in HTML.
pub struct Finding {
    /// Its anchor.
    pub anchor: &'static str,
    /// What it is about.
    pub title: &'static str,
    /// The statement.
    pub text: String,
}

/// All statements; `zigzag` are the runs of Fig. 1b that the paper shows.
pub fn findings(
    pair: &falling_pair::Runs,
    zigzag: &published::Runs,
    tolerance: f64,
) -> Result<Vec<Finding>, ReportError> {
    let mut all = vec![problem_books(pair, zigzag)?];
    all.extend(no_second_contact(pair)?);
    all.push(starts(tolerance)?);
    all.push(masses());
    all.extend(without_gravity(pair, tolerance)?);
    all.extend(joint_c(zigzag)?);
    all.push(thread(tolerance)?);
    Ok(all)
}

fn problem_books(pair: &falling_pair::Runs, zigzag: &published::Runs) -> Result<Finding, ReportError> {
    let (held, fall) = (pair.held(), pair.fall());
    let end = held.interval()[1];
    let free = time_of(fall, "phi", FRAC_PI_3, fall.interval())?;
    let value = |output: &str| at(held, output, end);
    let [kept, flying] = [at(held, "phi' * sqrt(l / g)", end)?, at(fall, "phi' * sqrt(l / g)", free)?];
    let level = |record: &Trajectory| at(record, "-phi'", record.interval()[1]);
    let text = format!(
        "The problem books keep the bars on their supports. At φ = π/3, where A and B reach the corners, the corners of \
         Fig. 1a would then have to pull with N = {} <i>mg</i> (−19/160), and the bars' centres would fall with {} <i>g</i> \
         (339/320), faster than freely. The bars would turn with {} √(<i>g/l</i>); free since φ₁ they turn with {}. \
         The bars of Fig. 1b, kept on the floor, would lie level at {} √(<i>g/l</i>) (√3); in flight it is {}.",
        decimals(value("N(P) / (m * g)")?, 5),
        decimals(value("-0.5 * (ay(A) + ay(D)) / g")?, 6),
        decimals(kept, 4),
        decimals(flying, 4),
        decimals(level(zigzag.held())?, 4),
        decimals(level(zigzag.level())?, 4),
    );
    Ok(Finding { anchor: "kept", title: "What a support that cannot pull changes", text })
}

fn no_second_contact(pair: &falling_pair::Runs) -> Result<Option<Finding>, ReportError> {
    let (Some(open), fall) = (pair.opening(), pair.fall()) else { return Ok(None) };
    let passes = time_of(fall, "phi", FRAC_PI_3, [open, fall.interval()[1]])?;
    let text = format!(
        "In Fig. 1a the bars leave the corners at φ₁ for good, as the paper reads off its Fig. 6; it is a near miss. When the \
         ends A and B pass above the corners, at φ = π/3, the bars clear them by {} <i>l</i>; from there on the ends are \
         inside the gap.",
        decimals(at(fall, "gap(P) / l", passes)?, 4),
    );
    Ok(Some(Finding { anchor: "clearance", title: "No repeated contact in Fig. 1a", text }))
}

fn starts(tolerance: f64) -> Result<Finding, ReportError> {
    let published = |ratio| threshold(published::MODEL, &["phi"], ratio, tolerance);
    let strict = |ratio| threshold(strict::MODEL, &["phi_inner", "phi_outer"], ratio, tolerance);
    let text = format!(
        "Bars that start low stay on the floor. As published, Fig. 1b lifts off from starts at rest above \
         φ(0) = {:.6} for λ = ½ and {:.6} for λ = ¼; with every support watched on its own from {:.6} for λ = ½ \
         and {:.6} for λ = ¼. (From φ(0) = π/2 the start is an unstable equilibrium: the runs begin on its energy level.)",
        published(0.5)?,
        published(0.25)?,
        strict(0.5)?,
        strict(0.25)?,
    );
    Ok(Finding { anchor: "starts", title: "Lift-off depends on where the bars start", text })
}

fn masses() -> Finding {
    let text = "From φ(0) = π/2 the bars lift off for every λ but 0: μ(φ*, λ) of Table 1 exceeds 2 (N &lt; 0) there, and is 2 at \
                λ = 0 alone, where N touches zero at φ = arcsin ⅓ and comes back at once: φ₁ = φ₂, no flight. (B and D are \
                <i>l</i>/3 above the floor there and reach it at φ = 0.) λ = 1 leaves inner bars without mass, which has no \
                sense, as the paper says; its column of Table 1 holds for the equal angles of the published scheme only."
        .into();
    Finding { anchor: "masses", title: "Lift-off for every λ but 0", text }
}

/// The flight of Fig. 1a again from a state shortly behind its beginning, without gravity.
fn without_gravity(pair: &falling_pair::Runs, tolerance: f64) -> Result<Option<Finding>, ReportError> {
    let (Some(open), fall) = (pair.opening(), pair.fall()) else { return Ok(None) };
    let end = fall.interval()[1];
    let begin = open + 0.1 * (end - open);
    let value = |output: &str| at(fall, output, begin);
    let start = [("phi", value("phi")?), ("y", value("y")?), ("phi'", value("phi'")?), ("y'", value("y'")?)];
    let spec = RunSpec {
        parameters: named(&[("m", 1.0), ("l", 1.0), ("g", 0.0)]),
        ..RunSpec::default().start(&start).until("phi = pi/2").tolerance(tolerance)
    };
    let weightless = models().find(falling_pair::MODEL)?.run(&spec)?;
    let difference = (weightless.interval()[1] - (end - begin)).abs();
    let text = format!(
        "In flight φ(t) does not depend on <i>g</i>: the centre of mass falls, the bars turn about it. The last nine tenths \
         of the flight of Fig. 1a, repeated with <i>g</i> = 0 from the same state, take {:.4} s as well, the \
         same to {}.",
        end - begin,
        if difference == 0.0 {
            "the last bit".into()
        } else {
            format!("10{} s", superscript(difference.log10().ceil() as i64))
        },
    );
    Ok(Some(Finding { anchor: "weightless", title: "φ(t) in flight is that without gravity", text }))
}

fn joint_c(zigzag: &published::Runs) -> Result<Option<Finding>, ReportError> {
    let Some([_, touch]) = zigzag.interval() else { return Ok(None) };
    let value = |output: &str| at(zigzag.flight(), output, touch);
    let text = format!(
        "The floor is reached by B and D, at φ₂ &lt; 0, when A, C and E are still {} <i>l</i> above it. That is why C's \
         acceleration does not vanish at φ₂: it is that of free flight, {} <i>g</i> downward by (3.22), not a consequence of the \
         contact, which begins there.",
        decimals(value("y(C)")?, 4),
        decimals(-value("ay(C)")?, 4),
    );
    Ok(Some(Finding { anchor: "joint-c", title: "B and D strike first", text }))
}

fn thread(tolerance: f64) -> Result<Finding, ReportError> {
    let model = models().find("zigzag-thread")?;
    let run = model.run(&model.default_run().tolerance(tolerance))?;
    let cut = run.events().iter().find(|event| event.kind == EventKind::Cut).map_or(0.0, |event| event.t);
    let before = |output: &str| at(&run, output, 0.5 * cut);
    let after = |output: &str| at(&run, output, cut + 1e-9);
    let text = format!(
        "The paper begins behind the breakage of the thread BD. Declared with it (<code>zigzag-thread</code>, λ = ½, at rest at \
         φ = {}), its tension is {} (<i>m</i>₁ + <i>m</i>₂)<i>g</i>, which is ½ cot φ; the floor bears {} at C and {} at A and \
         at E. As it breaks these jump to {} and {}, and the bars fall as above.",
        decimals(before("phi_inner")?, 4),
        decimals(before("N(BD) / ((m1 + m2) * g)")?, 4),
        decimals(before("N(C) / ((m1 + m2) * g)")?, 4),
        decimals(before("N(A) / ((m1 + m2) * g)")?, 4),
        decimals(after("N(C) / ((m1 + m2) * g)")?, 4),
        decimals(after("N(A) / ((m1 + m2) * g)")?, 4),
    );
    Ok(Finding { anchor: "thread", title: "The thread itself", text })
}
