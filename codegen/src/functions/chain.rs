//! A pinned chain of equal uniform bars without loads: the runtime's `Chain`.

use crate::algebra::{Rational, Series};
use crate::kinematics::Kinematics;
use crate::motion::{Branch, Motion};
use crate::program::{Id, Lowering};
use crate::system::System;

/// From so many bars on its loops take fewer cycles than straight lines: 72 ns for 75 at 6 bars, 46
/// for 38 at 4.
const FROM: usize = 6;

/// The constants of a chain, its angles measured from the first axis.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    /// Mass of a bar.
    pub mass: Id,
    /// Its length.
    pub length: Id,
    /// Its moment of inertia J about its centre.
    pub inertia: Id,
    /// Free fall along both axes.
    pub gravity: [Id; 2],
    /// κ = m l²/4J.
    pub slenderness: Id,
    /// m l/2J.
    pub lever: Id,
    /// Whether J = m l²/12.
    pub is_uniform: bool,
}

impl Chain {
    /// The constants, where the system is such a chain and long enough.
    pub(super) fn recognise(
        lowering: &mut Lowering,
        system: &System,
        kinematics: &Kinematics,
        motion: &Motion,
    ) -> Option<Self> {
        let branches = &motion.tree.as_ref()?.branches;
        let (first, bar) = (branches.first()?, branches.get(1)?);
        let quarters = |branch: &Branch| kinematics.directions[branch.body].quarter_turns();
        let [lumped] = &first.lumped_masses[..] else { return None };
        let middle = bar.reach.each_ref().map(|part| part.scale(Rational::new(1, 2)));
        let ordered = |(i, branch): (usize, &Branch)| {
            let next = i == 0 || (branch.parent == Some(i - 1) && branch.reach == bar.reach);
            let alike = branch.lumped_masses == first.lumped_masses
                && branch.sign == first.sign
                && branch.coordinate == i;
            next && alike && quarters(branch) == quarters(first) && branch.base.is_none()
        };
        let plain = motion.rows.is_empty() && motion.loads.actions.is_empty() && !lumped.inertia.is_zero();
        let centred = lumped.at == middle && bar.reach[1].is_zero();
        if branches.len() < FROM || !plain || !centred || !branches.iter().enumerate().all(ordered) {
            return None;
        }
        let length = &bar.reach[0];
        let is_uniform = lumped.inertia == (&(&lumped.mass * length) * length).scale(Rational::new(1, 12));
        let gravity = turned(system.gravity.as_ref(), first.sign, quarters(first));
        let [mass, length, inertia] = [&lumped.mass, length, &lumped.inertia].map(|s| lowering.series(s));
        let gravity = gravity.map(|part| lowering.series(&part));
        let program = lowering.program();
        let half = program.ratio(Rational::new(1, 2));
        let half = program.mul(half, length);
        let moment = program.mul(mass, half);
        let lever = program.div(moment, inertia);
        let slenderness = program.mul(lever, half);
        Some(Self { mass, length, inertia, gravity, slenderness, lever, is_uniform })
    }

    /// All of them.
    pub fn constants(&self) -> [Id; 7] {
        let Self { mass, length, inertia, gravity: [x, y], slenderness, lever, .. } = *self;
        [mass, length, inertia, x, y, slenderness, lever]
    }
}

/// Free fall in axes from which a direction `± q + quarters π/2` is q: turned back, or turned on
/// after a reflection.
fn turned(gravity: Option<&[Series; 2]>, sign: i8, quarters: u8) -> [Series; 2] {
    let [x, y] = gravity.cloned().unwrap_or_else(|| [Series::zero(), Series::zero()]);
    let (y, quarters) = if sign < 0 { (-y, (4 - quarters) % 4) } else { (y, quarters) };
    match quarters {
        0 => [x, y],
        1 => [y, -x],
        2 => [-x, -y],
        _ => [-y, x],
    }
}
