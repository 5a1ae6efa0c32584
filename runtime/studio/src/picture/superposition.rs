//! Superposed positions of a motion, with the paths of points.

use super::sample::traced;
use crate::plot::{Axis, Colour, Dash, Figure, LegendLine, Stroke, Superposition};
use crate::registry::Configuration;
use crate::registry::MotionError;
use core::f64::consts::{FRAC_PI_2, TAU};
use liftoff::{EventKind, Trajectory};
use liftoff_core::model::geometry::{Body, Fixture, Look, Round, Shape, Solid};

/// Positions where none are asked for.
const POSITIONS: usize = 13;
/// Chords by which a circle that moves is drawn.
const RIM: u32 = 72;
/// Free part of the size round all that moves.
const ROOM: f64 = 0.06;
/// Width of a figure, and what its axes take of width and height.
const WIDTH: u32 = 860;
const BESIDE: [f64; 2] = [90.0, 96.0];
/// Heights that a figure has at least and at most.
const HEIGHTS: [f64; 2] = [220.0, 900.0];
/// Colours of phases by turns.
const COLOURS: [Colour; 5] = [Colour::Blue, Colour::Vermilion, Colour::Purple, Colour::Sky, Colour::Orange];

/// The model at equal times, later ones stronger, each phase in its colour; and paths of points.
pub struct Positions<'a> {
    record: &'a Trajectory,
    count: usize,
    trails: Vec<String>,
    size: (Option<u32>, Option<u32>),
}

impl<'a> Positions<'a> {
    /// Of a motion, without paths.
    pub fn new(record: &'a Trajectory) -> Self {
        Self { record, count: POSITIONS, trails: Vec::new(), size: (None, None) }
    }

    /// So many positions; one at least.
    #[must_use]
    pub fn count(self, count: usize) -> Self {
        Self { count: count.max(1), ..self }
    }

    /// The paths of these points too.
    #[must_use]
    pub fn trails(self, points: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { trails: points.into_iter().map(Into::into).collect(), ..self }
    }

    /// Width and height in pixels; what is not given is chosen.
    #[must_use]
    pub fn size(self, width: Option<u32>, height: Option<u32>) -> Self {
        Self { size: (width, height), ..self }
    }

    /// As SVG text, both axes to one scale.
    ///
    /// # Errors
    /// A point that the model does not have.
    pub fn svg(&self) -> Result<String, MotionError> {
        let [start, end] = self.record.interval();
        let first = Configuration::from_run(self.record, start);
        let lines = Lines::from_run(self.record);
        let phases = Phases::from_run(self.record);
        let mut moving = self.paths()?;
        for i in 0..self.count {
            let part = i as f64 / (self.count - 1).max(1) as f64;
            let t = start + part * (end - start);
            let configuration = Configuration::from_run(self.record, t);
            let colour = phases.colour(t);
            moving.extend(lines.strokes(&configuration, t, colour, 0.3 + 0.7 * part));
        }
        let seen = Seen::enclose(moving.iter().flat_map(|stroke| &stroke.points), &first);
        let fixtures = first.geometry().fixtures.iter();
        let mut strokes: Vec<Stroke> = fixtures.filter_map(|fixture| seen.fixture(fixture, &first)).collect();
        strokes.extend(moving);
        let [x, y] = ["x, m", "y, m"].map(str::to_owned);
        let superposition = Superposition {
            x: Axis::linear(&x, seen.ranges[0]),
            y: Axis::linear(&y, seen.ranges[1]),
            strokes,
            dots: fixed(&first),
            labels: Vec::new(),
            legend: self.legend(&phases),
        };
        let description = format!("{}: superposed positions", self.record.layout().name);
        let width = self.size.0.unwrap_or(WIDTH);
        let size = (width, self.size.1.unwrap_or_else(|| seen.height(width)));
        Ok(Figure { description, size }.superposition(&superposition))
    }

    fn paths(&self) -> Result<Vec<Stroke>, MotionError> {
        let path = |(i, point): (usize, &String)| {
            let [x, y] = ["x", "y"].map(|axis| self.record.function(&format!("{axis}({point})")));
            let points = traced(self.record, &x?, &y?).joined();
            let (colour, dash) = trail(i);
            Ok(points
                .split(|p| p[0].is_nan())
                .map(|run| Stroke { dash, ..Stroke::solid(run.to_vec(), colour, 0.9, 1) })
                .collect::<Vec<_>>())
        };
        let all: Result<Vec<_>, MotionError> = self.trails.iter().enumerate().map(path).collect();
        Ok(all?.concat())
    }

    fn legend(&self, phases: &Phases) -> Vec<LegendLine> {
        let phases = phases.0.iter().map(|phase| LegendLine::solid(&phase.name, phase.colour));
        let trails = self.trails.iter().enumerate().map(|(i, point)| {
            let (colour, dash) = trail(i);
            LegendLine { name: format!("path of {point}"), colour, dash }
        });
        let all: Vec<LegendLine> = phases.chain(trails).collect();
        if all.len() > 1 { all } else { Vec::new() }
    }
}

/// The look of a path.
fn trail(number: usize) -> (Colour, Dash) {
    let dashes = [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::Long, Dash::Sparse];
    (if number < dashes.len() { Colour::Green } else { Colour::Black }, dashes[number % dashes.len()])
}

/// Contact sets of a motion with their colours, and when they hold.
struct Phases(Vec<Phase>);

struct Phase {
    name: String,
    colour: Colour,
    spans: Vec<[f64; 2]>,
}

impl Phases {
    fn from_run(record: &Trajectory) -> Self {
        let mut phases: Vec<Phase> = Vec::new();
        for segment in record.segments().iter().filter(|segment| segment.t0 < segment.t1) {
            let name = match segment.closed.join(", ") {
                closed if closed.is_empty() && record.layout().contacts.is_empty() => String::new(),
                closed if closed.is_empty() => record.layout().unclosed().to_owned(),
                closed => format!("on {closed}"),
            };
            let span = [segment.t0, segment.t1];
            match phases.iter_mut().find(|phase| phase.name == name) {
                Some(phase) => phase.spans.push(span),
                None => {
                    let colour = COLOURS[phases.len() % COLOURS.len()];
                    phases.push(Phase { name, colour, spans: vec![span] });
                }
            }
        }
        Self(phases)
    }

    /// Of the phase that begins at a time or goes on there; of the last one at the end.
    fn colour(&self, t: f64) -> Colour {
        let holds = |phase: &&Phase| phase.spans.iter().any(|[from, to]| *from <= t && t < *to);
        let last = || self.0.iter().max_by(|a, b| end(a).total_cmp(&end(b)));
        self.0.iter().find(holds).or_else(last).map_or(Colour::Blue, |phase| phase.colour)
    }
}

fn end(phase: &Phase) -> f64 {
    phase.spans.last().map_or(f64::NEG_INFINITY, |span| span[1])
}

/// Points that lines of the model go through: bodies, springs, threads; and points that are all
/// there is.
struct Lines {
    heavy: Vec<Vec<usize>>,
    /// And until when: to the cut of a thread.
    light: Vec<(Vec<usize>, f64)>,
    single: Vec<usize>,
}

impl Lines {
    fn from_run(record: &Trajectory) -> Self {
        let geometry = record.layout().geometry;
        let outline = |body: &Body| match body.outline {
            [_, _] => body.outline.to_vec(),
            outline => outline.iter().chain(outline.first()).copied().collect(),
        };
        let threads = geometry.threads.iter().map(|thread| (thread.path.to_vec(), cut(record, thread.name)));
        let springs = geometry.springs.iter().map(|spring| (spring.ends.to_vec(), f64::INFINITY));
        Self {
            heavy: geometry.bodies.iter().map(outline).collect(),
            light: threads.chain(springs).collect(),
            single: geometry.marked(Look::Mass).collect(),
        }
    }

    fn strokes(&self, configuration: &Configuration, t: f64, colour: Colour, opacity: f64) -> Vec<Stroke> {
        let through = |line: &[usize]| line.iter().map(|&point| configuration.points[point]).collect();
        let heavy = self.heavy.iter().map(|line| Stroke::solid(through(line), colour, opacity, 2));
        let light = self.light.iter().filter(|(_, until)| t <= *until);
        let light = light.map(|(line, _)| Stroke::solid(through(line), colour, opacity, 1));
        // A stroke from a point to itself is a dot as wide as its pen.
        let single = self
            .single
            .iter()
            .map(|&point| Stroke::solid(vec![configuration.points[point]; 2], colour, opacity, 7));
        let rims = configuration.geometry().rounds.iter();
        let rims = rims.map(|round| Stroke::solid(rim(configuration, round), colour, opacity, 1));
        heavy.chain(light).chain(single).chain(rims).collect()
    }
}

/// Once round, and where it turns, to its centre.
fn rim(configuration: &Configuration, round: &Round) -> Vec<[f64; 2]> {
    let (centre, radius) = (configuration.points[round.centre], configuration.number(round.radius));
    let from = round.along.map_or(0.0, |along| configuration.direction(along) + FRAC_PI_2);
    let at = |i: u32| {
        let (sin, cos) = (from + TAU * f64::from(i) / f64::from(RIM)).sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    };
    (0..=RIM).map(at).chain(round.along.map(|_| centre)).collect()
}

/// When a thread is cut; never, if it is not.
fn cut(record: &Trajectory, thread: &str) -> f64 {
    let cuts = record.events().iter().filter(|event| event.kind == EventKind::Cut);
    cuts.filter(|event| event.supports.contains(&thread)).map(|event| event.t).fold(f64::INFINITY, f64::min)
}

/// What fixed points there are: wedges, feet, ground.
fn fixed(configuration: &Configuration) -> Vec<[f64; 2]> {
    let geometry = configuration.geometry();
    let wedges = geometry.fixtures.iter().filter(|fixture| fixture.shape == Shape::Wedge);
    let wedges = wedges.map(|wedge| configuration.position(wedge.at));
    let points = geometry.grounded().map(|(point, _)| configuration.points[point]);
    wedges.chain(points).collect()
}

/// The part of the plane that is seen.
struct Seen {
    ranges: [[f64; 2]; 2],
}

impl Seen {
    fn enclose<'a>(points: impl Iterator<Item = &'a [f64; 2]>, configuration: &Configuration) -> Self {
        let fixtures = configuration.geometry().fixtures.iter();
        let round = fixtures.filter(|fixture| matches!(fixture.shape, Shape::Circle { .. }));
        let centres = round.map(|fixture| configuration.position(fixture.at));
        let all: Vec<[f64; 2]> = points.copied().chain(centres).chain(fixed(configuration)).collect();
        let range = |axis: usize| {
            all.iter()
                .map(|p| p[axis])
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
        };
        let ranges = [0, 1].map(range);
        let longest = ranges.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        let room = if longest > 0.0 { ROOM * longest } else { 0.5 };
        Self { ranges: ranges.map(|[low, high]| [low - room, high + room]) }
    }

    /// Supports and guides; the frame cuts them.
    fn fixture(&self, fixture: &Fixture, configuration: &Configuration) -> Option<Stroke> {
        let [x, y] = configuration.position(fixture.at);
        let longest = self.ranges.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        match fixture.shape {
            Shape::Line { angle, solid } => {
                let angle = configuration.number(angle);
                let far = 100.0 * (longest + (x - self.ranges[0][0]).hypot(y - self.ranges[1][0]));
                let end = |k: f64| [x + k * angle.cos(), y + k * angle.sin()];
                let width = if solid { 4 } else { 1 };
                Some(Stroke::solid(vec![end(-far), end(far)], Colour::Grey, 1.0, width))
            }
            Shape::Circle { radius, solid, .. } => {
                let (radius, width) =
                    (configuration.number(radius), if solid == Solid::Nowhere { 1 } else { 3 });
                // No chord is further from the arc than a ten thousandth of what is seen.
                let parts = (222.0 * (radius / longest).sqrt()).clamp(120.0, 1e5).ceil();
                let at = |i: u32| TAU * f64::from(i) / parts;
                let at = |i: u32| [x + radius * at(i).cos(), y + radius * at(i).sin()];
                Some(Stroke::solid((0..=parts as u32).map(at).collect(), Colour::Grey, 1.0, width))
            }
            Shape::Wedge => None,
        }
    }

    /// The height at which a figure of this width shows it without empty margins.
    fn height(&self, width: u32) -> u32 {
        let [across, up] = self.ranges.map(|[low, high]| high - low);
        let height = (f64::from(width) - BESIDE[0]) * up / across + BESIDE[1];
        height.clamp(HEIGHTS[0], HEIGHTS[1]).round() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::examples::{ball, ladder};

    #[test]
    fn each_phase_has_its_colour() {
        let record = ladder();
        let phases = Phases::from_run(&record);
        let leaves = record.events()[1].t;
        assert_eq!(phases.colour(record.interval()[0]), phases.colour(leaves.next_down()));
        assert_ne!(phases.colour(leaves), phases.colour(leaves.next_down()));
        assert_eq!(phases.colour(leaves), phases.colour(record.interval()[1]));
        let svg = Positions::new(&record).trails(["B"]).svg().unwrap();
        for word in ["on A, B", "on A", "path of B", "x, m", "y, m"] {
            assert!(svg.contains(&format!(">{word}<")), "{word}");
        }
    }

    #[test]
    fn all_that_moves_is_seen() {
        let record = ball();
        let start = Configuration::from_run(&record, 0.0);
        let seen = Seen::enclose([[0.0, 1.0], [2.0, 0.0]].iter(), &start);
        let edge = seen.fixture(&start.geometry().fixtures[0], &start).unwrap().points;
        assert!(edge[0][0] < seen.ranges[0][0] && seen.ranges[0][1] < edge[1][0] && edge[0][1] == 0.0);
        assert!(Positions::new(&record).count(1).svg().is_ok());
        let error = Positions::new(&record).trails(["Q"]).svg().unwrap_err();
        assert_eq!(error.to_string(), "no point `Q`; known: P");
    }
}
