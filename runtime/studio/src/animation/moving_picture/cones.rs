//! Friction cones of closed contacts: the reaction lies within, on the edge where its contact
//! slides.

use super::contacts::{is_closed, pushes};
use super::stage::Stage;
use super::track::{line, path};
use crate::plot::Colour;
use crate::plot::svg::plane::{Px, along, left_of, towards, unit};
use crate::plot::svg::{Fill, Pen};
use crate::registry::{Configuration, MotionError};
use liftoff::Trajectory;
use liftoff_core::model::geometry::Push;
use liftoff_core::model::{Contact, ContactKind};

const EDGES: Pen = Pen::new(Colour::Orange, 1.0);

/// How long the edges are.
const LONG: f64 = 46.0;

/// Those of all contacts that have friction.
pub(super) fn drawn(stage: &Stage, record: &Trajectory) -> Result<String, MotionError> {
    let mut text = String::new();
    for (i, contact) in record.layout().contacts.iter().enumerate() {
        if let Some(support) = contact.friction.and(contact.supports.first()) {
            let mu = record.function(&format!("mu({support})"))?;
            let at = |&t: &f64| is_closed(record, i, t).then(|| mu(t)).filter(|mu| mu.is_finite());
            text += &cones(stage, contact, &stage.timeline.times.iter().map(at).collect::<Vec<_>>());
        }
    }
    Ok(text)
}

/// At each frame with its coefficient; none while it is open.
fn cones(stage: &Stage, contact: &Contact, coefficients: &[Option<f64>]) -> String {
    let cone = |push: &Push| {
        let form = |(frame, mu): (&Configuration, &Option<f64>)| {
            let (tip, ahead) = (stage.px(frame.touched(push)), towards(frame.normal(push)));
            let edge = |side: f64| {
                let reach = if mu.is_some() { LONG } else { 0.0 };
                along(tip, unit(along(ahead, left_of(ahead), side * mu.unwrap_or(0.0))), reach)
            };
            if contact.kind != ContactKind::Guide {
                return line(&[edge(1.0), tip, edge(-1.0)]);
            }
            // A guide bears on either side.
            let back = |ahead: Px| along(tip, [tip[0] - ahead[0], tip[1] - ahead[1]], 1.0);
            line(&[edge(1.0), back(edge(1.0)), back(edge(-1.0)), edge(-1.0)])
        };
        let forms: Vec<_> = stage.frames.iter().zip(coefficients).map(form).collect();
        let style = format!(" data-cone=\"{}\"{EDGES}{}", push.support, Fill::Faint(Colour::Orange, 0.18));
        path(&stage.timeline, &style, &forms, "")
    };
    pushes(&stage.frames[0], contact).map(cone).collect()
}
