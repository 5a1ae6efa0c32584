//! Ten thousand random linkages with one to four contacts, and Lemke's method on the same.

use nalgebra::{DMatrix, DVector};

use super::super::decision::{FrictionError, FrictionSolution, Question};
use super::super::modes::{Bound, Frictional, Given, Mode, Sense, Slip};
use super::super::problem::Problem;
use super::super::stability::{Sliding, painleve};
use super::oracle::{Contact, Linkage, Motion};
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
            slip: Slip::Rest,
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
            contact.slip = [Slip::Forward, Slip::Backward, Slip::Rest, Slip::Rest][random.below(4)];
            if random.below(6) == 0 {
                (contact.limit, contact.slip) = (f64::INFINITY, Slip::Rest);
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

    pub(super) fn question<'a>(&'a self, linkage: &'a Linkage) -> Question<'a> {
        let Self { candidates, tied, contacts } = self;
        Question { rows: LcpRows { fixed: &linkage.joints, candidates, tied, trials: None }, contacts }
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
pub(super) fn in_order(linkage: &Linkage, modes: &[Mode]) -> Vec<Mode> {
    let with = linkage.contacts.iter().filter(|it| it.has_friction()).count();
    let (mut friction, mut smooth) = (modes[..with].iter(), modes[with..].iter());
    let mode = |it: &Contact| if it.has_friction() { friction.next() } else { smooth.next() };
    linkage.contacts.iter().map(mode).map(|mode| *mode.unwrap()).collect()
}

/// Some contacts are given an impulse, and with it bounds of friction beside those of what they bear; some of these give back slip:
/// their friction is no less than that.
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
        (contact.given, contact.limit, contact.slip) = (Some(Given { forward, backward }), mu, Slip::Rest);
    }
}

/// Every solution is found and named, and the one that is taken satisfies the law to 1e-10 of its largest value.
#[test]
fn all_solutions_of_random_linkages_are_found() {
    let (counts, worst) = compared(Random(0x9E37_79B9_7F4A_7C15), 2_500, |_, _| ());
    println!("solutions 0, 1, 2, …: {counts:?}, worst residual {worst:e}");
    assert!(worst <= 1e-10, "{worst:e}");
    let total: usize = counts.iter().sum();
    assert!(100 * counts[0] > total && 100 * counts[2] > total && 1000 * counts[3] > total);
}

/// The same where half of the contacts with friction are guides, of which each side counts.
#[test]
fn all_solutions_of_random_linkages_with_guides_are_found() {
    let guides = |random: &mut Random, linkage: &mut Linkage| {
        for contact in linkage.contacts.iter_mut().filter(|it| it.has_friction()) {
            contact.is_guide = random.below(2) == 0;
        }
    };
    let (counts, worst) = compared(Random(0x2545_F491_4F6C_DD1D), 2_500, guides);
    println!("solutions 0, 1, 2, …: {counts:?}, worst residual {worst:e}");
    assert!(worst <= 1e-10, "{worst:e}");
    let total: usize = counts.iter().sum();
    assert!(100 * counts[0] > total && 100 * counts[2] > total);
}

/// The same of the second stage of Poisson's law.
#[test]
fn all_solutions_of_random_linkages_with_given_impulses_are_found() {
    let (counts, worst) = compared(Random(0x3C6E_F372_FE94_F82B), 600, give);
    println!("solutions 0, 1, 2, …: {counts:?}, worst residual {worst:e}");
    assert!(worst <= 1e-10, "{worst:e}");
    let total: usize = counts.iter().sum();
    assert!(100 * counts[0] > total && 100 * counts[2] > total);
}

/// How many of so many changed linkages have so many solutions, and the worst residual of those taken.
fn compared(
    mut random: Random,
    usual: usize,
    change: impl Fn(&mut Random, &mut Linkage),
) -> ([usize; 6], f64) {
    let (mut counts, mut worst) = ([0usize; 6], 0.0f64);
    for k in 0..cases(usual) {
        let mut linkage = linkage(&mut random, 1 + k % 4);
        change(&mut random, &mut linkage);
        let mut expected = linkage.solutions();
        counts[expected.len().min(5)] += 1;
        let found = match solve(&linkage) {
            Ok(found) => found,
            Err(FrictionError::Inconsistent) => {
                assert!(expected.is_empty(), "{k}: {expected:?}");
                continue;
            }
            Err(other) => panic!("{k}: {other:?}"),
        };
        let mut all: Vec<_> = found.solutions.iter().map(|modes| in_order(&linkage, modes)).collect();
        let taken = all[found.taken].clone();
        all.sort();
        // Of many modes one solution is looked for.
        expected.retain(|modes| found.complete || all.contains(modes));
        expected.sort();
        assert_eq!(all, expected, "{k}");
        let motion = Motion { a: found.solution.accelerations, multipliers: found.solution.reactions };
        worst = worst.max(linkage.violation(&taken, &motion));
    }
    (counts, worst)
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

#[test]
fn units_do_not_matter() {
    let mut random = Random(0x7F4A_7C15_9E37_79B9);
    for k in 0..cases(500) {
        let linkage = linkage(&mut random, 1 + k % 4);
        let found = solve(&linkage);
        for units in [(1e7, 1e-4, 3e-3), (2e-9, 7e3, 1e5)] {
            let (found, other) = match (&found, solve(&in_units(&linkage, units))) {
                (Ok(found), Ok(other)) => (found, other),
                (found, other) => {
                    assert_eq!(found.as_ref().err(), other.as_ref().err(), "{k}");
                    continue;
                }
            };
            assert_eq!((&found.modes, &found.solutions), (&other.modes, &other.solutions), "{k}");
            assert_eq!((found.reason, &found.next), (other.reason, &other.next), "{k}");
            assert_eq!((found.determined, found.solution.unique), (other.determined, other.solution.unique));
            let (mass, length, time) = units;
            let back = &other.solution.reactions * (time * time / (mass * length));
            let size = 1.0 + found.solution.reactions.amax();
            assert!((&found.solution.reactions - back).amax() <= 1e-9 * size, "{k}");
        }
    }
}

/// Lemke's method finds one of the solutions that enumeration finds, and none where there is none.
#[test]
fn lemke_agrees_with_enumeration() {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let (mut solvable, mut missed) = (0, 0);
    for k in 0..cases(1_000) {
        let mut linkage = linkage(&mut random, 1 + k % 4);
        if k % 8 >= 4 {
            give(&mut random, &mut linkage);
        }
        let sorted = Sorted::new(&linkage);
        let question = sorted.question(&linkage);
        let mut kkt = kkt(&linkage);
        kkt.couple(question.contacts);
        let problem = Problem::new(&kkt, &question);
        let all: Vec<_> =
            problem.enumerate().unwrap().iter().map(|found| problem.modes(&found.chosen)).collect();
        solvable += usize::from(!all.is_empty());
        match problem.pivot().unwrap() {
            Some(found) => assert!(all.contains(&problem.modes(&found.chosen)), "{k}"),
            None => missed += usize::from(!all.is_empty()),
        }
    }
    println!("of {solvable} with solutions Lemke's path misses {missed}");
    assert!(missed * 20 < solvable, "{missed} of {solvable}");
}

/// The border of Painlevé's region of each contact that slides, while others are as in a solution.
#[test]
fn the_border_within_a_set() {
    let mut random = Random(0x0123_4567_89AB_CDEF);
    let mut compared = 0;
    for k in 0..2_000 {
        let linkage = linkage(&mut random, 2 + k % 3);
        for mut modes in linkage.solutions() {
            let slides = |(at, mode): (usize, &Mode)| match mode {
                Mode::Slide(sense) => Some((at, *sense)),
                _ => None,
            };
            let sliding: Vec<(usize, Sense)> = modes.iter().enumerate().filter_map(slides).collect();
            let of = |(at, sense): (usize, Sense)| Sliding {
                normal: linkage.contacts[at].normal,
                tangent: linkage.contacts[at].tangent.unwrap(),
                signed_mu: sense.sign() * linkage.contacts[at].mu,
            };
            let Some(&first) = sliding.first() else { continue };
            let mut closed = linkage.joints.clone();
            for (contact, mode) in linkage.contacts.iter().zip(&modes) {
                if *mode == Mode::Stick {
                    closed.extend([Some(contact.normal), contact.tangent].into_iter().flatten());
                }
            }
            let others: Vec<Sliding> = sliding[1..].iter().map(|it| of(*it)).collect();
            let found = painleve(&linkage.mass, &linkage.jacobian, of(first), &closed, &others).unwrap();
            modes[first.0] = Mode::Open;
            let Some(expected) = linkage.response(first.0, first.1, &modes) else { continue };
            let size = 1.0 + expected.abs();
            assert!((found - expected).abs() <= 1e-10 * size, "{k}: {found} {expected}");
            compared += 1;
        }
    }
    assert!(compared > 500, "{compared}");
}
