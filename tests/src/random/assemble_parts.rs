//! What a spec has beside bars, pins, masses and supports as the oracle's data.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector2;

use super::assemble::{Places, coordinate, normal, vector};
use super::parts::{SliderSpec, Target, Track, Weld};
use super::quantity::Quantity;
use super::spec::{Declared, Origin, Spec};
use crate::oracle;
use crate::oracle::{
    AngleTie, Assembly, Contact, Coordinate, Couple, Drive, Guide, Load, Spring, Support, Torsion,
};

/// Everything of [`Parts`](super::parts::Parts) but welds and particles.
pub fn parts(spec: &Spec, places: &Places, assembly: &mut Assembly) {
    let parts = &spec.parts;
    let number = |quantity: &Option<Quantity>| quantity.as_ref().map_or(0.0, |q| q.value);
    assembly.sliders = parts.sliders.iter().map(|slider| self::slider(slider, places)).collect();
    assembly.supports.extend(parts.threads.iter().map(|thread| Support {
        name: thread.name.clone(),
        contact: Contact::Thread {
            path: thread.path.iter().map(|point| places[point]).collect(),
            length: thread.length.value,
        },
        rough: false,
    }));
    assembly.springs.extend(parts.springs.iter().map(|spring| Spring {
        ends: spring.ends.each_ref().map(|end| places[end]),
        stiffness: number(&spring.stiffness),
        length: number(&spring.length),
        damping: number(&spring.damping),
    }));
    assembly.torsions.extend(parts.torsions.iter().map(|torsion| {
        let on = torsion.second.unwrap_or(torsion.first);
        let from = torsion.second.map(|_| torsion.first);
        let shown = counted_direction(spec, on) - from.map_or(0.0, |from| counted_direction(spec, from));
        Torsion {
            on,
            from,
            stiffness: number(&torsion.stiffness),
            angle: number(&torsion.angle) + shown - unwind(shown),
            damping: number(&torsion.damping),
        }
    }));
    assembly.loads.extend(parts.forces.iter().map(|force| Load {
        at: places[&force.point],
        force: force.value.each_ref().map(|value| value.formula(spec, places)),
        frame: force.frame,
    }));
    assembly.couples.extend(parts.couples.iter().map(|couple| Couple {
        on: couple.on,
        from: couple.from,
        value: couple.value.formula(spec, places),
    }));
    assembly.drives.extend(parts.drives.iter().map(|drive| Drive {
        reading: reading(spec, &drive.target, places),
        value: drive.value.formula(spec, places),
    }));
}

fn slider(slider: &SliderSpec, places: &Places) -> oracle::Slider {
    let line = |through, normal| Guide::Line { through, normal };
    let guide = match &slider.track {
        Track::Horizontal(height) => line(Vector2::new(0.0, height.value), Vector2::y()),
        Track::Vertical(x) => line(Vector2::new(x.value, 0.0), Vector2::x()),
        Track::Line(angle, through) => line(vector(through), normal(angle.value)),
        Track::Bar(bar) => Guide::Axis(*bar),
    };
    oracle::Slider { point: places[&slider.point], guide }
}

fn reading(spec: &Spec, target: &Target, places: &Places) -> Coordinate {
    match target {
        Target::Coordinate(index) => coordinate(spec, &spec.coordinates[*index], places),
        Target::Direction(bar) => {
            let shown = counted_direction(spec, *bar);
            Coordinate::Angle { terms: vec![(*bar, 1.0)], offset: shown - unwind(shown) }
        }
        Target::Position(point, axis) => Coordinate::Position { at: places[point], axis: *axis, sign: 1.0 },
    }
}

/// The direction of a bar in the figure as its declared angle counts it.
fn counted_direction(spec: &Spec, bar: usize) -> f64 {
    let heading = spec.bars[bar].heading.angle();
    let base = spec.coordinates.iter().find_map(|declared| match declared {
        Declared::Angle { bar: own, origin: Origin::Direction(quarters, _), .. } if *own == bar => {
            Some(*quarters as f64 * FRAC_PI_2)
        }
        _ => None,
    });
    base.map_or(heading, |base| base + unwind(heading - base))
}

/// An angle within half a turn; a straight one is positive.
fn unwind(angle: f64) -> f64 {
    let rest = angle.rem_euclid(TAU);
    if rest > PI + 1e-9 { rest - TAU } else { rest }
}

/// A weld keeps the difference that the headings have.
pub fn weld(spec: &Spec, weld: &Weld) -> AngleTie {
    let angle = |bar: usize| spec.bars[bar].heading.angle();
    match weld.second {
        None => AngleTie { terms: vec![(weld.first, 1.0)], value: angle(weld.first) },
        Some(second) => AngleTie {
            terms: vec![(second, 1.0), (weld.first, -1.0)],
            value: angle(second) - angle(weld.first),
        },
    }
}
