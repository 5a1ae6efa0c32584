//! What lines and boxes stand for, below the graph.

use super::{Graph, arrow, lettering, pen, pen_of};
use crate::plot::svg::{Anchor, Pen, Svg};
use liftoff::Change;
use liftoff_core::model::{Contact, ContactKind};

const ROW: f64 = 22.0;
const LEFT: f64 = 14.0;
const LETTER: f64 = 7.2;

impl Graph<'_> {
    /// Draws the legend below a graph of this size; width and height of both together.
    pub(super) fn legend(&self, svg: &mut Svg, [width, height]: [f64; 2], summary: bool) -> [f64; 2] {
        let mut legend = Legend { svg, size: [width, height + 10.0] };
        if !summary {
            for (i, contact) in self.0.layout().contacts.iter().enumerate() {
                legend.row(Some(pen(i)), &format!("{}: {}", contact.label, leads(contact)));
                if contact.friction.is_some() {
                    let dotted = pen_of(i, Change::Sticks);
                    legend.row(
                        Some(dotted),
                        &format!(
                            "{}: sticks along the arrow{}, slips on the way back",
                            contact.label,
                            if is_always_closed(contact) { "" } else { ", or as it closes" }
                        ),
                    );
                }
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
        legend.size
    }
}

/// Whether no arrow opens it.
fn is_always_closed(contact: &Contact) -> bool {
    matches!(contact.kind, ContactKind::Guide | ContactKind::Hinge { .. })
}

/// What leads along the arrow, and what back.
fn leads(contact: &Contact) -> &'static str {
    match (contact.kind == ContactKind::Thread, contact.stop) {
        _ if contact.is_hinge() => "a hinge, closed always",
        _ if is_always_closed(contact) => "a guide, closed always",
        _ if contact.kind.is_drive() => {
            "takes hold along the arrow, lets go on the way back where its condition ceases"
        }
        (_, true) => "closes along the arrow (the run ends there), opens on the way back",
        (false, _) => "closes along the arrow (impact), opens on the way back",
        (true, _) => "becomes taut along the arrow, slack on the way back",
    }
}

/// A legend in the making, and the size of all that is drawn so far.
struct Legend<'a> {
    svg: &'a mut Svg,
    size: [f64; 2],
}

impl Legend<'_> {
    fn row(&mut self, pen: Option<Pen>, text: &str) {
        let (mut x, y) = (LEFT, self.size[1] + ROW / 2.0);
        if let Some(pen) = pen {
            arrow(self.svg, [[x, y], [x + 34.0, y]], pen);
            x += 44.0;
        }
        self.svg.word(lettering([x, y]).anchored(Anchor::Start), text);
        let width = x + text.chars().count() as f64 * LETTER + LEFT;
        self.size = [self.size[0].max(width), self.size[1] + ROW];
    }
}
