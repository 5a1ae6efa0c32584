//! Event indicators for model exchange: one function of the state for each way in which the contact
//! set may change, positive until it does.
//!
//! | contact | indicator | positive while |
//! |---|---|---|
//! | open, over a bar | max(g, −d) | g > 0, or the corner is beyond the bar's end, d < 0 |
//! | open | g | the gap is open |
//! | closed | s N | it bears; s = 1, the sign of the side of a guide |
//! | closed, sticking | μ \|N\| − \|R\| | friction is below its limit |
//! | closed, sliding | σ v | it slips on |
//! | closed, over a bar | d | the corner is between the bar's ends |

use liftoff_core::model::Layout;
use liftoff_studio::RunSpec;

/// An event indicator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guard {
    /// The gap or the reaction of a contact.
    Normal(usize),
    /// The slip or the friction limit of a contact.
    Friction(usize),
    /// The distance of a contact's corner to the nearer end of its bar.
    End(usize),
}

impl Guard {
    /// All of a model, in the order of its contacts.
    pub fn all(layout: &Layout) -> Vec<Self> {
        let of = |(i, contact): (usize, &liftoff_core::model::Contact)| {
            let friction = contact.friction.map(|_| Self::Friction(i));
            [Some(Self::Normal(i)), friction, contact.foot.map(|_| Self::End(i))]
        };
        layout.contacts.iter().enumerate().flat_map(of).flatten().collect()
    }

    /// Its contact.
    pub fn contact(self) -> usize {
        let (Self::Normal(contact) | Self::Friction(contact) | Self::End(contact)) = self;
        contact
    }

    /// Its name among the variables.
    pub(crate) fn name(self, layout: &Layout) -> String {
        let label = layout.contacts[self.contact()].label;
        match self {
            Self::Normal(_) => format!("guard({label})"),
            Self::Friction(_) => format!("guard({label}, friction)"),
            Self::End(_) => format!("guard({label}, end of bar)"),
        }
    }
}

/// Why a model cannot be exchanged: events that are no zeros of these indicators.
pub fn exchange_lacks(layout: &Layout, spec: &RunSpec) -> Option<&'static str> {
    let reasons = [
        (layout.has_hinges(), "friction in hinges"),
        (!layout.switches.is_empty(), "springs or loads on conditions"),
        (
            layout.contacts.iter().any(|contact| contact.armed.or(contact.breaks).is_some()),
            "supports or drives on conditions",
        ),
        (!spec.release.is_empty() || !spec.cut.is_empty(), "supports or threads that vanish"),
        (!spec.impulses.is_empty(), "impulses"),
        (!spec.hold.is_empty(), "supports that are held"),
    ];
    reasons.into_iter().find_map(|(has, what)| has.then_some(what))
}
