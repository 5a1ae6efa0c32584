//! Mistakes found so far, so that one compile shows all.

use std::fmt::Display;

use proc_macro2::Span;
use quote::ToTokens;

/// Collects spanned errors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report(Option<syn::Error>);

impl Report {
    /// Adds a mistake at a place.
    pub fn add_message(&mut self, span: Span, message: impl Display) {
        self.add(syn::Error::new(span, message));
    }

    /// Adds a mistake that all of these tokens make.
    pub fn over(&mut self, tokens: &impl ToTokens, message: impl Display) {
        self.add(syn::Error::new_spanned(tokens, message));
    }

    /// Adds errors.
    pub fn add(&mut self, error: syn::Error) {
        match &mut self.0 {
            Some(all) => all.combine(error),
            None => self.0 = Some(error),
        }
    }

    /// The value, or what is wrong is kept.
    pub fn keep<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.add(error)).ok()
    }

    /// All mistakes as one error.
    ///
    /// # Errors
    /// If there was any.
    pub fn finish(self) -> syn::Result<()> {
        self.0.map_or(Ok(()), Err)
    }
}
