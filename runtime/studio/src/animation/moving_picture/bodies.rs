//! What moves: threads, springs, bodies, points.

use super::contacts::Contacts;
use super::stage::Stage;
use super::track::{carried, line, number, path, steps, write_point};
use crate::plot::Colour;
use crate::plot::svg::plane::{Px, along, left_of, minus, towards, unit};
use crate::plot::svg::{Fill, Pen};
use crate::registry::Configuration;
use liftoff::{EventKind, Trajectory};
use liftoff_core::model::geometry::{Look, Round, Solid, Spring, Thread};

const BAR: Pen = Pen::new(Colour::Black, 4.5);
const OUTLINE: Pen = Pen::new(Colour::Black, 1.6);
const THREAD: Pen = Pen::new(Colour::Blue, 2.0);

/// Half the width of a spring.
const COIL: f64 = 8.0;

/// Bars, plates and blocks.
pub(super) fn bodies(stage: &Stage) -> String {
    let geometry = stage.frames[0].geometry();
    let mut text: String = geometry.rounds.iter().map(|form| round(stage, form)).collect();
    for body in geometry.bodies {
        let plate = body.outline.len() > 2;
        let form = |places: Vec<Px>| line(&places) + if plate { "Z" } else { "" };
        let forms: Vec<_> =
            stage.frames.iter().map(|frame| form(stage.places(frame, body.outline))).collect();
        let style =
            if plate { format!("{OUTLINE}{}", Fill::Faint(Colour::Blue, 0.25)) } else { BAR.to_string() };
        text += &path(&stage.timeline, &style, &forms, "");
    }
    for block in geometry.blocks {
        let corners = [[-10.0, -6.0], [10.0, -6.0], [10.0, 6.0], [-10.0, 6.0]];
        let forms = stage.frames.iter().map(|frame| {
            let (at, ahead) = (stage.px(frame.points[block.point]), towards(frame.direction(block.along)));
            let corner = |[x, y]: Px| along(along(at, ahead, x), left_of(ahead), y);
            line(&corners.map(corner)) + "Z"
        });
        let style = format!("{OUTLINE}{}", Fill::Paper);
        text += &path(&stage.timeline, &style, &forms.collect::<Vec<_>>(), "");
    }
    text
}

/// A circle about a point, and a stroke from its centre that turns with it.
fn round(stage: &Stage, round: &Round) -> String {
    let radius = stage.long(stage.frames[0].number(round.radius));
    let places: Vec<_> =
        stage.frames.iter().map(|frame| write_point(stage.px(frame.points[round.centre]))).collect();
    let fill = match round.solid {
        Solid::Within => Fill::Faint(Colour::Blue, 0.25).to_string(),
        Solid::Around | Solid::Nowhere => String::new(),
    };
    let rim =
        carried(&stage.timeline, &places, &format!("<circle r=\"{}\"{OUTLINE}{fill}/>", number(radius)));
    let spoke = |turns| {
        let form = |frame: &Configuration| {
            let across = left_of(towards(frame.direction(turns)));
            let centre = stage.px(frame.points[round.centre]);
            line(&[centre, along(centre, across, radius)])
        };
        path(&stage.timeline, &OUTLINE.to_string(), &stage.frames.iter().map(form).collect::<Vec<_>>(), "")
    };
    rim + &round.along.map(spoke).unwrap_or_default()
}

/// Threads: dashed while slack, gone when cut.
pub(super) fn threads(stage: &Stage, contacts: &Contacts, record: &Trajectory) -> String {
    let threads = stage.frames[0].geometry().threads.iter();
    let thread = |thread: &Thread| {
        let taut = contacts.closed(stage, record, thread.name);
        let dashes: Vec<_> =
            taut.iter().map(|&(key, taut)| (key, if taut { "none" } else { "4 5" })).collect();
        let cut = record.events().iter().find(|event| {
            matches!(event.kind, EventKind::Cut | EventKind::Release) && event.supports.contains(&thread.name)
        });
        let shown: Vec<_> =
            [(0.0, "1")].into_iter().chain(cut.map(|event| (stage.timeline.key(event.t), "0"))).collect();
        let inside =
            steps(&stage.timeline, "stroke-dasharray", &dashes) + &steps(&stage.timeline, "opacity", &shown);
        let slack = dashes.first().is_some_and(|first| first.1 != "none");
        let style = if slack { format!("{THREAD} stroke-dasharray=\"4 5\"") } else { THREAD.to_string() };
        path(&stage.timeline, &style, &thread_forms(stage, thread), &inside)
    };
    threads.map(thread).collect()
}

fn thread_forms(stage: &Stage, thread: &Thread) -> Vec<String> {
    stage.frames.iter().map(|frame| line(&stage.places(frame, thread.path))).collect()
}

/// Springs and dampers, while they act.
pub(super) fn springs(stage: &Stage, record: &Trajectory) -> String {
    let springs = stage.frames[0].geometry().springs.iter();
    let spring = |spring: &Spring| {
        let shown = shown(stage, record, spring.name)?;
        Some(path(&stage.timeline, &OUTLINE.to_string(), &spring_forms(stage, spring), &shown))
    };
    springs.filter_map(spring).collect()
}

fn spring_forms(stage: &Stage, spring: &Spring) -> Vec<String> {
    let form = if spring.coil { coil } else { dashpot };
    let ends = |frame: &Configuration| spring.ends.map(|end| stage.px(frame.points[end]));
    stage.frames.iter().map(|frame| form(ends(frame))).collect()
}

/// All threads and springs, none slack or cut.
pub(super) fn ties(stage: &Stage) -> String {
    let geometry = stage.frames[0].geometry();
    let thread = |thread| path(&stage.timeline, &THREAD.to_string(), &thread_forms(stage, thread), "");
    let spring = |spring| path(&stage.timeline, &OUTLINE.to_string(), &spring_forms(stage, spring), "");
    geometry.threads.iter().map(thread).chain(geometry.springs.iter().map(spring)).collect()
}

/// When a spring is seen: while it acts; none if it never does.
fn shown(stage: &Stage, record: &Trajectory, spring: &str) -> Option<String> {
    let Some(switch) = record.layout().switch_of(&format!("spring {spring}")) else {
        return Some(String::new());
    };
    let lasting = record.segments().into_iter().filter(|segment| segment.t1 > segment.t0);
    let mut all: Vec<(f64, &str)> = lasting
        .map(|segment| {
            (stage.timeline.key(segment.t0), if segment.acting.contains(&switch) { "1" } else { "0" })
        })
        .collect();
    if let Some(first) = all.first_mut() {
        first.0 = 0.0;
    }
    all.iter().any(|(_, seen)| *seen == "1").then(|| steps(&stage.timeline, "opacity", &all))
}

/// Straight at the ends, zigzag between.
fn coil([a, b]: [Px; 2]) -> String {
    let step = minus(b, a);
    let across = left_of(unit(step));
    let at = |part: f64, side: f64| along(along(a, step, part), across, side * COIL);
    let turns = (0..8).map(|i| at((f64::from(i) + 3.5) / 14.0, if i % 2 == 0 { 1.0 } else { -1.0 }));
    let ends = [a, at(3.0 / 14.0, 0.0)];
    line(&ends.into_iter().chain(turns).chain([at(11.0 / 14.0, 0.0), b]).collect::<Vec<_>>())
}

/// A cup, and a piston in it.
fn dashpot([a, b]: [Px; 2]) -> String {
    let step = minus(b, a);
    let across = left_of(unit(step));
    let at = |part: f64, side: f64| along(along(a, step, part), across, side * COIL);
    let cup = [at(0.6, 1.0), at(0.35, 1.0), at(0.35, -1.0), at(0.6, -1.0)];
    [vec![a, at(0.35, 0.0)], cup.to_vec(), vec![at(0.5, 0.8), at(0.5, -0.8)], vec![at(0.5, 0.0), b]]
        .map(|part| line(&part))
        .concat()
}

/// Joints and masses.
pub(super) fn points(stage: &Stage) -> String {
    let layout = stage.frames[0].layout;
    let masses: Vec<usize> = layout.geometry.marked(Look::Mass).collect();
    let mut text = String::new();
    for i in 0..layout.points.len() {
        let places: Vec<Px> = stage.frames.iter().map(|frame| stage.px(frame.points[i])).collect();
        let heavy = masses.contains(&i);
        let (radius, fill) = if heavy { (7, Fill::Colour(Colour::Black)) } else { (3, Fill::Paper) };
        let dot = format!("<circle data-point=\"{}\" r=\"{radius}\"{OUTLINE}{fill}/>", layout.points[i]);
        text += &carried(&stage.timeline, &texts(&places), &dot);
    }
    text
}

fn texts(places: &[Px]) -> Vec<String> {
    places.iter().map(|&at| write_point(at)).collect()
}
