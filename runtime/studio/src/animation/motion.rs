//! A motion as the page reads it.

use super::About;
use super::geometry::Geometry;
use super::quantities::{AnimatedQuantity, Function, functions, quantities};
use super::rounding::{CLOSENESS, sizes, whole};
use super::sampling::{Sampled, Sampler};
use super::scenery::{EventItem, SceneryItem, scenery};
use crate::registry::{Configuration, MotionError};
use liftoff::{Segment, Trajectory};
use liftoff_core::model::Layout;
use serde::Serialize;

/// Times at which the sizes of quantities are read, beside the steps' ends.
const READ: u32 = 400;

#[derive(Serialize)]
pub(super) struct Motion {
    interval: [f64; 2],
    points: Vec<&'static str>,
    geometry: Geometry,
    scenery: Vec<SceneryItem>,
    /// Positions of the points first.
    pub(super) quantities: Vec<AnimatedQuantity>,
    /// The unit in which each quantity's values are given.
    pub(super) steps: Vec<f64>,
    pub(super) phases: Vec<Phase>,
    events: Vec<EventItem>,
}

#[derive(Serialize)]
pub(super) struct Phase {
    /// Indices of the closed contacts, and their supports.
    closed: Vec<usize>,
    supports: Vec<&'static str>,
    method: &'static str,
    /// Indices of the springs that do not act.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) off: Vec<usize>,
    pub(super) times: Vec<f64>,
    /// Of each quantity, at the start and at both thirds and the end of each interval; one value if
    /// it never changes.
    pub(super) values: Vec<Vec<Option<i64>>>,
}

impl Motion {
    /// Of a record.
    pub fn from_run(record: &Trajectory, about: &About) -> Result<Self, MotionError> {
        let layout = record.layout();
        let quantities = quantities(record, about.outputs);
        let functions = functions(record, &quantities)?;
        let sizes = sizes(&quantities, &survey(record, &functions));
        let tolerances = sizes.iter().map(|size| CLOSENESS * size).collect();
        let sampled = Sampler::new(&functions, tolerances).phases(&record.segments(), &record.times());
        // Rounding takes a tenth of what may be missed.
        let steps: Vec<f64> = sizes.iter().map(|size| short(0.2 * CLOSENESS * size)).collect();
        let interval = record.interval();
        let start = Configuration::from_run(record, interval[0]);
        Ok(Self {
            interval,
            points: layout.points.to_vec(),
            geometry: Geometry::new(&start),
            scenery: scenery(&start),
            phases: phases(record, &sampled, &steps),
            events: record.events().iter().map(EventItem::from_event).collect(),
            quantities,
            steps,
        })
    }

    /// As text that may stand in a script element.
    pub fn json(&self) -> String {
        serde_json::to_string(self).map_or_else(|_| "null".to_owned(), |text| text.replace('<', "\\u003c"))
    }
}

/// Values at times spread over the run.
fn survey(record: &Trajectory, functions: &[Function]) -> Vec<Vec<f64>> {
    let [start, end] = record.interval();
    let even = (0..=READ).map(|i| start + (end - start) * f64::from(i) / f64::from(READ));
    even.map(|t| functions.iter().map(|function| function(t)).collect()).collect()
}

/// The power of ten at or below a number, which is short to write.
fn short(x: f64) -> f64 {
    10.0_f64.powi(x.log10().floor() as i32)
}

fn phases(record: &Trajectory, sampled: &[Sampled], steps: &[f64]) -> Vec<Phase> {
    let segments = record.segments();
    let phase = |sampled: &Sampled| {
        let segment = &segments[sampled.segment];
        let values = steps.iter().enumerate().map(|(i, step)| track(&sampled.rows, i, *step));
        Phase {
            closed: segment.set.iter().collect(),
            supports: segment.closed.clone(),
            method: segment.choice.method,
            off: off(record.layout(), segment),
            times: sampled.times.clone(),
            values: values.collect(),
        }
    };
    sampled.iter().map(phase).collect()
}

/// The springs that a switch has and that do not act.
fn off(layout: &Layout, segment: &Segment) -> Vec<usize> {
    let rests = |name: &str| {
        let switch = layout.switch_of(&format!("spring {name}"));
        switch.is_some_and(|switch| !segment.acting.contains(&switch))
    };
    let springs = layout.geometry.springs.iter().enumerate();
    springs.filter(|(_, spring)| rests(spring.name)).map(|(i, _)| i).collect()
}

fn track(rows: &[Vec<f64>], i: usize, step: f64) -> Vec<Option<i64>> {
    let mut values: Vec<_> = rows.iter().map(|row| whole(row[i], step)).collect();
    if values.iter().all(|value| *value == values[0]) {
        values.truncate(1);
    }
    values
}
