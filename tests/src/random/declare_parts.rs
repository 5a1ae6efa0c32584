//! What a scheme has beside bars, pins, masses and supports as declarations.

use std::fmt::Write;

use super::declare::pair;
use super::parts::{Couple, Drive, Force, Manner, Slider, Spring, Target, Thread, Torsion, Track, Weld};
use super::quantity::Quantity;
use super::scheme::{Declared, Scheme};

/// One line for each.
pub fn parts(scheme: &Scheme) -> Vec<String> {
    let parts = &scheme.parts;
    let bar = |index: usize| scheme.bars[index].name.as_str();
    let particles = parts.particles.iter();
    let particles = particles.map(|(point, mass)| format!("#[particle({point}, mass = {})]", mass.text()));
    let grounds = parts.grounds.iter();
    let grounds = grounds.map(|point| format!("#[ground({point} = {})]", pair(&scheme.figure[point])));
    let sections = parts.sections.iter();
    let sections = sections.map(|s| format!("#[section({} = {}, at = {})]", s.name, bar(s.bar), s.at.text()));
    particles
        .chain(grounds)
        .chain(parts.welds.iter().map(|weld| self::weld(scheme, weld)))
        .chain(parts.sliders.iter().map(|slider| self::slider(scheme, slider)))
        .chain(parts.threads.iter().map(thread))
        .chain(parts.springs.iter().map(spring))
        .chain(parts.torsions.iter().map(|torsion| self::torsion(scheme, torsion)))
        .chain(parts.forces.iter().map(|force| self::force(scheme, force)))
        .chain(parts.couples.iter().map(|couple| self::couple(scheme, couple)))
        .chain(parts.drives.iter().map(|drive| self::drive(scheme, drive)))
        .chain(sections)
        .collect()
}

/// The options of a support or thread.
pub fn manner(manner: &Manner) -> String {
    let mut text = String::new();
    if manner.rough {
        text += ", rough";
    }
    if let Some(restitution) = &manner.restitution {
        let _ = write!(text, ", restitution = {}", restitution.text());
    }
    if manner.poisson {
        text += ", law = poisson";
    }
    text
}

fn weld(scheme: &Scheme, weld: &Weld) -> String {
    let name = |bar: usize| scheme.bars[bar].name.as_str();
    let second = weld.second.map(|bar| format!(", {}", name(bar))).unwrap_or_default();
    let angle = match weld.said {
        true => format!(", angle = {} * pi / 2", weld.quarters),
        false => String::new(),
    };
    format!("#[weld({}{second}{angle})]", name(weld.first))
}

fn slider(scheme: &Scheme, slider: &Slider) -> String {
    let track = match &slider.track {
        Track::Horizontal(height) => format!("horizontal({})", height.text()),
        Track::Vertical(x) => format!("vertical({})", x.text()),
        Track::Line(angle, through) => format!("line({}, {})", angle.text(), pair(through)),
        Track::Bar(bar) => format!("bar({})", scheme.bars[*bar].name),
    };
    let of = if slider.name == slider.point { String::new() } else { format!(", of = {}", slider.point) };
    format!("#[slider({} = {track}{of})]", slider.name)
}

fn thread(thread: &Thread) -> String {
    let path = thread.path.join(" -> ");
    let manner = manner(&thread.manner);
    format!("#[thread({} = {path}, length = {}{manner})]", thread.name, thread.length.text())
}

fn options(all: &[(&str, &Option<Quantity>)]) -> String {
    let given = all.iter().filter_map(|(name, quantity)| Some((name, quantity.as_ref()?)));
    given.map(|(name, quantity)| format!(", {name} = {}", quantity.text())).collect()
}

fn spring(spring: &Spring) -> String {
    let Spring { name, ends: [from, to], stiffness, length, damping } = spring;
    let options = options(&[("stiffness", stiffness), ("length", length), ("damping", damping)]);
    format!("#[spring({name} = {from} -> {to}{options})]")
}

fn torsion(scheme: &Scheme, torsion: &Torsion) -> String {
    let Torsion { first, second, stiffness, angle, damping } = torsion;
    let options = options(&[("stiffness", stiffness), ("angle", angle), ("damping", damping)]);
    let second = second.map(|bar| format!(", {}", scheme.bars[bar].name)).unwrap_or_default();
    format!("#[torsion({}{second}{options})]", scheme.bars[*first].name)
}

fn force(scheme: &Scheme, force: &Force) -> String {
    let [x, y] = force.value.each_ref().map(|value| value.text(scheme));
    let at = if force.name == force.point { String::new() } else { format!(", at = {}", force.point) };
    let frame = force.frame.map(|bar| format!(", frame = {}", scheme.bars[bar].name)).unwrap_or_default();
    format!("#[force({} = ({x}, {y}){at}{frame})]", force.name)
}

fn couple(scheme: &Scheme, couple: &Couple) -> String {
    let name = |bar: usize| scheme.bars[bar].name.as_str();
    let on =
        if couple.name == name(couple.on) { String::new() } else { format!(", on = {}", name(couple.on)) };
    let from = couple.from.map(|bar| format!(", from = {}", name(bar))).unwrap_or_default();
    format!("#[couple({} = {}{on}{from})]", couple.name, couple.value.text(scheme))
}

/// What a drive drives.
pub fn target(scheme: &Scheme, target: &Target) -> String {
    match target {
        Target::Coordinate(index) => {
            let (Declared::Angle { name, .. } | Declared::Position { name, .. }) =
                &scheme.coordinates[*index];
            name.clone()
        }
        Target::Direction(bar) => format!("angle({})", scheme.bars[*bar].name),
        Target::Position(point, axis) => format!("{}({point})", ["x", "y"][*axis]),
    }
}

fn drive(scheme: &Scheme, drive: &Drive) -> String {
    format!("#[drive({} = {})]", target(scheme, &drive.target), drive.value.text(scheme))
}
