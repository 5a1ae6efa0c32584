//! How the model is drawn.

use liftoff_codegen::geometry::{self as derived};
use liftoff_core::model::geometry::{
    Block, Body, Direction, Fixture, Geometry, Length, Look, Mark, Push, Reading, Round, Section, Shape,
    Solid, Spiral, Spot, Spring, Thread,
};

use super::{list, text};

/// The same forms, lasting.
pub(super) fn geometry(drawn: &derived::Geometry) -> Geometry {
    let spiral =
        |(point, from): &(usize, derived::DrawnDirection)| Spiral { point: *point, from: direction(from) };
    let block =
        |(point, along): &(usize, derived::DrawnDirection)| Block { point: *point, along: direction(along) };
    let mark = |(point, of): &(usize, derived::Look)| Mark { point: *point, look: look(*of) };
    Geometry {
        bodies: list(drawn.bodies.iter().map(|body| Body {
            outline: list(body.outline.iter().copied()),
            inner: list(body.inner.iter().copied()),
        })),
        rounds: list(drawn.rounds.iter().map(|round| Round {
            centre: round.centre,
            radius: round.radius,
            text: text(&round.text),
            solid: solid(round.solid),
            along: round.along.as_ref().map(direction),
        })),
        threads: list(drawn.threads.iter().map(|thread| Thread {
            name: text(&thread.name),
            path: list(thread.path.iter().copied()),
            length: thread.length,
            text: text(&thread.text),
        })),
        springs: list(drawn.springs.iter().map(|spring| Spring {
            name: text(&spring.name),
            ends: spring.ends,
            coil: spring.coil,
            dashpot: spring.dashpot,
            text: text(&spring.text),
        })),
        spirals: list(drawn.spirals.iter().map(spiral)),
        blocks: list(drawn.blocks.iter().map(block)),
        marks: list(drawn.marks.iter().map(mark)),
        fixtures: list(drawn.fixtures.iter().map(|fixture| Fixture {
            name: text(&fixture.name),
            at: fixture.at,
            shape: shape(&fixture.shape),
        })),
        sections: list(drawn.sections.iter().map(|section| Section {
            name: text(&section.name),
            ends: section.ends,
            at: section.at,
        })),
        readings: list(drawn.readings.iter().map(reading)),
        lengths: list(drawn.lengths.iter().map(|length| Length {
            value: length.value,
            text: text(&length.text),
            between: list(length.between.iter().copied()),
        })),
        pushes: list(drawn.pushes.iter().map(|push| Push {
            support: text(&push.support),
            at: spot(&push.at),
            rim: push.rim,
            along: direction(&push.along),
            turns: push.turns,
            slip: push.slip,
        })),
        gravity: drawn.gravity,
    }
}

fn spot(spot: &derived::Spot) -> Spot {
    match *spot {
        derived::Spot::Point(point) => Spot::Point(point),
        derived::Spot::Fixed(at) => Spot::Fixed(at),
    }
}

fn direction(direction: &derived::DrawnDirection) -> Direction {
    match direction {
        derived::DrawnDirection::Fixed(angle) => Direction::Fixed(*angle),
        derived::DrawnDirection::Towards(from, to) => Direction::Towards(spot(from), spot(to)),
        derived::DrawnDirection::Axis(ends, step) => Direction::Axis { ends: *ends, step: *step },
    }
}

fn look(look: derived::Look) -> Look {
    match look {
        derived::Look::Peg => Look::Peg,
        derived::Look::Mass => Look::Mass,
        derived::Look::Ring => Look::Ring,
        derived::Look::Disc => Look::Disc,
        derived::Look::Foot => Look::Foot,
        derived::Look::Ground => Look::Ground,
    }
}

fn shape(shape: &derived::DrawnShape) -> Shape {
    match shape {
        derived::DrawnShape::Line { angle, solid } => Shape::Line { angle: *angle, solid: *solid },
        derived::DrawnShape::Circle { radius, solid: bounds, text: formula } => {
            Shape::Circle { radius: *radius, solid: solid(*bounds), text: text(formula) }
        }
        derived::DrawnShape::Wedge => Shape::Wedge,
    }
}

fn solid(solid: derived::Solid) -> Solid {
    match solid {
        derived::Solid::Within => Solid::Within,
        derived::Solid::Around => Solid::Around,
        derived::Solid::Nowhere => Solid::Nowhere,
    }
}

fn reading(reading: &derived::DrawnReading) -> Reading {
    match *reading {
        derived::DrawnReading::Angle { vertex, tip, ref from, against, sign } => {
            Reading::Angle { vertex, tip, from: direction(from), against, sign }
        }
        derived::DrawnReading::Position { point, axis, sign } => Reading::Position { point, axis, sign },
    }
}
