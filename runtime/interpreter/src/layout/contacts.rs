//! One-sided contacts.

use liftoff_codegen::Analysis;
use liftoff_codegen::motion::Contact;
use liftoff_codegen::system::Law;
use liftoff_core::model::{self, ContactKind};

use super::{list, text};

/// All of them; feet and frictions are counted in their order.
pub(super) fn contacts(analysis: &Analysis) -> &'static [model::Contact] {
    let (mut feet, mut frictions) = (0.., 0..);
    list(analysis.motion.contacts.iter().map(|of| {
        let foot = of.foot.as_ref().and_then(|_| feet.next());
        let friction = of.friction.as_ref().and_then(|_| frictions.next());
        contact(analysis, of, foot, friction)
    }))
}

fn contact(
    analysis: &Analysis,
    of: &Contact,
    foot: Option<usize>,
    friction: Option<usize>,
) -> model::Contact {
    let system = &analysis.system;
    let support = of.support(system);
    model::Contact {
        label: text(&of.label(system)),
        supports: list(of.supports.iter().map(|&support| text(&system.supports[support].name))),
        shared: of.shared,
        foot,
        kind: match () {
            () if of.is_thread(system) => ContactKind::Thread,
            () if of.two_sided => of.force.map_or(ContactKind::Guide, |force| ContactKind::Hinge { force }),
            () if of.is_turned(system) && of.driven => ContactKind::Turn,
            () if of.is_turned(system) => ContactKind::AngleLimit,
            () if of.driven => ContactKind::Drive,
            () => ContactKind::Support,
        },
        rough: support.rough,
        friction,
        jams: support.friction.as_ref().is_some_and(|friction| friction.jams),
        law: match support.law {
            Law::Newton => model::Law::Newton,
            Law::Moreau => model::Law::Moreau,
            Law::Poisson => model::Law::Poisson,
            Law::Stronge => model::Law::Stronge,
        },
        stop: support.stop,
        armed: support.armed.as_ref().map(|condition| text(condition)),
        breaks: support.breaks.as_ref().map(|condition| text(condition)),
    }
}
