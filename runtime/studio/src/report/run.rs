//! The default run: what happens, and the work that it takes.

use super::Subject;
use crate::html::escaped;
use crate::registry::MotionError;
use core::fmt::Write;
use liftoff::__private::expression::significant;
use liftoff::Trajectory;
use liftoff::{Event, Reaction};

/// Significant digits in the table.
const DIGITS: usize = 5;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let record = subject.record()?;
    let stopped = subject
        .stopped
        .as_ref()
        .map_or(String::new(), |why| format!("<p class=vermilion>It stopped short: {}.</p>\n", escaped(why)));
    Ok(stopped + &events(record) + &work(record))
}

fn events(record: &Trajectory) -> String {
    let names = record.layout().names_of_motion().map(|name| name.replace('\'', "′"));
    let heads: String = names.map(|name| format!("<th>{}", escaped(&name))).collect();
    let struck = record.events().iter().any(|event| !event.impulses.is_empty());
    let impulses = if struck { "<th class=word>impulses, N s" } else { "" };
    let beside = if record.layout().frictions.is_empty() { "" } else { ", and friction" };
    let mut html = format!(
        "<div class=table><table>\n<thead><tr><th>t<th class=word>event{heads}<th class=word>reactions after it, N{beside}\
         {impulses}</tr></thead>\n<tbody>\n",
    );
    for event in record.events() {
        let state: String = record
            .unrounded(&record.with_dependent(&event.state))
            .iter()
            .map(|value| format!("<td>{}", minus(&significant(*value, DIGITS))))
            .collect();
        let _ = writeln!(
            html,
            "<tr><td>{}<td class=word>{}{state}<td class=word>{}{}</tr>",
            significant(event.t, DIGITS),
            escaped(&what(event)),
            forces(&event.reactions),
            if struck { format!("<td class=word>{}", forces(&event.impulses)) } else { String::new() },
        );
    }
    html + "</tbody></table></div>\n"
}

fn what(event: &Event) -> String {
    let note = event.note.as_ref().map_or(String::new(), |note| format!(" ({note})"));
    format!("{} {}{note}", event.kind, event.supports.join(", "))
}

fn forces(forces: &[Reaction]) -> String {
    let number = |value: f64| minus(&significant(value, DIGITS));
    let one = |force: &Reaction| {
        let normal = format!("{} {}", escaped(force.label), number(force.value));
        force.friction.map_or(normal.clone(), |friction| format!("{normal} and {}", number(friction)))
    };
    forces.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Phases, methods, steps.
fn work(record: &Trajectory) -> String {
    let work = record.statistics();
    let mut methods: Vec<&str> = Vec::new();
    for segment in record.segments() {
        if !methods.contains(&segment.choice.method) {
            methods.push(segment.choice.method);
        }
    }
    format!(
        "<p>Phases: {}, by {}; steps: {}, rejected: {}, evaluations: {}.</p>\n",
        record.segments().len(),
        methods.join(", "),
        work.steps,
        work.rejected,
        work.evaluations,
    )
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}
