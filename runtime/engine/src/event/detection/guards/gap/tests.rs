use super::*;
use crate::event::detection::tests::given::*;
use crate::model::ContactSet;

/// The gap of a corner, and how far its foot is from the nearer end of its bar.
fn corner(gap: fn(f64) -> f64, foot: fn(f64) -> f64) -> Scene {
    Scene::closed(ContactSet::EMPTY, move |t| {
        let mut shown = Shown { feet: [foot(t), 1.0], ..Shown::default() };
        shown.gaps[CORNER] = gap(t);
        shown
    })
}

/// The guard of the corner, and what is known of it beside.
fn guard(status: &ContactStatus<'_>) -> (GapGuard, Tracking) {
    (GapGuard::new(CORNER, Some(0), status), GapGuard::watch(CORNER, Some(0), status).tracking)
}

/// Below its bar from 0.25 on, beyond its end up to 0.5: nothing closes, and it has passed at the
/// end.
#[test]
fn a_gap_remembers_where_it_has_passed_its_bar() {
    let scene = corner(|t| 0.25 - t, |t| t - 0.5);
    let (mut guard, mut tracking) = guard(&roles(ContactSet::EMPTY));
    scene.look(|step| {
        let found = guard.find_event(&tracking, step, &mut Findings::default());
        assert_eq!(found, Some(Ok(None)));
        let from = guard.below.expect("it passes");
        assert!((from - 0.25).abs() < 1e-12, "{from}");
        guard.end_step(&tracking, step, 1.0);
        assert_eq!(guard.below, Some(0.0));
        // In a step that proves it above it has come back.
        tracking.is_clear = true;
        guard.end_step(&tracking, step, 1.0);
        tracking.is_clear = false;
        assert!(!guard.is_below());
        // Seen below beside the end of its bar.
        guard.end_step(&tracking, step, 0.375);
        assert!(guard.is_below());
    });
    // Under its bar it may be zero at the end of a run.
    assert!(scene.look(|step| guard.may_arrive(step)));
    assert!(!corner(|t| 0.25 - t, |_| -0.5).look(|step| guard.may_arrive(step)));
}

/// What is told of a gap as a phase begins holds up to the first step's end; a low flight is
/// followed from there.
#[test]
fn a_flight_is_followed_while_it_is_low() {
    for (k, is_low) in [(1e-9, true), (1.0, false)] {
        let scene = Scene::closed(ContactSet::EMPTY, move |t| {
            let mut shown = Shown::default();
            shown.gaps[CORNER] = k * t.powi(3);
            shown.curvatures[CORNER] = 6.0 * k * t;
            shown
        });
        for (order, begins) in [(3, true), (2, false)] {
            let orders = [(CORNER, order)];
            let (mut guard, tracking) = guard(&ContactStatus { orders: &orders, ..roles(ContactSet::EMPTY) });
            assert_eq!((guard.order, guard.flight.is_some()), (Some(order), begins));
            scene.look(|step| {
                assert_eq!(guard.begin(step), None);
                guard.leave_step(&tracking, step);
            });
            assert_eq!((guard.order, guard.flight.is_some()), (None, begins && is_low), "{k} {order}");
        }
    }
}
