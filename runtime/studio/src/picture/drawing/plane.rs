//! Vectors of the drawing: pixels, x to the right, y down.

/// A place or a step on the drawing.
pub(super) type Px = [f64; 2];

pub(super) fn add(a: Px, b: Px) -> Px {
    [a[0] + b[0], a[1] + b[1]]
}

pub(super) fn minus(a: Px, b: Px) -> Px {
    [a[0] - b[0], a[1] - b[1]]
}

/// a + k v.
pub(super) fn along(a: Px, v: Px, k: f64) -> Px {
    [a[0] + k * v[0], a[1] + k * v[1]]
}

pub(super) fn middle(a: Px, b: Px) -> Px {
    [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])]
}

pub(super) fn dot(a: Px, b: Px) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn length(v: Px) -> f64 {
    v[0].hypot(v[1])
}

pub(super) fn distance(a: Px, b: Px) -> f64 {
    length(minus(a, b))
}

/// The direction of `v`; to the right if it has none.
pub(super) fn unit(v: Px) -> Px {
    let size = length(v);
    if size > 0.0 { [v[0] / size, v[1] / size] } else { [1.0, 0.0] }
}

/// The direction at an angle of the model, counter-clockwise from the right as its readers see it.
pub(super) fn towards(angle: f64) -> Px {
    [angle.cos(), -angle.sin()]
}

/// A quarter turn to the left as readers see it.
pub(super) fn left_of(v: Px) -> Px {
    [v[1], -v[0]]
}

/// Points of an arc about `centre` from angle `from` over `sweep`.
pub(super) fn arc(centre: Px, radius: f64, from: f64, sweep: f64) -> Vec<Px> {
    let parts = (sweep.abs() / 0.08).ceil().max(1.0) as u32;
    let at = |i: u32| along(centre, towards(from + sweep * f64::from(i) / f64::from(parts)), radius);
    (0..=parts).map(at).collect()
}

/// A rectangle by its least and its greatest corner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Box2 {
    pub least: Px,
    pub most: Px,
}

impl Box2 {
    /// The smallest one round `points`.
    pub fn round(points: impl IntoIterator<Item = Px>) -> Option<Self> {
        points.into_iter().map(|p| Self { least: p, most: p }).reduce(Self::with)
    }

    /// The smallest one round both.
    pub fn with(self, other: Self) -> Self {
        Self {
            least: [self.least[0].min(other.least[0]), self.least[1].min(other.least[1])],
            most: [self.most[0].max(other.most[0]), self.most[1].max(other.most[1])],
        }
    }

    /// The same, wider by `by` on all sides.
    pub fn wider(self, by: f64) -> Self {
        Self { least: add(self.least, [-by, -by]), most: add(self.most, [by, by]) }
    }

    pub fn size(self) -> Px {
        minus(self.most, self.least)
    }

    pub fn centre(self) -> Px {
        middle(self.least, self.most)
    }

    /// Whether the two have inner points in common.
    pub fn overlaps(self, other: Self) -> bool {
        (0..2).all(|i| self.least[i] < other.most[i] && other.least[i] < self.most[i])
    }

    /// The part of the segment from `a` to `b` inside, as fractions of it (Liang and Barsky).
    pub fn clip(self, a: Px, b: Px) -> Option<[f64; 2]> {
        let step = minus(b, a);
        let mut part = [0.0_f64, 1.0_f64];
        for i in 0..2 {
            for (rate, room) in [(-step[i], a[i] - self.least[i]), (step[i], self.most[i] - a[i])] {
                if rate == 0.0 && room < 0.0 {
                    return None;
                } else if rate < 0.0 {
                    part[0] = part[0].max(room / rate);
                } else if rate > 0.0 {
                    part[1] = part[1].min(room / rate);
                }
            }
        }
        (part[0] < part[1]).then_some(part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_is_clipped_at_the_sides_it_crosses() {
        let square = Box2 { least: [0.0, 0.0], most: [2.0, 2.0] };
        assert_eq!(square.clip([-1.0, 1.0], [3.0, 1.0]), Some([0.25, 0.75]));
        assert_eq!(square.clip([1.0, 1.0], [1.0, 5.0]), Some([0.0, 0.25]));
        assert_eq!(square.clip([3.0, 0.0], [3.0, 2.0]), None);
        assert_eq!(square.clip([-1.0, 2.0], [0.0, 4.0]), None);
    }

    #[test]
    fn boxes_that_share_a_side_do_not_overlap() {
        let a = Box2 { least: [0.0, 0.0], most: [1.0, 1.0] };
        let beside = Box2 { least: [1.0, 0.0], most: [2.0, 1.0] };
        assert!(!a.overlaps(beside) && a.overlaps(beside.wider(0.1)));
    }
}
