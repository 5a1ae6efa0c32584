//! What coordinates measure, and the lengths of bars.

use super::{DrawnDirection, DrawnReading, GeometryDraft, Length};
use crate::system::{CoordinateKind, OneSided, Reference};

impl GeometryDraft<'_> {
    pub(super) fn reading(&mut self, kind: &CoordinateKind) -> DrawnReading {
        match kind {
            CoordinateKind::Position { point, axis, sign } => {
                DrawnReading::Position { point: *point, axis: *axis, sign: *sign }
            }
            CoordinateKind::Angle { body, reference, sign } => {
                let (from, on_ground) = match reference {
                    Reference::Ground(angle) => (DrawnDirection::Fixed(self.numbers.angle(angle)), true),
                    Reference::Body(other) => (self.axis(*other), false),
                };
                let [first, last] = self.ends(*body);
                let is_bar = self.system.bodies[*body].outline.len() == 2;
                let against = on_ground && is_bar && self.rank(last) > self.rank(first);
                let (vertex, tip) = if against { (last, first) } else { (first, last) };
                DrawnReading::Angle { vertex, tip, from, against, sign: *sign }
            }
        }
    }

    /// How good a point is to show an angle at.
    fn rank(&self, point: usize) -> u8 {
        let stands = |contact: &OneSided| matches!(contact, OneSided::Line { point: on, .. } if *on == point);
        if self.is_pinned(point) {
            2
        } else {
            u8::from(self.system.supports.iter().any(|support| stands(&support.contact)))
        }
    }

    /// Those of bars, each once.
    pub(super) fn lengths(&mut self) -> Vec<Length> {
        let mut lengths: Vec<Length> = Vec::new();
        for (body, declared) in self.system.bodies.iter().enumerate() {
            if declared.outline.len() > 2 {
                continue;
            }
            let (ends, text) = (self.ends(body), self.text(&declared.length));
            let value = self.numbers.length(&declared.length);
            match lengths.iter_mut().find(|other| other.value == value) {
                Some(known) => known.between.push(ends),
                None => lengths.push(Length { value, text, between: vec![ends] }),
            }
        }
        lengths
    }
}
