//! The forms that are drawn against what the equations say of the same coordinates, bars and contacts: a kind of either that
//! has no form is found here.

use liftoff::model::geometry::{Direction, Look, Reading, Shape, Spot};
use liftoff_models::models;
use liftoff_studio::picture::clearest_pose;
use liftoff_studio::registry::{Configuration, Entry};

fn pose(model: &Entry) -> Configuration {
    clearest_pose(model, &model.default_run()).expect("a pose")
}

/// How far apart two places are.
fn distance([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a - c).hypot(b - d)
}

/// Rounding of some sums of lengths of the model's size, and of roots of their squares.
fn near(model: &Entry, what: &str, a: f64, b: f64) {
    let bound = 1e-12 * (1.0 + a.abs() + b.abs());
    assert!((a - b).abs() <= bound, "{}: {what} is drawn as {a}, not {b}", model.name());
}

#[test]
fn every_coordinate_is_measured_where_it_is() {
    for model in models().iter() {
        let pose = pose(model);
        let (layout, readings) = (pose.layout, pose.geometry().readings);
        assert_eq!(readings.len(), layout.coordinates.len(), "{}", model.name());
        for (i, reading) in readings.iter().enumerate() {
            let (name, value) = (layout.coordinates[i].name, pose.state[i]);
            match *reading {
                Reading::Position { point, axis, sign } => {
                    near(model, name, f64::from(sign) * pose.points[point][axis], value);
                }
                Reading::Angle { vertex, tip, from, against, sign } => {
                    let body = pose.geometry().bodies.iter().find(|body| body.outline.contains(&tip));
                    if body.is_some_and(|body| body.outline.len() > 2) {
                        continue;
                    }
                    let ends = if against { [tip, vertex] } else { [vertex, tip] };
                    let [a, b] = ends.map(Spot::Point);
                    let angle = pose.direction(Direction::Towards(a, b)) - pose.direction(from);
                    near(model, name, (f64::from(sign) * angle).cos(), value.cos());
                    near(model, name, (f64::from(sign) * angle).sin(), value.sin());
                }
            }
        }
    }
}

#[test]
fn every_body_is_drawn_and_every_bar_as_long_as_is_written() {
    for model in models().iter() {
        let pose = pose(model);
        let geometry = pose.geometry();
        assert_eq!(geometry.bodies.len(), pose.layout.bars.len(), "{}", model.name());
        for (bar, body) in pose.layout.bars.iter().zip(geometry.bodies) {
            assert_eq!([bar.from, bar.to], body.outline[..2], "{}", bar.name);
            let written = geometry.lengths.iter().any(|length| length.between.contains(&[bar.from, bar.to]));
            assert_eq!(written, body.outline.len() == 2, "{}", bar.name);
        }
        for length in geometry.lengths {
            for [a, b] in length.between {
                let seen = distance(pose.points[*a], pose.points[*b]);
                near(model, "a length", seen, pose.number(length.value));
            }
        }
        let masses = geometry.marked(Look::Mass).count();
        let measured = pose.measures.iter().filter(|measure| measure.of.starts_with("mass at ")).count();
        assert_eq!(masses, measured, "{}", model.name());
    }
}

/// The gap of a support or thread as it is drawn: how far what moves is from what stands still, along the push.
fn drawn_gap(pose: &Configuration, name: &str) -> Option<f64> {
    let geometry = pose.geometry();
    let push = geometry.push(name)?;
    if let Some(thread) = geometry.threads.iter().find(|thread| thread.name == name) {
        let seen = distance(pose.points[thread.path[0]], pose.points[thread.path[1]]);
        let length = pose.number(thread.length);
        return (thread.path.len() == 2).then(|| (length * length - seen * seen) / (2.0 * length));
    }
    let fixture = geometry.fixtures.iter().find(|fixture| fixture.name == name)?;
    let [x, y] = pose.place(fixture.at);
    let (mut sin, mut cos) = pose.direction(push.along).sin_cos();
    for _ in 0..push.turns {
        (cos, sin) = (-sin, cos);
    }
    let height = |[u, v]: [f64; 2]| (u - x) * cos + (v - y) * sin;
    match fixture.shape {
        Shape::Line { solid, .. } => solid.then(|| height(pose.spot(push.at))),
        Shape::Circle { radius, inside, .. } => {
            let (along, radius) = (height(pose.spot(push.at)), pose.number(radius));
            let sign = if inside { -1.0 } else { 1.0 };
            Some((along * along - radius * radius) * sign / (2.0 * radius)).filter(|_| along * sign > 0.0)
        }
        Shape::Wedge => match push.along {
            Direction::Towards(on_bar, _) => Some(height(pose.spot(on_bar))),
            Direction::Fixed(_) | Direction::Axis { .. } => None,
        },
    }
}

/// Over a run, so that contacts are open too and a push the wrong way is seen.
#[test]
fn every_contact_is_drawn_where_its_gap_is() {
    for model in models().iter().filter(|model| !model.layout().contacts.is_empty()) {
        let run = model.run(&model.default_run()).expect("a run");
        let [start, end] = run.interval();
        for support in model.layout().contacts.iter().flat_map(|contact| contact.supports) {
            let gap = run.function(&format!("gap({support})")).expect("a gap");
            for k in 0..=8 {
                let t = start + (end - start) * f64::from(k) / 8.0;
                let drawn = drawn_gap(&Configuration::of(&run, t), support);
                let drawn = drawn.unwrap_or_else(|| panic!("{}: {support} is not drawn", model.name()));
                near(model, support, drawn, gap(t));
            }
        }
    }
}
