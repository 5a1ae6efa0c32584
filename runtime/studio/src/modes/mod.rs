//! The graph of modes as SVG: a column for each number of closed contacts, those that stick
//! counted twice, an arrow for each contact that closes or sticks.

mod legend;
mod place;
#[cfg(test)]
mod tests;

use crate::plot::svg::plane::{Box2, Px, add, along, head, minus};
use crate::plot::svg::{Anchor, Colour, Fill, Lettering, Pen, Svg};
use liftoff::{Change, Mode, ModeTransition, Modes};
use liftoff_core::model::{Layout, Slip};
use place::Places;

/// With more changes than this they are told apart by colour and dashes only, as the legend says.
const LABELLED: usize = 12;
/// More sets than this are not drawn one by one.
const SETS: usize = 64;
const LETTERS: f64 = 13.0;

fn lettering(at: Px) -> Lettering {
    Lettering { size: LETTERS, ..Lettering::new(at) }
}

/// How the changes of the `i`-th contact are drawn.
fn pen(i: usize) -> Pen {
    const COLOURS: [Colour; 6] =
        [Colour::Blue, Colour::Vermilion, Colour::Green, Colour::Purple, Colour::Orange, Colour::Sky];
    const DASHES: [&str; 3] = ["", "7 4", "2 3"];
    Pen { dashes: DASHES[i / COLOURS.len() % DASHES.len()], ..Pen::new(COLOURS[i % COLOURS.len()], 1.6) }
}

/// The same where it sticks: dotted.
fn pen_of(contact: usize, change: Change) -> Pen {
    let pen = pen(contact);
    if change == Change::Sticks { Pen { dashes: "1 4", ..pen } } else { pen }
}

fn sticks(layout: &Layout, mode: &Mode, contact: usize) -> bool {
    layout.contacts[contact].friction.is_some() && mode.set.slip(contact) == Slip::Stick
}

/// Draws an arrow.
fn arrow(svg: &mut Svg, [from, to]: [Px; 2], pen: Pen) {
    svg.line(&[from, to], pen);
    svg.polygon(&head(to, minus(to, from)), Fill::Colour(pen.colour));
}

/// On which side of a point above an arrow its name stands, by how far the arrow falls.
fn anchor(fall: f64) -> Anchor {
    match fall {
        fall if fall > 20.0 => Anchor::Start,
        fall if fall < -20.0 => Anchor::End,
        _ => Anchor::Middle,
    }
}

/// The graph as SVG: sets with code of their own in full boxes, others in dashed ones, each with
/// its degrees of freedom; the legend says what the arrows stand for. Of many sets only how many
/// there are with each number of closed contacts.
pub fn svg(modes: &Modes) -> String {
    Graph(modes).svg()
}

/// The modes to be drawn.
struct Graph<'a>(&'a Modes);

impl Graph<'_> {
    fn svg(&self) -> String {
        let summary = self.0.modes.len() > SETS;
        let nodes = if summary {
            self.by_number()
        } else {
            self.0.modes.iter().map(|mode| Node::new(self.0.layout(), mode)).collect()
        };
        let changes = if summary { Vec::new() } else { self.drawn() };
        let labelled = changes.len() <= LABELLED;
        let places = Places::arrange(&nodes, labelled);
        let mut svg = Svg::default();
        for (change, ends) in changes.iter().zip(places.arrows(&changes)) {
            self.change(change, ends, labelled, &mut svg);
        }
        for (node, area) in nodes.iter().zip(&places.boxes) {
            node.draw(*area, &mut svg);
        }
        let size = self.legend(&mut svg, places.size, summary);
        svg.finished(&format!("Modes of {}", self.0.layout().name), size)
    }

    /// The changes but those by which a contact closes and sticks at once: they pass over the boxes
    /// in which it slides.
    fn drawn(&self) -> Vec<ModeTransition> {
        self.0.transitions.iter().filter(|of| of.change != Change::ClosesSticking).copied().collect()
    }

    fn change(&self, change: &ModeTransition, ends: [Px; 2], labelled: bool, svg: &mut Svg) {
        let pen = pen_of(self.contact(change), change.change);
        arrow(svg, ends, pen);
        if labelled {
            let step = minus(ends[1], ends[0]);
            let at = add(along(ends[0], step, 0.36), [0.0, -6.0 - 0.34 * LETTERS]);
            svg.word(
                Lettering { colour: pen.colour, anchor: anchor(step[1]), ..lettering(at) },
                change.contact,
            );
        }
    }

    /// The contact that a change is about.
    fn contact(&self, change: &ModeTransition) -> usize {
        let contacts = self.0.layout().contacts;
        contacts.iter().position(|contact| contact.label == change.contact).unwrap_or_default()
    }

    /// For each number of closed contacts how many sets there are.
    fn by_number(&self) -> Vec<Node> {
        let most = self.0.modes.iter().map(|mode| mode.set.len()).max().unwrap_or(0);
        let nodes = (0..=most).map(|closed| {
            let of = || self.0.modes.iter().filter(move |mode| mode.set.len() == closed);
            let [least, most] = [of().map(|m| m.degrees).min(), of().map(|m| m.degrees).max()];
            let [least, most] = [least.unwrap_or(0), most.unwrap_or(0)];
            let range = if least == most { least.to_string() } else { format!("{least} … {most}") };
            let sets = of().count();
            Node {
                column: closed,
                title: format!("{closed} closed: {sets} set{}", if sets == 1 { "" } else { "s" }),
                degrees: format!("{range} degrees"),
                own_code: of().all(|mode| mode.own_code),
            }
        });
        nodes.collect()
    }
}

/// A box of the graph.
struct Node {
    column: usize,
    title: String,
    degrees: String,
    own_code: bool,
}

impl Node {
    fn new(layout: &Layout, mode: &Mode) -> Self {
        let title = match mode.closed.as_slice() {
            [] => layout.unclosed().to_owned(),
            closed => closed.join(" | "),
        };
        let degrees = match mode.degrees {
            1 => "1 degree".to_owned(),
            n => format!("{n} degrees"),
        };
        // A contact that sticks takes as much freedom as two.
        let sticking = mode.set.iter().filter(|&i| sticks(layout, mode, i)).count();
        Self { column: mode.set.len() + sticking, title, degrees, own_code: mode.own_code }
    }

    fn draw(&self, area: Box2, svg: &mut Svg) {
        let dashes = if self.own_code { "" } else { "5 3" };
        svg.rounded_rectangle(area, 6.0, Pen { dashes, ..Pen::new(Colour::Black, 1.0) });
        let at = |y: f64| lettering([area.centre()[0], area.least[1] + y]);
        svg.word(Lettering { bold: true, ..at(13.0) }, &self.title);
        svg.word(at(30.0), &self.degrees);
    }
}
