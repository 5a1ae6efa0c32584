//! Title, events and a bar of time.

use super::About;
use super::stage::Stage;
use super::track::{number, path, steps};
use crate::html::escaped;
use crate::plot::Colour;
use crate::plot::svg::plane::Px;
use crate::plot::svg::{Fill, Pen};
use liftoff::{Event, EventKind, Trajectory};

/// Events that follow each other within so many seconds have one word.
const AT_ONCE: f64 = 0.1;
/// Names in one word.
const NAMES: usize = 2;

/// Room at the left and at the right, and between two words.
const INDENT: f64 = 20.0;
const BETWEEN: f64 = 26.0;
/// Sizes of letters.
const TITLE: f64 = 16.0;
const WORD: f64 = 16.0;
/// The breadth of a bold letter over its size, rather too wide than too narrow.
const BREADTH: f64 = 0.6;

/// Events that are named together.
struct Group {
    t: f64,
    last: f64,
    names: Vec<String>,
    time: String,
    count: usize,
}

/// A word in its place: it appears at its key and stays until the line is full and another begins.
struct Placed {
    text: String,
    x: f64,
    from: f64,
    until: Option<f64>,
}

/// The words over the picture, and its time below.
pub(super) fn drawn(stage: &Stage, record: &Trajectory, about: &About) -> String {
    let groups = groups(stage, record);
    let word = |word: &Placed| {
        let shown = [(0.0, "0"), (word.from, "1")].into_iter().chain(word.until.map(|key| (key, "0")));
        format!(
            "<text x=\"{}\" y=\"58\" font-size=\"{WORD}\" font-weight=\"bold\" opacity=\"0\"{}>{}{}</text>\n",
            number(word.x),
            Fill::Colour(Colour::Vermilion),
            escaped(&word.text),
            steps(&stage.timeline, "opacity", &shown.collect::<Vec<_>>()),
        )
    };
    let words: String = placed(stage, &groups).iter().map(word).collect();
    let keys: Vec<f64> = groups.iter().map(|group| stage.timeline.key(group.t)).collect();
    title(stage, about) + &words + &clock(stage, &keys)
}

/// The words from left to right, line after line in one place.
fn placed(stage: &Stage, groups: &[Group]) -> Vec<Placed> {
    let mut all: Vec<Placed> = Vec::new();
    let (mut x, mut line) = (INDENT, 0);
    for group in groups {
        let (text, from) = (group.said(), stage.timeline.key(group.t));
        let width = BREADTH * WORD * text.chars().count() as f64;
        if x > INDENT && x + width > stage.size[0] - INDENT {
            all[line..].iter_mut().for_each(|word| word.until = Some(from));
            (x, line) = (INDENT, all.len());
        }
        all.push(Placed { text, x, from, until: None });
        x += width + BETWEEN;
    }
    all
}

fn title(stage: &Stage, about: &About) -> String {
    let pace = stage.timeline.pace;
    let round = |x: f64| (1e6 * x).round() / 1e6;
    let speed = match pace {
        1.0 => String::new(),
        pace if pace < 1.0 => format!(", {} times slower", round(1.0 / pace)),
        pace => format!(", {} times faster", round(pace)),
    };
    format!(
        "<text x=\"{INDENT}\" y=\"28\" font-size=\"{TITLE}\"{}>{}{speed}</text>\n",
        Fill::Colour(Colour::Black),
        escaped(about.title),
    )
}

/// How much of the time has passed, with a stroke for each event.
fn clock(stage: &Stage, keys: &[f64]) -> String {
    let [width, height] = stage.size;
    let (from, to, y) = (INDENT, width - INDENT, height - 14.0);
    let timeline = &stage.timeline;
    let at = |key: f64| from + (to - from) * key / timeline.end().max(f64::MIN_POSITIVE);
    let rail = |x: f64| format!("M{} {}H{}", number(from), number(y), number(x));
    let passed: Vec<String> = timeline.times.iter().map(|&t| rail(at(timeline.key(t)))).collect();
    let strokes: String = keys.iter().map(|&key| stroke([at(key), y])).collect();
    let marks = match strokes.is_empty() {
        true => String::new(),
        false => format!("<path d=\"{strokes}\"{}/>\n", Pen::new(Colour::Vermilion, 2.4)),
    };
    let bar = format!("<path d=\"{}\"{}/>\n", rail(to), Pen::new(Colour::Grey, 4.0));
    bar + &path(timeline, &Pen::new(Colour::Blue, 4.0).to_string(), &passed, "") + &marks
}

fn stroke([x, y]: Px) -> String {
    format!("M{} {}v12", number(x), number(y - 6.0))
}

fn groups(stage: &Stage, record: &Trajectory) -> Vec<Group> {
    let unsaid = [EventKind::Start, EventKind::Stop, EventKind::End];
    let mut groups: Vec<Group> = Vec::new();
    for event in record.events().iter().filter(|event| !unsaid.contains(&event.kind)) {
        let (name, time) = said(event);
        let with = groups.last_mut().filter(|group| event.t - group.last < AT_ONCE * stage.timeline.pace);
        let Some(group) = with else {
            groups.push(Group { t: event.t, last: event.t, names: vec![name], time, count: 1 });
            continue;
        };
        (group.last, group.count) = (event.t, group.count + 1);
        if !group.names.contains(&name) {
            group.names.push(name);
        }
    }
    groups
}

/// What `run` prints of an event: name and time.
fn said(event: &Event) -> (String, String) {
    let text = event.to_string();
    let (name, rest) = text.split_once(" at t = ").unwrap_or((&text, ""));
    let time = rest.split([',', ' ']).next().unwrap_or("");
    (name.to_owned(), time.to_owned())
}

impl Group {
    fn said(&self) -> String {
        let few = self.names.len() <= NAMES;
        let names = self.names[..self.names.len().min(NAMES)].join("; ") + if few { "" } else { "; …" };
        let times = if self.count > self.names.len() { format!(" ×{}", self.count) } else { String::new() };
        format!("{names}{times}, {}", self.time)
    }
}
