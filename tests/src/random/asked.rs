//! The quantities of a sample by the names that the runtime gives them.

use super::assemble::Places;
use super::declare_parts::target;
use super::spec::Spec;
use crate::oracle::{Assembly, Mark, Motion, Place, State};

/// What a name asks for.
#[derive(Clone, Debug)]
pub enum Asked {
    /// Force of a joint on a bar at a point, along an axis.
    Joint(Mark, usize),
    /// Force of the ground at a pin, along an axis.
    Pin(usize, usize),
    /// Tension of a spring.
    Tension(usize),
    /// Torque of a torsion spring.
    Torque(usize),
    /// Force or torque of a drive.
    Drive(usize),
    /// Normal force, shear or moment in a section.
    Internal(Mark, usize),
    /// Momentum along x or y, or angular.
    Momentum(usize),
}

impl Asked {
    /// Its value.
    pub fn value(&self, assembly: &Assembly, state: &State, motion: &Motion) -> f64 {
        match *self {
            Self::Joint(mark, axis) => assembly.joint_force(motion, mark)[axis],
            Self::Pin(pin, axis) => motion.pins[pin][axis],
            Self::Tension(spring) => assembly.tension(state, &assembly.springs[spring]),
            Self::Torque(torsion) => assembly.torque(state, &assembly.torsions[torsion]),
            Self::Drive(drive) => motion.drives[drive],
            Self::Internal(section, which) => {
                let internal = assembly.internal(state, motion, section);
                [internal.normal, internal.shear, internal.moment][which]
            }
            Self::Momentum(which) => assembly.momenta(state)[which],
        }
    }
}

/// Every quantity that a spec has, with its name.
pub fn asked(spec: &Spec, places: &Places) -> Vec<(String, Asked)> {
    let mut all: Vec<_> =
        ["px", "py", "Lz"].into_iter().zip(0..).map(|(n, k)| (n.into(), Asked::Momentum(k))).collect();
    let axes = [("fx", 0), ("fy", 1)];
    for point in spec.figure.keys().filter(|point| is_bare(spec, places, point)) {
        let pin = spec.pins.iter().position(|pin| pin == point);
        all.extend(
            pin.iter().flat_map(|&pin| axes.map(|(f, k)| (format!("{f}({point})"), Asked::Pin(pin, k)))),
        );
        let on = spec.on(point);
        for (body, [x, y]) in on.iter().filter(|_| on.len() > 1 || pin.is_some()) {
            let mark = Mark { body: *body, local: nalgebra::Vector2::new(x.value, y.value) };
            let name = |f: &str| format!("{f}({point}, {})", spec.bars[*body].name);
            all.extend(axes.map(|(f, k)| (name(f), Asked::Joint(mark, k))));
        }
    }
    let parts = &spec.parts;
    let bar = |index: usize| spec.bars[index].name.as_str();
    let springs = parts.springs.iter().enumerate();
    all.extend(springs.map(|(k, spring)| (format!("force({})", spring.name), Asked::Tension(k))));
    all.extend(parts.torsions.iter().enumerate().map(|(k, torsion)| {
        let second = torsion.second.map(|body| format!(", {}", bar(body))).unwrap_or_default();
        (format!("torque({}{second})", bar(torsion.first)), Asked::Torque(k))
    }));
    let drives = parts.drives.iter().enumerate();
    all.extend(drives.map(|(k, d)| (format!("drive({})", target(spec, &d.target)), Asked::Drive(k))));
    for section in &parts.sections {
        let mark = Mark::along(section.bar, section.at.value);
        let kinds = ["normal", "shear", "moment"].into_iter().zip(0..);
        all.extend(kinds.map(|(name, k)| (format!("{name}({})", section.name), Asked::Internal(mark, k))));
    }
    all
}

/// Whether nothing but its joint acts at a point: what does may be counted to any of its bodies.
fn is_bare(spec: &Spec, places: &Places, point: &str) -> bool {
    let parts = &spec.parts;
    let supported = spec.supports.iter().any(|support| support.point == point);
    let massive = spec.masses.iter().any(|(at, _)| at == point);
    let slid = parts.sliders.iter().any(|slider| slider.point == point);
    let tied = parts.threads.iter().any(|thread| thread.path.iter().any(|at| at == point));
    let sprung = parts.springs.iter().any(|spring| spring.ends.iter().any(|at| at == point));
    let pushed = parts.forces.iter().any(|force| force.point == point);
    let driven = !parts.drives.is_empty();
    let body = matches!(places[point], Place::Body(_));
    body && !(supported || massive || slid || tied || sprung || pushed || driven)
}
