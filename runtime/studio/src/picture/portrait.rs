//! Phase portraits: rates against coordinates, of one motion or of several.

use super::quantities::shown;
use super::sample::{Traced, seen, traced};
use crate::registry::{MotionError, Units};
use liftoff::EventKind;
use liftoff::Trajectory;

use crate::plot::{Axis, Chart, Colour, Curve, Dash, Figure, Mark};

/// Width and height of a panel.
const PANEL: (u32, u32) = (680, 480);

/// Rates against coordinates, one panel for each coordinate, one curve for each motion.
pub struct Portrait<'a> {
    runs: Vec<(String, &'a Trajectory)>,
    coordinates: Vec<String>,
    size: (Option<u32>, Option<u32>),
}

impl<'a> Portrait<'a> {
    /// Of a motion and all of its coordinates.
    pub fn new(name: &str, record: &'a Trajectory) -> Self {
        let coordinates = record.layout().coordinates.iter().map(|c| c.name.to_owned()).collect();
        Self { runs: vec![(name.to_owned(), record)], coordinates, size: (None, None) }
    }

    /// Another motion of the same model.
    #[must_use]
    pub fn and(mut self, name: &str, record: &'a Trajectory) -> Self {
        self.runs.push((name.to_owned(), record));
        self
    }

    /// These coordinates only.
    #[must_use]
    pub fn coordinates(self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { coordinates: names.into_iter().map(Into::into).collect(), ..self }
    }

    /// Width and height in pixels; what is not given is chosen.
    #[must_use]
    pub fn size(self, width: Option<u32>, height: Option<u32>) -> Self {
        Self { size: (width, height), ..self }
    }

    /// As SVG text: starts as dots, events as rings, a rate that an impact changes at once as a
    /// dotted line.
    ///
    /// # Errors
    /// A coordinate that the model does not have.
    pub fn svg(&self) -> Result<String, MotionError> {
        let charts: Result<Vec<Chart>, MotionError> =
            self.coordinates.iter().map(|coordinate| self.chart(coordinate)).collect();
        let charts = charts?;
        let height = self.size.1.unwrap_or(PANEL.1 * charts.len().max(1) as u32);
        let model = self.runs.first().map_or("", |(_, record)| record.layout().name);
        let figure = Figure {
            description: format!("{model}: phase portrait of {}", self.coordinates.join(", ")),
            size: (self.size.0.unwrap_or(PANEL.0), height),
        };
        Ok(figure.charts(&charts))
    }

    fn chart(&self, coordinate: &str) -> Result<Chart, MotionError> {
        let outputs = [coordinate.to_owned(), format!("{coordinate}'")];
        let mut curves = Vec::new();
        let mut marks = Vec::new();
        for (i, (name, record)) in self.runs.iter().enumerate() {
            let [x, y] = [record.function(&outputs[0])?, record.function(&outputs[1])?];
            let curve = traced(record, &x, &y);
            let (colour, dash) = Dash::choose(i);
            curves.extend(jumps(&curve, colour));
            let name = if self.runs.len() > 1 { shown(name) } else { String::new() };
            curves.push(Curve { dash, ..Curve::solid(&name, colour, curve.joined()) });
            let start = record.interval()[0];
            marks.push(Mark { at: [x(start), y(start)], label: String::new() });
            curves.push(events(record, &x, &y, colour));
        }
        let axis = |i: usize| self.axis(&outputs[i], curves.iter().flat_map(|c| &c.points).map(|p| p[i]));
        Ok(Chart { x: axis(0), y: axis(1), curves: curves.clone(), marks })
    }

    fn axis(&self, output: &str, values: impl Iterator<Item = f64>) -> Axis {
        let unit = self.runs.first().and_then(|(_, record)| Units::from_layout(record.layout()).unit(output));
        let name = match unit {
            Some(unit) if !unit.is_empty() => format!("{}, {unit}", shown(output)),
            _ => shown(output),
        };
        Axis::holding(&name, seen(values))
    }
}

fn jumps(curve: &Traced, colour: Colour) -> Vec<Curve> {
    let line = |(_, ends): (usize, [[f64; 2]; 2])| Curve {
        dash: Dash::Dotted,
        ..Curve::solid("", colour, ends.to_vec())
    };
    curve.jumps().into_iter().map(line).collect()
}

/// Dots where events are, each on its own.
fn events(record: &Trajectory, x: &dyn Fn(f64) -> f64, y: &dyn Fn(f64) -> f64, colour: Colour) -> Curve {
    let marked = record
        .events()
        .iter()
        .filter(|event| !matches!(event.kind, EventKind::Start | EventKind::End | EventKind::Stop));
    let points = marked.flat_map(|event| [[x(event.t), y(event.t)], [f64::NAN; 2]]).collect();
    Curve::solid("", colour, points).dotted()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::examples::ball;

    #[test]
    fn an_impact_turns_the_rate_round_at_one_height() {
        let record = ball();
        let chart = Portrait::new("", &record).chart("y").unwrap();
        assert_eq!((chart.x.name.as_str(), chart.y.name.as_str()), ("y, m", "y\u{307}, m/s"));
        assert_eq!(chart.marks[0].at, [1.0, 0.0]);
        let jump = &chart.curves[0].points;
        assert!((jump[0][1] + 4.0).abs() < 1e-9 && (jump[1][1] - 2.0).abs() < 1e-9, "{jump:?}");
        assert!(jump.iter().all(|point| point[0].abs() < 1e-9));
    }
}
