//! Where the number with the most digits is declared: what most likely overflows.

use proc_macro2::Span;

use super::System;
use crate::algebra::Series;

impl System {
    /// The part of the declaration with the longest exact number.
    pub(crate) fn longest_number(&self) -> Span {
        let bodies = self.bodies.iter().flat_map(|body| {
            let own = [&body.mass, &body.length, &body.inertia].into_iter().chain(&body.centre);
            own.map(|value| (value, body.span))
        });
        let points = self
            .points
            .iter()
            .flat_map(|point| point.on.iter().flat_map(|(_, local)| local).map(|value| (value, point.span)));
        let particles = self.particles.iter().map(|particle| (&particle.mass, particle.span));
        let pins = self.pins.iter().flat_map(|pin| pin.at.each_ref().map(|value| (value, pin.span)));
        let springs = self.springs.iter().flat_map(|spring| {
            let values = [spring.stiffness.as_ref(), spring.damping.as_ref(), Some(&spring.length)];
            values.into_iter().flatten().filter_map(|value| Some((value.as_series()?, spring.span)))
        });
        let torsions = self.torsions.iter().flat_map(|torsion| {
            let values = [torsion.stiffness.as_ref(), torsion.damping.as_ref(), Some(&torsion.angle)];
            values.into_iter().flatten().filter_map(|value| Some((value.as_series()?, torsion.span)))
        });
        let all = bodies.chain(points).chain(particles).chain(pins).chain(springs).chain(torsions);
        let longest = all.max_by_key(|(value, _)| bits(value)).filter(|(value, _)| bits(value) > LONG);
        longest.map_or_else(|| self.ident.span(), |(_, span)| span)
    }
}

/// Numbers of fewer bits do not overflow by themselves.
const LONG: u32 = 16;

/// Bits of the longest coefficient's numerator and denominator together.
fn bits(series: &Series) -> u32 {
    let length = |n: i128| i128::BITS - n.unsigned_abs().leading_zeros();
    series.terms().map(|(_, c)| length(c.numerator()) + length(c.denominator())).max().unwrap_or(0)
}
