//! What follows from the runs, one statement each with its numbers.

use super::border::find_least_start;
use super::falling_pair;
use super::falling_pair::asymmetry::{Asymmetry, DROP};
use super::figure::decimals;
use super::printed::GRAVITY;
use super::published;
use super::reading::events_of;
use super::reading::{evaluate_output, time_of};
use super::strict;
use super::strikes::Strikes;
use super::{ReportError, Study};
use crate::models;
use liftoff::__private::expression::superscript;
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
pub(super) fn findings(
    study: &Study,
    zigzag: &published::PublishedRuns,
) -> Result<Vec<Finding>, ReportError> {
    let Study { pair, tolerance, .. } = study;
    let mut all = vec![problem_books(pair, zigzag)?, sizes(pair, *tolerance)?];
    all.extend(no_second_contact(pair)?);
    all.push(not_symmetric(&study.asymmetry));
    all.push(starts(*tolerance)?);
    all.push(masses(&study.published)?);
    all.extend(without_gravity(pair, *tolerance)?);
    all.extend(first_strike(zigzag, &study.strikes)?);
    all.push(thread(*tolerance)?);
    Ok(all)
}

fn problem_books(
    pair: &falling_pair::FallingPairRuns,
    zigzag: &published::PublishedRuns,
) -> Result<Finding, ReportError> {
    let (held, fall) = (pair.held(), pair.fall());
    let end = held.interval()[1];
    let free = time_of(fall, "phi", FRAC_PI_3, fall.interval())?;
    let value = |output: &str| evaluate_output(held, output, end);
    let [kept, flying] = [
        evaluate_output(held, "phi' * sqrt(l / g)", end)?,
        evaluate_output(fall, "phi' * sqrt(l / g)", free)?,
    ];
    let level = |record: &Trajectory| evaluate_output(record, "-phi'", record.interval()[1]);
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

fn no_second_contact(pair: &falling_pair::FallingPairRuns) -> Result<Option<Finding>, ReportError> {
    let (Some(open), fall) = (pair.opening(), pair.fall()) else { return Ok(None) };
    let passes = time_of(fall, "phi", FRAC_PI_3, [open, fall.interval()[1]])?;
    let text = format!(
        "In Fig. 1a the bars leave the corners at φ₁ for good, as the paper reads off its Fig. 6; it is a near miss. When the \
         ends A and B pass above the corners, at φ = π/3, the bars clear them by {} <i>l</i>; from there on the ends are \
         inside the gap.",
        decimals(evaluate_output(fall, "gap(P) / l", passes)?, 4),
    );
    Ok(Some(Finding { anchor: "clearance", title: "No repeated contact in Fig. 1a", text }))
}

fn starts(tolerance: f64) -> Result<Finding, ReportError> {
    let published = |ratio| find_least_start(published::MODEL, &["phi"], ratio, tolerance);
    let strict = |ratio| find_least_start(strict::MODEL, &["phi_inner", "phi_outer"], ratio, tolerance);
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

/// φ₁ of Fig. 1a again with another mass and length.
fn sizes(pair: &falling_pair::FallingPairRuns, tolerance: f64) -> Result<Finding, ReportError> {
    let model = models().find(falling_pair::MODEL)?;
    let other = RunSpec {
        parameters: named(&[("m", 7.0), ("l", 0.3), ("g", GRAVITY)]),
        ..model.default_run().tolerance(tolerance)
    };
    let angle = |run: &Trajectory| -> Result<f64, ReportError> {
        let open = events_of(run, EventKind::Open).next().map_or(f64::NAN, |event| event.t);
        Ok(evaluate_output(run, "phi", open)?)
    };
    let [one, other] = [angle(pair.fall())?, angle(&model.run(&other)?)?];
    let text = format!(
        "With <i>m</i> = 7 kg and <i>l</i> = 0.3 m the corners let go at φ₁ = {other:.10} as with 1 kg and 1 m, at {one:.10}.",
    );
    Ok(Finding { anchor: "sizes", title: "φ₁ does not depend on mass and length", text })
}

fn not_symmetric(asymmetry: &Asymmetry) -> Finding {
    let text = format!(
        "The fall of Fig. 1a is symmetric only from a symmetric start. From rest with D {DROP} <i>l</i> down \
         (<code>falling-pair-full</code>) both bars fall in while D is less than {:.10} <i>l</i> beside the middle. \
         From 0.01 <i>l</i> beside it D slides off over a corner{}. Between, strips of starts that fall in and that slide off alternate. \
         Where the ends A and B land on the ground beside the gap, nothing slides off: from 0.01 <i>l</i> both bars come to lie flat{}.",
        asymmetry.border,
        asymmetry.slides_off.map_or_else(String::new, |phi| format!(
            ", with one bar flat on it and the other turned up by {} rad",
            decimals(-phi, 3)
        )),
        asymmetry
            .lies_flat
            .map_or_else(String::new, |x| format!(", D {} <i>l</i> beside the middle", decimals(x, 4))),
    );
    Finding { anchor: "beside", title: "Fig. 1a, not quite symmetric", text }
}

fn masses(published: &[published::PublishedRuns]) -> Result<Finding, ReportError> {
    let mut most = Vec::new();
    for runs in published {
        let turning = runs.turning_points()?;
        let star = turning.iter().map(|it| decimals(2.0 * (1.0 - it.value), 6)).collect::<Vec<_>>();
        most.push(format!("{} at λ = {}", star.join(" and "), runs.ratio().1));
    }
    let touches =
        published.iter().find(|runs| runs.ratio().1 == 0.0).and_then(published::PublishedRuns::lift_off);
    let text = format!(
        "μ of (3.19), with N = 2(m₁ + m₂)<i>g</i>(1 − μ/2), has one extremum on the way down for each λ of Table 1: {}. From          φ(0) = π/2 the bars lift off where it exceeds 2, that is for every λ but 0, where N touches zero at φ = {} (arcsin ⅓) and          comes back at once: φ₁ = φ₂, no flight. (B and D are <i>l</i>/3 above the floor there and reach it at φ = 0.) λ = 1 leaves          inner bars without mass, which has no sense, as the paper says; its column of Table 1 holds for the equal angles of the          published scheme only.",
        most.join(", "),
        touches.map_or_else(|| "–".into(), |phi| decimals(phi, 10)),
    );
    Ok(Finding { anchor: "masses", title: "Lift-off for every λ but 0", text })
}

/// The flight of Fig. 1a again from a state shortly behind its beginning, without gravity.
fn without_gravity(
    pair: &falling_pair::FallingPairRuns,
    tolerance: f64,
) -> Result<Option<Finding>, ReportError> {
    let (Some(open), fall) = (pair.opening(), pair.fall()) else { return Ok(None) };
    let end = fall.interval()[1];
    let begin = open + 0.1 * (end - open);
    let value = |output: &str| evaluate_output(fall, output, begin);
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

fn first_strike(
    zigzag: &published::PublishedRuns,
    strikes: &Strikes,
) -> Result<Option<Finding>, ReportError> {
    let Some([_, touch]) = zigzag.interval() else { return Ok(None) };
    let value = |output: &str| evaluate_output(zigzag.flight(), output, touch);
    let text = format!(
        "At λ = {} the floor is reached by B and D, at φ₂ &lt; 0, when A, C and E are still {} <i>l</i> above it. That is why C's          acceleration does not vanish at φ₂: it is that of free flight, {} <i>g</i> downward by (3.22), not a consequence of the          contact, which begins there. For λ &lt; {:.10} it is A, C and E that land again first, at λ = 0.01 at φ₂ = {};          at that border all five points reach the floor at once. That is why φ₂ of Table 1 goes from 0.34 to −0.022          (<a href=#strikes>figure</a>). Watched on its own, C lands again first for λ &lt; {:.10}.",
        zigzag.ratio().1,
        decimals(value("y(C)")?, 4),
        decimals(-value("ay(C)")?, 4),
        strikes.published_level,
        strikes.light().map_or_else(|| "–".into(), |phi| decimals(phi, 4)),
        strikes.strict_level,
    );
    let title = "B and D strike first, unless the outer bars are light";
    Ok(Some(Finding { anchor: "strike", title, text }))
}

fn thread(tolerance: f64) -> Result<Finding, ReportError> {
    let model = models().find("zigzag-thread")?;
    let run = model.run(&model.default_run().tolerance(tolerance))?;
    let cut = run.events().iter().find(|event| event.kind == EventKind::Cut).map_or(0.0, |event| event.t);
    let before = |output: &str| evaluate_output(&run, output, 0.5 * cut);
    let after = |output: &str| evaluate_output(&run, output, cut + 1e-9);
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
