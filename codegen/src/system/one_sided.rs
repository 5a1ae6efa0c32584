//! One-sided constraints: supports and threads, what they touch, how they act; and what holds both
//! ways while it is there.

use proc_macro2::Span;

use super::{Disc, Driven, Formula, Law, System, listed};
use crate::algebra::{Angle, Series};

/// A one-sided constraint: a support or a thread; or a guide with friction, or a drive on a
/// condition, which hold both ways.
#[derive(Clone, Debug)]
pub struct Support {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
    /// Its gap.
    pub contact: OneSided,
    /// The disc that touches with its rim; the point itself if absent.
    pub disc: Option<Disc>,
    /// Whether it is closed always, whatever the sign of its reaction.
    pub two_sided: bool,
    /// Whether it admits no slip while closed.
    pub rough: bool,
    /// Coulomb friction.
    pub friction: Option<Friction>,
    /// The velocity of its surface along its direction, an expression of time.
    pub moving: Option<Formula>,
    /// Restitution; plastic if absent.
    pub restitution: Option<Series>,
    /// The law of its impacts.
    pub law: Law,
    /// Whether reaching it ends a run.
    pub stop: bool,
    /// The condition that it is there on, as conditions of runs are written; always if absent.
    pub armed: Option<String>,
    /// The condition that ends it; never if absent.
    pub breaks: Option<String>,
}

/// Coefficients of Coulomb friction.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// μ of sliding; reads parameters and the slip velocity.
    pub kinetic: Formula,
    /// μₛ of sticking.
    pub limit: Series,
    /// The part of the slip velocity that an impact gives back where it would end the slip; none if
    /// absent.
    pub tangential: Option<Series>,
    /// Whether a run ends where no reaction obeys the law.
    pub jams: bool,
}

/// What may not be penetrated, or not stretched.
#[derive(Clone, Debug)]
pub enum OneSided {
    /// A point over a line.
    Line {
        /// The point.
        point: usize,
        /// A point of the line.
        through: [Series; 2],
        /// The line's direction; a quarter turn counter-clockwise from it lies the free side.
        direction: Angle,
    },
    /// A bar over (or under) a corner, along its length.
    Corner {
        /// The bar.
        body: usize,
        /// The corner.
        at: [Series; 2],
        /// +1: the gap is n·(A − corner), n the bar's left normal and A its first point; −1: its
        /// opposite.
        side: i8,
    },
    /// A point, or the disc about it, outside or inside a circle.
    Circle {
        /// The point.
        point: usize,
        /// The circle's centre.
        centre: Centre,
        /// Its radius.
        radius: Series,
        /// The least distance of the point from its centre, inside the greatest: the radius, and
        /// that of the disc that touches.
        reach: Series,
        /// Whether the point is kept inside.
        inside: bool,
    },
    /// A point on one side of an edge of a body, along its length.
    Edge {
        /// The point.
        point: usize,
        /// The edge.
        edge: Edge,
        /// +1: the point stays to the left of the edge, −1: to the right.
        side: i8,
    },
    /// What slides along a bar, before an end of it.
    Stop {
        /// The point.
        point: usize,
        /// The bar.
        body: usize,
        /// Whether it is the bar's last point.
        is_last: bool,
    },
    /// A hinge with friction: its journal turns in its bearing.
    Hinge {
        /// The point.
        point: usize,
        /// The body that turns.
        body: usize,
        /// What it turns against; the ground if absent.
        from: Option<usize>,
        /// The radius of the journal.
        radius: Series,
    },
    /// An inextensible thread through points, smooth between its ends.
    Thread {
        /// From end to end.
        path: Vec<usize>,
        /// Its length.
        length: Series,
    },
    /// A bound of what a drive could prescribe.
    Limit {
        /// What is bounded.
        driven: Driven,
        /// Its value there.
        bound: Series,
        /// Whether it is the greatest.
        is_upper: bool,
        /// What must be positive: a distance, or what is left between two bounds.
        extent: Option<Series>,
    },
    /// A drive that holds while its condition does, both ways; its index.
    Drive(usize),
}

/// The centre of a circle.
#[derive(Clone, Debug)]
pub enum Centre {
    /// A place of the ground.
    Ground([Series; 2]),
    /// A point.
    Point {
        /// The point.
        point: usize,
        /// The body that the circle turns with.
        body: Option<usize>,
    },
}

/// A straight side of a body.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The body.
    pub body: usize,
    /// The points of the body where it begins and ends.
    pub ends: [usize; 2],
    /// Its direction in the body's frame, a unit vector.
    pub along: [Series; 2],
    /// Its length.
    pub length: Series,
}

impl OneSided {
    /// The point that touches, by itself or by a disc about it.
    pub(super) fn point(&self) -> Option<usize> {
        match self {
            Self::Line { point, .. } | Self::Edge { point, .. } | Self::Circle { point, .. } => Some(*point),
            Self::Corner { .. }
            | Self::Stop { .. }
            | Self::Hinge { .. }
            | Self::Thread { .. }
            | Self::Limit { .. }
            | Self::Drive(_) => None,
        }
    }

    /// Whether it is a hinge with friction.
    pub fn is_hinge(&self) -> bool {
        matches!(self, Self::Hinge { .. })
    }

    /// Whether it pulls.
    pub fn is_thread(&self) -> bool {
        matches!(self, Self::Thread { .. })
    }

    /// The index of the drive that it is.
    pub fn drive(&self) -> Option<usize> {
        if let Self::Drive(i) = self { Some(*i) } else { None }
    }
}

impl Support {
    /// What it is, in a line of documentation.
    pub fn meaning(&self, system: &System) -> String {
        let (name, point) = (&self.name, |point: usize| &system.points[point].name);
        if self.two_sided && !self.contact.is_hinge() {
            let of = self.contact.point().map(|of| format!(" of `{}`", point(of))).unwrap_or_default();
            return format!("Slider `{name}`: a guide{of} with friction.");
        }
        match &self.contact {
            OneSided::Line { point: p, .. } => {
                format!("Support `{name}`: a line that `{}` does not pass.", point(*p))
            }
            OneSided::Corner { body, .. } => {
                format!("Support `{name}`: a corner that `{}` does not pass.", system.bodies[*body].name)
            }
            OneSided::Circle { point: p, inside, .. } => {
                let side = if *inside { "inside" } else { "outside" };
                format!("Support `{name}`: a circle, `{}` {side} it.", point(*p))
            }
            OneSided::Edge { point: p, edge, .. } => {
                let [from, to] = edge.ends.map(point);
                format!(
                    "Support `{name}`: a side from `{from}` to `{to}` that `{}` does not pass.",
                    point(*p)
                )
            }
            OneSided::Stop { point: p, body, is_last } => {
                let bar = &system.bodies[*body];
                let end = point(if *is_last { bar.to } else { bar.from });
                format!("Support `{name}`: the end `{end}` of `{}`, which stops `{}`.", bar.name, point(*p))
            }
            OneSided::Hinge { point: p, .. } => format!("Hinge `{}`: a journal with friction.", point(*p)),
            OneSided::Thread { path, .. } => {
                format!("Thread `{name}` through {}.", listed(path.iter().map(|&p| point(p))))
            }
            OneSided::Limit { is_upper, .. } => {
                format!("Limit `{name}`: a {} bound.", if *is_upper { "upper" } else { "lower" })
            }
            OneSided::Drive(i) => {
                format!("Drive `{}`, which may hold while its condition is true.", system.drives[*i].name)
            }
        }
    }

    /// A length of its own, which is positive, and what it is called.
    pub fn extent(&self) -> Option<(String, &Series)> {
        match &self.contact {
            OneSided::Thread { length, .. } => Some((format!("thread {}", self.name), length)),
            OneSided::Circle { inside: true, reach, .. } if self.disc.is_some() => {
                Some((format!("the play of {}", self.name), reach))
            }
            OneSided::Circle { radius, .. } => Some((format!("the radius of {}", self.name), radius)),
            OneSided::Limit { extent, is_upper, .. } => {
                let what = if *is_upper { "the range up to" } else { "the limit" };
                extent.as_ref().map(|extent| (format!("{what} {}", self.name), extent))
            }
            OneSided::Hinge { radius, .. } => Some((format!("the radius of hinge {}", self.name), radius)),
            OneSided::Line { .. }
            | OneSided::Corner { .. }
            | OneSided::Edge { .. }
            | OneSided::Stop { .. }
            | OneSided::Drive(_) => None,
        }
    }
}
