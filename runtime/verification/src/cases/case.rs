//! One case: a scene, what is expected of it and how it is measured.

use super::answer::{Answer, Expectation, Expected};
use crate::MotionError;
use liftoff::Trajectory;
use liftoff::method::MethodId;

/// What a case does to be measured.
type Measure = Box<dyn FnOnce(MethodId) -> Result<Answer, MotionError> + Send>;

/// One case, to be judged.
pub struct Case {
    /// Unique id: group, `.`, name; then the method.
    pub id: String,
    /// Model, parameters and start in a few words, for the table.
    pub scene: String,
    /// The method that the scene is run by; DOP853 unless [`Case::by`] sets it.
    pub method: MethodId,
    /// Where the expected outcome comes from.
    pub source: &'static str,
    pub(super) expected: Expected,
    pub(super) measure: Measure,
}

impl Case {
    /// A case with any kind of expected outcome.
    pub fn new(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        expected: Expected,
        measure: impl FnOnce(MethodId) -> Result<Answer, MotionError> + Send + 'static,
    ) -> Self {
        let (id, scene) = (id.into(), scene.into());
        Self { id, scene, method: MethodId::Dop853, source, expected, measure: Box::new(measure) }
    }

    /// Numbers within the errors that `expectations` allow.
    pub fn numbers(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        expectations: Vec<Expectation>,
        measure: impl FnOnce(MethodId) -> Result<Vec<f64>, MotionError> + Send + 'static,
    ) -> Self {
        Self::text_and_numbers(id, scene, source, ("", expectations), move |by| {
            Ok((String::new(), measure(by)?))
        })
    }

    /// An exact text, and numbers within the errors that `expectations` allow.
    pub fn text_and_numbers(
        id: impl Into<String>,
        scene: impl Into<String>,
        source: &'static str,
        (text, expectations): (&str, Vec<Expectation>),
        measure: impl FnOnce(MethodId) -> Result<(String, Vec<f64>), MotionError> + Send + 'static,
    ) -> Self {
        let expected = Expected::Answer { text: text.into(), expectations };
        let measure = move |by| measure(by).map(|(text, numbers)| Answer { text, numbers });
        Self::new(id, scene, source, expected, measure)
    }

    /// A typed error whose text contains this.
    pub fn refused(
        id: impl Into<String>,
        scene: impl Into<String>,
        text: impl Into<String>,
        run: impl FnOnce(MethodId) -> Result<Trajectory, MotionError> + Send + 'static,
    ) -> Self {
        let measure = |by| run(by).map(|record| Answer::of_events(&record));
        Self::new(id, scene, "mechanics", Expected::Refusal(text.into()), measure)
    }

    /// The same by this method, which its id names.
    #[must_use]
    pub fn by(self, method: MethodId) -> Self {
        let id = format!("{} {}", self.id, method.name());
        Self { id, method, ..self }
    }
}

impl core::fmt::Debug for Case {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Case").field("id", &self.id).field("expected", &self.expected).finish_non_exhaustive()
    }
}
