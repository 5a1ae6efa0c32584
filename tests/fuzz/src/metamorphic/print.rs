//! A scene as a file.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

use super::scene::{Body, Guide, Look, Reference, Scene, Shape, Support, Target, Vector, Wave};

/// Numbers of a declaration: written out where they are short, else parameters with values.
#[derive(Default)]
struct Numbers {
    values: Vec<f64>,
    are_parameters: bool,
}

impl Numbers {
    fn number(&mut self, value: f64) -> String {
        let short = format!("{value:?}");
        let is_short = short.len() < 8 && !short.contains('e');
        if value == 0.0 || (is_short && !self.are_parameters) {
            return if value == 0.0 { "0".to_owned() } else { short };
        }
        let size = value.abs();
        let known = self.values.iter().position(|known| *known == size);
        let place = known.unwrap_or(self.values.len());
        if known.is_none() {
            self.values.push(size);
        }
        format!("{}p{place}", if value < 0.0 { "-" } else { "" })
    }

    fn pair(&mut self, [x, y]: Vector) -> String {
        format!("({}, {})", self.number(x), self.number(y))
    }

    /// Multiples of quarter turns are exact.
    fn angle(&mut self, value: f64) -> String {
        let quarters = value / FRAC_PI_2;
        match quarters == quarters.round() {
            true if quarters == 0.0 => "0".to_owned(),
            true => format!("{quarters} * pi / 2"),
            false => self.number(value),
        }
    }

    fn wave(&mut self, wave: &Wave) -> String {
        let mean = self.number(wave.mean);
        if wave.amplitude == 0.0 {
            return mean;
        }
        let [amplitude, rate, phase] = [wave.amplitude, wave.rate, wave.phase].map(|x| self.number(x));
        format!("{mean} + {amplitude} * sin({rate} * t + {phase})")
    }
}

/// The declaration: one attribute a line, in the order of `order`, and the struct.
pub fn declare(scene: &Scene, are_parameters: bool, order: impl Fn(&mut Vec<String>)) -> String {
    let mut numbers = Numbers { are_parameters, ..Numbers::default() };
    let mut lines = attributes(scene, &mut numbers);
    order(&mut lines);
    let mut text = format!("#[derive(BarSystem)]\n#[liftoff(dimensionless, sets = {})]\n", scene.sets);
    lines.iter().for_each(|line| text.extend([line, "\n"]));
    text += "struct Scene {\n";
    let words: BTreeSet<String> = text.split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect();
    let used = numbers.values.iter().enumerate().filter(|(k, _)| words.contains(&format!("p{k}")));
    for (k, value) in used {
        let _ = writeln!(text, "    #[value = {value:?}]\n    p{k}: f64,");
    }
    text + "}\n"
}

fn attributes(scene: &Scene, numbers: &mut Numbers) -> Vec<String> {
    let mut lines = Vec::new();
    if scene.gravity != [0.0; 2] {
        let [x, y] = scene.gravity;
        lines.push(match x == 0.0 && y < 0.0 {
            true => format!("#[gravity({})]", numbers.number(-y)),
            false => format!("#[gravity({}, {})]", numbers.number(x), numbers.number(y)),
        });
    }
    let at = |point: &str| scene.points[point].position;
    scene.bodies.iter().for_each(|body| lines.extend(declare_body(body, numbers)));
    for (name, mass) in &scene.particles {
        lines.push(format!("#[particle({name}, mass = {})]", numbers.number(*mass)));
    }
    for (name, mass) in &scene.masses {
        lines.push(format!("#[mass({name}, {})]", numbers.number(*mass)));
    }
    for name in &scene.pins {
        lines.push(format!("#[pin({name} = {})]", numbers.pair(at(name))));
    }
    let pegs = scene.corners.iter().filter(|name| !is_corner(scene, name));
    for name in scene.grounds.iter().chain(pegs) {
        lines.push(format!("#[ground({name} = {})]", numbers.pair(at(name))));
    }
    for [a, b] in &scene.welds {
        let angle = scene.bodies[*b].angle - scene.bodies[*a].angle;
        let [a, b] = [a, b].map(|k| &scene.bodies[*k].name);
        lines.push(format!("#[weld({a}, {b}, angle = {})]", numbers.angle(angle)));
    }
    for slider in &scene.sliders {
        let guide = match &slider.guide {
            Guide::Line { angle, through } if *angle == 0.0 => {
                format!("horizontal({})", numbers.number(through[1]))
            }
            Guide::Line { angle, through } if *angle == FRAC_PI_2 => {
                format!("vertical({})", numbers.number(through[0]))
            }
            Guide::Line { angle, through } => {
                format!("line({}, {})", numbers.angle(*angle), numbers.pair(*through))
            }
            Guide::Circle { centre, radius } => {
                format!("circle({}, {})", numbers.pair(*centre), numbers.number(*radius))
            }
        };
        lines.push(format!("#[slider({} = {guide})]", slider.point));
    }
    scene.supports.iter().for_each(|support| lines.push(declare_support(scene, support, numbers)));
    for support in scene.supports.iter().filter(|support| support.radius != 0.0) {
        lines.push(format!("#[disc({}, radius = {})]", support.point, numbers.number(support.radius)));
    }
    for thread in &scene.threads {
        let path = thread.path.join(" -> ");
        let [length, e] = [thread.length, thread.restitution].map(|x| numbers.number(x));
        lines.push(format!("#[thread({} = {path}, length = {length}, restitution = {e})]", thread.name));
    }
    for spring in &scene.springs {
        let [a, b] = &spring.ends;
        let [k, s, c] = [spring.stiffness, spring.length, spring.damping].map(|x| numbers.number(x));
        let name = &spring.name;
        lines.push(format!("#[spring({name} = {a} -> {b}, stiffness = {k}, length = {s}, damping = {c})]"));
    }
    for torsion in &scene.torsions {
        let first = torsion.first.map(|k| format!("{}, ", scene.bodies[k].name)).unwrap_or_default();
        let second = &scene.bodies[torsion.second].name;
        let [k, c] = [torsion.stiffness, torsion.damping].map(|x| numbers.number(x));
        let angle = numbers.angle(torsion.angle);
        lines.push(format!("#[torsion({first}{second}, stiffness = {k}, angle = {angle}, damping = {c})]"));
    }
    for force in &scene.forces {
        let wave = numbers.wave(&force.wave);
        let drag = numbers.number(force.drag);
        let part = |numbers: &mut Numbers, axis: usize, rate: &str| {
            let along = numbers.number(force.along[axis]);
            let drag = if force.drag == 0.0 {
                String::new()
            } else {
                format!(" - {drag} * {rate}({})", force.point)
            };
            format!("{along} * ({wave}){drag}")
        };
        let (x, y) = (part(numbers, 0, "vx"), part(numbers, 1, "vy"));
        let until =
            force.until.map(|t| format!(", while(\"t < {}\")", numbers.number(t))).unwrap_or_default();
        lines.push(format!("#[force({} = ({x}, {y}), at = {}{until})]", force.name, force.point));
    }
    for couple in &scene.couples {
        let from = couple.from.map(|k| format!(", from = {}", scene.bodies[k].name)).unwrap_or_default();
        let on = &scene.bodies[couple.body].name;
        let wave = numbers.wave(&couple.wave);
        lines.push(format!("#[couple({} = {wave}, on = {on}{from})]", couple.name));
    }
    for drive in &scene.drives {
        let target = name_target(scene, &drive.target);
        lines.push(format!("#[drive({target} = {})]", numbers.wave(&drive.wave)));
    }
    for (k, body) in scene.bodies.iter().enumerate().filter(|(k, _)| has_coordinate(scene, *k)) {
        let from = match body.reference {
            Reference::Quarters(quarters) => {
                ["right", "up", "left", "down"][quarters.rem_euclid(4) as usize].to_owned()
            }
            Reference::Body(other) => scene.bodies[other].name.clone(),
        };
        lines.push(format!("#[coordinate(q{k} = angle({}), from = {from})]", body.name));
    }
    let drawn = scene.points.iter().filter(|(name, _)| !scene.is_fixed(name));
    let drawn = drawn.filter(|(name, _)| !is_spot(scene, name));
    let drawn: Vec<String> =
        drawn.map(|(name, place)| format!("{name} = {}", numbers.pair(place.position))).collect();
    if !drawn.is_empty() {
        lines.push(format!("#[figure({})]", drawn.join(", ")));
    }
    if let Some(x) = scene.mirror {
        lines.push(format!("#[mirror(x = {})]", numbers.number(x)));
    }
    lines
}

/// Whether it only lies on one body.
fn is_spot(scene: &Scene, point: &str) -> bool {
    let is_end = |body: &Body| body.ends.iter().any(|end| end == point);
    !scene.bodies.iter().any(is_end) && scene.bodies_at(point).count() > 0
}

/// Only bars lie on corners.
pub fn is_corner(scene: &Scene, point: &str) -> bool {
    let under = scene.supports.iter().filter(|support| support.point == point);
    let mut bodies = under.filter_map(|support| match support.shape {
        Shape::Bar { body, .. } => Some(body),
        _ => None,
    });
    scene.corners.iter().any(|name| name == point)
        && bodies.all(|k| scene.bodies[k].look != Look::Body && scene.bodies[k].angle.cos().abs() > 1e-3)
}

/// Of what moves with another one by a joint or an image there is none.
pub fn has_coordinate(scene: &Scene, body: usize) -> bool {
    let image = scene.mirror.is_some() && scene.bodies[body].name.ends_with('m');
    !image && !scene.welds.iter().any(|[_, second]| *second == body)
}

pub fn name_target(scene: &Scene, target: &Target) -> String {
    let name = |k: &usize| &scene.bodies[*k].name;
    match target {
        Target::Angle(body) => format!("angle({})", name(body)),
        Target::Between(first, second) => format!("angle({}, {})", name(first), name(second)),
        Target::Distance([a, b]) => format!("distance({a}, {b})"),
    }
}

fn declare_body(body: &Body, numbers: &mut Numbers) -> Vec<String> {
    let Body { name, ends: [a, b], .. } = body;
    let [m, i, l] = [body.mass, body.inertia, body.length].map(|x| numbers.number(x));
    let mut lines = match body.look {
        Look::Bar if body.is_uniform() => {
            vec![format!("#[bar({name} = {a} -> {b}, mass = {m}, length = {l})]")]
        }
        Look::Bar => {
            let centre = numbers.pair(body.centre);
            vec![format!(
                "#[bar({name} = {a} -> {b}, mass = {m}, length = {l}, inertia = {i}, centre = {centre})]"
            )]
        }
        Look::Body => {
            let spots = body.spots.iter().map(|(name, at)| format!(", {name} = {}", numbers.pair(*at)));
            let spots: String = spots.collect();
            let centre = numbers.pair(body.centre);
            return vec![format!(
                "#[body({name}, points({a} = (0, 0), {b} = ({l}, 0){spots}), mass = {m}, inertia = {i}, centre = {centre})]"
            )];
        }
        Look::Masses => {
            let [end, middle] = [body.mass / 6.0, 2.0 / 3.0 * body.mass].map(|x| numbers.number(x));
            let half = numbers.number(body.length / 2.0);
            vec![
                format!("#[bar({name} = {a} -> {b}, mass = 0, length = {l})]"),
                format!("#[mass({a}, {end})]\n#[mass({b}, {end})]\n#[mass({name}c, {middle})]"),
                format!("#[point({name}c = {name}, at = {half})]"),
            ]
        }
    };
    for (point, at) in &body.spots {
        lines.push(format!("#[point({point} = {name}, at = {})]", numbers.pair(*at)));
    }
    lines
}

fn declare_support(scene: &Scene, support: &Support, numbers: &mut Numbers) -> String {
    let side = |is_left: bool| if is_left { "left" } else { "right" };
    let shape = match &support.shape {
        Shape::Line { angle, through } if *angle == 0.0 => format!("floor({})", numbers.number(through[1])),
        Shape::Line { angle, through } if angle.abs() == FRAC_PI_2 => {
            format!("wall({}), facing = {}", numbers.number(through[0]), side(*angle > 0.0))
        }
        Shape::Line { angle, through } => {
            format!("slope({}, {})", numbers.angle(*angle), numbers.pair(*through))
        }
        Shape::Circle { centre, radius, inside } => {
            let word = if *inside { "bowl" } else { "circle" };
            format!("{word}({}, {})", numbers.pair(*centre), numbers.number(*radius))
        }
        Shape::Bar { body, is_left } if is_corner(scene, &support.point) => {
            let Body { name, angle, .. } = &scene.bodies[*body];
            let word = if *is_left == (angle.cos() > 0.0) { "over" } else { "under" };
            format!("corner{}, {word} = {name}", numbers.pair(scene.points[&support.point].position))
        }
        Shape::Bar { body, is_left } => {
            let Body { name, ends: [a, b], look, .. } = &scene.bodies[*body];
            let edge = if *look == Look::Body { format!("edge({a}, {b})") } else { format!("bar({name})") };
            format!("{edge}, facing = {}", side(*is_left))
        }
    };
    let mut text = format!("#[support({} = {shape}", support.point);
    if let Some([kinetic, holding]) = support.friction {
        let [kinetic, holding] = [kinetic, holding].map(|x| numbers.number(x));
        let _ = write!(text, ", friction = {kinetic}, static = {holding}");
    }
    if support.is_rough {
        text += ", rough";
    }
    if !support.moving.is_zero() {
        // A wall moves upwards, whichever way it faces.
        let faces_right = matches!(support.shape, Shape::Line { angle, .. } if angle == -FRAC_PI_2);
        let moving = if faces_right { support.moving.opposite() } else { support.moving };
        let _ = write!(text, ", moving = {}", numbers.wave(&moving));
    }
    if support.restitution != 0.0 {
        let _ = write!(text, ", restitution = {}", numbers.number(support.restitution));
        if support.is_poisson {
            text += ", law = poisson";
        }
    }
    text + ")]"
}
