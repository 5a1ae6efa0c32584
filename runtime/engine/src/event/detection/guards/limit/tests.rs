use super::*;
use crate::event::detection::guards::{Findings, Watch};
use crate::event::detection::tests::given::*;
use crate::integrate::Guards;
use crate::model::{ContactSet, Side, Slip};
use crate::series::ORDERS;

const MU: f64 = 0.25;

fn watch(slip: Slip, side: Side) -> Watch<'static> {
    LimitGuard::watch(FrictionGuard { contact: GUIDE, friction: 1, slip, side }, CONTACTS + 1, false)
}

/// N = ±(4 − t) and R = σ (t − 0.5): 0.25 (4 − t) ± (t − 0.5).
#[test]
fn a_limit_is_that_of_its_side_and_sense() {
    for (side, s) in [(Side::Positive, 1.0), (Side::Negative, -1.0)] {
        let closed = ContactSet::EMPTY.slipping(GUIDE, Slip::Stick).pressing(GUIDE, side);
        let scene = Scene::closed(closed, move |t| {
            let mut shown = Shown::default();
            (shown.reactions[GUIDE], shown.reactions[CONTACTS + 1]) = (s * (4.0 - t), t - 0.5);
            shown.slips[1] = [0.0, MU];
            shown
        });
        let [mut reactions, rest] = [[[0.0; ORDERS]; CONTACTS + FRICTIONS]; 2];
        reactions[GUIDE] = padded(&[4.0 * s, -s]);
        reactions[CONTACTS + 1] = padded(&[-0.5, 1.0]);
        let series = Guards::new(2, &reactions, &rest, &[[0.0; ORDERS]; 2]);
        for (slip, sigma) in [(Slip::Forward, 1.0), (Slip::Backward, -1.0)] {
            let mut watch = watch(slip, side);
            let expected = [4.0 * MU - 0.5 * sigma, sigma - MU];
            scene.look_with(Some(series), |step| {
                watch.begin(step);
                assert!(!watch.tracking.at_root);
                watch.begin_step(step);
                assert_eq!(watch.tracking.series(&*watch.kind, step.view), Some(&expected[..]));
                assert_eq!(watch.value(step, 0.5), expected[0] + 0.5 * expected[1]);
            });
            // What is closed because others are has no series.
            let other = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
            other.look_with(Some(series), |step| {
                watch.begin_step(step);
                assert_eq!(watch.tracking.series(&*watch.kind, step.view), None);
            });
        }
    }
}

/// μₛ N = 0.5 and R = 0.75 t: it slides backward where R pushes forward.
#[test]
fn a_limit_is_reached_in_one_sense() {
    let closed = ContactSet::EMPTY.slipping(GUIDE, Slip::Stick);
    let scene = Scene::closed(closed, |t| {
        let mut shown = Shown::default();
        (shown.reactions[GUIDE], shown.reactions[CONTACTS + 1]) = (2.0, 0.75 * t);
        shown.slips[1] = [0.0, MU];
        shown
    });
    let find = |slip| {
        let mut watch = watch(slip, Side::Positive);
        scene.look(|step| watch.find_event(step, &mut Findings::default()))
    };
    let backward = find(Slip::Backward);
    assert!(backward.is_ok_and(|at| at.is_some_and(|at| (at - 2.0 / 3.0).abs() < 1e-12)), "{backward:?}");
    assert_eq!(find(Slip::Forward), Ok(None));
}
