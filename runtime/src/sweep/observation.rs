//! What is read of each member: `first open`, `first open phi`, `t of last impact`, `count impact`, `max N(A)`, `end`.

use super::SweepError;
use crate::event::EventKind;
use crate::model::Layout;
use crate::names::unknown;
use crate::occurrence::Occurrence;
use crate::output::Output;

/// What is read of each member.
///
/// | | |
/// |---|---|
/// | `first open`, `last impact` | which supports: a category; `none` where there is no such event |
/// | `first open EXPR`, `EXPR of first open` | the value of an output there, after the event |
/// | `first open A`, `t of first open A` | the same of one support's events |
/// | `count impact`, `count impact A` | how many |
/// | `end EXPR` | the value at the end |
/// | `max EXPR`, `min EXPR` | over the run, at turning points and at the ends of phases |
/// | `end` | what ended the run: a category |
#[derive(Clone, Debug)]
pub struct Observation {
    text: String,
    pub(super) what: What,
}

#[derive(Clone, Debug)]
pub(super) enum What {
    Ending,
    End(Output),
    Greatest(Output),
    Least(Output),
    Count(Occurrence),
    Supports(Which, Occurrence),
    Value(Which, Occurrence, Output),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Which {
    First,
    Last,
}

const WORDS: [&str; 6] = ["first", "last", "count", "end", "max", "min"];

impl Observation {
    /// Reads an observation with the names of a model.
    ///
    /// # Errors
    /// Unknown words, kinds of events, supports or outputs, with the nearest.
    pub fn parse(text: &str, layout: &'static Layout) -> Result<Self, SweepError> {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let what = match text.split_once(" of ") {
            Some((output, event)) => {
                let what = what(event, layout).map_err(|reason| SweepError::words(&text, reason))?;
                of_event(output, what, layout)
            }
            None => what(&text, layout),
        };
        Ok(Self { what: what.map_err(|reason| SweepError::words(&text, reason))?, text })
    }

    /// As it was said, single spaces between words.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it has a name for a value, not a number.
    pub fn is_category(&self) -> bool {
        matches!(self.what, What::Ending | What::Supports(..))
    }

    /// The event after which nothing more is needed; none: the whole run is.
    pub(super) fn suffices(&self) -> Option<Occurrence> {
        match self.what {
            What::Supports(Which::First, occurrence) | What::Value(Which::First, occurrence, _) => {
                Some(occurrence)
            }
            _ => None,
        }
    }

    /// The output, of what is read at the end alone.
    pub(super) fn at_end(&self) -> Option<&Output> {
        if let What::End(output) = &self.what { Some(output) } else { None }
    }

    /// The output, if there is one.
    pub(super) fn output(&self) -> Option<&Output> {
        match &self.what {
            What::End(output) | What::Greatest(output) | What::Least(output) | What::Value(_, _, output) => {
                Some(output)
            }
            What::Ending | What::Count(_) | What::Supports(..) => None,
        }
    }
}

fn what(text: &str, layout: &'static Layout) -> Result<What, String> {
    let (word, rest) = text.split_once(' ').unwrap_or((text, ""));
    match (word, rest) {
        ("end", "") => Ok(What::Ending),
        ("end", output) => Ok(What::End(read(output, layout)?)),
        ("max", output) => Ok(What::Greatest(read(output, layout)?)),
        ("min", output) => Ok(What::Least(read(output, layout)?)),
        ("first", event) => happened(Which::First, event, layout),
        ("last", event) => happened(Which::Last, event, layout),
        ("count", event) => match happened(Which::First, event, layout)? {
            What::Supports(_, occurrence) => Ok(What::Count(occurrence)),
            _ => Err("expected count, a kind of event and at most a support".into()),
        },
        _ => Err(unknown("observation", word, WORDS).to_string()),
    }
}

/// `KIND [SUPPORT] [EXPR]`.
fn happened(which: Which, text: &str, layout: &'static Layout) -> Result<What, String> {
    let (kind, rest) = text.split_once(' ').unwrap_or((text, ""));
    let found = EventKind::ALL.into_iter().find(|known| known.name() == kind);
    let kind =
        found.ok_or_else(|| unknown("event", kind, EventKind::ALL.map(EventKind::name)).to_string())?;
    let (word, after) = rest.split_once(' ').unwrap_or((rest, ""));
    let is_support = layout.contacts.iter().any(|contact| contact.supports.contains(&word));
    let (support, output) = if is_support { (Some(word), after) } else { (None, rest) };
    let occurrence = Occurrence::of(layout, kind, support).map_err(|error| error.to_string())?;
    match output {
        "" => Ok(What::Supports(which, occurrence)),
        output => Ok(What::Value(which, occurrence, read(output, layout)?)),
    }
}

fn of_event(output: &str, what: What, layout: &'static Layout) -> Result<What, String> {
    match what {
        What::Supports(which, occurrence) => Ok(What::Value(which, occurrence, read(output, layout)?)),
        _ => Err("expected an output of first or last and a kind of event".into()),
    }
}

fn read(text: &str, layout: &'static Layout) -> Result<Output, String> {
    Output::of(layout, text).map_err(|error| error.to_string())
}
