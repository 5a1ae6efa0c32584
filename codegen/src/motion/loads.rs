//! Springs, dampers, applied forces and couples: what acts where, and the springs' potential.
//!
//! A spring from a to b with `r = b − a`, `d = |r|` bears the tension `S = k (d − l) + c ḋ`,
//! `ḋ = r·ṙ / d`; it pulls a with `κ r`, `κ = S/d`, b with the opposite; on a condition
//! `d² = |r|² + 1 − s`, so that the direction is not lost where the ends meet while it does not
//! act. A torsion spring turns its body by `−k (Δ − a) − c Δ̇`. What acts on a condition has the
//! factor s, 1 while it acts, else 0, which is constant between events.

use super::action::{Action, Scene, normal, unit};
use super::expression::{Expression, OpaqueTerms};
use super::{Quantity, QuantityKind, dot};
use crate::algebra::{Rational, Series, Symbol};
use crate::system::{Load, LoadKind, Spring, Torsion};

/// What acts beside gravity.
#[derive(Clone, Debug)]
pub struct Loads {
    /// Every force and couple.
    pub actions: Vec<Action>,
    /// The springs' potential.
    pub potential: Series,
    /// Tension of each spring, then torque of each torsion spring.
    pub tensions: Vec<Quantity<Series>>,
}

impl Loads {
    pub(super) fn derive(scene: &Scene, opaque_terms: &mut OpaqueTerms) -> Self {
        let mut loads = Self { actions: Vec::new(), potential: Series::zero(), tensions: Vec::new() };
        for spring in &scene.system.springs {
            loads.spring(scene, opaque_terms, spring);
        }
        for torsion in &scene.system.torsions {
            loads.torsion(scene, opaque_terms, torsion);
        }
        for load in &scene.system.loads {
            loads.applied(scene, opaque_terms, load);
        }
        loads
    }

    fn spring(&mut self, scene: &Scene, opaque_terms: &mut OpaqueTerms, spring: &Spring) {
        let [a, b] = spring.ends.map(|end| &scene.kinematics.points[end]);
        let span = [0, 1].map(|axis| &b[axis] - &a[axis]);
        let value = |series: &Series| Expression::series(series.clone());
        let of = |formula| Expression::from_formula(formula, scene.system, scene.kinematics);
        let (approach, distance) = (dot(&span, &span.each_ref().map(Series::rate)), dot(&span, &span));
        let distance = value(&(&distance + &apart(spring.switch))).sqrt();
        let name = &spring.name;
        // Damping along a distance of zero has no direction.
        let damping = spring.damping.as_ref().filter(|c| !c.is_zero());
        let mut tension = Series::zero();
        if let Some(k) = &spring.stiffness {
            let k = &opaque_terms.symbol(&format!("k_{name}"), of(k));
            let stretched = distance.clone().minus(of(&spring.length));
            let stretch = opaque_terms.symbol(&format!("Δ_{name}"), stretched);
            let square = if spring.length.is_zero() { dot(&span, &span) } else { &stretch * &stretch };
            self.potential += switched(spring.switch, (k * &square).scale(Rational::new(1, 2)));
            tension += k * &stretch;
        }
        if let Some(c) = damping {
            let c = &opaque_terms.symbol(&format!("c_{name}"), of(c));
            tension +=
                c * &opaque_terms.symbol(&format!("ḋ_{name}"), value(&approach).over(distance.clone()));
        }
        let ratio = match (&spring.stiffness, damping) {
            (Some(k), None) if spring.length.is_zero() => opaque_terms.symbol(&format!("k_{name}"), of(k)),
            _ => opaque_terms.symbol(&format!("κ_{name}"), value(&tension).over(distance)),
        };
        let [tension, ratio] = [tension, ratio].map(|part| switched(spring.switch, part));
        self.tensions.push(Quantity::new(format!("force({name})"), QuantityKind::SpringForce, tension));
        let pull = span.map(|part| &part * &ratio);
        let back = pull.each_ref().map(|part| -part);
        self.actions.push(Action::at_point(scene, spring.ends[0], pull));
        self.actions.push(Action::at_point(scene, spring.ends[1], back));
    }

    fn torsion(&mut self, scene: &Scene, opaque_terms: &mut OpaqueTerms, torsion: &Torsion) {
        let direction = |body: usize| &scene.kinematics.directions[body];
        let turned = match torsion.from {
            None => direction(torsion.body).clone(),
            Some(from) => direction(torsion.body) - direction(from),
        };
        let name = torsion.name.replace(", ", "_");
        let of = |formula| Expression::from_formula(formula, scene.system, scene.kinematics);
        let turns = scene.kinematics.lost_turns(scene.system, torsion.from, torsion.body);
        let turn = Expression::Angle(turned.clone()).plus_turns(turns);
        let rest = if torsion.angle.is_zero() { turn } else { turn.minus(of(&torsion.angle)) };
        let mut torque = Series::zero();
        if let Some(k) = &torsion.stiffness {
            let k = &opaque_terms.symbol(&format!("k_{name}"), of(k));
            let wound = opaque_terms.symbol(&format!("Δ_{name}"), rest);
            torque -= k * &wound;
            self.potential += switched(torsion.switch, (k * &(&wound * &wound)).scale(Rational::new(1, 2)));
        }
        if let Some(c) = &torsion.damping {
            torque -= &opaque_terms.symbol(&format!("c_{name}"), of(c)) * &turned.rate();
        }
        let torque = switched(torsion.switch, torque);
        let name = format!("torque({})", torsion.name);
        self.tensions.push(Quantity::new(name, QuantityKind::SpringTorque, torque.clone()));
        self.couple(scene, torsion.body, torsion.from, torque);
    }

    fn couple(&mut self, scene: &Scene, body: usize, from: Option<usize>, couple: Series) {
        self.actions.extend(from.map(|from| Action::couple(scene, from, Some(body), -&couple)));
        self.actions.push(Action::couple(scene, body, from, couple));
    }

    fn applied(&mut self, scene: &Scene, opaque_terms: &mut OpaqueTerms, load: &Load) {
        let mut symbol = |part: &str, formula| {
            let expression = Expression::from_formula(formula, scene.system, scene.kinematics);
            switched(load.switch, opaque_terms.symbol(&format!("{}{part}", load.name), expression))
        };
        match &load.kind {
            LoadKind::Couple { body, from, value } => {
                let couple = symbol("", value);
                self.couple(scene, *body, *from, couple);
            }
            LoadKind::Force { point, frame: None, value } => {
                let force = [symbol("_x", &value[0]), symbol("_y", &value[1])];
                self.actions.push(Action::at_point(scene, *point, force));
            }
            LoadKind::Force { point, frame: Some(body), value } => {
                let [along, across] = [symbol("_along", &value[0]), symbol("_across", &value[1])];
                let direction = &scene.kinematics.directions[*body];
                let (e, n) = (unit(direction), normal(direction));
                let force = [0, 1].map(|axis| &(&e[axis] * &along) + &(&n[axis] * &across));
                self.actions.push(Action::at_point(scene, *point, force));
            }
        }
    }
}

/// 1 − s.
fn apart(switch: Option<usize>) -> Series {
    switch.map_or(Series::zero(), |i| &Series::one() - &Series::symbol(Symbol::Switch(i as u16)))
}

/// What acts by a switch.
fn switched(switch: Option<usize>, value: Series) -> Series {
    match switch {
        Some(i) => &Series::symbol(Symbol::Switch(i as u16)) * &value,
        None => value,
    }
}
