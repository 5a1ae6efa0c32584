//! The forms that are drawn against what the equations say of the same coordinates, bars and
//! contacts: a kind of either that has no form is found here.

use liftoff_core::model::geometry::{Direction, Look, Push, Reading, Shape, Solid, Spot};
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

/// The gap of a support or thread as it is drawn: how far what moves is from what stands still,
/// along the push.
fn drawn_gap(pose: &Configuration, name: &str) -> Option<f64> {
    let geometry = pose.geometry();
    let push = geometry.push(name)?;
    if let Some(thread) = geometry.threads.iter().find(|thread| thread.name == name) {
        let seen = distance(pose.points[thread.path[0]], pose.points[thread.path[1]]);
        let length = pose.number(thread.length);
        return (thread.path.len() == 2).then(|| (length * length - seen * seen) / (2.0 * length));
    }
    let (sin, cos) = pose.normal(push).sin_cos();
    let at = pose.touched(push);
    let height = |[x, y]: [f64; 2]| (at[0] - x) * cos + (at[1] - y) * sin;
    let Some(fixture) = geometry.fixtures.iter().find(|fixture| fixture.name == name) else {
        return moving_gap(pose, push, height);
    };
    let on = pose.position(fixture.at);
    match fixture.shape {
        Shape::Line { solid, .. } => solid.then(|| height(on)),
        Shape::Circle { radius, solid, .. } => round_gap(pose, push, on, (pose.number(radius), solid)),
        Shape::Wedge => match push.along {
            Direction::Towards(on_bar, _) => Some(-height(pose.spot(on_bar))),
            Direction::Fixed(_) | Direction::Axis { .. } => None,
        },
    }
}

/// The gap over what moves: a circle about a point, or an edge from a point on.
fn moving_gap(pose: &Configuration, push: &Push, height: impl Fn([f64; 2]) -> f64) -> Option<f64> {
    match push.along {
        Direction::Towards(Spot::Point(centre), towards) if towards == push.at => {
            let round = pose.geometry().rounds.iter().find(|round| round.centre == centre)?;
            round_gap(pose, push, pose.points[centre], (pose.number(round.radius), round.solid))
        }
        Direction::Towards(from, _) => Some(height(pose.spot(from))),
        Direction::Fixed(_) | Direction::Axis { .. } => None,
    }
}

/// (d² − L²)/2L of the distance d of the centres, L where they touch; inside its opposite.
fn round_gap(pose: &Configuration, push: &Push, on: [f64; 2], (radius, solid): (f64, Solid)) -> Option<f64> {
    let rim = push.rim.map_or(0.0, |rim| pose.number(rim));
    let (reach, sign) = match solid {
        Solid::Within => (radius + rim, 1.0),
        Solid::Around => (radius - rim, -1.0),
        Solid::Nowhere => return None,
    };
    let apart = distance(pose.spot(push.at), on);
    Some(sign * (apart * apart - reach * reach) / (2.0 * reach))
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
                let drawn = drawn_gap(&Configuration::from_run(&run, t), support);
                let drawn = drawn.unwrap_or_else(|| panic!("{}: {support} is not drawn", model.name()));
                near(model, support, drawn, gap(t));
            }
        }
    }
}
