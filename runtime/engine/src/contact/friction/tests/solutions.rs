//! Ten thousand random linkages with one to four contacts, and Lemke's method on the same.

use super::super::decision::FrictionError;
use super::super::modes::{ContactMode, Frictional, SlipDirection};
use super::super::problem::BalancedProblem;
use super::super::stability::{Sliding, painleve};
use super::oracle::{Linkage, Motion};
use super::random::{Random, Sorted, cases, give, in_order, in_units, kkt, linkage, solve};

/// Every solution is found and named, and the one that is taken satisfies the law to 1e-10 of its
/// largest value.
#[test]
fn all_solutions_of_random_linkages_are_found() {
    let (counts, worst) = compared(Random(0x9E37_79B9_7F4A_7C15), [2_500, 98_023], |_, _| ());
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
    let (counts, worst) = compared(Random(0x2545_F491_4F6C_DD1D), [2_500, 15_551], guides);
    println!("solutions 0, 1, 2, …: {counts:?}, worst residual {worst:e}");
    assert!(worst <= 1e-10, "{worst:e}");
    let total: usize = counts.iter().sum();
    assert!(100 * counts[0] > total && 100 * counts[2] > total);
}

/// The same of the second stage of Poisson's law.
#[test]
fn all_solutions_of_random_linkages_with_given_impulses_are_found() {
    let (counts, worst) = compared(Random(0x3C6E_F372_FE94_F82B), [600; 2], give);
    println!("solutions 0, 1, 2, …: {counts:?}, worst residual {worst:e}");
    assert!(worst <= 1e-10, "{worst:e}");
    let total: usize = counts.iter().sum();
    assert!(100 * counts[0] > total && 100 * counts[2] > total);
}

/// How many of so many changed linkages, and of a later one besides, have so many solutions, and
/// the worst residual of those taken.
fn compared(
    mut random: Random,
    [usual, later]: [usize; 2],
    change: impl Fn(&mut Random, &mut Linkage),
) -> ([usize; 6], f64) {
    let (mut counts, mut worst) = ([0usize; 6], 0.0f64);
    let count = cases(usual);
    for k in 0..count.max(later + 1) {
        let mut linkage = linkage(&mut random, 1 + k % 4);
        change(&mut random, &mut linkage);
        if k >= count && k != later {
            continue;
        }
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
        // Of many modes, which only what is given has here, one solution is looked for.
        assert!(found.complete || linkage.contacts.iter().any(|it| it.given.is_some()), "{k}");
        expected.retain(|modes| found.complete || all.contains(modes));
        expected.sort();
        assert_eq!(all, expected, "{k}");
        // What is taken is one of the modes that it leaves to the next order.
        let leaves =
            |(mode, next): (&ContactMode, &Frictional)| next.choices.iter().any(|it| it.mode == *mode);
        assert!(found.modes.iter().zip(&found.next).all(leaves), "{k}: {:?}", found.modes);
        let motion = Motion { a: found.solution.accelerations, multipliers: found.solution.reactions };
        worst = worst.max(linkage.violation(&taken, &motion));
    }
    (counts, worst)
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
        let problem = BalancedProblem::new(&kkt, &question);
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
            let slides = |(at, mode): (usize, &ContactMode)| match mode {
                ContactMode::Slide(sense) => Some((at, *sense)),
                _ => None,
            };
            let sliding: Vec<(usize, SlipDirection)> = modes.iter().enumerate().filter_map(slides).collect();
            let of = |(at, sense): (usize, SlipDirection)| Sliding {
                normal: linkage.contacts[at].normal,
                tangent: linkage.contacts[at].tangent.unwrap(),
                signed_mu: sense.sign() * linkage.contacts[at].mu,
            };
            let Some(&first) = sliding.first() else { continue };
            let mut closed = linkage.joints.clone();
            for (contact, mode) in linkage.contacts.iter().zip(&modes) {
                if *mode == ContactMode::Stick {
                    closed.extend([Some(contact.normal), contact.tangent].into_iter().flatten());
                }
            }
            let others: Vec<Sliding> = sliding[1..].iter().map(|it| of(*it)).collect();
            let found = painleve(&linkage.mass, &linkage.jacobian, of(first), &closed, &others).unwrap();
            modes[first.0] = ContactMode::Open;
            let Some(expected) = linkage.response(first.0, first.1, &modes) else { continue };
            let size = 1.0 + expected.abs();
            assert!((found - expected).abs() <= 1e-10 * size, "{k}: {found} {expected}");
            compared += 1;
        }
    }
    assert!(compared > 500, "{compared}");
}
