//! Relations of directions: what declared coordinates, welds, equal angles and the mirror say.

use proc_macro2::Span;

use super::affine::{AffineAngle, Unknown};
use crate::algebra::Angle;
use crate::syntax::plain;
use crate::system::{ConstrainedAngle, CoordinateKind, Reference, System};

/// `affine = 0`.
pub(super) struct Relation {
    pub affine: AffineAngle,
    /// What it is solved for, where that has a unit coefficient.
    pub preferred: Option<Unknown>,
    pub subject: Subject,
    pub span: Span,
}

/// What a relation says, for messages.
pub(super) enum Subject {
    /// What a coordinate or the mirror says of an angle.
    Angle,
    /// Two angles are equal.
    Equal([String; 2]),
    /// A bar is welded to another, or to the ground.
    Weld(String),
}

/// All relations of a system.
pub(super) fn relations(system: &System) -> Vec<Relation> {
    let declared = system.coordinates.iter().enumerate().filter_map(|(i, coordinate)| {
        let CoordinateKind::Angle { body, reference, sign } = &coordinate.kind else { return None };
        let direction = Unknown::Direction(*body);
        let base = match reference {
            Reference::Ground(angle) => AffineAngle::constant(angle.clone()),
            Reference::Body(other) => AffineAngle::from_unknown(Unknown::Direction(*other)),
        };
        let affine = AffineAngle::from_unknown(direction)
            .plus(-1, &base)
            .plus(-i32::from(*sign), &AffineAngle::from_unknown(Unknown::Declared(i)));
        let subject = Subject::Angle;
        Some(Relation { affine, preferred: Some(direction), subject, span: coordinate.name.span() })
    });
    let equal = system.equal.iter().map(|equal| Relation {
        affine: AffineAngle::constant(Angle::zero())
            .plus(equal.factors[0], &unknown(&equal.left))
            .plus(-equal.factors[1], &unknown(&equal.right)),
        preferred: None,
        subject: Subject::Equal(
            [(equal.factors[0], &equal.left), (equal.factors[1], &equal.right)]
                .map(|side| label(system, side)),
        ),
        span: equal.span,
    });
    declared.chain(welded(system)).chain(mirrored(system)).chain(equal).collect()
}

fn welded(system: &System) -> impl Iterator<Item = Relation> + '_ {
    system.welds.iter().map(|weld| {
        let direction = Unknown::Direction(weld.body);
        let own = AffineAngle::from_unknown(direction).plus(-1, &AffineAngle::constant(weld.angle.clone()));
        let name = |body: usize| &system.bodies[body].name;
        let (affine, subject) = match weld.to {
            None => (own, format!("the direction of `{}`", name(weld.body))),
            Some(other) => (
                own.plus(-1, &AffineAngle::from_unknown(Unknown::Direction(other))),
                format!("the weld of `{}` to `{}`", name(weld.body), name(other)),
            ),
        };
        Relation { affine, preferred: Some(direction), subject: Subject::Weld(subject), span: weld.span }
    })
}

fn label(system: &System, (factor, direction): (i32, &ConstrainedAngle)) -> String {
    let name = match direction {
        ConstrainedAngle::Body(body) => format!("angle({})", system.bodies[*body].name),
        ConstrainedAngle::Coordinate(i) => plain(&system.coordinates[*i].name),
    };
    match factor {
        1 => name,
        -1 => format!("−{name}"),
        _ => format!("{factor} {name}"),
    }
}

fn unknown(direction: &ConstrainedAngle) -> AffineAngle {
    AffineAngle::from_unknown(match direction {
        ConstrainedAngle::Body(body) => Unknown::Direction(*body),
        ConstrainedAngle::Coordinate(i) => Unknown::Declared(*i),
    })
}

/// Reflection in a vertical line sends `δ` to `π − δ`, in a horizontal one to `−δ`; exchanged ends
/// add π.
fn mirrored(system: &System) -> impl Iterator<Item = Relation> + '_ {
    system.mirror.iter().flat_map(|mirror| {
        mirror.bodies.iter().enumerate().filter(|(body, (image, _))| body <= image).map(
            |(body, &(image, _))| Relation {
                affine: AffineAngle::from_unknown(Unknown::Direction(body))
                    .plus(1, &AffineAngle::from_unknown(Unknown::Direction(image)))
                    .plus(-1, &AffineAngle::constant(mirror.sum_of_directions(body))),
                preferred: None,
                subject: Subject::Angle,
                span: mirror.span,
            },
        )
    })
}
