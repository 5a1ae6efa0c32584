//! What counts as zero, in any units.

use super::{HingeProblem, SignCondition};
use crate::contact::ContactProblem;
use crate::contact::friction::SlipVelocity;
use crate::contact::hinges::choices::choices;
use crate::contact::hinges::tests::Resting;
use crate::context::{Numbers, RunContext, scales_of};
use crate::model::ContactSet;
use crate::system::Model;

fn context((m, l, g): (f64, f64, f64)) -> RunContext {
    let model = Model::new(&Resting { m, l, mu: 0.3, r: 0.02 * l, g });
    let scales = scales_of(&model).unwrap();
    RunContext { model, scales }
}

/// A law holds down to −1e-9 of its unit, and is open within ±1e-9 of it; one whose reaction was
/// located holds and is open anyhow.
#[test]
fn laws_hold_up_to_rounding() {
    let law = |margin: f64, is_located: bool| SignCondition { margin, zero: 2.0, is_located };
    for (margin, holds, is_open) in
        [(-2.1, false, false), (-1.9, true, true), (1.9, true, true), (2.1, true, false)]
    {
        let it = law(margin, false);
        assert_eq!((it.holds(), it.is_open()), (holds, is_open), "{margin}");
        let located = law(margin, true);
        assert!(located.holds() && located.is_open(), "{margin}");
    }
}

/// N = m g/2 of the end that lies and of the pin, whose friction has μ N r to spare where nothing
/// turns it; or ¾ · 2 g of the end that falls: 1e-9 of the natural force, of the acceleration at
/// the natural length, whatever the units are.
#[test]
fn zero_does_not_depend_on_units() {
    for units in [(2.0, 0.5, 9.81), (3e-7, 4e5, 2e-9), (5e8, 1e-6, 7e6)] {
        let context = context(units);
        let (m, _, g) = units;
        let place = HingeProblem::new(&context, Numbers::from_slice(&[0.0; 2]));
        let layout = context.layout();
        let hinge = (0..2).find(|&contact| layout.contacts[contact].is_hinge()).unwrap();
        let slips = [(hinge, SlipVelocity::Rest)];
        let touching: ContactSet = (0..2).collect();
        let question = ContactProblem { touching, slips: &slips, ..ContactProblem::default() };
        let options = choices(layout, &question);
        let of = |contact: usize| options.iter().find(|it| it.0 == contact).unwrap().1.clone();
        // Sticking, with the end closed or open.
        let [closed, open] = [false, true].map(|is_open| {
            let support = of(1 - hinge).into_iter().find(|it| it.is_open == is_open).unwrap();
            place.answer(vec![(1 - hinge, support), (hinge, of(hinge)[0])]).unwrap()
        });
        let told =
            |laws: Vec<SignCondition>| laws.iter().map(|law| (law.margin, law.zero)).collect::<Vec<_>>();
        let (closed, open) = (told(place.laws(&closed)), told(place.laws(&open)));
        let force = 1e-9 * context.scales.force();
        assert!((force / (1e-9 * m * g) - 1.0).abs() < 10.0, "{units:?}: {force:e}");
        // The end presses, the pin presses, its friction has something to spare; or the end opens.
        assert_eq!((closed.len(), open.len()), (3, 3), "{units:?}");
        assert!(closed.iter().all(|(_, zero)| (zero / force - 1.0).abs() < 1e-12), "{units:?} {closed:?}");
        let acceleration = 1e-9 * context.scales.length / context.scales.time.powi(2);
        assert!((open[0].1 / acceleration - 1.0).abs() < 1e-12, "{units:?} {open:?}");
    }
}
