//! Curves in the plane of two varied names across which what is observed changes, followed by
//! continuation: from a point x of a curve with the unit tangent t and the normal n, in parts of
//! the ranges,
//!
//! ```text
//! y = x + h t,    x′ on y + s n, where what is observed changes from the one to the other,    t′ ∥ x′ − x
//! ```
//!
//! A curve is found on a coarse grid and followed both ways, to the edge of the ranges, to itself,
//! or to where a third outcome meets the two. No derivative is taken: a contact that touches and
//! one that is first are found alike.

use core::fmt;

use super::criterion::Criterion;
use super::plan::Plan;
use super::{Range, Spread, SweepError, Varied};

/// Cells along each range where no count is given.
const COARSE: usize = 8;
/// Steps along a curve, in parts of the ranges.
const FIRST: f64 = 1e-3;
const LARGEST: f64 = 1.0 / 32.0;
const SMALLEST: f64 = 1e-4;
const GROWTH: f64 = 1.5;
/// By how much a curve turns in a step at most: the cosine of an eighth of a turn.
const TURN: f64 = 0.7;
/// By how much its first direction may differ from one across the grid, rad.
const TURNS: [f64; 7] = [0.0, 0.5, -0.5, 1.0, -1.0, 1.4, -1.4];
/// How far from the step the curve is looked for, in steps.
const REACH: [f64; 4] = [0.05, 0.2, 0.5, 1.0];
/// A third outcome between two within this, in parts of the ranges, is that of events which the
/// tolerance of runs takes for one.
const SLIVER: f64 = 1e-6;
/// Parts of a bracket of which the ends are looked at together.
const PARTS: usize = 8;
/// Changes on an edge of the grid.
const MOST_CHANGES: usize = 4;
const MOST_POINTS: usize = 10_000;

/// A curve across which what is observed changes.
#[derive(Clone, PartialEq, Debug)]
pub struct Boundary {
    /// What is observed to the left of its direction.
    pub left: String,
    /// What is observed to the right of it.
    pub right: String,
    /// Values of the two varied names along it.
    pub points: Vec<[f64; 2]>,
    /// How it ends at its first point and at its last.
    pub ends: [BoundaryEnd; 2],
}

/// Where a boundary ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BoundaryEnd {
    /// At the edge of the ranges.
    Edge,
    /// It comes back to itself.
    Closed,
    /// Where a third outcome begins.
    Meets(String),
    /// It turns more sharply than it is followed.
    Corner,
    /// It is longer than it is followed.
    Long,
}

impl fmt::Display for BoundaryEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edge => f.write_str("the edge"),
            Self::Closed => f.write_str("its start"),
            Self::Meets(third) => write!(f, "where `{third}` begins"),
            Self::Corner => f.write_str("a corner"),
            Self::Long => f.write_str("where it becomes too long"),
        }
    }
}

/// A place in parts of the ranges.
type Place = [f64; 2];

/// Outcomes on both sides of a curve.
#[derive(Clone, PartialEq)]
struct Sides {
    left: String,
    right: String,
}

/// A part of a curve: from where on, in which direction.
#[derive(Clone)]
struct Heading {
    place: Place,
    tangent: Place,
    sides: Sides,
}

/// Finds and follows curves.
struct Tracer<'a> {
    plan: &'a Plan<'a>,
    criterion: &'a Criterion,
    ranges: [Range; 2],
    /// How narrow a bracket becomes, in parts of the ranges.
    width: f64,
}

/// All boundaries between outcomes, each to within `width`, a part of the ranges.
pub(super) fn boundaries(
    plan: &Plan<'_>,
    varied: &[Varied],
    criterion: &Criterion,
    width: f64,
) -> Result<Vec<Boundary>, SweepError> {
    let [first, second] = varied else {
        return Err(SweepError::Invalid("boundaries are curves in the plane of two varied names".into()));
    };
    criterion.check(plan.observations, plan.model.layout())?;
    if !(width > 0.0 && width < SLIVER) {
        return Err(SweepError::Invalid(format!("a width above zero and below {SLIVER}, not {width}")));
    }
    let [(first, columns), (second, rows)] = [spread(first)?, spread(second)?];
    Tracer { plan, criterion, ranges: [first, second], width }.all([columns, rows])
}

/// The range of a varied name and the number of cells along it.
fn spread(varied: &Varied) -> Result<(Range, usize), SweepError> {
    match varied.spread {
        Spread::Anywhere(range) => Ok((range, COARSE)),
        Spread::Grid(range, count) => Ok((range, count - 1)),
        Spread::Listed(_) => {
            Err(SweepError::Invalid(format!("`{}` is varied over a range, low:high", varied.name)))
        }
    }
}

impl Tracer<'_> {
    /// Curves from every edge of the grid across which the outcome changes.
    fn all(&self, [columns, rows]: [usize; 2]) -> Result<Vec<Boundary>, SweepError> {
        let place = |i: usize, j: usize| [i as f64 / columns as f64, j as f64 / rows as f64];
        let across = (0..=rows).flat_map(|j| (0..columns).map(move |i| [(i, j), (i + 1, j)]));
        let upward = (0..rows).flat_map(|j| (0..=columns).map(move |i| [(i, j), (i, j + 1)]));
        let mut found: Vec<(Vec<Place>, Boundary)> = Vec::new();
        let edges: Vec<[Place; 2]> =
            across.chain(upward).map(|ends| ends.map(|(i, j)| place(i, j))).collect();
        let labels = self.labels(&edges.concat())?;
        for ([from, to], labels) in edges.iter().zip(labels.chunks(2)) {
            if labels[0] == labels[1] {
                continue;
            }
            for start in self.changes((*from, *to), (&labels[0], &labels[1]))? {
                let is_known = |(places, of): &(Vec<Place>, Boundary)| {
                    let same = [&of.left, &of.right].contains(&&start.sides.left)
                        && [&of.left, &of.right].contains(&&start.sides.right);
                    same && passes(places, start.place)
                };
                if !found.iter().any(is_known) {
                    found.push(self.curve(start)?);
                }
            }
        }
        Ok(found.into_iter().map(|(_, boundary)| boundary).collect())
    }

    /// Changes from one end of an edge to the other, each with a guess of its direction, across the
    /// edge.
    fn changes(
        &self,
        (mut from, to): (Place, Place),
        (left, right): (&str, &str),
    ) -> Result<Vec<Heading>, SweepError> {
        let along = direction(from, to);
        let (mut left, mut found) = (left.to_owned(), Vec::new());
        while left != *right && found.len() < MOST_CHANGES {
            let place = self.edge_of(&left, from, to)?;
            from = moved(place, along, SLIVER);
            let next = self.labels(&[from])?.remove(0);
            let sides = Sides { left, right: next.clone() };
            // Left of the direction is where the edge comes from.
            found.push(Heading {
                place: moved(place, along, 0.5 * SLIVER),
                tangent: [-along[1], along[0]],
                sides,
            });
            left = next;
        }
        for heading in &mut found {
            let n = normal(heading.tangent);
            let [a, b] = [SLIVER, -SLIVER].map(|by| moved(heading.place, n, by));
            heading.place = self.crossing(&heading.sides, a, b)?.unwrap_or(heading.place);
        }
        Ok(found)
    }

    /// A curve both ways from a place on it.
    fn curve(&self, start: Heading) -> Result<(Vec<Place>, Boundary), SweepError> {
        let (ahead, last) = self.followed(start.clone())?;
        let back = Heading {
            tangent: start.tangent.map(|x| -x),
            sides: Sides { left: start.sides.right.clone(), right: start.sides.left.clone() },
            ..start.clone()
        };
        let (mut places, first) = match last {
            BoundaryEnd::Closed => (Vec::new(), BoundaryEnd::Closed),
            _ => self.followed(back)?,
        };
        places.reverse();
        places.push(start.place);
        places.extend(ahead);
        let values = |place: &Place| [0, 1].map(|k| self.ranges[k].interpolate(place[k]));
        let points = places.iter().map(values).collect();
        let Sides { left, right } = start.sides;
        Ok((places, Boundary { left, right, points, ends: [first, last] }))
    }

    /// The places of a curve ahead, and how it ends.
    fn followed(&self, start: Heading) -> Result<(Vec<Place>, BoundaryEnd), SweepError> {
        let Some((mut place, mut step)) = self.first_step(&start)? else {
            return Ok((Vec::new(), self.third(&start, SMALLEST)?));
        };
        let mut tangent = direction(start.place, place);
        let mut places = vec![place];
        while places.len() < MOST_POINTS {
            let here = Heading { place, tangent, sides: start.sides.clone() };
            if let Some(room) = room(place, tangent).filter(|room| *room <= step) {
                places.extend(self.at_edge(&here, room)?);
                return Ok((places, BoundaryEnd::Edge));
            }
            let next = self.next(&here, step)?;
            let next = next.filter(|next| dot(direction(place, *next), tangent) >= TURN);
            match next {
                Some(next) => {
                    tangent = direction(place, next);
                    places.push(next);
                    place = next;
                    let closes = places.len() > 3 && distance(place, start.place) <= step;
                    if closes && dot(tangent, direction(place, start.place)) > 0.0 {
                        return Ok((places, BoundaryEnd::Closed));
                    }
                    step = LARGEST.min(step * GROWTH);
                }
                None if step > SMALLEST => step *= 0.5,
                None => return Ok((places, self.third(&here, step)?)),
            }
        }
        Ok((places, BoundaryEnd::Long))
    }

    /// The first step, in whichever direction the curve has.
    fn first_step(&self, start: &Heading) -> Result<Option<(Place, f64)>, SweepError> {
        for turn in TURNS {
            let (sin, cos) = f64::sin_cos(turn);
            let [x, y] = start.tangent;
            let turned = Heading { tangent: [cos * x - sin * y, sin * x + cos * y], ..start.clone() };
            let inside = moved(start.place, turned.tangent, FIRST).iter().all(|x| (0.0..=1.0).contains(x));
            if let Some(next) = if inside { self.next(&turned, FIRST)? } else { None } {
                return Ok(Some((next, FIRST)));
            }
        }
        Ok(None)
    }

    /// The place of the curve a step ahead.
    fn next(&self, here: &Heading, step: f64) -> Result<Option<Place>, SweepError> {
        let (ahead, n) = (moved(here.place, here.tangent, step), normal(here.tangent));
        self.across(&here.sides, ahead, n, step)
    }

    /// The place of the curve at the edge of the ranges.
    fn at_edge(&self, here: &Heading, room: f64) -> Result<Option<Place>, SweepError> {
        let ahead = moved(here.place, here.tangent, room).map(|x| x.clamp(0.0, 1.0));
        let lies = |k: usize| ahead[k] <= f64::EPSILON || ahead[k] >= 1.0 - f64::EPSILON;
        let along = if lies(0) { [0.0, 1.0] } else { [1.0, 0.0] };
        let sign = dot(along, normal(here.tangent)).signum();
        self.across(&here.sides, ahead, along.map(|x| sign * x), room.max(SMALLEST))
    }

    /// The change from the left side to the right one nearest to a place, along a direction that
    /// points to the left.
    fn across(&self, sides: &Sides, at: Place, n: Place, step: f64) -> Result<Option<Place>, SweepError> {
        let ends =
            |reach: &f64| [reach * step, -reach * step].map(|by| moved(at, n, by).map(|x| x.clamp(0.0, 1.0)));
        let pairs: Vec<[Place; 2]> = REACH.iter().map(ends).collect();
        let labels = self.labels(&pairs.concat())?;
        let bracket = pairs.iter().zip(labels.chunks(2));
        let mut bracket = bracket.filter(|(_, labels)| labels[0] == sides.left && labels[1] == sides.right);
        match bracket.next() {
            Some(([a, b], _)) => self.crossing(sides, *a, *b),
            None => Ok(None),
        }
    }

    /// The place between two at which the one side ends and the other begins, if nothing but a
    /// sliver lies between.
    fn crossing(&self, sides: &Sides, a: Place, b: Place) -> Result<Option<Place>, SweepError> {
        let left = self.edge_of(&sides.left, a, b)?;
        let right = self.edge_of(&sides.right, b, a)?;
        let middle = [0, 1].map(|k| 0.5 * (left[k] + right[k]));
        Ok((distance(left, right) <= SLIVER).then_some(middle))
    }

    /// Where on the way from one place to another an outcome ends.
    fn edge_of(&self, label: &str, mut from: Place, mut to: Place) -> Result<Place, SweepError> {
        while distance(from, to) > self.width {
            let at = |k: usize| {
                let part = k as f64 / PARTS as f64;
                [0, 1].map(|i| from[i] + part * (to[i] - from[i]))
            };
            let places: Vec<Place> = (0..=PARTS).map(at).collect();
            let labels = self.labels(&places[1..PARTS])?;
            let changed = labels.iter().position(|other| other != label).map_or(PARTS, |k| k + 1);
            if places[changed - 1] == from && places[changed] == to {
                break;
            }
            (from, to) = (places[changed - 1], places[changed]);
        }
        Ok([0, 1].map(|k| 0.5 * (from[k] + to[k])))
    }

    /// What begins where a curve ends.
    fn third(&self, here: &Heading, step: f64) -> Result<BoundaryEnd, SweepError> {
        let ahead = moved(here.place, here.tangent, 4.0 * step);
        let around = [-4.0, -1.0, 0.0, 1.0, 4.0].map(|by| moved(ahead, normal(here.tangent), by * step));
        let labels = self.labels(&around.map(|place| place.map(|x| x.clamp(0.0, 1.0))))?;
        let other = labels.into_iter().find(|label| ![&here.sides.left, &here.sides.right].contains(&label));
        Ok(other.map_or(BoundaryEnd::Corner, BoundaryEnd::Meets))
    }

    fn labels(&self, places: &[Place]) -> Result<Vec<String>, SweepError> {
        let values = |place: &Place| [0, 1].map(|k| self.ranges[k].interpolate(place[k])).to_vec();
        let rows = self.plan.rows(places.iter().map(values).collect())?;
        if rows.len() < places.len() {
            return Err(SweepError::Interrupted);
        }
        Ok(rows.iter().map(|row| self.criterion.label(&row.outcome)).collect())
    }
}

fn moved(from: Place, along: Place, by: f64) -> Place {
    [0, 1].map(|k| from[k] + by * along[k])
}

fn distance(a: Place, b: Place) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

fn direction(a: Place, b: Place) -> Place {
    let length = distance(a, b);
    [0, 1].map(|k| (b[k] - a[k]) / length)
}

/// To the left.
fn normal([x, y]: Place) -> Place {
    [-y, x]
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// How far the edge of the ranges is ahead.
fn room(place: Place, tangent: Place) -> Option<f64> {
    let along = |k: usize| match tangent[k] {
        t if t > 0.0 => (1.0 - place[k]) / t,
        t if t < 0.0 => -place[k] / t,
        _ => f64::INFINITY,
    };
    let room = along(0).min(along(1));
    room.is_finite().then_some(room)
}

/// Whether a curve passes a place, as closely as its chords follow it.
fn passes(places: &[Place], at: Place) -> bool {
    places.windows(2).any(|chord| {
        let (length, along) = (distance(chord[0], chord[1]), direction(chord[0], chord[1]));
        let from = [at[0] - chord[0][0], at[1] - chord[0][1]];
        let (s, off) = (dot(from, along), dot(from, normal(along)));
        (-0.1 * length..=1.1 * length).contains(&s) && off.abs() <= 0.25 * length
    })
}
