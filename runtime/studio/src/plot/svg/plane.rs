//! Vectors of a drawing: pixels, x to the right, y down.

/// Pixels that nobody sees.
const UNSEEN: f64 = 0.05;
/// Points of a line that are left out one after another at most.
const SKIPPED: usize = 100;

/// A place or a step on the drawing.
pub(crate) type Px = [f64; 2];

pub(crate) fn add(a: Px, b: Px) -> Px {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn minus(a: Px, b: Px) -> Px {
    [a[0] - b[0], a[1] - b[1]]
}

/// a + k v.
pub(crate) fn along(a: Px, v: Px, k: f64) -> Px {
    [a[0] + k * v[0], a[1] + k * v[1]]
}

pub(crate) fn middle(a: Px, b: Px) -> Px {
    [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])]
}

pub(crate) fn dot(a: Px, b: Px) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn length(v: Px) -> f64 {
    v[0].hypot(v[1])
}

pub(crate) fn distance(a: Px, b: Px) -> f64 {
    length(minus(a, b))
}

/// The direction of `v`; to the right if it has none.
pub(crate) fn unit(v: Px) -> Px {
    let size = length(v);
    if size > 0.0 { [v[0] / size, v[1] / size] } else { [1.0, 0.0] }
}

/// The direction at an angle of the model, counter-clockwise from the right as its readers see it.
pub(crate) fn towards(angle: f64) -> Px {
    [angle.cos(), -angle.sin()]
}

/// A quarter turn to the left as readers see it.
pub(crate) fn left_of(v: Px) -> Px {
    [v[1], -v[0]]
}

/// Points of an arc about `centre` from angle `from` over `sweep`.
pub(crate) fn arc(centre: Px, radius: f64, from: f64, sweep: f64) -> Vec<Px> {
    let parts = (sweep.abs() / 0.08).ceil().max(1.0) as u32;
    let at = |i: u32| along(centre, towards(from + sweep * f64::from(i) / f64::from(parts)), radius);
    (0..=parts).map(at).collect()
}

/// The head of an arrow.
pub(crate) fn head(tip: Px, direction: Px) -> [Px; 3] {
    let ahead = unit(direction);
    let back = along(tip, ahead, -9.0);
    [tip, along(back, left_of(ahead), 3.2), along(back, left_of(ahead), -3.2)]
}

/// The line without points that are seen on a straight line from the one kept before them to one
/// after them.
pub(crate) fn thinned(line: &[Px]) -> Vec<Px> {
    let (mut kept, mut from) = (line.get(..1).unwrap_or_default().to_vec(), 0);
    for end in 2..line.len() {
        let mut skipped = line[from + 1..end].iter();
        if skipped.len() > SKIPPED || skipped.any(|&point| off(point, line[from], line[end]) > UNSEEN) {
            from = end - 1;
            kept.push(line[from]);
        }
    }
    kept.extend(line.get(1..).and_then(<[Px]>::last));
    kept
}

/// How far `point` is from the segment from `a` to `b`.
fn off(point: Px, a: Px, b: Px) -> f64 {
    let (step, square) = (minus(b, a), dot(minus(b, a), minus(b, a)));
    let part = if square > 0.0 { dot(minus(point, a), step) / square } else { 0.0 };
    distance(point, along(a, step, part.clamp(0.0, 1.0)))
}

/// A rectangle by its least and its greatest corner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Box2 {
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

    /// Whether a place is inside or on a side.
    pub fn holds(self, p: Px) -> bool {
        (0..2).all(|i| self.least[i] <= p[i] && p[i] <= self.most[i])
    }

    /// Its part of this length along an axis from the least corner, and the rest.
    pub fn split(self, axis: usize, length: f64) -> [Self; 2] {
        let [mut first, mut rest] = [self; 2];
        rest.least[axis] += length;
        first.most[axis] = rest.least[axis];
        [first, rest]
    }

    /// So many strips of one height, from above.
    pub fn strips(self, count: usize) -> impl Iterator<Item = Self> {
        let height = self.size()[1] / count as f64;
        (0..count).map(move |i| self.split(1, height * i as f64)[1].split(1, height)[0])
    }

    /// The parts of a line inside.
    pub fn inside(self, line: &[Px]) -> Vec<Vec<Px>> {
        let mut parts: Vec<Vec<Px>> = Vec::new();
        for pair in line.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let Some(part) = self.clip(a, b) else { continue };
            let at = |k: f64| if k < 1.0 { along(a, minus(b, a), k) } else { b };
            let [from, to] = part.map(at);
            match parts.last_mut().filter(|part| part.last() == Some(&from)) {
                Some(part) => part.push(to),
                None => parts.push(vec![from, to]),
            }
        }
        parts
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
    fn a_line_is_cut_into_the_parts_inside() {
        let square = Box2 { least: [0.0, 0.0], most: [2.0, 2.0] };
        let line = [[-1.0, 1.0], [1.0, 1.0], [1.0, 3.0], [2.0, 1.0], [2.0, 0.0]];
        let parts = square.inside(&line);
        assert_eq!(
            parts,
            [vec![[0.0, 1.0], [1.0, 1.0], [1.0, 2.0]], vec![[1.5, 2.0], [2.0, 1.0], [2.0, 0.0]],]
        );
    }

    /// A parabola keeps what its curvature needs: a chord of length c is c²/8 off where the second
    /// derivative is 1.
    #[test]
    fn points_that_nobody_sees_are_left_out() {
        let parabola: Vec<Px> = (0..=1000).map(|i| f64::from(i) / 100.0).map(|x| [x, x * x / 2.0]).collect();
        let kept = thinned(&parabola);
        assert!((9..40).contains(&kept.len()), "{}", kept.len());
        let near = |p: &Px| kept.windows(2).any(|pair| off(*p, pair[0], pair[1]) <= UNSEEN);
        assert!(parabola.iter().all(near));
        let turning = [[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]];
        assert_eq!(thinned(&turning), turning);
    }

    #[test]
    fn boxes_that_share_a_side_do_not_overlap() {
        let a = Box2 { least: [0.0, 0.0], most: [1.0, 1.0] };
        let beside = Box2 { least: [1.0, 0.0], most: [2.0, 1.0] };
        assert!(!a.overlaps(beside) && a.overlaps(beside.wider(0.1)));
    }
}
