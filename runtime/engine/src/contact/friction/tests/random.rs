//! Random linkages with one to four contacts, as the solver reads them.

use nalgebra::{DMatrix, DVector};

use super::super::decision::{FrictionError, FrictionSolution};
use super::super::modes::{Bound, ContactMode, Frictional, ImpulseBounds, SlipVelocity};
use super::super::problem::FrictionProblem;
use super::oracle::{Contact, Linkage};
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;

/// A generator of fixed seed (Marsaglia, *Xorshift RNGs*, J. Stat. Softw. 8, 2003).
pub(in crate::contact) struct Random(pub(in crate::contact) u64);

impl Random {
    pub(in crate::contact) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(in crate::contact) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(in crate::contact) fn below(&mut self, count: u64) -> usize {
        ((self.bits() >> 20) % count) as usize
    }
}

/// How many random cases are tried: so many, or so many times `LIFTOFF_CASES`.
pub(in crate::contact) fn cases(usual: usize) -> usize {
    usual * std::env::var("LIFTOFF_CASES").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// The velocity of a body's point at `arm` from its centre along a unit vector: a row of J.
fn along(row: &mut [f64], body: usize, arm: [f64; 2], direction: [f64; 2], sign: f64) {
    row[3 * body] += sign * direction[0];
    row[3 * body + 1] += sign * direction[1];
    row[3 * body + 2] += sign * (arm[0] * direction[1] - arm[1] * direction[0]);
}

/// Contacts with friction, of which one of four is smooth, and one of eight rough.
pub(super) fn linkage(random: &mut Random, contacts: usize) -> Linkage {
    let bodies = 1 + random.below(3);
    let n = 3 * bodies;
    let (mut rows, mut joints, mut list) = (Vec::<Vec<f64>>::new(), Vec::new(), Vec::new());
    let point = |random: &mut Random| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
    for body in 1..bodies {
        if random.below(4) > 0 {
            let arms = [point(random), point(random)];
            for direction in [[1.0, 0.0], [0.0, 1.0]] {
                let mut row = vec![0.0; n];
                along(&mut row, body - 1, arms[0], direction, 1.0);
                along(&mut row, body, arms[1], direction, -1.0);
                joints.push(rows.len());
                rows.push(row);
            }
        }
    }
    for _ in 0..contacts {
        let (body, arm, angle) = (random.below(bodies as u64), point(random), random.between(0.0, 6.3));
        let (sine, cosine) = angle.sin_cos();
        let mut contact = Contact {
            normal: rows.len(),
            tangent: None,
            mu: 0.0,
            limit: 0.0,
            slip: SlipVelocity::Rest,
            is_guide: false,
            given: None,
        };
        let mut row = vec![0.0; n];
        along(&mut row, body, arm, [cosine, sine], 1.0);
        rows.push(row);
        if random.below(4) > 0 {
            contact.tangent = Some(rows.len());
            let mut row = vec![0.0; n];
            along(&mut row, body, arm, [-sine, cosine], 1.0);
            rows.push(row);
            contact.mu = random.between(0.0, 2.0);
            contact.limit = contact.mu * [1.0, 1.0, random.between(1.0, 1.5)][random.below(3)];
            contact.slip =
                [SlipVelocity::Forward, SlipVelocity::Backward, SlipVelocity::Rest, SlipVelocity::Rest]
                    [random.below(4)];
            if random.below(6) == 0 {
                (contact.limit, contact.slip) = (f64::INFINITY, SlipVelocity::Rest);
            }
        }
        list.push(contact);
    }
    let mass = DVector::from_fn(n, |k, _| if k % 3 == 2 { random.between(0.05, 1.0) } else { 1.0 });
    let r = rows.len();
    Linkage {
        mass: DMatrix::from_diagonal(&mass),
        jacobian: DMatrix::from_fn(r, n, |i, j| rows[i][j]),
        force: DVector::from_fn(n, |_, _| random.between(-1.0, 1.0)),
        bias: DVector::from_fn(r, |_, _| random.between(-1.0, 0.5)),
        joints,
        contacts: list,
    }
}

/// Rows of the contacts without friction, the ties of rough ones, and the contacts with friction.
pub(super) struct Sorted {
    pub(super) candidates: Vec<usize>,
    pub(super) tied: Vec<(usize, usize)>,
    contacts: Vec<Frictional>,
}

impl Sorted {
    pub(super) fn new(linkage: &Linkage) -> Self {
        let others = || linkage.contacts.iter().filter(|it| !it.has_friction());
        let frictional = linkage.contacts.iter().filter(|it| it.has_friction());
        let contacts = frictional.filter_map(|it| {
            let rows = (it.normal, it.tangent?);
            let of = if it.is_guide { Frictional::guide } else { Frictional::touching };
            Some(match it.given {
                Some(given) => Frictional::given(rows, given),
                None => of(rows, (it.mu, it.limit), it.slip),
            })
        });
        Self {
            candidates: others().map(|it| it.normal).collect(),
            tied: others().filter_map(|it| Some((it.tangent?, it.normal))).collect(),
            contacts: contacts.collect(),
        }
    }

    pub(super) fn question<'a>(&'a self, linkage: &'a Linkage) -> FrictionProblem<'a> {
        let Self { candidates, tied, contacts } = self;
        FrictionProblem { rows: LcpRows { fixed: &linkage.joints, candidates, tied, trials: None }, contacts }
    }
}

pub(super) fn kkt(linkage: &Linkage) -> EquilibratedKkt {
    EquilibratedKkt::new(
        &linkage.mass,
        &linkage.jacobian,
        (&linkage.force, &linkage.bias),
        (&linkage.force.abs(), &linkage.bias.abs()),
    )
}

pub(super) fn solve(linkage: &Linkage) -> Result<FrictionSolution, FrictionError> {
    kkt(linkage).solve_with_friction(&Sorted::new(linkage).question(linkage))
}

/// Modes with friction first, in the order of the linkage's contacts.
pub(super) fn in_order(linkage: &Linkage, modes: &[ContactMode]) -> Vec<ContactMode> {
    let with = linkage.contacts.iter().filter(|it| it.has_friction()).count();
    let (mut friction, mut smooth) = (modes[..with].iter(), modes[with..].iter());
    let mode = |it: &Contact| if it.has_friction() { friction.next() } else { smooth.next() };
    linkage.contacts.iter().map(mode).map(|mode| *mode.unwrap()).collect()
}

/// Some contacts are given an impulse, and with it bounds of friction beside those of what they
/// bear; some of these give back slip: their friction is no less than that.
pub(super) fn give(random: &mut Random, linkage: &mut Linkage) {
    for contact in linkage.contacts.iter_mut().filter(|it| it.has_friction()) {
        if random.below(3) == 0 {
            continue;
        }
        let (mu, given) = (contact.mu, random.between(0.0, 1.0));
        let friction = Bound { slope: mu, offset: mu * given };
        let returned = Bound { slope: 0.0, offset: -random.between(0.0, mu * given) };
        let [forward, backward] =
            [[friction; 2], [friction; 2], [returned, friction], [friction, returned]][random.below(4)];
        (contact.given, contact.limit, contact.slip) =
            (Some(ImpulseBounds { forward, backward }), mu, SlipVelocity::Rest);
    }
}

/// The same in other units of mass, length and time.
pub(super) fn in_units(it: &Linkage, (mass, length, time): (f64, f64, f64)) -> Linkage {
    let unit = |j: usize| if j % 3 == 2 { 1.0 } else { length };
    let ((r, n), rate) = (it.jacobian.shape(), 1.0 / (time * time));
    Linkage {
        mass: DMatrix::from_fn(n, n, |i, j| it.mass[(i, j)] * mass * length * length / (unit(i) * unit(j))),
        jacobian: DMatrix::from_fn(r, n, |i, j| it.jacobian[(i, j)] * length / unit(j)),
        force: DVector::from_fn(n, |j, _| it.force[j] * mass * length * length * rate / unit(j)),
        bias: &it.bias * (length * rate),
        ..it.clone()
    }
}
