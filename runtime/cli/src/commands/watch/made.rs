//! The page of a text, made on a thread of its own.

use super::Request;
use super::server::Shown;
use crate::CommandError;
use crate::options::files;
use anstream::adapter::strip_str;
use liftoff::Trajectory;
use liftoff_studio::animation::{About, page};
use liftoff_studio::registry::{Entry, RunOptions, as_far};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

/// A page that is being made; given up when dropped.
pub(super) struct Making(Arc<AtomicBool>);

impl Making {
    /// Of the text of a file, or of why it cannot be read now.
    pub fn begin(
        (path, text): (String, Result<String, String>),
        request: Arc<Request>,
        shown: Arc<Shown>,
    ) -> Self {
        let cancel = Arc::<AtomicBool>::default();
        let given_up = Arc::clone(&cancel);
        thread::spawn(move || {
            let made =
                text.map_err(CommandError::Failed).and_then(|text| request.made(&path, &text, &given_up));
            if !given_up.load(Ordering::Relaxed) {
                match made {
                    Ok(page) => shown.page(page),
                    Err(error) => shown.mistakes(&strip_str(&error.to_string()).to_string()),
                }
            }
        });
        Self(cancel)
    }
}

impl Drop for Making {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl Request {
    /// The page of the motion, as far as it comes.
    fn made(&self, path: &str, text: &str, cancel: &Arc<AtomicBool>) -> Result<String, CommandError> {
        let model = files::of_text(path, text, self.model.as_deref())?;
        self.output.iter().try_for_each(|output| model.check(output))?;
        let spec = self.run_args.spec(&model)?;
        let options = RunOptions::by(self.method).cancel(Arc::clone(cancel));
        let (record, stopped) = as_far(model.run_by(options, &spec))?;
        self.page(&model, &spec.parameters, (&record, stopped.as_deref()))
    }

    fn page(
        &self,
        model: &Entry,
        parameters: &[(String, f64)],
        (record, stopped): (&Trajectory, Option<&str>),
    ) -> Result<String, CommandError> {
        let (title, summary, outputs) = (model.name(), model.summary(), &self.output[..]);
        Ok(page(record, &About { title, summary, parameters, outputs, stopped })?)
    }
}
