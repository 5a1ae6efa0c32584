//! One case: a scene, what is expected of it and how it is measured.

use super::answer::{Answer, Expected, Want};
use crate::catalog::{Failure, Integrator, Record};

/// What a case does to be measured.
type Measure = Box<dyn FnOnce(Integrator) -> Result<Answer, Failure> + Send>;

/// One case, to be judged.
pub struct Case {
    /// Its group and name.
    pub id: String,
    /// The scene in words.
    pub scene: String,
    /// The method of integration.
    pub method: Integrator,
    /// Where the expected outcome comes from.
    pub source: &'static str,
    pub(super) expected: Expected,
    pub(super) measure: Measure,
}

impl Case {
    /// Something said and numbers, both expected.
    pub fn new(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        expected: Expected,
        measure: impl FnOnce(Integrator) -> Result<Answer, Failure> + Send + 'static,
    ) -> Self {
        let (id, scene) = (id.into(), scene.into());
        Self { id, scene, method: Integrator::Dop853, source, expected, measure: Box::new(measure) }
    }

    /// Numbers near those wanted.
    pub fn numbers(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        wants: Vec<Want>,
        measure: impl FnOnce(Integrator) -> Result<Vec<f64>, Failure> + Send + 'static,
    ) -> Self {
        Self::told(id, scene, source, ("", wants), move |by| Ok((String::new(), measure(by)?)))
    }

    /// A text, and numbers near those wanted.
    pub fn told(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        (said, wants): (&str, Vec<Want>),
        measure: impl FnOnce(Integrator) -> Result<(String, Vec<f64>), Failure> + Send + 'static,
    ) -> Self {
        let expected = Expected::Answer { said: said.into(), wants };
        let measure = move |by| measure(by).map(|(said, numbers)| Answer { said, numbers });
        Self::new(id, scene, source, expected, measure)
    }

    /// A typed error whose text contains this.
    pub fn refused(
        id: impl Into<String>,
        scene: impl Into<String>,
        text: impl Into<String>,
        run: impl FnOnce(Integrator) -> Result<Box<dyn Record>, Failure> + Send + 'static,
    ) -> Self {
        let measure = |by| run(by).map(|record| Answer::of_story(&*record));
        Self::new(id, scene, "mechanics", Expected::Refusal(text.into()), measure)
    }

    /// The same by this method, which its id names.
    #[must_use]
    pub fn by(self, method: Integrator) -> Self {
        let id = format!("{} {}", self.id, method.name());
        Self { id, method, ..self }
    }
}

impl core::fmt::Debug for Case {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Case").field("id", &self.id).field("expected", &self.expected).finish_non_exhaustive()
    }
}
