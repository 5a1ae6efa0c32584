//! Threads: `g = ℓ − Σ |segments|`, polynomial where only one segment moves.
//!
//! With `d` the length of a segment between `a` and `b`, `r = b − a`: `ḋ = r·ṙ / d`, and without
//! accelerations `d̈ = ((r×ṙ)² / d² + r·β) / d`, β what r̈ is without them; a difference of ṙ·ṙ and
//! ḋ² would lose digits.

use super::action::{Action, Scene};
use super::expression::{Expression, OpaqueTerms};
use super::measured::{Measured, inverse};
use super::row::{Row, bias};
use super::{Vector, dot};
use crate::algebra::{Rational, Series, Symbol};

/// A part of a thread between two of its points.
struct Segment {
    ends: [usize; 2],
    /// From the first end to the second.
    span: Vector,
}

impl Segment {
    fn moves(&self) -> bool {
        self.span.iter().any(|part| part.symbols().iter().any(|s| matches!(s, Symbol::Coordinate { .. })))
    }

    fn length(&self) -> Expression {
        Expression::series(dot(&self.span, &self.span)).sqrt()
    }

    /// What d̈ is without accelerations, its factors not multiplied out.
    fn curvature(&self, rate: &Vector, n: usize) -> Expression {
        let [[x, y], [u, v]] = [&self.span, rate].map(|part| part.clone().map(Expression::series));
        let [alpha, beta] = self.span.each_ref().map(|part| Expression::series(bias(part, n)));
        let inverse = || Expression::series(Series::one()).over(self.length());
        let across = x.clone().times(v).minus(y.clone().times(u)).times(inverse());
        across.clone().times(across).plus(x.times(alpha).plus(y.times(beta))).times(inverse())
    }

    /// The forces of a unit tension: towards the other end.
    fn pull(&self, scene: &Scene, inverse: &Series) -> [Action; 2] {
        let towards = self.span.each_ref().map(|part| part * inverse);
        let back = towards.each_ref().map(|part| -part);
        [Action::at_point(scene, self.ends[0], towards), Action::at_point(scene, self.ends[1], back)]
    }
}

pub(super) fn measure(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    name: &str,
    path: &[usize],
    length: &Series,
) -> Measured {
    let points = &scene.kinematics.points;
    let segments = path.windows(2).map(|pair| Segment {
        ends: [pair[0], pair[1]],
        span: [0, 1].map(|axis| &points[pair[1]][axis] - &points[pair[0]][axis]),
    });
    let (moving, fixed): (Vec<Segment>, Vec<Segment>) = segments.partition(Segment::moves);
    let fixed: Series =
        fixed.iter().map(|segment| opaque_terms.symbol(&format!("part of {name}"), segment.length())).sum();
    let free = length - &fixed;
    let (row, actions) = match &moving[..] {
        [segment] => polynomial(scene, opaque_terms, segment, &free),
        _ => rooted(scene, opaque_terms, name, &moving, &free),
    };
    Measured { row, foot: None, tangent: None, actions: [actions, Vec::new()] }
}

/// One moving segment.
fn polynomial(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    segment: &Segment,
    free: &Series,
) -> (Row, Vec<Action>) {
    let inverse = inverse(opaque_terms, free);
    let slack = &(free * free) - &dot(&segment.span, &segment.span);
    let gap = (&slack * &inverse).scale(Rational::new(1, 2));
    let mut row = Row::from_gap(&gap, scene.n());
    // The opaque terms of a thread are constants.
    row.prescribed_gap_rate = Series::zero();
    row.bias = -(&bias(&dot(&segment.span, &segment.span), scene.n()) * &inverse).scale(Rational::new(1, 2));
    (row, segment.pull(scene, &inverse).into())
}

/// Several moving segments: their lengths are roots.
fn rooted(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    name: &str,
    segments: &[Segment],
    free: &Series,
) -> (Row, Vec<Action>) {
    let n = scene.n();
    let (mut gap, mut curved) = (free.clone(), Series::zero());
    let mut jacobian = vec![Series::zero(); n];
    let mut actions = Vec::new();
    for (k, segment) in segments.iter().enumerate() {
        let one = Expression::series(Series::one());
        gap -= opaque_terms.symbol(&format!("d{}_{name}", k + 1), segment.length());
        let inverse = opaque_terms.symbol(&format!("1/d{}_{name}", k + 1), one.over(segment.length()));
        let rate = segment.span.each_ref().map(Series::rate);
        for (i, entry) in jacobian.iter_mut().enumerate() {
            let slope = segment.span.each_ref().map(|part| part.derivative(Symbol::coordinate(i)));
            *entry -= &dot(&segment.span, &slope) * &inverse;
        }
        curved -= opaque_terms.symbol(&format!("e{}_{name}", k + 1), segment.curvature(&rate, n));
        actions.extend(segment.pull(scene, &inverse));
    }
    (Row { gap, jacobian, bias: curved, prescribed_gap_rate: Series::zero() }, actions)
}
