//! What a spec has beside bars, pins, masses and supports as declarations.

use std::fmt::Write;

use super::declare::pair;
use super::parts::{
    CoupleSpec, DriveSpec, Force, Manner, SliderSpec, SpringSpec, Target, Thread, TorsionSpec, Track, Weld,
};
use super::quantity::Quantity;
use super::spec::{Declared, Spec};

/// One line for each.
pub fn parts(spec: &Spec) -> Vec<String> {
    let parts = &spec.parts;
    let bar = |index: usize| spec.bars[index].name.as_str();
    let particles = parts.particles.iter();
    let particles = particles.map(|(point, mass)| format!("#[particle({point}, mass = {})]", mass.text()));
    let grounds = parts.grounds.iter();
    let grounds = grounds.map(|point| format!("#[ground({point} = {})]", pair(&spec.figure[point])));
    let sections = parts.sections.iter();
    let sections = sections.map(|s| format!("#[section({} = {}, at = {})]", s.name, bar(s.bar), s.at.text()));
    particles
        .chain(grounds)
        .chain(parts.welds.iter().map(|weld| self::weld(spec, weld)))
        .chain(parts.sliders.iter().map(|slider| self::slider(spec, slider)))
        .chain(parts.threads.iter().map(thread))
        .chain(parts.springs.iter().map(spring))
        .chain(parts.torsions.iter().map(|torsion| self::torsion(spec, torsion)))
        .chain(parts.forces.iter().map(|force| self::force(spec, force)))
        .chain(parts.couples.iter().map(|couple| self::couple(spec, couple)))
        .chain(parts.drives.iter().map(|drive| self::drive(spec, drive)))
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

fn weld(spec: &Spec, weld: &Weld) -> String {
    let name = |bar: usize| spec.bars[bar].name.as_str();
    let second = weld.second.map(|bar| format!(", {}", name(bar))).unwrap_or_default();
    let angle = match weld.said {
        true => format!(", angle = {} * pi / 2", weld.quarters),
        false => String::new(),
    };
    format!("#[weld({}{second}{angle})]", name(weld.first))
}

fn slider(spec: &Spec, slider: &SliderSpec) -> String {
    let track = match &slider.track {
        Track::Horizontal(height) => format!("horizontal({})", height.text()),
        Track::Vertical(x) => format!("vertical({})", x.text()),
        Track::Line(angle, through) => format!("line({}, {})", angle.text(), pair(through)),
        Track::Bar(bar) => format!("bar({})", spec.bars[*bar].name),
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

fn spring(spring: &SpringSpec) -> String {
    let SpringSpec { name, ends: [from, to], stiffness, length, damping } = spring;
    let options = options(&[("stiffness", stiffness), ("length", length), ("damping", damping)]);
    format!("#[spring({name} = {from} -> {to}{options})]")
}

fn torsion(spec: &Spec, torsion: &TorsionSpec) -> String {
    let TorsionSpec { first, second, stiffness, angle, damping } = torsion;
    let options = options(&[("stiffness", stiffness), ("angle", angle), ("damping", damping)]);
    let second = second.map(|bar| format!(", {}", spec.bars[bar].name)).unwrap_or_default();
    format!("#[torsion({}{second}{options})]", spec.bars[*first].name)
}

fn force(spec: &Spec, force: &Force) -> String {
    let [x, y] = force.value.each_ref().map(|value| value.text(spec));
    let at = if force.name == force.point { String::new() } else { format!(", at = {}", force.point) };
    let frame = force.frame.map(|bar| format!(", frame = {}", spec.bars[bar].name)).unwrap_or_default();
    format!("#[force({} = ({x}, {y}){at}{frame})]", force.name)
}

fn couple(spec: &Spec, couple: &CoupleSpec) -> String {
    let name = |bar: usize| spec.bars[bar].name.as_str();
    let on =
        if couple.name == name(couple.on) { String::new() } else { format!(", on = {}", name(couple.on)) };
    let from = couple.from.map(|bar| format!(", from = {}", name(bar))).unwrap_or_default();
    format!("#[couple({} = {}{on}{from})]", couple.name, couple.value.text(spec))
}

/// What a drive drives.
pub fn target(spec: &Spec, target: &Target) -> String {
    match target {
        Target::Coordinate(index) => {
            let (Declared::Angle { name, .. } | Declared::Position { name, .. }) = &spec.coordinates[*index];
            name.clone()
        }
        Target::Direction(bar) => format!("angle({})", spec.bars[*bar].name),
        Target::Position(point, axis) => format!("{}({point})", ["x", "y"][*axis]),
    }
}

fn drive(spec: &Spec, drive: &DriveSpec) -> String {
    format!("#[drive({} = {})]", target(spec, &drive.target), drive.value.text(spec))
}
