//! More contacts than are taken in at once.

use nalgebra::{DMatrix, DVector};

use super::super::decision::FrictionSolution;
use super::super::modes::{
    Bound, ContactMode, Frictional, ImpulseBounds, ModeChoice, ModeCondition, SlipDirection, SlipVelocity,
};
use super::super::problem::{BalancedProblem, FrictionProblem};
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;

const FORWARD: ContactMode = ContactMode::Slide(SlipDirection::Forward);
const BACKWARD: ContactMode = ContactMode::Slide(SlipDirection::Backward);

/// Blocks on the floor, of which the first slides and the second, which moves as fast without
/// friction, is behind it or before it; the others are pushed from rest.
fn train(behind: bool, (mu, masses): (f64, [f64; 2]), pushes: &[f64]) -> FrictionSolution {
    let bodies = 2 + pushes.len();
    let (n, r) = (2 * bodies, 2 * bodies + 1);
    let mut jacobian = DMatrix::zeros(r, n);
    for body in 0..bodies {
        // The floor's normal and tangent of each.
        (jacobian[(2 * body, 2 * body + 1)], jacobian[(2 * body + 1, 2 * body)]) = (1.0, 1.0);
    }
    let sense = if behind { 1.0 } else { -1.0 };
    (jacobian[(r - 1, 0)], jacobian[(r - 1, 2)]) = (sense, -sense);
    let of = |body: usize| if body < 2 { masses[body] } else { 1.0 };
    let mass = DMatrix::from_diagonal(&DVector::from_fn(n, |j, _| of(j / 2)));
    let force = DVector::from_fn(n, |j, _| match (j / 2, j % 2) {
        (body, 1) => -of(body),
        (body, _) if body >= 2 => pushes[body - 2],
        _ => 0.0,
    });
    let contact = |body: usize| {
        let slip = if body == 0 { SlipVelocity::Forward } else { SlipVelocity::Rest };
        Frictional::touching((2 * body, 2 * body + 1), (mu, mu), slip)
    };
    let contacts: Vec<Frictional> = (0..bodies).filter(|body| *body != 1).map(contact).collect();
    let rows = LcpRows { candidates: &[2, r - 1], ..LcpRows::default() };
    let bias = DVector::zeros(r);
    let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
    // Blocks that touch none of the others would be decided apart.
    kkt.couple(&contacts);
    let question = FrictionProblem { rows, contacts: &contacts };
    let problem = BalancedProblem::new(&kkt, &question);
    problem.conclude(problem.decide_alone().unwrap())
}

/// Only friction makes the first block press on the one behind it: without friction that contact
/// bears nothing. Both slow down with a = −μ g m₀/(m₀ + m₁); one before it leaves.
#[test]
fn what_only_friction_presses_is_taken_in() {
    let mu = 0.4;
    let pushes: Vec<f64> = (0..14).map(|k| 0.15 * (k as f64 - 6.8)).collect();
    for masses in [[2.0, 3.0], [1e4, 1e3]] {
        for behind in [true, false] {
            let found = train(behind, (mu, masses), &pushes);
            let a = &found.solution.accelerations;
            let together = -mu * masses[0] / (masses[0] + masses[1]);
            let [first, second] = if behind { [together; 2] } else { [-mu, 0.0] };
            assert!((a[0] - first).abs() < 1e-12 && (a[2] - second).abs() < 1e-12, "{behind} {a}");
            assert!(!found.complete);
            let between = found.solution.reactions[found.solution.reactions.len() - 1];
            assert!((between + second * masses[1]).abs() < 1e-12 * masses[1], "{behind} {between}");
            assert_eq!(found.modes[0], FORWARD);
            for (k, push) in pushes.iter().enumerate() {
                let expected = push - push.clamp(-mu, mu);
                assert!((a[4 + 2 * k] - expected).abs() < 1e-12 * masses[0], "{behind} {push}");
                let mode = match expected {
                    0.0 => ContactMode::Stick,
                    a if a > 0.0 => FORWARD,
                    _ => BACKWARD,
                };
                assert_eq!(found.modes[1 + k], mode, "{behind} {push}");
            }
        }
    }
}

/// A plank on so many feet, the last of which may be another kind of contact.
fn first_within(feet: usize, last: Option<Frictional>) -> Vec<usize> {
    let jacobian = DMatrix::from_fn(2 * feet, 3, |row, j| {
        if row % 2 == 0 { [0.0, 1.0, (row / 2) as f64 - 2.3][j] } else { [1.0, 0.0, 0.0][j] }
    });
    let (force, bias) = (DVector::from_row_slice(&[0.0, -1.0, 0.0]), DVector::zeros(2 * feet));
    let mut contacts: Vec<Frictional> = (0..feet)
        .map(|foot| Frictional::touching((2 * foot, 2 * foot + 1), (0.5, 0.5), SlipVelocity::Rest))
        .collect();
    if let Some(last) = last {
        contacts[feet - 1] = last;
    }
    let mut kkt =
        EquilibratedKkt::new(&DMatrix::identity(3, 3), &jacobian, (&force, &bias), (&force.abs(), &bias));
    let question = FrictionProblem { rows: LcpRows::default(), contacts: &contacts };
    kkt.couple(question.contacts);
    let problem = BalancedProblem::new(&kkt, &question);
    problem.first_within(&problem.shapes().unwrap())
}

/// Up to twelve are taken in at once; of more those that bear without friction, which are two of a
/// plank's, and those that act whatever is found.
#[test]
fn few_contacts_are_taken_in_at_once() {
    let all = |feet: usize| (0..feet).collect::<Vec<_>>();
    assert_eq!(first_within(12, None), all(12));
    let some = first_within(13, None);
    assert!(some.len() <= 2 && !some.is_empty(), "{some:?}");
    let rows = (24, 25);
    let bound = Bound { slope: 0.5, offset: 0.1 };
    let given = Frictional::given(rows, ImpulseBounds { forward: bound, backward: bound });
    let choice = |mode: ContactMode, condition: ModeCondition| ModeChoice {
        mode,
        conditions: [condition].into_iter().collect(),
    };
    let brink = Frictional {
        choices: vec![
            choice(ContactMode::Stick, ModeCondition::Above),
            choice(FORWARD, ModeCondition::Slips),
        ],
        ..Frictional::touching(rows, (0.5, 0.5), SlipVelocity::Rest)
    };
    for last in [given, brink] {
        assert!(!some.contains(&12) && first_within(13, Some(last)).contains(&12));
    }
    // One that is decided is no open one.
    let decided = || Frictional::decided(rows, (0.5, 0.5), ContactMode::Stick);
    assert_eq!(first_within(13, Some(decided())), all(12));
}

/// Contacts at the limit of sticking whose reactions are decided: N rises with w, the push with p
/// in the sense of the slip that may begin. Each sticks up to p = μ w and slides beyond it.
#[test]
fn contacts_at_their_brink_stick_or_slide() {
    let mu = 0.5;
    let cases: Vec<(f64, f64, SlipDirection)> = [SlipDirection::Forward, SlipDirection::Backward]
        .into_iter()
        .flat_map(|sense| {
            [(0.4, 1.0), (0.6, 1.0), (-0.3, 1.0), (-0.6, -1.0), (-0.4, -1.0)].map(|(p, w)| (p, w, sense))
        })
        .collect();
    let count = cases.len();
    let jacobian = DMatrix::from_fn(2 * count, 2 * count, |row, j| {
        // x and y of each; normals first.
        let column = if row < count { 2 * row + 1 } else { 2 * (row - count) };
        f64::from(u8::from(j == column))
    });
    let choice = |mode: ContactMode, condition: ModeCondition| ModeChoice {
        mode,
        conditions: [condition].into_iter().collect(),
    };
    let contact = |k: usize| {
        let sense = cases[k].2;
        let reserve =
            if sense == SlipDirection::Forward { ModeCondition::Above } else { ModeCondition::Below };
        Frictional {
            choices: vec![
                choice(ContactMode::Stick, reserve),
                choice(ContactMode::Slide(sense), ModeCondition::Slips),
            ],
            ..Frictional::touching((k, count + k), (mu, mu), SlipVelocity::Rest)
        }
    };
    let contacts: Vec<Frictional> = (0..count).map(contact).collect();
    let force = DVector::from_fn(2 * count, |j, _| {
        let (p, w, sense) = cases[j / 2];
        if j % 2 == 0 { sense.sign() * p } else { -w }
    });
    let (mass, bias) = (DMatrix::identity(2 * count, 2 * count), DVector::zeros(2 * count));
    let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
    let question = FrictionProblem { rows: LcpRows::default(), contacts: &contacts };
    kkt.couple(question.contacts);
    let problem = BalancedProblem::new(&kkt, &question);
    let found = problem.pivot().unwrap().unwrap();
    for (k, &(p, w, sense)) in cases.iter().enumerate() {
        let slides = p > mu * w;
        let mode = if slides { ContactMode::Slide(sense) } else { ContactMode::Stick };
        assert_eq!(problem.modes(&found.chosen)[k], mode, "{p} {w} {sense:?}");
        let a = if slides { sense.sign() * (p - mu * w) } else { 0.0 };
        assert!((found.trial.a[2 * k] - a).abs() < 1e-14, "{p} {w} {sense:?}");
        assert!((found.trial.reactions[k] - w).abs() < 1e-14, "{p} {w} {sense:?}");
    }
}
