//! What lines and boxes stand for, below the graph.

use core::fmt::Write;

use super::{Graph, LETTERS, Line, line};
use crate::html::escaped;
use liftoff::model::{Contact, ContactKind};

const ROW: f64 = 22.0;
const LEFT: f64 = 14.0;
const LETTER: f64 = 7.2;

/// The legend as SVG, and width and height of graph and legend together.
pub(super) struct Legend {
    pub svg: String,
    pub size: [f64; 2],
}

impl Graph<'_> {
    pub(super) fn legend(&self, [width, height]: [f64; 2], summary: bool) -> Legend {
        let mut legend = Legend { svg: String::new(), size: [width, height + 10.0] };
        if !summary {
            for (i, contact) in self.0.layout().contacts.iter().enumerate() {
                legend.row(Some(i), &format!("{}: {}", contact.label, leads(contact)));
            }
        }
        let (own, all) = (self.0.modes.iter().filter(|mode| mode.own_code).count(), self.0.modes.len());
        match (own == all, own) {
            (true, _) => legend.row(None, "Every set has code of its own."),
            (_, 0) => legend.row(None, "Dashed boxes: these sets share the full equations with multipliers."),
            _ => legend.row(
                None,
                "Full boxes: sets with code of their own; dashed: full equations with multipliers.",
            ),
        }
        if !self.0.complete {
            legend.row(None, "Only the sets with code of their own are listed.");
        }
        legend
    }
}

/// What leads along the arrow, and what back.
fn leads(contact: &Contact) -> &'static str {
    match (contact.kind == ContactKind::Thread, contact.stop) {
        (_, true) => "closes along the arrow (the run ends there), opens on the way back",
        (false, _) => "closes along the arrow (impact), opens on the way back",
        (true, _) => "becomes taut along the arrow, slack on the way back",
    }
}

impl Legend {
    fn row(&mut self, contact: Option<usize>, text: &str) {
        let y = self.size[1] + ROW / 2.0;
        let mut x = LEFT;
        if let Some(contact) = contact {
            let Line { colour, dashes } = line(contact);
            let _ = writeln!(
                self.svg,
                "<path d=\"M{x} {y:.1}h34\" stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"{dashes}\" \
                 marker-end=\"url(#closes-{contact})\"/>",
                colour.hex()
            );
            x += 44.0;
        }
        let _ = writeln!(
            self.svg,
            "<text x=\"{x}\" y=\"{:.1}\" fill=\"#000000\">{}</text>",
            y + LETTERS / 3.0,
            escaped(text)
        );
        let width = x + text.chars().count() as f64 * LETTER + LEFT;
        self.size = [self.size[0].max(width), self.size[1] + ROW];
    }
}
