//! Improved senses against all modes.

use super::choices::choices;
use super::place::{HingeCandidate, HingeProblem};
use super::{policy, search};
use crate::contact::ContactProblem;
use crate::contact::friction::{Reason, SlipVelocity};
use crate::context::{Numbers, RunContext, scales_of};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

/// A chain of five bars on a pin, pulled at its end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[bar(CD, mass = m, length = l)]
#[bar(DE, mass = m, length = l)]
#[bar(EF, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[hinge(B, friction = mu, radius = r)]
#[hinge(C, friction = mu, radius = r)]
#[hinge(D, friction = mu, radius = r)]
#[hinge(E, friction = mu, radius = r)]
#[force(F = (p, q))]
#[coordinate(a = angle(AB), from = down)]
#[coordinate(b = angle(BC), from = down)]
#[coordinate(c = angle(CD), from = down)]
#[coordinate(d = angle(DE), from = down)]
#[coordinate(e = angle(EF), from = down)]
#[figure(B = (0, -l), C = (0, -2 * l), D = (0, -3 * l), E = (0, -4 * l), F = (0, -5 * l))]
struct Chain {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    p: f64,
    q: f64,
    g: f64,
}

#[test]
fn improvement_agrees_with_enumeration() {
    let mut seed = 5_u64;
    let mut between = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut improved, mut sticking) = (0, 0);
    for _ in 0..40 {
        let (mu, r) = (between(0.1, 2.0), between(0.02, 0.1));
        let [p, q] = [between(-20.0, 20.0), between(-20.0, 20.0)];
        let chain = Chain { m: 1.0, l: 1.0, mu, r, p, q, g: 9.81 };
        let model = Model::new(&chain);
        let scales = scales_of(&model).unwrap();
        let context = RunContext { model, scales };
        let spread = between(0.0, 0.4);
        let mut state = [0.0; 10];
        state[..5].iter_mut().for_each(|angle| *angle = between(-spread, spread));
        let hinges: ContactSet = (0..5).collect();
        let slips: Vec<(usize, SlipVelocity)> = (0..5).map(|hinge| (hinge, SlipVelocity::Rest)).collect();
        let question = ContactProblem { touching: hinges, slips: &slips, ..ContactProblem::default() };
        let place = HingeProblem::new(&context, Numbers::from_slice(&state));
        let options = choices(context.layout(), &question);
        let all = search::all(&place, &options);
        let [known] = &all[..] else { panic!("{} motions", all.len()) };
        if let Some(found) = search::improved(&place, &options, usize::MAX) {
            assert_eq!(found[0].set, known.set, "{state:?}");
            improved += 1;
            // All but the hinges at rest have one combination.
            assert!(search::improved(&place, &options, 1).is_some());
            assert!(search::improved(&place, &options, 0).is_none());
        }
        sticking += known.set.iter().filter(|&i| known.set.slip(i) == crate::model::Slip::Stick).count();
    }
    // Some of all kinds.
    assert!(improved > 30 && sticking > 10 && sticking < 190, "{improved} {sticking}");
}

/// A hinge that slides has its sense, in all modes and among improved ones; the others are as they
/// would be.
#[test]
fn a_hinge_that_moves_keeps_its_sense() {
    let mut compared = 0;
    for k in 0..12 {
        let rate = [0.8, -0.8, 2.0][k % 3];
        let mut start = [0.0; 10];
        start[..5].iter_mut().enumerate().for_each(|(i, angle)| *angle = 0.1 * ((i * k) % 5) as f64 - 0.2);
        start[9] = rate;
        let (context, state) = evaluate_chain(start);
        let place = HingeProblem::new(&context, state);
        let slides = |hinge: usize| place.slips[context.layout().contacts[hinge].friction.unwrap()].velocity;
        let known = |hinge: usize| match slides(hinge) {
            v if v > 0.0 => SlipVelocity::Forward,
            v if v < 0.0 => SlipVelocity::Backward,
            _ => SlipVelocity::Rest,
        };
        let slips: Vec<(usize, SlipVelocity)> = (0..5).map(|hinge| (hinge, known(hinge))).collect();
        assert_eq!(slips.iter().filter(|(_, slip)| *slip != SlipVelocity::Rest).count(), 1);
        let question =
            ContactProblem { touching: (0..5).collect(), slips: &slips, ..ContactProblem::default() };
        let options = choices(context.layout(), &question);
        let all = search::all(&place, &options);
        let [found] = &all[..] else { panic!("{} motions", all.len()) };
        let moving = slips.iter().find(|(_, slip)| *slip != SlipVelocity::Rest).unwrap().0;
        assert_eq!(f64::from(found.set.slip(moving).sign()), slides(moving).signum(), "{k}");
        let Some(improved) = search::improved(&place, &options, usize::MAX) else { continue };
        assert_eq!(improved[0].set, found.set, "{k}");
        compared += 1;
    }
    assert!(compared > 6, "{compared}");
}

#[test]
fn all_senses_are_distinguished() {
    let mut senses: Vec<Vec<f64>> = policy::all(4).collect();
    senses.sort_by(|a, b| a.partial_cmp(b).unwrap());
    senses.dedup();
    assert_eq!(senses.len(), 81);
}

/// A chain at some state.
fn evaluate_chain(state: [f64; 10]) -> (RunContext, Numbers) {
    let model = Model::new(&Chain { m: 1.0, l: 1.0, mu: 0.3, r: 0.05, p: 3.0, q: 2.0, g: 9.81 });
    let scales = scales_of(&model).unwrap();
    (RunContext { model, scales }, Numbers::from_slice(&state))
}

/// With accelerations a + (b − a) τ/Δt the rates gain (a + b) Δt/2, the coordinates u Δt + (2 a +
/// b) Δt²/6.
#[test]
fn a_moment_later_the_state_has_moved() {
    let dt = |context: &RunContext, state: &Numbers| {
        let still = HingeProblem::new(context, state.clone());
        still.moved(&[1.0; 5], &[1.0; 5])[5] - state[5]
    };
    let from = [1.0, -2.0, 0.5, 0.0, 3.0];
    let to = [2.0, 1.0, 0.5, -1.0, 0.0];
    let mut start = [0.0; 10];
    let (context, state) = evaluate_chain(start);
    let dt = dt(&context, &state);
    assert!(dt > 0.0);
    // Rates so small that the turn by them is no larger than by the accelerations, and zero.
    for rate in [0.0, dt, -dt] {
        start[5..].fill(rate);
        let (context, state) = evaluate_chain(start);
        let moved = HingeProblem::new(&context, state).moved(&from, &to);
        for i in 0..5 {
            let gained = 0.5 * (from[i] + to[i]) * dt;
            assert!((moved[5 + i] - rate - gained).abs() <= 1e-9 * dt, "{rate} {i}");
            let turned = rate * dt + (2.0 * from[i] + to[i]) / 6.0 * dt * dt;
            assert!((moved[i] - turned).abs() <= 1e-9 * dt * dt, "{rate} {i}");
        }
    }
}

/// What a motion is: its closed contacts with their slips, its accelerations, and whether its
/// reactions are the only ones.
fn found(set: ContactSet, acceleration: f64, unique: bool) -> HingeCandidate {
    let reactions = Numbers::from_slice(&[if unique { 1.0 } else { 2.0 }; 10]);
    let accelerations = Numbers::from_slice(&[acceleration, 0.0, 0.0, 0.0, 0.0]);
    HingeCandidate { choice: Vec::new(), set, accelerations, reactions, unique }
}

/// Fewest closed contacts, then most that stick, then unique reactions; one motion is told once.
#[test]
fn of_several_motions_one_is_taken_and_all_are_reported() {
    use crate::model::Slip::{Backward, Forward, Stick};
    let (context, state) = evaluate_chain([0.1; 10]);
    let place = HingeProblem::new(&context, state);
    let set = |slips: &[crate::model::Slip]| {
        let each = slips.iter().enumerate();
        each.fold(ContactSet::EMPTY, |set, (contact, slip)| set.slipping(contact, *slip))
    };
    let [less, stuck, slid] = [set(&[Forward]), set(&[Stick, Forward]), set(&[Backward, Forward])];
    let taken = |motions: &[(ContactSet, f64, bool)], complete: bool| {
        // In any order.
        let forth = motions.iter().map(|it| found(it.0, it.1, it.2)).collect();
        let back = motions.iter().rev().map(|it| found(it.0, it.1, it.2)).collect();
        let [one, other] = [forth, back].map(|motions| place.taken(motions, complete).unwrap());
        assert_eq!((one.closed, one.unique), (other.closed, other.unique));
        assert_eq!(one.reactions, other.reactions);
        let told = one.alternatives.map(|it| (it.motions.len(), it.reason, it.complete));
        (one.closed, one.unique, told)
    };
    assert!(place.taken(Vec::new(), true).is_none());
    assert_eq!(taken(&[(stuck, 1.0, true)], true), (stuck, true, None));
    assert_eq!(taken(&[(stuck, 1.0, true)], false), (stuck, true, Some((1, Reason::Only, false))));
    assert_eq!(taken(&[(stuck, 1.0, false), (stuck, 1.0, true)], true), (stuck, true, None));
    assert_eq!(taken(&[(slid, 1.0, true), (stuck, 1.0, false)], true), (stuck, false, None));
    let sticks = (stuck, true, Some((2, Reason::Sticks, true)));
    assert_eq!(taken(&[(slid, 1.0, true), (stuck, 2.0, true)], true), sticks);
    let opens = |complete| (less, true, Some((2, Reason::LiftOff, complete)));
    assert_eq!(taken(&[(less, 1.0, true), (stuck, 2.0, true)], true), opens(true));
    assert_eq!(taken(&[(less, 1.0, true), (stuck, 2.0, true)], false), opens(false));
    assert_eq!(taken(&[(less, 1.0, true), (stuck, 1.0 + 1e-10, true)], true), (less, true, None));
    let three = taken(&[(less, 1.0, true), (stuck, 2.0, true), (slid, -1.0, true)], true);
    assert_eq!(three, (less, true, Some((3, Reason::LiftOff, true))));
}

/// A bar on a pin with friction, its end on a floor without.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[support(B = floor)]
#[coordinate(a = angle(AB), from = right)]
#[figure(B = (l, 0))]
pub(super) struct Resting {
    pub(super) m: f64,
    pub(super) l: f64,
    pub(super) mu: f64,
    pub(super) r: f64,
    pub(super) g: f64,
}

/// One that opens must not fall, unless that is known; one that is closed must press, unless it is
/// held.
#[test]
fn each_choice_has_its_laws() {
    let model = Model::new(&Resting { m: 2.0, l: 0.5, mu: 0.3, r: 0.02, g: 9.81 });
    let scales = scales_of(&model).unwrap();
    let context = RunContext { model, scales };
    let place = HingeProblem::new(&context, Numbers::from_slice(&[0.0; 2]));
    let layout = context.layout();
    let support = (0..2).find(|&contact| !layout.contacts[contact].is_hinge()).unwrap();
    let touching = ContactSet::EMPTY.with(support);
    let options = |question: ContactProblem| {
        choices(layout, &question).into_iter().find(|it| it.0 == support).unwrap().1
    };
    let asked = options(ContactProblem { touching, ..ContactProblem::default() });
    let held = options(ContactProblem { touching, held: touching, ..ContactProblem::default() });
    let unloaded = options(ContactProblem { touching, unloaded: touching, ..ContactProblem::default() });
    // Closed or open, closed, open.
    assert_eq!(
        [&asked, &held, &unloaded].map(|it| it.iter().map(|it| it.is_open).collect::<Vec<_>>()),
        [vec![false, true], vec![false], vec![true]]
    );
    let laws = |choice| place.laws(&place.answer(vec![(support, choice)]).unwrap());
    let margins = |choice| laws(choice).iter().map(|law| law.margin).collect::<Vec<f64>>();
    let all = [asked[0], asked[1], held[0], unloaded[0]].map(margins);
    assert_eq!(all.each_ref().map(Vec::len), [1, 1, 0, 0]);
    // N = m g / 2, and the end falls with ¾ · 2 g.
    assert!((all[0][0] - 0.5 * 2.0 * 9.81).abs() < 1e-9 && (all[1][0] + 1.5 * 9.81).abs() < 1e-9, "{all:?}");
}

/// A body that is guided and lies on the floor, with a bar on a hinge at its corner.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[hinge(B, friction = mu, radius = r)]
#[slider(A = horizontal(0), friction = mu)]
#[point(G = BC, at = l / 2)]
#[support(C = floor, friction = mu)]
#[support(G = floor)]
#[coordinate(x = x(A))]
#[coordinate(a = angle(AB), from = right)]
#[coordinate(b = angle(BC), from = right)]
#[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0))]
struct Guided {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    g: f64,
}

/// A guide or hinge never opens, and a guide presses to either side; what is held does not open,
/// what is unloaded does. The sense of a slip that is known is not asked for.
#[test]
fn contacts_have_the_choices_of_their_kinds() {
    use crate::model::{ContactKind, Side, Slip as Slips};
    let model = Model::new(&Guided { m: 1.0, l: 1.0, mu: 0.3, r: 0.02, g: 9.81 });
    let layout = model.layout();
    let of = |is: &dyn Fn(usize) -> bool| (0..layout.contacts.len()).find(|&contact| is(contact)).unwrap();
    let guide = of(&|it| layout.contacts[it].kind == ContactKind::Guide);
    let hinge = of(&|it| layout.contacts[it].is_hinge());
    let rubs = of(&|it| it != guide && it != hinge && layout.contacts[it].friction.is_some());
    let smooth = of(&|it| layout.contacts[it].friction.is_none());
    let all: ContactSet = [guide, hinge, rubs, smooth].into_iter().collect();
    let senses = [Slips::Stick, Slips::Forward, Slips::Backward].map(Some);
    for (known, slips) in [
        (SlipVelocity::Rest, &senses[..]),
        (SlipVelocity::Forward, &senses[1..2]),
        (SlipVelocity::Leaves(crate::contact::friction::SlipDirection::Forward), &senses[1..2]),
        (SlipVelocity::Backward, &senses[2..]),
    ] {
        let slipping: Vec<(usize, SlipVelocity)> =
            [guide, hinge, rubs].map(|contact| (contact, known)).to_vec();
        let question = ContactProblem { touching: all, slips: &slipping, ..ContactProblem::default() };
        let told = |question: &ContactProblem, contact: usize| {
            let options = choices(layout, question).into_iter().find(|it| it.0 == contact).unwrap().1;
            let known_ones = options.iter().filter(|it| !it.is_open);
            assert!(
                contact == smooth
                    || known_ones.clone().all(|it| it.is_known == (known != SlipVelocity::Rest))
            );
            let closed = known_ones.map(|it| (it.slip, it.side)).collect::<Vec<_>>();
            (closed, options.iter().filter(|it| it.is_open).count())
        };
        let on = |side: Side| slips.iter().map(move |slip| (*slip, side));
        let both: Vec<_> =
            slips.iter().flat_map(|slip| [(*slip, Side::Positive), (*slip, Side::Negative)]).collect();
        let positive: Vec<_> = on(Side::Positive).collect();
        assert_eq!(told(&question, guide), (both.clone(), 0), "{known:?}");
        assert_eq!(told(&question, hinge), (positive.clone(), 0), "{known:?}");
        assert_eq!(told(&question, rubs), (positive.clone(), 1), "{known:?}");
        assert_eq!(told(&question, smooth), (vec![(None, Side::Positive)], 1), "{known:?}");
        let held = ContactProblem { held: all, ..question };
        assert_eq!([guide, hinge, rubs, smooth].map(|it| told(&held, it).1), [0; 4], "{known:?}");
        let unloaded = ContactProblem { unloaded: all, ..question };
        assert_eq!(told(&unloaded, guide), (both, 0), "{known:?}");
        assert_eq!(told(&unloaded, hinge), (positive, 0), "{known:?}");
        assert_eq!([rubs, smooth].map(|it| told(&unloaded, it)), [(vec![], 1), (vec![], 1)], "{known:?}");
    }
}

/// Accelerations are one up to 1e-8 of the larger, or of the natural one.
#[test]
fn accelerations_that_differ_by_rounding_are_one() {
    let (context, state) = evaluate_chain([0.0; 10]);
    let natural = 1.0 / (context.scales.time * context.scales.time);
    let place = HingeProblem::new(&context, state);
    let of = |acceleration: f64| found(ContactSet::EMPTY, acceleration, true);
    for size in [0.0, natural, 100.0 * natural, 1e6 * natural] {
        let most = 1e-8 * size.max(natural);
        for sign in [1.0, -1.0] {
            assert!(place.are_one(&of(sign * size), &of(sign * (size + 0.9 * most))), "{size}");
            assert!(place.are_one(&of(sign * (size + 0.9 * most)), &of(sign * size)), "{size}");
            assert!(!place.are_one(&of(sign * size), &of(sign * (size + 1.1 * most))), "{size}");
        }
    }
}
