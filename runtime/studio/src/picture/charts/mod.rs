//! Outputs of a motion against time, or against another output.

mod events;
mod panels;
#[cfg(test)]
mod tests;

use super::quantities::{axis, shown};
use super::sample::{Traced, seen, traced};
use crate::registry::{MotionError, Units};

use crate::plot::{Axis, Chart, Figure};
use events::EventMarks;
use liftoff::Trajectory;
use panels::{Panel, defaults};

/// Width of a figure, and the height of a panel, pixels.
const SIZE: (u32, u32) = (860, 230);
/// Height that words, keys and the axis below take beside the panels.
const BESIDE: u32 = 90;

/// Outputs of a motion, those of one unit in one panel, over one axis.
pub struct Charts<'a> {
    record: &'a Trajectory,
    outputs: Vec<String>,
    against: String,
    size: (Option<u32>, Option<u32>),
}

/// Curves over one axis, and the events of the motion.
pub struct ChartNumbers {
    /// Name of the axis, with its unit.
    pub against: String,
    /// In the order of the outputs.
    pub curves: Vec<ChartCurve>,
    /// What has happened, and the times: several where an event repeats in a row of many.
    pub events: Vec<(String, Vec<f64>)>,
}

/// An output over the axis.
pub struct ChartCurve {
    /// The output in print.
    pub name: String,
    /// Empty for a number, and where it is not known.
    pub unit: String,
    /// Dense enough for a drawing; a point that is not a number breaks the line.
    pub points: Vec<[f64; 2]>,
}

impl<'a> Charts<'a> {
    /// Of a motion: its coordinates, reactions and energies against time, if nothing else is asked
    /// for.
    pub fn new(record: &'a Trajectory) -> Self {
        Self { record, outputs: Vec::new(), against: "t".into(), size: (None, None) }
    }

    /// These outputs: expressions as of [`Output`](liftoff::Output).
    #[must_use]
    pub fn outputs(self, outputs: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { outputs: outputs.into_iter().map(Into::into).collect(), ..self }
    }

    /// Against this output in place of time.
    #[must_use]
    pub fn against(self, output: &str) -> Self {
        Self { against: output.into(), ..self }
    }

    /// Width and height in pixels; what is not given is chosen.
    #[must_use]
    pub fn size(self, width: Option<u32>, height: Option<u32>) -> Self {
        Self { size: (width, height), ..self }
    }

    /// As SVG text. Phases are shaded by turns and named by their closed supports, events are
    /// marked and named; a value that an event changes at once is drawn before and after it, and
    /// where it is not finite there is a gap.
    ///
    /// # Errors
    /// An output that the model does not have.
    pub fn svg(&self) -> Result<String, MotionError> {
        let units = Units::from_layout(self.record.layout());
        let outputs = if self.outputs.is_empty() { defaults(self.record) } else { self.outputs.clone() };
        let x = self.record.function(&self.against)?;
        let panels = Panel::grouped(self.trace(&outputs)?, &units);
        let is_time = self.against.trim() == "t";
        let axis = self.axis(&panels, &units, is_time);
        let marks = if is_time {
            EventMarks::over(self.record, &axis, self.width())
        } else {
            EventMarks::beside(self.record, self.width())
        };
        let charts: Result<Vec<Chart>, MotionError> = panels
            .iter()
            .enumerate()
            .map(|(i, panel)| {
                let mut chart = panel.chart(&axis, i + 1 == panels.len());
                chart.marks.extend(marks.marks(self.record, &x, panel)?);
                Ok(chart)
            })
            .collect();
        let annotations = marks.annotations();
        let height = self
            .size
            .1
            .unwrap_or(BESIDE + SIZE.1 * panels.len() as u32 + 19 * annotations.notes.len() as u32);
        let figure = Figure { description: self.description(&outputs), size: (self.width(), height) };
        Ok(figure.stacked(&charts?, &annotations))
    }

    /// As numbers, for another program to draw.
    ///
    /// # Errors
    /// An output that the model does not have.
    pub fn numbers(&self) -> Result<ChartNumbers, MotionError> {
        let units = Units::from_layout(self.record.layout());
        let curve = |(output, curve): (String, Traced)| ChartCurve {
            name: shown(&output),
            unit: units.unit(&output).unwrap_or_default(),
            points: curve.joined(),
        };
        Ok(ChartNumbers {
            against: axis(&shown(&self.against), units.unit(&self.against).as_deref()),
            curves: self.trace(&self.outputs)?.into_iter().map(curve).collect(),
            events: events::events(self.record),
        })
    }

    fn trace(&self, outputs: &[String]) -> Result<Vec<(String, Traced)>, MotionError> {
        let x = self.record.function(&self.against)?;
        let curve =
            |output: &String| Ok((output.clone(), traced(self.record, &x, &self.record.function(output)?)));
        outputs.iter().map(curve).collect()
    }

    fn width(&self) -> u32 {
        self.size.0.unwrap_or(SIZE.0)
    }

    /// Time ends where the run ends; all else has a little room.
    fn axis(&self, panels: &[Panel], units: &Units, is_time: bool) -> Axis {
        let name = axis(&shown(&self.against), units.unit(&self.against).as_deref());
        let [start, end] = self.record.interval();
        if is_time && start < end {
            return Axis::linear(&name, [start, end]);
        }
        let points = panels.iter().flat_map(|panel| &panel.curves).flat_map(|(_, curve)| &curve.pieces);
        Axis::holding(&name, seen(points.flat_map(|piece| &piece.points).map(|point| point[0])))
    }

    fn description(&self, outputs: &[String]) -> String {
        format!("{}: {} against {}", self.record.layout().name, outputs.join(", "), self.against)
    }
}
