//! How a model looks: forms with a role, between points and at places that parameters determine. They tell what is drawn and
//! measured, not what kind of joint or support it stands for.
//!
//! A `usize` called a point is an index into [`Layout::points`](super::Layout::points).

/// An index into [`BarSystem::numbers`](super::BarSystem::numbers): a length or an angle in rad.
pub type Number = usize;

/// What is seen of a model, whatever the values of its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Geometry {
    /// Rigid bodies, one for each of [`Layout::bars`](super::Layout::bars).
    pub bodies: &'static [Body],
    /// Threads.
    pub threads: &'static [Thread],
    /// Springs and dampers between points.
    pub springs: &'static [Spring],
    /// Torsion springs.
    pub spirals: &'static [Spiral],
    /// Blocks that slide on guides.
    pub blocks: &'static [Block],
    /// Marks at points, in drawing order.
    pub marks: &'static [Mark],
    /// Surfaces and lines that stand still.
    pub fixtures: &'static [Fixture],
    /// Sections of bars.
    pub sections: &'static [Section],
    /// What each coordinate measures, in the layout's order.
    pub readings: &'static [Reading],
    /// Lengths of bars, one for all that have it.
    pub lengths: &'static [Length],
    /// Where supports and threads push or pull.
    pub pushes: &'static [Push],
    /// The components of gravity.
    pub gravity: Option<[Number; 2]>,
}

impl Geometry {
    /// Nothing.
    pub const EMPTY: Self = Self {
        bodies: &[],
        threads: &[],
        springs: &[],
        spirals: &[],
        blocks: &[],
        marks: &[],
        fixtures: &[],
        sections: &[],
        readings: &[],
        lengths: &[],
        pushes: &[],
        gravity: None,
    };

    /// The first place where what has this name pushes.
    pub fn push(&self, support: &str) -> Option<&'static Push> {
        self.pushes.iter().find(|push| push.support == support)
    }

    /// The points that have such a mark.
    pub fn marked(&self, look: Look) -> impl Iterator<Item = usize> + use<> {
        self.marks.iter().filter(move |mark| mark.look == look).map(|mark| mark.point)
    }

    /// The points of the ground: those with a foot, then all others.
    pub fn grounded(&self) -> impl Iterator<Item = (usize, Look)> + use<> {
        let marks = self.marks;
        let feet = move || marks.iter().filter(|mark| mark.look == Look::Foot);
        let others = marks.iter().filter(move |mark| match mark.look {
            Look::Ground | Look::Peg => feet().all(|foot| foot.point != mark.point),
            _ => false,
        });
        feet().chain(others).map(|mark| (mark.point, mark.look))
    }
}

/// A place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Spot {
    /// That of a point, which moves.
    Point(usize),
    /// Of the ground, by its x and y.
    Fixed([Number; 2]),
}

/// A direction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// At this angle, counter-clockwise from the right.
    Fixed(Number),
    /// From one place to another.
    Towards(Spot, Spot),
    /// The first axis of a body's frame.
    Axis {
        /// Two points of the body.
        ends: [usize; 2],
        /// The components of the step between them in the frame.
        step: [Number; 2],
    },
}

/// A rigid body: a bar between two points, a plate of more.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Its ends or corners.
    pub outline: &'static [usize],
    /// Its other points.
    pub inner: &'static [usize],
}

/// A line from point to point that can be slack.
#[derive(Clone, Copy, Debug)]
pub struct Thread {
    /// Its name.
    pub name: &'static str,
    /// Its points from end to end.
    pub path: &'static [usize],
    /// Its length, which it has when taut.
    pub length: Number,
    /// The length as a formula; empty for a plain number.
    pub text: &'static str,
}

/// A coil, a dashpot or both side by side.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Its name.
    pub name: &'static str,
    /// Its ends.
    pub ends: [usize; 2],
    /// Whether there is a coil.
    pub coil: bool,
    /// Whether there is a dashpot.
    pub dashpot: bool,
    /// Stiffness and damping as formulas; empty for plain numbers.
    pub text: &'static str,
}

/// A spiral about a point.
#[derive(Clone, Copy, Debug)]
pub struct Spiral {
    /// The point.
    pub point: usize,
    /// Where its inner end points.
    pub from: Direction,
}

/// A block about a point.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    /// The point.
    pub point: usize,
    /// The direction in which it slides.
    pub along: Direction,
}

/// A mark at a point.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// The point.
    pub point: usize,
    /// What is drawn there.
    pub look: Look,
}

/// Looks of a [`Mark`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Look {
    /// A disc that a thread passes over.
    Peg,
    /// A mass.
    Mass,
    /// A joint that turns.
    Ring,
    /// A joint that does not turn.
    Disc,
    /// A foot on the ground.
    Foot,
    /// A piece of the ground itself.
    Ground,
}

/// What stands still.
#[derive(Clone, Copy, Debug)]
pub struct Fixture {
    /// The support or guide it belongs to.
    pub name: &'static str,
    /// A place of it.
    pub at: [Number; 2],
    /// Its shape.
    pub shape: Shape,
}

/// Shapes of a [`Fixture`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A straight line through its place.
    Line {
        /// Its angle, counter-clockwise from the right.
        angle: Number,
        /// Whether it is the edge of something solid, to the right as one goes along it.
        solid: bool,
    },
    /// A circle about its place.
    Circle {
        /// Its radius.
        radius: Number,
        /// Whether what is solid lies outside.
        inside: bool,
        /// The radius as a formula; empty for a plain number.
        text: &'static str,
    },
    /// An edge that points where its support pushes.
    Wedge,
}

/// A stroke across a bar.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Its name.
    pub name: &'static str,
    /// Ends of the bar.
    pub ends: [usize; 2],
    /// The distance from the first.
    pub at: Number,
}

/// What a coordinate measures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reading {
    /// An angle between a direction and a bar: `sign` times the coordinate leads from one to the other.
    Angle {
        /// The point at which it is shown.
        vertex: usize,
        /// The other end of the bar.
        tip: usize,
        /// What it is measured from.
        from: Direction,
        /// Whether the bar is read from the tip to the vertex, so that the arc begins against `from`.
        against: bool,
        /// +1 counter-clockwise, −1 clockwise.
        sign: i8,
    },
    /// A position: `sign` times the coordinate is the point's place along the axis.
    Position {
        /// The point.
        point: usize,
        /// 0 for x, 1 for y.
        axis: usize,
        /// ±1.
        sign: i8,
    },
}

/// A length to be shown once.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    /// The length.
    pub value: Number,
    /// The same as a formula; empty for a plain number.
    pub text: &'static str,
    /// Pairs of points between which it may be shown.
    pub between: &'static [[usize; 2]],
}

/// Where a unit reaction acts, and which way.
#[derive(Clone, Copy, Debug)]
pub struct Push {
    /// The support or thread.
    pub support: &'static str,
    /// Where it acts.
    pub at: Spot,
    /// A direction of the contact.
    pub along: Direction,
    /// Quarter turns counter-clockwise from `along` to the reaction.
    pub turns: u8,
    /// Where a positive tangential reaction points: a quarter turn from the normal one, +1 counter-clockwise, −1 clockwise;
    /// 0 where there can be none.
    pub slip: i8,
}
