//! Drawn motions are found again, alone and beside others, with what they leave to the next order.

use nalgebra::{DMatrix, DVector};

use super::super::modes::ContactMode;
use super::drawn::{
    LITTLE, all_left, contacts_of_all_kinds, examine, is_the_drawn_one, is_well_conditioned, list_modes, load,
};
use super::oracle::{Contact, Linkage, Motion};
use super::random::{Random, Sorted, cases, in_units, kkt, linkage};
use crate::contact::complementarity::LcpRows;

/// The same in any units.
#[test]
fn vanishing_margins_are_left_to_the_next_order() {
    let mut random = Random(0x61C8_8646_80B5_83EB);
    let (mut drawn, mut open) = (0, 0);
    for k in 0..cases(1_500) {
        let mut linkage = contacts_of_all_kinds(&mut random, 1 + k % 3);
        let motion = load(&mut linkage, &mut random);
        let sorted = Sorted::new(&linkage);
        let solve = |linkage: &Linkage| kkt(linkage).solve_with_friction(&sorted.question(linkage)).unwrap();
        let found = solve(&linkage);
        if !is_the_drawn_one(&found, &motion) {
            continue;
        }
        drawn += 1;
        let expected = all_left(&linkage, &motion);
        let units = [(1.0, 1.0, 1.0), (1e7, 1e-4, 3e-3), (2e-9, 7e3, 1e5)];
        for found in units.map(|units| solve(&in_units(&linkage, units))) {
            assert_eq!(list_modes(&found.next), expected, "{k} {:?}", found.modes);
            let first: Vec<ContactMode> = expected.iter().map(|left| left[0].0).collect();
            assert_eq!(found.modes, first, "{k}");
            examine(&linkage, &motion, &found.solution, k);
        }
        open += usize::from(expected.iter().any(|left| left.len() > 1));
    }
    assert!(drawn > 800 && open > 300, "{drawn} {open}");
}

/// Where nothing acts everything is left, and nothing bears, pulls or pushes.
#[test]
fn without_loads_nothing_bears() {
    let mut random = Random(0x9216_D5D9_8979_FB1B);
    for k in 0..cases(100) {
        let mut linkage = contacts_of_all_kinds(&mut random, 1 + k % 3);
        (linkage.force, linkage.bias) = (&linkage.force * 0.0, &linkage.bias * 0.0);
        let motion = Motion { a: &linkage.force * 0.0, multipliers: &linkage.bias * 0.0 };
        let sorted = Sorted::new(&linkage);
        let found = kkt(&linkage).solve_with_friction(&sorted.question(&linkage)).unwrap();
        assert_eq!(list_modes(&found.next), all_left(&linkage, &motion), "{k}");
        examine(&linkage, &motion, &found.solution, k);
        let smooth = kkt(&linkage).solve(&sorted.question(&linkage).rows).unwrap();
        examine(&linkage, &motion, &smooth, k);
    }
}

/// Two linkages that do not touch.
pub(super) fn beside(one: &Linkage, other: &Linkage) -> Linkage {
    let ((r, n), (s, m)) = (one.jacobian.shape(), other.jacobian.shape());
    let mut mass = one.mass.clone().resize(n + m, n + m, 0.0);
    mass.view_mut((n, n), (m, m)).copy_from(&other.mass);
    let mut jacobian = one.jacobian.clone().resize(r + s, n + m, 0.0);
    jacobian.view_mut((r, n), (s, m)).copy_from(&other.jacobian);
    let stacked = |one: &DVector<f64>, other: &DVector<f64>| {
        DVector::from_iterator(one.len() + other.len(), one.iter().chain(other.iter()).copied())
    };
    let moved = other.contacts.iter().map(|it| Contact {
        normal: it.normal + r,
        tangent: it.tangent.map(|row| row + r),
        ..*it
    });
    Linkage {
        mass,
        jacobian,
        force: stacked(&one.force, &other.force),
        bias: stacked(&one.bias, &other.bias),
        joints: one.joints.iter().copied().chain(other.joints.iter().map(|row| row + r)).collect(),
        contacts: one.contacts.iter().copied().chain(moved).collect(),
    }
}

#[test]
fn independent_bodies_do_not_matter() {
    let mut random = Random(0x0A5B_35C9_E0F1_9D27);
    let mut drawn = 0;
    for k in 0..cases(400) {
        let [mut one, mut other] = [0; 2].map(|_| contacts_of_all_kinds(&mut random, 1 + k % 2));
        let motions = [load(&mut one, &mut random), load(&mut other, &mut random)];
        let far = in_units(&other, (1e12, 1e-3, 1e5));
        let own = [&one, &far].map(|it| kkt(it).solve_with_friction(&Sorted::new(it).question(it)).unwrap());
        let both = beside(&one, &far);
        let found = kkt(&both).solve_with_friction(&Sorted::new(&both).question(&both)).unwrap();
        let expected: Vec<_> = own.iter().flat_map(|it| list_modes(&it.next)).collect();
        assert_eq!(list_modes(&found.next), expected, "{k}");
        let modes: Vec<ContactMode> = own.iter().flat_map(|it| it.modes.clone()).collect();
        assert_eq!(found.modes, modes, "{k}");
        assert_eq!(found.solutions.len(), own[0].solutions.len() * own[1].solutions.len(), "{k}");
        let [first, second] = own.each_ref().map(|it| &it.solution.reactions);
        let all = &found.solution.reactions;
        let apart = [all.rows(0, first.len()) - first, all.rows(first.len(), second.len()) - second];
        // The second are in units of a tenth.
        assert!(
            apart[0].amax() <= 1e-9 * (1.0 + first.amax()) && apart[1].amax() <= 1e-9 * (0.1 + second.amax()),
            "{k}"
        );
        drawn += usize::from(is_the_drawn_one(&own[0], &motions[0]));
    }
    assert!(drawn > 200, "{drawn}");
}

/// Contacts without friction, some of them again in another unit: such a one shares the load of its
/// like.
#[test]
fn smooth_contacts_at_their_borders() {
    let mut random = Random(0x5851_F42D_4C95_7F2D);
    let (mut redundant, mut examined) = (0, 0);
    for k in 0..cases(1_500) {
        let mut linkage = linkage(&mut random, 1 + k % 5);
        linkage.contacts.iter_mut().for_each(|it| it.tangent = None);
        let motion = load(&mut linkage, &mut random);
        let Sorted { candidates, .. } = Sorted::new(&linkage);
        let openings = &linkage.jacobian * &motion.a + &linkage.bias;
        if !is_well_conditioned(&linkage) {
            continue;
        }
        examined += 1;
        for units in [(1.0, 1.0, 1.0), (1e7, 1e-4, 3e-3), (2e-9, 7e3, 1e5)] {
            let it = in_units(&linkage, units);
            let rows = LcpRows { fixed: &it.joints, candidates: &candidates, ..LcpRows::default() };
            let found = kkt(&it).solve(&rows).unwrap();
            examine(&linkage, &motion, &found, k);
            assert!(found.unique, "{k}");
        }
        let twin = candidates[random.below(candidates.len() as u64)];
        let it = with_twin(&linkage, twin);
        let mut candidates = candidates.clone();
        candidates.push(linkage.bias.len());
        let rows = LcpRows { fixed: &it.joints, candidates: &candidates, ..LcpRows::default() };
        let found = kkt(&it).solve(&rows).unwrap();
        let touches = openings[twin] < 1e-3 * LITTLE;
        assert_eq!(found.unique, !touches, "{k}");
        redundant += usize::from(touches);
        let size = 1.0 + motion.a.amax().max(motion.multipliers.amax());
        assert!((&found.accelerations - &motion.a).amax() <= 1e-9 * size, "{k}");
        assert_eq!(found.tight.contains(&linkage.bias.len()), touches, "{k}");
    }
    assert!(examined > 700 && redundant > 300, "{examined} {redundant}");
}

/// One contact's row again, four times as long.
fn with_twin(linkage: &Linkage, row: usize) -> Linkage {
    let (r, n) = linkage.jacobian.shape();
    let more = |i: usize| if i < r { (i, 1.0) } else { (row, 4.0) };
    let twin = Contact { normal: r, ..linkage.contacts[0] };
    Linkage {
        jacobian: DMatrix::from_fn(r + 1, n, |i, j| more(i).1 * linkage.jacobian[(more(i).0, j)]),
        bias: DVector::from_fn(r + 1, |i, _| more(i).1 * linkage.bias[more(i).0]),
        contacts: linkage.contacts.iter().copied().chain([twin]).collect(),
        ..linkage.clone()
    }
}
