//! The graph of modes as SVG: a column for each number of closed contacts, an arrow for each contact that closes.

mod legend;
mod place;
#[cfg(test)]
mod tests;

use core::fmt::Write;

use crate::html::escaped;
use crate::plot::Colour;
use liftoff::{Mode, Modes, Transition};
use place::{Box, Places};

/// With more changes than this they are told apart by colour and dashes only, as the legend says.
const LABELLED: usize = 12;
/// More sets than this are not drawn one by one.
const SETS: usize = 64;
const LETTERS: f64 = 13.0;

/// How the changes of a contact are drawn.
#[derive(Clone, Copy)]
struct Line {
    colour: Colour,
    dashes: &'static str,
}

/// The line of the `i`-th contact.
fn line(i: usize) -> Line {
    const COLOURS: [Colour; 6] =
        [Colour::Blue, Colour::Vermilion, Colour::Green, Colour::Purple, Colour::Orange, Colour::Sky];
    const DASHES: [&str; 3] = ["", "7 4", "2 3"];
    Line { colour: COLOURS[i % COLOURS.len()], dashes: DASHES[i / COLOURS.len() % DASHES.len()] }
}

/// Heads of the arrows, one for each contact.
fn heads(contacts: usize) -> String {
    let head = |i: usize| {
        let colour = line(i).colour.hex();
        format!(
            "<marker id=\"closes-{i}\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"6\" \
             markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0L8 4L0 8z\" fill=\"{colour}\"/></marker>\n"
        )
    };
    format!("<defs>\n{}</defs>\n", (0..contacts).map(head).collect::<String>())
}

/// On which side of a point above an arrow its name stands, by how far the arrow falls.
fn anchor(fall: f64) -> &'static str {
    match fall {
        fall if fall > 20.0 => "start",
        fall if fall < -20.0 => "end",
        _ => "middle",
    }
}

/// The graph as SVG: sets with code of their own in full boxes, others in dashed ones, each with its degrees of
/// freedom; the legend says what the arrows stand for. Of many sets only how many there are with each number of closed
/// contacts.
pub fn svg(modes: &Modes) -> String {
    Graph(modes).svg()
}

/// The modes to be drawn.
struct Graph<'a>(&'a Modes);

impl Graph<'_> {
    fn svg(&self) -> String {
        let summary = self.0.modes.len() > SETS;
        let nodes = if summary { self.by_number() } else { self.0.modes.iter().map(Node::of).collect() };
        let changes: &[Transition] = if summary { &[] } else { &self.0.transitions };
        let labelled = changes.len() <= LABELLED;
        let places = Places::of(&nodes, labelled);
        let mut drawn = String::new();
        for (change, ends) in changes.iter().zip(places.arrows(changes)) {
            self.arrow(change, ends, labelled, &mut drawn);
        }
        for (node, at) in nodes.iter().zip(&places.boxes) {
            node.draw(at, &mut drawn);
        }
        let legend = self.legend(places.size, summary);
        let [width, height] = legend.size;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
             viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" font-family=\"system-ui, sans-serif\" \
             font-size=\"{LETTERS}\">\n<title>Modes of {}</title>\n{}{drawn}{}</svg>\n",
            escaped(self.0.layout().name),
            heads(self.0.layout().contacts.len()),
            legend.svg,
        )
    }

    fn arrow(&self, change: &Transition, [from, to]: [[f64; 2]; 2], labelled: bool, drawn: &mut String) {
        let contact = self.contact(change);
        let Line { colour, dashes } = line(contact);
        let colour = colour.hex();
        let _ = writeln!(
            drawn,
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\" \
             stroke-dasharray=\"{dashes}\" marker-end=\"url(#closes-{contact})\"/>",
            from[0], from[1], to[0], to[1],
        );
        if labelled {
            let at = [0, 1].map(|axis| from[axis] + 0.36 * (to[axis] - from[axis]));
            let anchor = anchor(to[1] - from[1]);
            let _ = writeln!(
                drawn,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{}</text>",
                at[0],
                at[1] - 6.0,
                escaped(change.contact),
            );
        }
    }

    /// The contact that a change is about.
    fn contact(&self, change: &Transition) -> usize {
        let changed = self.0.modes[change.open].set.0 ^ self.0.modes[change.closed].set.0;
        changed.trailing_zeros() as usize
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
    fn of(mode: &Mode) -> Self {
        let title = if mode.closed.is_empty() { "free".to_owned() } else { mode.closed.join(" | ") };
        let degrees = match mode.degrees {
            1 => "1 degree".to_owned(),
            n => format!("{n} degrees"),
        };
        Self { column: mode.set.len(), title, degrees, own_code: mode.own_code }
    }

    fn draw(&self, Box { x, y, width, height }: &Box, drawn: &mut String) {
        let dashes = if self.own_code { "" } else { "5 3" };
        let middle = x + width / 2.0;
        let _ = writeln!(
            drawn,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"6\" fill=\"none\" \
             stroke=\"#000000\" stroke-dasharray=\"{dashes}\"/>\n\
             <text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\" font-weight=\"600\" fill=\"#000000\">{}</text>\n\
             <text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"#000000\">{}</text>",
            y + 17.0,
            escaped(&self.title),
            y + 34.0,
            self.degrees,
        );
    }
}
