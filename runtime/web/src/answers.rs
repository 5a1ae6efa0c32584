//! What is told.

use liftoff_studio::animation::Played;
use liftoff_studio::animation::live::Sliders;
use serde::Serialize;

/// What comes of a request.
#[derive(Serialize)]
#[serde(tag = "told", rename_all = "lowercase")]
pub enum Answer {
    /// A model.
    Model(Box<Described>),
    /// Equations as HTML with MathML.
    Equations {
        /// The HTML.
        html: String,
    },
    /// A motion.
    Motion {
        /// What the player is given.
        played: Box<Played>,
        /// Its events, one line each.
        events: Vec<String>,
        /// Why it came no further.
        stopped: Option<String>,
    },
    /// A motion as comma-separated values, a row for each end of the integration's steps.
    Table {
        /// The lines.
        csv: String,
    },
    /// Mistakes of a text, at their places.
    Mistakes {
        /// One by one.
        mistakes: Vec<Mistake>,
    },
    /// Why there is no answer.
    Refused {
        /// The reason.
        why: String,
    },
}

impl Answer {
    /// No answer.
    pub fn refused(why: String) -> Self {
        Self::Refused { why }
    }
}

/// A model and the run that it declares.
#[derive(Serialize, Debug)]
pub struct Described {
    /// The names of all models of the text.
    pub models: Vec<String>,
    /// Its own.
    pub name: String,
    /// The first line of its documentation.
    pub summary: String,
    /// What can be changed; a start that the declaration gives has values.
    #[serde(flatten)]
    pub sliders: Sliders,
    /// The model in its pose, as SVG; none where a parameter has no value.
    pub drawing: Option<String>,
}

/// A mistake of a text.
#[derive(Serialize, Debug, PartialEq)]
pub struct Mistake {
    /// What the compiler says.
    pub text: String,
    /// Where it begins, in UTF-16 units as browsers count.
    pub from: usize,
    /// Where it ends.
    pub to: usize,
}
