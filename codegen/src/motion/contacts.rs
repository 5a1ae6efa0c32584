//! Gaps of the supports, and which of them are one contact.
//!
//! A point over a line through `p` with normal `n`: `g = n · (r − p)`. A bar of direction `δ` and left normal
//! `n` over a corner `c`: `g = ± n · (r − c)`, its foot at `s = e · (c − r)` from the bar's first point, on the
//! bar while `0 ≤ s ≤ l`. Supports whose gaps are one series, and mirror images (whose gaps are one on the joints),
//! are one contact, with their total reaction.

use crate::algebra::{Angle, Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::system::{OneSided, Support, System};

/// Where a corner touches its bar.
#[derive(Clone, Debug)]
pub struct Foot {
    /// Distance from the bar's first point.
    pub from_first: Series,
    /// Distance from the bar's last point.
    pub from_last: Series,
}

impl Foot {
    /// Whether both lie under their bars together; a bar may be named from either end.
    fn equals(&self, other: &Self) -> bool {
        let straight = self.from_first == other.from_first && self.from_last == other.from_last;
        straight || self.from_first == other.from_last && self.from_last == other.from_first
    }
}

/// Supports that share a gap.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Indices of its supports.
    pub supports: Vec<usize>,
    /// Their gap.
    pub gap: Series,
    /// Whether its members are mirror images (or there is only one), so that each bears an equal share.
    pub shared: bool,
    /// The foot, for a corner.
    pub foot: Option<Foot>,
}

impl Contact {
    /// Names of the supports joined by commas.
    pub fn label(&self, system: &System) -> String {
        let names: Vec<_> = self.supports.iter().map(|&s| system.supports[s].name.as_str()).collect();
        names.join(", ")
    }
}

/// The contacts in order of their first support.
pub(super) fn merge(system: &System, kinematics: &Kinematics) -> syn::Result<Vec<Contact>> {
    let mut contacts: Vec<Contact> = Vec::new();
    let mut errors: Option<syn::Error> = None;
    for (i, support) in system.supports.iter().enumerate() {
        let (gap, foot) = measure(support, kinematics, system);
        if !gap.symbols().iter().any(|s| matches!(s, Symbol::Coordinate { .. })) {
            let text = format!("support `{}` does nothing: what it supports cannot move", support.name);
            let error = syn::Error::new(support.span, text);
            match &mut errors {
                Some(all) => all.combine(error),
                None => errors = Some(error),
            }
        }
        let image = |c: &Contact| system.mirror.as_ref().is_some_and(|m| c.supports.contains(&m.supports[i]));
        match contacts.iter_mut().find(|c| image(c) || c.gap == gap && same_foot(&c.foot, &foot)) {
            Some(contact) => contact.supports.push(i),
            None => contacts.push(Contact { supports: vec![i], gap, shared: true, foot }),
        }
    }
    for contact in &mut contacts {
        contact.shared = images(system, &contact.supports);
    }
    errors.map_or(Ok(contacts), Err)
}

fn same_foot(a: &Option<Foot>, b: &Option<Foot>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.equals(b),
        (a, b) => a.is_none() && b.is_none(),
    }
}

fn images(system: &System, supports: &[usize]) -> bool {
    match (supports, &system.mirror) {
        ([_], _) => true,
        (&[a, b], Some(mirror)) => mirror.supports[a] == b,
        _ => false,
    }
}

fn measure(support: &Support, kinematics: &Kinematics, system: &System) -> (Series, Option<Foot>) {
    match &support.contact {
        OneSided::Line { point, through, direction } => {
            (height(&kinematics.points[*point], through, direction), None)
        }
        OneSided::Corner { body, at, side } => {
            let direction = &kinematics.directions[*body];
            let first = &kinematics.points[system.bodies[*body].from];
            let gap = height(first, at, direction).scale(Rational::integer((*side).into()));
            let from_first = along(at, first, direction);
            let from_last = &system.bodies[*body].length - &from_first;
            (gap, Some(Foot { from_first, from_last }))
        }
        OneSided::Circle { .. } | OneSided::Thread { .. } => (Series::zero(), None),
    }
}

/// `n · (r − p)` with `n = (−sin δ, cos δ)`.
fn height(r: &[Series; 2], p: &[Series; 2], direction: &Angle) -> Series {
    let across = &Series::cos(direction) * &(&r[1] - &p[1]);
    &across - &(&Series::sin(direction) * &(&r[0] - &p[0]))
}

/// `e · (r − p)` with `e = (cos δ, sin δ)`.
fn along(r: &[Series; 2], p: &[Series; 2], direction: &Angle) -> Series {
    &(&Series::cos(direction) * &(&r[0] - &p[0])) + &(&Series::sin(direction) * &(&r[1] - &p[1]))
}
