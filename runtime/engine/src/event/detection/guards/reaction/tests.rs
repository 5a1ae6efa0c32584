use super::*;
use crate::event::detection::guards::Findings;
use crate::event::detection::tests::given::*;
use crate::integrate::Guards;
use crate::model::ContactSet;
use crate::series::ORDERS;

/// Of a guide and of a support, with N = 0.5 − t, above zero up to 0.5 on the positive side.
#[test]
fn a_reaction_has_the_sign_of_its_side() {
    let closed = set(&[PLAIN]).slipping(GUIDE, crate::model::Slip::Forward);
    let scene = Scene::closed(closed, |t| {
        let mut shown = Shown::default();
        (shown.reactions[PLAIN], shown.reactions[GUIDE]) = (0.5 - t, 0.5 - t);
        shown
    });
    for (contact, side, sign) in
        [(PLAIN, None, 1.0), (GUIDE, Some(Side::Positive), 1.0), (GUIDE, Some(Side::Negative), -1.0)]
    {
        let mut watch = ReactionGuard::watch(contact, side, false);
        let [mut reactions, rest] = [[[0.0; ORDERS]; CONTACTS + FRICTIONS]; 2];
        reactions[contact] = padded(&[0.5, -1.0]);
        let series = Guards::new(2, &reactions, &rest, &[[0.0; ORDERS]; 2]);
        scene.look_with(Some(series), |step| {
            watch.begin_step(step);
            assert_eq!(
                watch.tracking.series(&*watch.kind, step.view),
                Some(&[sign * 0.5, -sign][..]),
                "{side:?}"
            );
            assert_eq!(watch.value(step, 0.25), sign * 0.25);
            let at = watch.find_event(step, &mut Findings::default());
            let expected = if sign > 0.0 { 0.5 } else { 0.0 };
            assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - expected).abs() < 1e-12)), "{side:?} {at:?}");
        });
        scene.look(|step| {
            watch.begin_step(step);
            assert_eq!(watch.tracking.series(&*watch.kind, step.view), None);
        });
    }
    // One that is closed because others are has none on the negative side.
    let depends = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
    let rest = [[1.0; ORDERS]; CONTACTS + FRICTIONS];
    let series = Guards::new(2, &rest, &rest, &[[0.0; ORDERS]; 2]);
    let mut watch = ReactionGuard::watch(GUIDE, Some(Side::Negative), false);
    depends.look_with(Some(series), |step| {
        watch.begin_step(step);
        assert_eq!(watch.tracking.series(&*watch.kind, step.view), None);
    });
}
