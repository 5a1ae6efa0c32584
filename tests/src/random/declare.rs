//! The spec as a declaration.

use std::fmt::Write;

use super::declare_parts::{manner, parts};
use super::quantity::Quantity;
use super::spec::{Bar, Chain, Declared, Gravity, Mirror, Origin, Pair, Shape, Spec, SupportSpec, Tie};

const QUARTERS: [&str; 4] = ["right", "up", "left", "down"];

/// The whole item.
pub fn declaration(spec: &Spec) -> String {
    let mut lines = vec!["#[derive(BarSystem)]".to_string(), "#[liftoff(dimensionless)]".to_string()];
    let constants = spec.parameters.constants.iter();
    lines.extend(constants.map(|(name, q)| format!("#[constant({name} = {})]", q.text())));
    match &spec.gravity {
        Gravity::None => {}
        Gravity::Down(g) => lines.push(format!("#[gravity({})]", g.text())),
        Gravity::Vector([x, y]) => lines.push(format!("#[gravity({}, {})]", x.text(), y.text())),
    }
    lines.extend(beams(spec));
    lines.extend(spec.spots.iter().map(|spot| {
        let at = tuple_or_one(&spot.along, spot.across.as_ref());
        format!("#[point({} = {}, at = {at})]", spot.name, spec.bars[spot.bar].name)
    }));
    let masses = spec.masses.iter();
    lines.extend(masses.map(|(point, mass)| format!("#[mass({point}, {})]", mass.text())));
    let pins = spec.pins.iter();
    lines.extend(pins.map(|point| format!("#[pin({point} = {})]", pair(&spec.figure[point]))));
    lines.extend(spec.supports.iter().map(|support| self::support(spec, support)));
    lines.extend(spec.coordinates.iter().map(|declared| coordinate(spec, declared)));
    lines.extend(spec.ties.iter().map(|&tie| equal(spec, tie)));
    lines.extend(parts(spec));
    lines.extend(spec.mirror.as_ref().map(mirror));
    lines.extend(figure(spec));
    let fields = spec.parameters.fields.iter();
    let fields: Vec<_> = fields.map(|(name, _)| format!("pub {name}: f64")).collect();
    lines.push(format!("pub struct Sample {{ {} }}", fields.join(", ")));
    lines.join("\n")
}

pub(super) fn pair([x, y]: &Pair) -> String {
    format!("({}, {})", x.text(), y.text())
}

fn tuple_or_one(along: &Quantity, across: Option<&Quantity>) -> String {
    match across {
        None => along.text().into(),
        Some(across) => format!("({}, {})", along.text(), across.text()),
    }
}

fn beams(spec: &Spec) -> Vec<String> {
    let mut written = vec![false; spec.chains.len()];
    let mut lines = Vec::new();
    for bar in &spec.bars {
        match bar.chain {
            None => {
                if let Some(corner) = &bar.corner {
                    lines.push(triangle(bar, corner));
                    continue;
                }
                let letters = format!("{}{}", bar.from, bar.to) == bar.name;
                let ends = format!("{} = {} -> {}", bar.name, bar.from, bar.to);
                let head = if letters { &bar.name } else { &ends };
                lines.push(format!("#[bar({head}, {})]", matter(bar)));
            }
            Some(chain) if !std::mem::replace(&mut written[chain], true) => {
                lines.push(links(&spec.chains[chain], bar));
            }
            Some(_) => {}
        }
    }
    lines
}

/// A triangle in the frame of its first side.
fn triangle(bar: &Bar, (third, at): &(String, Pair)) -> String {
    let Bar { name, from, to, .. } = bar;
    let corners = format!("{from} = (0, 0), {to} = ({}, 0), {third} = {}", bar.length.text(), pair(at));
    let mut text = format!("#[body({name}, points({corners}), mass = {}", bar.mass.text());
    if let Some(inertia) = &bar.inertia {
        let _ = write!(text, ", inertia = {}", inertia.text());
    }
    if let Some((along, across)) = &bar.centre {
        let across = across.as_ref().map_or("0", Quantity::text);
        let _ = write!(text, ", centre = ({}, {across})", along.text());
    }
    text + ")]"
}

fn links(chain: &Chain, first: &Bar) -> String {
    let last = chain.last.iter().map(|name| format!("to = {name}, ")).collect::<String>();
    let (name, links) = (&chain.name, chain.links);
    format!("#[chain({name}, links = {links}, from = {}, {last}{})]", first.from, matter(first))
}

fn matter(bar: &Bar) -> String {
    let mut text = format!("mass = {}, length = {}", bar.mass.text(), bar.length.text());
    if let Some(inertia) = &bar.inertia {
        let _ = write!(text, ", inertia = {}", inertia.text());
    }
    if let Some((along, across)) = &bar.centre {
        let _ = write!(text, ", centre = {}", tuple_or_one(along, across.as_ref()));
    }
    text
}

fn support(spec: &Spec, support: &SupportSpec) -> String {
    let (shape, option) = match &support.shape {
        Shape::Floor(None) => ("floor".into(), String::new()),
        Shape::Floor(Some(height)) => (format!("floor({})", height.text()), String::new()),
        Shape::Wall { at, side, said } => {
            let facing = if *side > 0.0 { ", facing = right" } else { ", facing = left" };
            (format!("wall({})", at.text()), if *said { facing.into() } else { String::new() })
        }
        Shape::Slope { angle, through: None } => (format!("slope({})", angle.text()), String::new()),
        Shape::Slope { angle, through: Some(through) } => {
            (format!("slope({}, {})", angle.text(), pair(through)), String::new())
        }
        Shape::Corner { bar, at, under } => {
            let word = if *under { "under" } else { "over" };
            (format!("corner{}", pair(at)), format!(", {word} = {}", spec.bars[*bar].name))
        }
        Shape::Circle { centre, radius, inside } => {
            let word = if *inside { "bowl" } else { "circle" };
            (format!("{word}({}, {})", pair(centre), radius.text()), String::new())
        }
        Shape::Slot { angle, through, width } => {
            (format!("slot({}, {}, {})", angle.text(), pair(through), width.text()), String::new())
        }
    };
    let corner = matches!(support.shape, Shape::Corner { .. });
    let under = if corner || support.name == support.point {
        String::new()
    } else {
        format!(", under = {}", support.point)
    };
    let manner = manner(&support.manner);
    format!("#[support({} = {shape}{under}{option}{manner})]", support.name)
}

fn coordinate(spec: &Spec, declared: &Declared) -> String {
    match declared {
        Declared::Position { name, point, axis, negative } => {
            let sign = if *negative { "-" } else { "" };
            format!("#[coordinate({name} = {sign}{}({point}))]", ["x", "y"][*axis])
        }
        Declared::Angle { name, bar, origin } => {
            let (sign, from) = match origin {
                Origin::Line(line) => ("", (*line).to_string()),
                Origin::Direction(quarter, true) => ("-", QUARTERS[*quarter].into()),
                Origin::Direction(quarter, false) => ("", QUARTERS[*quarter].into()),
                Origin::Bar(other) => ("", spec.bars[*other].name.clone()),
            };
            format!("#[coordinate({name} = {sign}angle({}), from = {from})]", spec.bars[*bar].name)
        }
    }
}

fn equal(spec: &Spec, tie: Tie) -> String {
    let name = |index: usize| match &spec.coordinates[index] {
        Declared::Angle { name, .. } | Declared::Position { name, .. } => name.clone(),
    };
    let angle = |bar: usize| format!("angle({})", spec.bars[bar].name);
    match tie {
        Tie::Bars(a, b) => format!("#[equal({}, {})]", angle(a), angle(b)),
        Tie::Coordinates(a, b) => format!("#[equal({}, {})]", name(a), name(b)),
    }
}

fn mirror(mirror: &Mirror) -> String {
    let pairs = mirror.images.iter().filter(|_| mirror.said);
    let swaps: String = pairs.map(|(point, image)| format!(", swap({point}, {image})")).collect();
    format!("#[mirror({} = {}{swaps})]", ["x", "y"][mirror.axis], mirror.at.text())
}

/// Points on bars and pinned points follow; those of an undrawn chain are left to inference.
fn figure(spec: &Spec) -> Option<String> {
    let hidden = |point: &str| {
        let spot = spec.spots.iter().any(|spot| spot.name == point);
        let links = spec.bars.iter().filter(|bar| bar.to == point);
        let undrawn = links.filter_map(|bar| bar.chain).any(|chain| !spec.chains[chain].drawn);
        let mirror = spec.mirror.iter().filter(|mirror| !mirror.drawn);
        let image = mirror.flat_map(|m| &m.images).any(|(_, image)| image == point);
        let ground = spec.parts.grounds.iter().any(|ground| ground == point);
        spot || undrawn || image || ground || spec.pins.iter().any(|pin| pin == point)
    };
    let points = spec.figure.iter().filter(|(point, _)| !hidden(point));
    let given: Vec<_> = points.map(|(point, at)| format!("{point} = {}", pair(at))).collect();
    (!given.is_empty()).then(|| format!("#[figure({})]", given.join(", ")))
}
