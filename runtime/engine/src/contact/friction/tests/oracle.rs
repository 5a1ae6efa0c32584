//! All modes by plain elimination: the unknowns a, λ of joints, and λ_N and R of every contact,
//! with two equations for each contact whatever its mode.

use nalgebra::{DMatrix, DVector};

use super::super::modes::{Bound, ContactMode, ImpulseBounds, SlipDirection, SlipVelocity};
use crate::model::Side;

/// A planar linkage in maximal coordinates: bodies, joints, and contacts of points against lines.
#[derive(Debug, Clone)]
pub(super) struct Linkage {
    pub(super) mass: DMatrix<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) force: DVector<f64>,
    pub(super) bias: DVector<f64>,
    pub(super) joints: Vec<usize>,
    pub(super) contacts: Vec<Contact>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    pub(super) normal: usize,
    /// No tangent where it is smooth.
    pub(super) tangent: Option<usize>,
    pub(super) mu: f64,
    /// Infinite where it is rough.
    pub(super) limit: f64,
    pub(super) slip: SlipVelocity,
    /// Whether it holds both ways.
    pub(super) is_guide: bool,
    /// Bounds of friction while an impulse is given.
    pub(super) given: Option<ImpulseBounds>,
}

/// a and the multipliers of all rows.
pub(super) struct Motion {
    pub(super) a: DVector<f64>,
    pub(super) multipliers: DVector<f64>,
}

impl Contact {
    /// Whether it may slip against a force.
    pub(super) fn has_friction(&self) -> bool {
        self.tangent.is_some() && self.limit.is_finite()
    }

    /// |R| while it slides in a sense, `slope λ_N + offset`.
    fn kinetic(&self, sense: SlipDirection) -> (f64, f64) {
        match (self.given, sense) {
            (None, _) => (self.mu, 0.0),
            (Some(ImpulseBounds { forward: Bound { slope, offset }, .. }), SlipDirection::Forward) => {
                (slope, offset)
            }
            (Some(ImpulseBounds { backward: Bound { slope, offset }, .. }), SlipDirection::Backward) => {
                (slope, offset)
            }
        }
    }

    /// The reserves of friction that sticks, against the bounds in both senses.
    fn reserves(&self, normal: f64, friction: f64) -> [f64; 2] {
        [SlipDirection::Forward, SlipDirection::Backward].map(|sense| {
            let (slope, offset) = if self.given.is_some() { self.kinetic(sense) } else { (self.limit, 0.0) };
            slope * normal + offset + sense.sign() * friction
        })
    }

    fn modes(&self) -> Vec<ContactMode> {
        let (forward, backward) =
            (ContactMode::Slide(SlipDirection::Forward), ContactMode::Slide(SlipDirection::Backward));
        if self.given.is_some() {
            let part =
                [None, Some(SlipDirection::Forward), Some(SlipDirection::Backward)].map(ContactMode::Part);
            return [ContactMode::Stick, forward, backward].into_iter().chain(part).collect();
        }
        let guide = |senses: &[Option<SlipDirection>]| {
            let sides = [Side::Positive, Side::Negative].into_iter();
            sides
                .flat_map(|side| senses.iter().map(move |&sense| ContactMode::Guide { side, sense }))
                .collect()
        };
        match self.slip {
            SlipVelocity::Forward | SlipVelocity::Leaves(SlipDirection::Forward) if self.is_guide => {
                guide(&[Some(SlipDirection::Forward)])
            }
            SlipVelocity::Backward | SlipVelocity::Leaves(SlipDirection::Backward) if self.is_guide => {
                guide(&[Some(SlipDirection::Backward)])
            }
            SlipVelocity::Rest if self.is_guide => {
                guide(&[None, Some(SlipDirection::Forward), Some(SlipDirection::Backward)])
            }
            _ if !self.has_friction() => vec![ContactMode::Open, ContactMode::Stick],
            SlipVelocity::Forward | SlipVelocity::Leaves(SlipDirection::Forward) => {
                vec![ContactMode::Open, forward]
            }
            SlipVelocity::Backward | SlipVelocity::Leaves(SlipDirection::Backward) => {
                vec![ContactMode::Open, backward]
            }
            SlipVelocity::Rest => vec![ContactMode::Open, ContactMode::Stick, forward, backward],
        }
    }
}

impl Linkage {
    /// All modes that satisfy the law.
    pub(super) fn solutions(&self) -> Vec<Vec<ContactMode>> {
        let mut combinations: Vec<Vec<ContactMode>> = vec![Vec::new()];
        for contact in &self.contacts {
            combinations = combinations
                .into_iter()
                .flat_map(|modes| {
                    contact.modes().into_iter().map(move |mode| [modes.clone(), vec![mode]].concat())
                })
                .collect();
        }
        combinations
            .retain(|modes| self.motion(modes).is_some_and(|motion| self.violation(modes, &motion) <= 1e-9));
        combinations
    }

    fn motion(&self, modes: &[ContactMode]) -> Option<Motion> {
        let (n, r) = self.jacobian.transpose().shape();
        let mut matrix = DMatrix::zeros(n + r, n + r);
        let mut right = DVector::zeros(n + r);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.mass);
        matrix.view_mut((0, n), (n, r)).copy_from(&-self.jacobian.transpose());
        right.rows_mut(0, n).copy_from(&self.force);
        let mut hold = |row: usize| {
            matrix.view_mut((n + row, 0), (1, n)).copy_from(&self.jacobian.row(row));
            right[n + row] = -self.bias[row];
        };
        self.joints.iter().for_each(|&row| hold(row));
        for (contact, mode) in self.contacts.iter().zip(modes) {
            if !matches!(mode, ContactMode::Open | ContactMode::Part(_)) {
                hold(contact.normal);
            }
            let sticks = matches!(
                mode,
                ContactMode::Stick | ContactMode::Guide { sense: None, .. } | ContactMode::Part(None)
            );
            contact.tangent.filter(|_| sticks).into_iter().for_each(&mut hold);
        }
        for (contact, mode) in self.contacts.iter().zip(modes) {
            if matches!(mode, ContactMode::Open | ContactMode::Part(_)) {
                matrix[(n + contact.normal, n + contact.normal)] = 1.0;
            }
            let Some(tangent) = contact.tangent else { continue };
            match mode {
                ContactMode::Stick | ContactMode::Guide { sense: None, .. } | ContactMode::Part(None) => {}
                ContactMode::Guide { side, sense: Some(sense) } => {
                    matrix[(n + tangent, n + tangent)] = 1.0;
                    matrix[(n + tangent, n + contact.normal)] =
                        f64::from(side.sign()) * sense.sign() * contact.mu;
                }
                ContactMode::Open => matrix[(n + tangent, n + tangent)] = 1.0,
                ContactMode::Slide(sense) | ContactMode::Part(Some(sense)) => {
                    let (slope, offset) = contact.kinetic(*sense);
                    matrix[(n + tangent, n + tangent)] = 1.0;
                    matrix[(n + tangent, n + contact.normal)] = sense.sign() * slope;
                    right[n + tangent] = -sense.sign() * offset;
                }
            }
        }
        let x = matrix.clone().lu().solve(&right)?;
        // Contradictory contacts have a singular matrix, which elimination with rounding does not
        // tell.
        let small = (&matrix * &x - &right).amax() <= 1e-10 * (1.0 + x.amax()) && x.amax() < 1e9;
        let motion = Motion { a: x.rows(0, n).into_owned(), multipliers: x.rows(n, r).into_owned() };
        small.then_some(motion)
    }

    /// By how much a sliding contact's normal reaction of one opens it, with others in some modes:
    /// the contact is open for that, and its reaction a load.
    pub(super) fn response(
        &self,
        contact: usize,
        sense: SlipDirection,
        modes: &[ContactMode],
    ) -> Option<f64> {
        let it = self.contacts[contact];
        let push = self.jacobian.row(it.normal).transpose()
            - self.jacobian.row(it.tangent?).transpose() * (sense.sign() * it.mu);
        let still = |force: DVector<f64>| Self { force, bias: &self.bias * 0.0, ..self.clone() };
        let a = still(push).motion(modes)?.a;
        Some((self.jacobian.row(it.normal) * a)[0])
    }

    /// The largest violation of the equations and the law, relative to the largest value there is.
    pub(super) fn violation(&self, modes: &[ContactMode], motion: &Motion) -> f64 {
        let Motion { a, multipliers } = motion;
        let opening = &self.jacobian * a + &self.bias;
        let size = 1.0 + a.amax().max(multipliers.amax());
        let balance = &self.mass * a - &self.force - self.jacobian.tr_mul(multipliers);
        let mut worst = balance.amax();
        let mut check = |excess: f64| worst = worst.max(excess);
        self.joints.iter().for_each(|&row| check(opening[row].abs()));
        for (contact, mode) in self.contacts.iter().zip(modes) {
            let normal = multipliers[contact.normal];
            let (slip, friction) = contact.tangent.map_or((0.0, 0.0), |row| (opening[row], multipliers[row]));
            match mode {
                ContactMode::Open => {
                    check(-opening[contact.normal]);
                    check(normal.abs().max(friction.abs()));
                }
                ContactMode::Part(sense) => {
                    check(-opening[contact.normal]);
                    check(normal.abs());
                    let Some(sense) = sense else {
                        contact.reserves(0.0, friction).into_iter().for_each(|it| check(-it));
                        check(slip.abs());
                        continue;
                    };
                    check((friction + sense.sign() * contact.kinetic(*sense).1).abs());
                    check(-sense.sign() * slip);
                }
                ContactMode::Guide { side, sense } => {
                    check(opening[contact.normal].abs());
                    check(-f64::from(side.sign()) * normal);
                    match sense {
                        None => check(slip.abs().max(friction.abs() - contact.limit * normal.abs())),
                        Some(sense) => {
                            check((friction + sense.sign() * contact.mu * normal.abs()).abs());
                            check(if contact.slip == SlipVelocity::Rest {
                                -sense.sign() * slip
                            } else {
                                0.0
                            });
                        }
                    }
                }
                ContactMode::Stick => {
                    check(opening[contact.normal].abs().max(slip.abs()));
                    check(-normal);
                    if contact.has_friction() {
                        contact.reserves(normal.max(0.0), friction).into_iter().for_each(|it| check(-it));
                    }
                }
                ContactMode::Slide(sense) => {
                    check(opening[contact.normal].abs().max(-normal));
                    let (slope, offset) = contact.kinetic(*sense);
                    check((friction + sense.sign() * (slope * normal + offset)).abs());
                    if contact.slip == SlipVelocity::Rest {
                        check(-sense.sign() * slip);
                    }
                }
            }
        }
        worst / size
    }
}
