//! The edges of contacts that share their load.

use nalgebra::DMatrix;

use super::edges;
use crate::contact::closed_rows::ClosedRows;
use crate::contact::friction::SlipDirection;
use crate::model::{ContactSet, Friction, Slip as ModelSlip, SlipState};
use crate::system::Model;
use liftoff_fixtures::RodOnSupports;

/// Two edges of a cone with what it bears between them, and one of a contact without friction, or
/// that slides; nothing of what the motion determines.
#[test]
fn edges_of_cones_bear_the_reactions() {
    let plain = Model::new(&RodOnSupports { m: 1.0, l: 1.0, g: 1.0 }).layout();
    let mut contacts = plain.contacts.to_vec();
    (contacts[0].friction, contacts[2].friction) = (Some(0), Some(1));
    let friction = |contact: usize, row: usize| Friction { contact, row, follows_slip: false };
    let layout = (*plain)
        .contacts(contacts.leak())
        .tangents(&[0, 2])
        .frictions(vec![friction(0, 3), friction(2, 4)].leak());
    let jacobian = DMatrix::from_row_slice(4, 2, &[1.0, 0.5, 2.0, -1.0, 0.3, 4.0, 0.0, 3.0]);
    let rows = ClosedRows { rows: vec![0, 1, 2, 3], jacobian, levers: vec![1.0; 4] };
    let slip = |limit: f64| SlipState { velocity: 0.0, kinetic: limit, limit };
    let slips = [slip(0.25), slip(0.5)];
    // N of each contact, then R of both with friction.
    let reactions = [6.0, 5.0, 7.0, 0.75, -3.5];
    let closed = ContactSet::EMPTY.with(1).slipping(0, ModelSlip::Stick).slipping(2, ModelSlip::Forward);
    let row = |k: usize| rows.jacobian.row(k).transpose();
    let (all, taken) = edges(&layout, &closed, (&rows, &[true; 4]), &slips, &reactions);
    let expected = [
        (row(0) + row(3) * 0.25, 0.5 * (6.0 + 0.75 / 0.25), (0, Some(SlipDirection::Forward))),
        (row(0) - row(3) * 0.25, 0.5 * (6.0 - 0.75 / 0.25), (0, Some(SlipDirection::Backward))),
        (row(1), 5.0, (1, None)),
        (row(2), 7.0, (2, None)),
    ];
    let told: Vec<_> =
        all.into_iter().map(|edge| (edge.column, edge.load, (edge.contact, edge.slip))).collect();
    assert_eq!((told.as_slice(), taken.as_slice()), (&expected[..], &[0, 3, 1, 2][..]));
    for (undetermined, taken) in [
        ([false; 4], vec![]),
        ([false, false, false, true], vec![0, 3]),
        ([false, true, false, false], vec![1]),
    ] {
        assert_eq!(edges(&layout, &closed, (&rows, &undetermined), &slips, &reactions).1, taken);
    }
    // Without friction nothing is borne across, whatever rounding leaves there; nor what is
    // rounding beside the largest reaction.
    for (limit, across) in [(0.0, 1e-9), (1e-12, 1e-15)] {
        let reactions = [6.0, 5.0, 7.0, across, -3.5];
        let (all, _) = edges(&layout, &closed, (&rows, &[true; 4]), &[slip(limit), slip(0.5)], &reactions);
        assert_eq!((all[0].load, all[1].load), (3.0, 3.0), "{limit}");
    }
}
