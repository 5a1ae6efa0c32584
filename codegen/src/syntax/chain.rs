//! `#[chain(c, links = 16, from = O, mass = m, length = l)]`: equal bars `c1`, `c2`, … through
//! `c_1`, `c_2`, ….

use syn::Ident;
use syn::parse::ParseStream;

use super::bar::{Bar, MASS_PROPERTIES, MassProperties};
use super::options::{self, Options};
use super::plain;

/// More would overflow the stack of a compiler that compiles what is emitted.
const MOST: usize = 512;

/// Equal bars hinged one after the other.
#[derive(Clone, Debug)]
pub struct ChainDeclaration {
    /// Its name.
    pub name: Ident,
    /// How many bars.
    pub links: usize,
    /// Where it begins.
    pub from: Ident,
    /// What its last point is called, if not `NAME_n`.
    pub to: Option<Ident>,
    /// What each bar is made of.
    pub mass_properties: MassProperties,
}

/// Reads a chain.
pub(super) fn parse(input: ParseStream) -> syn::Result<ChainDeclaration> {
    let name: Ident = input.parse()?;
    let mut options = Options::parse(input, &[&MASS_PROPERTIES[..], &["links", "from", "to"]].concat())?;
    let links = options::whole("links", &options.require("links", &name)?, 1..=MOST)?;
    let begin = syn::Error::new(name.span(), format!("`{name}` has no beginning; add `from = …`, a point"));
    Ok(ChainDeclaration {
        links,
        from: options.take_name("from")?.ok_or(begin)?,
        to: options.take_name("to")?,
        mass_properties: MassProperties::take(&mut options, &name)?,
        name,
    })
}

impl ChainDeclaration {
    /// Its bars, in order.
    pub(crate) fn bars(&self) -> impl Iterator<Item = Bar> + '_ {
        let span = self.name.span();
        (1..=self.links).map(move |k| Bar {
            name: Ident::new(&format!("{}{k}", plain(&self.name)), span),
            from: self.point(k - 1),
            to: self.point(k),
            mass_properties: self.mass_properties.clone(),
        })
    }

    fn point(&self, k: usize) -> Ident {
        match &self.to {
            _ if k == 0 => self.from.clone(),
            Some(to) if k == self.links => to.clone(),
            _ => Ident::new(&format!("{}_{k}", plain(&self.name)), self.name.span()),
        }
    }
}
