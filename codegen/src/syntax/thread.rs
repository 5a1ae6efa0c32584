//! `#[thread(BD, length = s)]`, `#[thread(rope = A -> O -> B, length = s, restitution = e)]`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::contact_law::{CONTACT_LAW, ContactLaw};
use super::options::Options;
use super::route;

/// An inextensible thread.
#[derive(Clone, Debug)]
pub struct ThreadDeclaration {
    /// Its name.
    pub name: Ident,
    /// The points it passes, from end to end.
    pub path: Vec<Ident>,
    /// Its length.
    pub length: Expr,
    /// How it acts.
    pub contact_law: ContactLaw,
}

/// Reads a thread.
pub(super) fn parse(input: ParseStream) -> syn::Result<ThreadDeclaration> {
    let (name, path) = route::route("thread", input)?;
    let mut options = Options::with_flags(input, &[&["length"], &CONTACT_LAW[..]].concat(), &["stop"])?;
    Ok(ThreadDeclaration {
        path,
        length: options.require("length", &name)?,
        contact_law: ContactLaw::take(&mut options)?,
        name,
    })
}
