//! What stands still.

use super::stage::{BELOW, Stage};
use super::track::{line, number};
use crate::plot::Colour;
use crate::plot::svg::plane::{Px, add, along, arc, left_of, length, minus, towards};
use crate::plot::svg::{Fill, Pen};
use core::f64::consts::{FRAC_PI_2, TAU};
use liftoff_core::model::geometry::{Fixture, Look, Shape, Solid};

/// Breadth of what is hatched.
const STRIP: f64 = 9.0;

/// An outline.
const EDGE: Pen = Pen::new(Colour::Black, 1.6);

/// What is named where [`drawn`] is.
pub(super) fn definitions(stage: &Stage) -> String {
    let hatch = "<defs><pattern id=\"hatch\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">\
                 <path d=\"M-1 7 7 -1M-1 1 1 -1M5 7 7 5\"";
    let [width, height] = stage.size;
    format!(
        "{hatch}{}/></pattern><clipPath id=\"seen\"><rect width=\"{width}\" height=\"{}\"/></clipPath></defs>\n",
        Pen::new(Colour::Black, 0.8),
        number(height - BELOW + 30.0),
    )
}

/// Supports and guides, then the points of the ground.
pub(super) fn drawn(stage: &Stage) -> String {
    let mut text = "<g clip-path=\"url(#seen)\">\n".to_owned();
    let (start, mut pieces) = (&stage.frames[0], Vec::new());
    let fixtures = start.geometry().fixtures.iter().map(|fixture| fixed(stage, fixture));
    let ground = start.geometry().grounded().map(|(point, look)| grounded(stage, point, look));
    for piece in fixtures.chain(ground) {
        if !pieces.contains(&piece) {
            text += &piece;
            pieces.push(piece);
        }
    }
    text + "</g>\n"
}

fn fixed(stage: &Stage, fixture: &Fixture) -> String {
    let start = &stage.frames[0];
    let at = stage.px(start.position(fixture.at));
    match fixture.shape {
        Shape::Line { angle, solid } => straight(stage, at, towards(start.number(angle)), solid),
        Shape::Circle { radius, solid, .. } => round(at, stage.long(start.number(radius)), solid),
        Shape::Wedge => wedge(stage, at, fixture.name),
    }
}

/// From well before the picture to well beyond it, by the foot of its middle, so that equal lines
/// are equal text.
fn straight(stage: &Stage, at: Px, ahead: Px, solid: bool) -> String {
    let middle = stage.size.map(|side| 0.5 * side);
    let from = minus(middle, at);
    let foot = along(at, ahead, from[0] * ahead[0] + from[1] * ahead[1]);
    let reach = length(stage.size);
    let [a, b] = [-reach, reach].map(|side| along(foot, ahead, side));
    if !solid {
        return guide(&line(&[a, b]));
    }
    let down = left_of(ahead).map(|x| -STRIP * x);
    surface(&line(&[a, b]), &line(&[a, b, add(b, down), add(a, down)]))
}

fn round(at: Px, radius: f64, solid: Solid) -> String {
    let ring = |radius: f64| line(&arc(at, radius, 0.0, TAU)) + "Z";
    let (edge, back) = match solid {
        Solid::Around => (ring(radius), ring(radius + STRIP)),
        Solid::Within => (ring(radius), ring((radius - STRIP).max(0.0))),
        Solid::Nowhere => return guide(&ring(radius)),
    };
    surface(&edge, &(edge.clone() + &back))
}

/// An edge whose tip points where its support pushes at the start.
fn wedge(stage: &Stage, tip: Px, support: &str) -> String {
    let start = &stage.frames[0];
    let push = start.geometry().push(support);
    let angle = push.map_or(FRAC_PI_2, |push| start.normal(push));
    let base = along(tip, towards(angle), -16.0);
    let [a, b] = [-7.0, 7.0].map(|side| along(base, left_of(towards(angle)), side));
    let form = line(&[a, tip, b]);
    surface(&form, &form)
}

fn grounded(stage: &Stage, point: usize, look: Look) -> String {
    let at = stage.px(stage.frames[0].points[point]);
    match look {
        Look::Foot => {
            let [a, b] = [[-9.0, 14.0], [9.0, 14.0]].map(|step| add(at, step));
            let edge = line(&[a, at, b]) + "Z" + &line(&[add(a, [-4.0, 0.0]), add(b, [4.0, 0.0])]);
            let [c, d] = [add(b, [4.0, 6.0]), add(a, [-4.0, 6.0])];
            surface(&edge, &line(&[add(a, [-4.0, 0.0]), add(b, [4.0, 0.0]), c, d]))
        }
        _ => {
            let cross = [[[-5.0, 0.0], [5.0, 0.0]], [[0.0, -5.0], [0.0, 5.0]]];
            let lines = cross.map(|ends| line(&ends.map(|end| add(at, end))));
            format!("<path d=\"{}\"{EDGE}/>\n", lines.concat())
        }
    }
}

/// A line that something is kept on.
fn guide(form: &str) -> String {
    format!("<path d=\"{form}\"{}/>\n", Pen::new(Colour::Black, 1.0).dashed())
}

/// An edge, and the strip on its solid side.
fn surface(edge: &str, strip: &str) -> String {
    let pale = Fill::Faint(Colour::Grey, 0.25);
    format!(
        "<path d=\"{strip}\"{pale} fill-rule=\"evenodd\"/>\n\
         <path d=\"{strip}\" fill=\"url(#hatch)\" fill-rule=\"evenodd\" opacity=\"0.6\"/>\n<path d=\"{edge}\"{EDGE}/>\n"
    )
}
