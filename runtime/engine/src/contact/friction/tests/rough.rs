//! Rough contacts and smooth ones by themselves, against all sets of closed ones.

use super::super::modes::{ContactMode, SlipVelocity};
use super::oracle::Motion;
use super::random::{Random, Sorted, cases, in_units, kkt, linkage};
use crate::contact::Trials;
use crate::contact::complementarity::{LcpRows, Solution};
use crate::contact::trials::LcpError;

/// What is found is one of the motions that there are, the same in any units; nothing is found only
/// where there is none.
#[test]
fn rough_contacts_have_one_of_their_motions() {
    let mut random = Random(0x8F1B_BCDC_CA62_C1D6);
    let mut counts = [0usize; 4];
    for k in 0..cases(500) {
        let mut linkage = linkage(&mut random, 1 + k % 5);
        for contact in &mut linkage.contacts {
            (contact.limit, contact.slip) = (f64::INFINITY, SlipVelocity::Rest);
        }
        let expected = linkage.solutions();
        counts[expected.len().min(3)] += 1;
        let sorted = Sorted::new(&linkage);
        let rows = sorted.question(&linkage).rows;
        let found = kkt(&linkage).solve(&rows);
        for units in [(1e7, 1e-4, 3e-3), (2e-9, 7e3, 1e5)] {
            let other = kkt(&in_units(&linkage, units)).solve(&rows);
            let closed = |it: &Result<Solution, LcpError>| it.clone().map(|it| it.active_basis);
            assert_eq!(closed(&other), closed(&found), "{k}");
        }
        let Ok(found) = found else {
            assert!(expected.is_empty(), "{k} {expected:?}");
            continue;
        };
        let closed =
            |normal: usize| found.active_basis.contains(&normal) || found.degenerate.contains(&normal);
        let modes: Vec<ContactMode> = linkage
            .contacts
            .iter()
            .map(|it| if closed(it.normal) { ContactMode::Stick } else { ContactMode::Open })
            .collect();
        assert!(expected.contains(&modes), "{k}: {modes:?} {expected:?}");
        let motion = Motion { a: found.accelerations, multipliers: found.reactions };
        assert!(linkage.violation(&modes, &motion) <= 1e-9, "{k}");
    }
    assert!(counts[..3].iter().all(|count| *count > 10), "{counts:?}");
}

/// What sticks bears however ill-conditioned its equations are: of two motions the one with it
/// closed is found in all units. The tangents and the normal of the second contact depend on each
/// other but for 2e-4, and its opening is not zero but for 1e-9.
#[test]
fn a_contact_that_bears_is_not_released() {
    let mut random = Random(0x996E_2118_2D91_6AB8);
    let mut linkage = linkage(&mut random, 3);
    for contact in &mut linkage.contacts {
        (contact.limit, contact.slip) = (f64::INFINITY, SlipVelocity::Rest);
    }
    let [stick, open] = [ContactMode::Stick, ContactMode::Open];
    assert_eq!(linkage.solutions(), [[open, open, open], [open, stick, open]]);
    let sorted = Sorted::new(&linkage);
    let mut unit = || 10f64.powf(random.between(-8.0, 8.0));
    let others: Vec<_> = (0..40).map(|_| (unit(), unit(), unit())).collect();
    for units in [(2e-9, 7e3, 1e5)].into_iter().chain(others) {
        let found = kkt(&in_units(&linkage, units)).solve(&sorted.question(&linkage).rows);
        assert_eq!(found.unwrap().active_basis, [linkage.contacts[1].normal], "{units:?}");
    }
}

/// No more sets are tried than are allowed, and it is said that there may be others.
#[test]
fn sets_of_rough_contacts_are_counted() {
    let mut random = Random(0x2F73_7431_9E5C_0A11);
    let (mut searched, mut refused) = (0, 0);
    for k in 0..cases(300) {
        let mut linkage = linkage(&mut random, 3 + k % 2);
        for contact in &mut linkage.contacts {
            (contact.limit, contact.slip) = (f64::INFINITY, SlipVelocity::Rest);
        }
        let sorted = Sorted::new(&linkage);
        let rows = sorted.question(&linkage).rows;
        let trials = Trials::up_to(1_000);
        let found = kkt(&linkage).solve(&LcpRows { trials: Some(&trials), ..rows });
        let tried = 1_000 - trials.left();
        if tried == 0 {
            continue;
        }
        searched += 1;
        // The largest set that is a motion.
        if let Ok(found) = &found {
            let closed =
                |modes: &Vec<ContactMode>| modes.iter().filter(|mode| **mode == ContactMode::Stick).count();
            let most = linkage.solutions().iter().map(closed).max();
            assert_eq!(Some(found.active_basis.len() + found.degenerate.len()), most, "{k}");
        }
        for (most, is_enough) in [(tried, true), (tried - 1, false)] {
            let again = Trials::up_to(most);
            let other = kkt(&linkage).solve(&LcpRows { trials: Some(&again), ..rows });
            assert_eq!(other.as_ref().err() == Some(&LcpError::Exhausted), !is_enough, "{k}");
            refused += usize::from(!is_enough);
            assert!(!is_enough || other.is_ok() == found.is_ok(), "{k}");
            assert_eq!(again.left(), 0, "{k}");
        }
    }
    assert!(searched > 20 && refused > 20, "{searched} {refused}");
}
