//! Scenes moved, renamed and joined; a half and its image.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::scene::{Guide, Place, Reference, Scene, Shape, Target, Vector};

/// Each position, velocity, line and direction of a scene.
pub fn move_places(scene: &Scene, place: impl Fn(Place) -> Place) -> Scene {
    let mut scene = scene.clone();
    let position = |at: &mut Vector| *at = place(Place { position: *at, velocity: [0.0; 2] }).position;
    scene.points.values_mut().for_each(|known| *known = place(*known));
    for support in &mut scene.supports {
        match &mut support.shape {
            Shape::Line { through, .. } => position(through),
            Shape::Circle { centre, .. } => position(centre),
            Shape::Bar { .. } => {}
        }
    }
    for slider in &mut scene.sliders {
        match &mut slider.guide {
            Guide::Line { through, .. } => position(through),
            Guide::Circle { centre, .. } => position(centre),
        }
    }
    scene
}

/// The angles of lines, by reference.
pub fn line_angles(scene: &mut Scene) -> impl Iterator<Item = &mut f64> {
    let supports = scene.supports.iter_mut().filter_map(|support| match &mut support.shape {
        Shape::Line { angle, .. } => Some(angle),
        _ => None,
    });
    supports.chain(scene.sliders.iter_mut().filter_map(|slider| match &mut slider.guide {
        Guide::Line { angle, .. } => Some(angle),
        Guide::Circle { .. } => None,
    }))
}

/// The image in the line x = 0.
pub fn reflect(original: &Scene) -> Scene {
    let flip = |[x, y]: Vector| [-x, y];
    let place = |Place { position, velocity }| Place { position: flip(position), velocity: flip(velocity) };
    let mut scene = move_places(original, place);
    scene.gravity = flip(scene.gravity);
    for body in &mut scene.bodies {
        body.angle = PI - body.angle;
        body.rate = -body.rate;
        body.centre[1] = -body.centre[1];
        body.spots.iter_mut().for_each(|(_, at)| at[1] = -at[1]);
    }
    line_angles(&mut scene).for_each(|angle| *angle = -*angle);
    scene.supports.iter_mut().for_each(|support| support.moving = support.moving.opposite());
    for support in &mut scene.supports {
        if let Shape::Bar { is_left, .. } = &mut support.shape {
            *is_left = !*is_left;
        }
    }
    scene.forces.iter_mut().for_each(|force| force.along = flip(force.along));
    scene.couples.iter_mut().for_each(|couple| couple.wave = couple.wave.opposite());
    scene.turn_as_in(original, -1.0);
    scene
}

/// The same scene with other names and other numbers of bodies.
pub fn rename(scene: &Scene, name: impl Fn(&str) -> String, first_body: usize) -> Scene {
    let mut scene = scene.clone();
    let rename = |own: &mut String| *own = name(own);
    for body in &mut scene.bodies {
        rename(&mut body.name);
        body.ends.iter_mut().for_each(rename);
        body.spots.iter_mut().for_each(|(spot, _)| rename(spot));
        if let Reference::Body(other) = &mut body.reference {
            *other += first_body;
        }
    }
    scene.particles.iter_mut().chain(&mut scene.masses).for_each(|(point, _)| rename(point));
    let lists = [&mut scene.pins, &mut scene.grounds, &mut scene.corners];
    lists.into_iter().flatten().for_each(rename);
    scene.welds.iter_mut().flatten().for_each(|body| *body += first_body);
    scene.sliders.iter_mut().for_each(|slider| rename(&mut slider.point));
    for support in &mut scene.supports {
        rename(&mut support.point);
        if let Shape::Bar { body, .. } = &mut support.shape {
            *body += first_body;
        }
    }
    for thread in &mut scene.threads {
        rename(&mut thread.name);
        thread.path.iter_mut().for_each(rename);
    }
    for spring in &mut scene.springs {
        rename(&mut spring.name);
        spring.ends.iter_mut().for_each(rename);
    }
    for torsion in &mut scene.torsions {
        torsion.second += first_body;
        torsion.first = torsion.first.map(|body| body + first_body);
    }
    for force in &mut scene.forces {
        rename(&mut force.name);
        rename(&mut force.point);
    }
    for couple in &mut scene.couples {
        rename(&mut couple.name);
        couple.body += first_body;
        couple.from = couple.from.map(|body| body + first_body);
    }
    for drive in &mut scene.drives {
        match &mut drive.target {
            Target::Angle(body) => *body += first_body,
            Target::Between(first, second) => {
                *first += first_body;
                *second += first_body;
            }
            Target::Distance(ends) => ends.iter_mut().for_each(rename),
        }
    }
    let points = std::mem::take(&mut scene.points);
    scene.points = points.into_iter().map(|(own, place)| (name(&own), place)).collect::<BTreeMap<_, _>>();
    scene
}

/// Both together.
pub fn join(one: &Scene, other: Scene) -> Scene {
    let mut scene = one.clone();
    scene.bodies.extend(other.bodies);
    scene.particles.extend(other.particles);
    scene.masses.extend(other.masses);
    scene.pins.extend(other.pins);
    scene.grounds.extend(other.grounds);
    scene.corners.extend(other.corners);
    scene.welds.extend(other.welds);
    scene.sliders.extend(other.sliders);
    scene.supports.extend(other.supports);
    scene.threads.extend(other.threads);
    scene.springs.extend(other.springs);
    scene.torsions.extend(other.torsions);
    scene.forces.extend(other.forces);
    scene.couples.extend(other.couples);
    scene.drives.extend(other.drives);
    scene.points.extend(other.points);
    scene
}

/// A half and its image, which share the points on the line x = 0.
pub fn add_image(half: &Scene) -> Scene {
    let is_shared = |name: &str| half.points.get(name).is_some_and(|place| place.position[0] == 0.0);
    let name_image = |name: &str| if is_shared(name) { name.to_owned() } else { format!("{name}m") };
    let mut half = half.clone();
    // What acts on what is its own image is its own image, too.
    half.supports.retain(|support| {
        !is_shared(&support.point) || matches!(support.shape, Shape::Line { angle: 0.0, .. })
    });
    half.forces.iter_mut().filter(|force| is_shared(&force.point)).for_each(|force| force.along = [0.0, 1.0]);
    half.threads.retain(|thread| !thread.path.iter().any(|point| is_shared(point)));
    let mut image = rename(&reflect(&half), name_image, half.bodies.len());
    image.supports.retain(|support| !is_shared(&support.point));
    image.forces.retain(|force| !is_shared(&force.point));
    let lists = [&mut image.pins, &mut image.grounds, &mut image.corners];
    lists.into_iter().for_each(|list| list.retain(|name| !is_shared(name)));
    image.sliders.retain(|slider| !is_shared(&slider.point));
    image.masses.retain(|(point, _)| !is_shared(point));
    image.particles.retain(|(point, _)| !is_shared(point));
    join(&half, image)
}
