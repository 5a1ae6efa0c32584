//! Random scenes, each in several equal forms, and held to the laws of mechanics by what its run
//! puts out.
//!
//! The scene is drawn in numbers, printed as a file, and run as `liftoff run FILE.rs` does. What it
//! does has to satisfy the laws of mechanics as the scene has them; and its forms, turned,
//! reflected, in other units and words, have to do the same.

mod compare;
mod draw;
mod form;
mod image;
mod law;
mod motion;
mod print;
mod scene;

use std::fmt;

use liftoff_tests::random::Source;

use crate::subject::Fate;
use crate::{Finding, Subject};
use compare::Pair;
use form::{Change, Form, draw_changes, draw_other};
use motion::{Motion, Refusal};
use scene::Scene;

/// How many forms of each scene are compared with it.
const FORMS: usize = 3;

/// Scenes in several forms.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scenes;

/// A scene, and the changes that make its other forms.
#[derive(Clone, Debug)]
pub struct Case {
    scene: Scene,
    changes: Vec<Vec<Change>>,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&Form::new(self.scene.clone()).declare())?;
        writeln!(f, "// limit {:?}", self.scene.limit)?;
        for changes in &self.changes {
            writeln!(f, "// {changes:?}")?;
        }
        Ok(())
    }
}

impl Case {
    fn form(&self, changes: &[Change]) -> Form {
        changes.iter().fold(Form::new(self.scene.clone()), |form, change| form.apply(*change))
    }
}

fn names(changes: &[Change]) -> String {
    changes.iter().map(Change::to_string).collect::<Vec<_>>().join(", ")
}

impl Subject for Scenes {
    type Case = Case;

    fn generate(&self, seed: u64) -> Case {
        let mut source = Source::new(seed);
        let scene = draw::draw(&mut source);
        let changes = (0..FORMS).map(|_| draw_changes(&scene, &mut source)).collect();
        Case { scene, changes }
    }

    fn check(&self, case: &Case) -> Result<Fate, Finding> {
        let form = Form::new(case.scene.clone());
        let motion = match Motion::run_form(&form) {
            Ok(motion) => motion,
            Err(Refusal::Declaration(_)) => return Ok(vec!["refused: declaration"]),
            Err(Refusal::Start(_)) => return Ok(vec!["refused: start"]),
            Err(Refusal::Stopped { .. }) => return Ok(vec!["stopped"]),
        };
        let mut fates = vec!["ran"];
        law::check(&case.scene, &motion)?;
        for changes in &case.changes {
            let told = check_form(case, &form, &motion, changes);
            fates.push(told.map_err(|Finding(text)| Finding(format!("{}: {text}", names(changes))))?);
        }
        Ok(fates)
    }

    fn details(&self, case: &Case) -> String {
        let mut text = String::new();
        for changes in [&Vec::new()].into_iter().chain(&case.changes) {
            let form = case.form(changes);
            let start = motion::start_form(&form);
            let start: String =
                start.iter().map(|(name, value)| format!(" --start \"{name}={value:?}\"")).collect();
            let limit = form.scene.limit;
            text += &format!("--- {}\n{}", names(changes), form.declare());
            text += &format!("// liftoff run FILE.rs{start} --limit {limit:?}\n");
            match Motion::run_form(&form) {
                Err(refusal) => text += &format!("{refusal}\n"),
                Ok(motion) => {
                    let run = &motion.run;
                    run.events().iter().for_each(|event| text += &format!("{event}\n"));
                    run.log().iter().for_each(|entry| text += &format!("{:?} {}\n", entry.t, entry.decision));
                }
            }
        }
        text
    }
}

/// A scene that is refused beside another is refused alone.
fn check_alone(case: &Case, changes: &[Change], refusal: &Refusal) -> Result<&'static str, Finding> {
    for change in changes {
        if let Change::Beside(seed) = change
            && Motion::run_form(&Form::new(draw_other(&case.scene, *seed))).is_ok()
        {
            return Err(Finding(format!("both run alone: {refusal}")));
        }
    }
    Ok("not compared: the scene beside is refused")
}

fn check_form(
    case: &Case,
    form: &Form,
    motion: &Motion,
    changes: &[Change],
) -> Result<&'static str, Finding> {
    let mut other = case.form(changes);
    let (mut from, mut state) = (0.0, None);
    if let [Change::Split(part)] = changes {
        from = part * motion.run.end_time();
        let events = motion.run.events();
        let is_near = events.iter().any(|event| (event.t - from).abs() < 1e-3 * motion.run.end_time());
        if is_near {
            return Ok("not compared: split at an event");
        }
        if motion.is_at_rest(from) {
            return Ok("not compared: split at rest");
        }
        other.scene = other.scene.after(from);
        state = Some(motion.state(from));
    }
    let [is_beside, is_mirrored] = [Change::Beside(0), Change::Mirror].map(|kind| {
        changes.iter().any(|change| std::mem::discriminant(change) == std::mem::discriminant(&kind))
    });
    let found = match Motion::run_from(&other, motion::TOLERANCE, state) {
        Ok(found) => found,
        Err(Refusal::Start(text))
            if from > 0.0 && text.contains("penetrated") && case.scene.has_bars_as_ground() =>
        {
            return Ok("not compared: split behind an end");
        }
        Err(Refusal::Start(text)) if text.contains("equilibrium") && motion.stays_at_rest() => {
            return Ok("the same: at rest");
        }
        Err(Refusal::Stopped { t, is_undecided, .. })
            if is_undecided || t / other.map.units[1] + from >= motion.undecided_from() =>
        {
            return Ok("not compared: it stops where the motion is undecided");
        }
        Err(refusal) if is_beside => return check_alone(case, changes, &refusal),
        Err(Refusal::Declaration(_)) if is_mirrored => return Ok("not compared: mirror refused"),
        Err(refusal) => return Err(Finding(format!("refused: {refusal}"))),
    };
    let is_unique = motion.has_unique_reactions() && found.has_unique_reactions();
    let with_forces = is_unique && !is_mirrored;
    Pair { scene: &case.scene, one: motion, other: &found, map: other.map, from, is_unique, with_forces }
        .check(form)
}
