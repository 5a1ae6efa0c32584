//! Phases and events of a motion on its charts.

use super::panels::Panel;
use crate::registry::MotionError;

use crate::plot::{Annotations, Axis, Band, Head, Mark, significant};
use liftoff::Trajectory;
use liftoff::{Event, EventKind};

/// Events beyond which those of one kind in a row are shown as one.
const MANY: usize = 12;
/// Lines below a chart at most.
const LINES: usize = 10;
/// Pixels beside a line, and of a letter at most.
const BESIDE: u32 = 80;
const LETTER: f64 = 6.8;
/// Between two notes of a line; viewers make one of several common spaces.
const BETWEEN: &str = "\u{2003}";

/// Events in a row that are shown as one.
#[derive(Clone, Debug)]
struct Group {
    times: Vec<f64>,
    what: String,
    /// From which event to which, counted from 1.
    numbers: [usize; 2],
}

/// Events on a figure: lines with words or numbers, or numbered dots.
pub(super) struct EventMarks {
    annotations: Annotations,
    /// Where events are marked on curves, with their numbers; empty against time.
    marked: Vec<(f64, String)>,
}

impl EventMarks {
    /// Against time: phases as bands, events as lines with their words; with numbers and a list
    /// where words have no room.
    pub fn over(record: &Trajectory, axis: &Axis, width: u32) -> Self {
        let groups = groups(record);
        let heads = |text: &dyn Fn(&Group) -> String| -> Vec<Head> {
            let head = |group: &Group| {
                let line = |at: &f64| Head { at: *at, text: String::new() };
                let mut lines: Vec<Head> = group.times.iter().map(line).collect();
                lines.first_mut().into_iter().for_each(|first| first.text = text(group));
                lines
            };
            groups.iter().flat_map(head).collect()
        };
        let bands = bands(record);
        let with_words =
            Annotations { bands: bands.clone(), heads: heads(&|group| group.words()), notes: Vec::new() };
        let annotations = if with_words.fits(axis, width) {
            with_words
        } else {
            let annotations =
                Annotations { bands, heads: heads(&|group| group.number()), notes: notes(&groups, width) };
            thinned(annotations, axis, width)
        };
        Self { annotations, marked: Vec::new() }
    }

    /// Against anything else: events as numbered dots on the curves, and a list.
    pub fn beside(record: &Trajectory, width: u32) -> Self {
        let groups = groups(record);
        let marked = groups.iter().filter_map(|group| Some((*group.times.first()?, group.number())));
        let annotations = Annotations { notes: notes(&groups, width), ..Annotations::default() };
        Self { marked: marked.collect(), annotations }
    }

    pub fn annotations(&self) -> Annotations {
        self.annotations.clone()
    }

    /// Dots where events are on the first curve of a panel.
    pub fn marks(
        &self,
        record: &Trajectory,
        x: &dyn Fn(f64) -> f64,
        panel: &Panel,
    ) -> Result<Vec<Mark>, MotionError> {
        let Some((output, _)) = panel.curves.first() else { return Ok(Vec::new()) };
        let y = record.function(output)?;
        let mark = |(t, number): &(f64, String)| Mark { at: [x(*t), y(*t)], label: number.clone() };
        Ok(self.marked.iter().map(mark).filter(|mark| mark.at.iter().all(|x| x.is_finite())).collect())
    }
}

impl Group {
    /// `A, B open`.
    fn words(&self) -> String {
        match self.times.len() {
            1 => self.what.clone(),
            count => format!("{} × {count}", self.what),
        }
    }

    fn number(&self) -> String {
        match self.numbers {
            [first, last] if first == last => first.to_string(),
            [first, last] => format!("{first}–{last}"),
        }
    }

    fn note(&self) -> String {
        let time = |t: Option<&f64>| significant(t.copied().unwrap_or(f64::NAN), 4);
        let until =
            if self.times.len() > 1 { format!(" … {}", time(self.times.last())) } else { String::new() };
        format!("{}: {} at t = {}{until} s", self.number(), self.what, time(self.times.first()))
    }
}

/// Events but the start and a mere end; where there are many, those of one kind and the same
/// supports in a row as one.
fn groups(record: &Trajectory) -> Vec<Group> {
    let marks = |event: &&Event| !matches!(event.kind, EventKind::Start | EventKind::End | EventKind::Stop);
    let events: Vec<&Event> = record.events().iter().filter(marks).collect();
    let mut groups: Vec<Group> = Vec::new();
    for (i, event) in events.iter().enumerate() {
        let what = match event.supports.join(", ") {
            supports if supports.is_empty() => event.kind.to_string(),
            supports => format!("{supports} {}", event.kind),
        };
        match groups.last_mut().filter(|last| events.len() > MANY && last.what == what) {
            Some(last) => {
                last.times.push(event.t);
                last.numbers[1] = i + 1;
            }
            None => groups.push(Group { times: vec![event.t], what, numbers: [i + 1, i + 1] }),
        }
    }
    groups
}

/// Events in words with their times.
pub(super) fn events(record: &Trajectory) -> Vec<(String, Vec<f64>)> {
    groups(record).into_iter().map(|group| (group.words(), group.times)).collect()
}

/// As many as have room on a line.
fn notes(groups: &[Group], width: u32) -> Vec<String> {
    let letters = (f64::from(width.saturating_sub(BESIDE)) / LETTER) as usize;
    let mut lines: Vec<String> = Vec::new();
    for note in groups.iter().map(Group::note) {
        let has_room =
            |line: &&mut String| line.chars().count() + note.chars().count() + BETWEEN.len() <= letters;
        match lines.last_mut().filter(has_room) {
            Some(line) => *line = [line.as_str(), &note].join(BETWEEN),
            None => lines.push(note),
        }
    }
    if lines.len() > LINES {
        lines.truncate(LINES);
        lines.push("…".into());
    }
    lines
}

/// Phases that last, named by their closed supports; no names where nothing can close.
fn bands(record: &Trajectory) -> Vec<Band> {
    let mut bands: Vec<Band> = Vec::new();
    for segment in record.segments() {
        let closed = segment.closed.join(", ");
        let name = match (record.layout().contacts.is_empty(), closed.is_empty()) {
            (true, _) => String::new(),
            (false, true) => record.layout().unclosed().into(),
            (false, false) => format!("on {closed}"),
        };
        match bands.last_mut().filter(|last| last.name == name) {
            Some(last) => last.range[1] = segment.t1,
            None => bands.push(Band { range: [segment.t0, segment.t1], name }),
        }
    }
    bands.retain(|band| band.range[0] < band.range[1]);
    bands
}

/// Without the numbers that have no room.
fn thinned(mut annotations: Annotations, axis: &Axis, width: u32) -> Annotations {
    let texts: Vec<String> =
        annotations.heads.iter_mut().map(|head| core::mem::take(&mut head.text)).collect();
    for (i, text) in texts.into_iter().enumerate() {
        annotations.heads[i].text = text;
        if !annotations.fits(axis, width) {
            annotations.heads[i].text.clear();
        }
    }
    annotations
}
