//! What is read of each member: `first open`, `first open phi`, `t of last impact`, `count impact`,
//! `max N(A)`, `end`.

use super::SweepError;
use liftoff::__private::event::Occurrence;
use liftoff::NameError;
use liftoff::Output;
use liftoff::{EventFilter, EventKind};
use liftoff_core::model::Layout;

/// What is read of each member.
///
/// | | |
/// |---|---|
/// | `first open`, `last impact` | which supports: a category; `none` where there is no such event |
/// | `first open EXPR`, `EXPR of first open` | the value of an output there, after the event |
/// | `2nd impact`, `3rd impact EXPR` | the same of later ones |
/// | `first open A`, `t of first open A` | the same of one support's events |
/// | `count impact`, `count impact A` | how many |
/// | `end EXPR` | the value at the end |
/// | `max EXPR`, `min EXPR` | over the run, at turning points and at the ends of phases |
/// | `end` | what ended the run: a category |
#[derive(Clone, Debug)]
pub struct Observation {
    text: String,
    pub(super) quantity: ObservedQuantity,
}

#[derive(Clone, Debug)]
pub(super) enum ObservedQuantity {
    Ending,
    End(Output),
    Greatest(Output),
    Least(Output),
    Count(EventFilter),
    Supports(Occurrence, EventFilter),
    Value(Occurrence, EventFilter, Output),
}

const WORDS: [&str; 6] = ["first", "last", "count", "end", "max", "min"];

impl Observation {
    /// Reads an observation with the names of a model.
    ///
    /// # Errors
    /// Unknown words, kinds of events, supports or outputs, with the nearest.
    pub fn parse(text: &str, layout: &'static Layout) -> Result<Self, SweepError> {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let quantity = match text.split_once(" of ") {
            Some((output, event)) => {
                let quantity = quantity(event, layout).map_err(|reason| SweepError::syntax(&text, reason))?;
                of_event(output, quantity, layout)
            }
            None => quantity(&text, layout),
        };
        Ok(Self { quantity: quantity.map_err(|reason| SweepError::syntax(&text, reason))?, text })
    }

    /// As it was given, single spaces between words.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it has a name for a value, not a number.
    pub fn is_category(&self) -> bool {
        matches!(self.quantity, ObservedQuantity::Ending | ObservedQuantity::Supports(..))
    }

    /// The event after which nothing more is needed; none: the whole run is.
    pub(super) fn suffices(&self) -> Option<EventFilter> {
        match self.quantity {
            ObservedQuantity::Supports(Occurrence::Nth(1), filter)
            | ObservedQuantity::Value(Occurrence::Nth(1), filter, _) => Some(filter),
            _ => None,
        }
    }

    /// The event that it is of, and the output that is read there, if it names one.
    pub fn event(&self) -> Option<(Occurrence, EventFilter, Option<&Output>)> {
        match &self.quantity {
            ObservedQuantity::Supports(which, filter) => Some((*which, *filter, None)),
            ObservedQuantity::Value(which, filter, output) => Some((*which, *filter, Some(output))),
            _ => None,
        }
    }

    /// The output, of what is read at the end alone.
    pub fn at_end(&self) -> Option<&Output> {
        if let ObservedQuantity::End(output) = &self.quantity { Some(output) } else { None }
    }

    /// The output, if there is one.
    pub(super) fn output(&self) -> Option<&Output> {
        match &self.quantity {
            ObservedQuantity::End(output)
            | ObservedQuantity::Greatest(output)
            | ObservedQuantity::Least(output)
            | ObservedQuantity::Value(_, _, output) => Some(output),
            ObservedQuantity::Ending | ObservedQuantity::Count(_) | ObservedQuantity::Supports(..) => None,
        }
    }
}

fn quantity(text: &str, layout: &'static Layout) -> Result<ObservedQuantity, String> {
    let (word, rest) = text.split_once(' ').unwrap_or((text, ""));
    match (word, rest) {
        ("end", "") => Ok(ObservedQuantity::Ending),
        ("end", output) => Ok(ObservedQuantity::End(parse_output(output, layout)?)),
        ("max", output) => Ok(ObservedQuantity::Greatest(parse_output(output, layout)?)),
        ("min", output) => Ok(ObservedQuantity::Least(parse_output(output, layout)?)),
        ("count", event) => match event_quantity(Occurrence::Nth(1), event, layout)? {
            ObservedQuantity::Supports(_, filter) => Ok(ObservedQuantity::Count(filter)),
            _ => Err("expected count, a kind of event and at most a support".into()),
        },
        (word, event) => match Occurrence::parse(word) {
            Some(which) => event_quantity(which, event, layout),
            None => Err(NameError::new("observation", word, WORDS).to_string()),
        },
    }
}

/// `KIND [SUPPORT] [EXPR]`.
fn event_quantity(
    which: Occurrence,
    text: &str,
    layout: &'static Layout,
) -> Result<ObservedQuantity, String> {
    let (kind, rest) = text.split_once(' ').unwrap_or((text, ""));
    let found = EventKind::ALL.into_iter().find(|known| known.name() == kind);
    let kind = found
        .ok_or_else(|| NameError::new("event", kind, EventKind::ALL.map(EventKind::name)).to_string())?;
    let (word, after) = rest.split_once(' ').unwrap_or((rest, ""));
    let is_support = layout.contacts.iter().any(|contact| contact.supports.contains(&word));
    let (support, output) = if is_support { (Some(word), after) } else { (None, rest) };
    let filter = EventFilter::new(layout, kind, support).map_err(|error| error.to_string())?;
    match output {
        "" => Ok(ObservedQuantity::Supports(which, filter)),
        output => Ok(ObservedQuantity::Value(which, filter, parse_output(output, layout)?)),
    }
}

fn of_event(
    output: &str,
    quantity: ObservedQuantity,
    layout: &'static Layout,
) -> Result<ObservedQuantity, String> {
    match quantity {
        ObservedQuantity::Supports(which, filter) => {
            Ok(ObservedQuantity::Value(which, filter, parse_output(output, layout)?))
        }
        _ => Err("expected an output of `first`, `2nd`, … or `last` and a kind of event".into()),
    }
}

fn parse_output(text: &str, layout: &'static Layout) -> Result<Output, String> {
    Output::parse(layout, text).map_err(|error| error.to_string())
}
