//! The table of helper attributes: what each is called, how it is written, what reads it.

use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Field, Meta, Token};

use super::{
    Beam, Description, bar, chain, constant, coordinate, equal, figure, gravity, identifiers, mass, mirror,
    point, support,
};

type Reader = fn(ParseStream, &mut Description) -> syn::Result<()>;

const ATTRIBUTES: [(&str, &str, Reader); 13] = [
    ("liftoff", "#[liftoff(crate = path)]", runtime),
    ("constant", "#[constant(h = l / 2)]", |input, d| {
        constant::read(input).map(|constant| d.constants.push(constant))
    }),
    ("gravity", "#[gravity(g)]", |input, d| gravity::read(input, &mut d.gravity)),
    ("bar", "#[bar(AD, mass = m, length = l)]", |input, d| {
        bar::read(input).map(|bar| d.beams.push(Beam::Bar(bar)))
    }),
    ("chain", "#[chain(c, links = 16, from = O, mass = m, length = l)]", |input, d| {
        chain::read(input).map(|chain| d.beams.push(Beam::Chain(chain)))
    }),
    ("point", "#[point(G = AD, at = l / 2)]", |input, d| {
        point::read(input).map(|point| d.points.push(point))
    }),
    ("mass", "#[mass(A, m)]", |input, d| mass::read(input).map(|mass| d.masses.push(mass))),
    ("pin", "#[pin(O = (0, 0))]", |input, d| figure::positions(input).map(|pins| d.pins.extend(pins))),
    ("support", "#[support(A = floor)]", |input, d| {
        support::read(input).map(|support| d.supports.push(support))
    }),
    ("coordinate", "#[coordinate(phi = angle(AD), from = horizontal)]", |input, d| {
        coordinate::read(input).map(|coordinate| d.coordinates.push(coordinate))
    }),
    ("equal", "#[equal(angle(AB), angle(CD))]", |input, d| {
        equal::read(input).map(|equal| d.equal.push(equal))
    }),
    ("figure", "#[figure(A = (0, 0), D = (l, 0))]", |input, d| {
        figure::positions(input).map(|places| d.figure.extend(places))
    }),
    ("mirror", "#[mirror(x = 0)]", |input, d| mirror::read(input, &mut d.mirror)),
];

/// Reads one attribute of the struct; those of others are left alone.
pub(super) fn read(attribute: &Attribute, description: &mut Description) {
    let kind = ATTRIBUTES.iter().find(|(name, ..)| attribute.path().is_ident(name));
    let Some(&(name, example, reader)) = kind else {
        return;
    };
    let result = match &attribute.meta {
        Meta::List(list) => (|input: ParseStream| reader(input, description)).parse2(list.tokens.clone()),
        meta => Err(syn::Error::new_spanned(meta, "something is missing in parentheses")),
    };
    if let Err(errors) = result {
        description.broken.push(name);
        description.malformed.extend(mentioned(attribute));
        for error in errors {
            description.report.at(error.span(), format!("{error} (for example `{example}`)"));
        }
    }
}

/// All names in an attribute, and the letters of those that may be bars named by their ends.
fn mentioned(attribute: &Attribute) -> impl Iterator<Item = String> {
    let letters = |name: &String| -> Vec<String> {
        let letters = name.chars().map(String::from);
        if name.chars().count() == 2 { letters.collect() } else { Vec::new() }
    };
    let names = identifiers(&attribute.meta);
    let letters: Vec<String> = names.iter().flat_map(letters).collect();
    names.into_iter().chain(letters)
}

/// Reports attributes of this table on a field.
pub(super) fn misplaced(field: &Field, description: &mut Description) {
    for attribute in &field.attrs {
        if let Some((name, ..)) = ATTRIBUTES.iter().find(|(name, ..)| attribute.path().is_ident(name)) {
            let text = format!("`{name}` describes the whole system; put it on the struct");
            description.report.over(attribute.path(), text);
        }
    }
}

fn runtime(input: ParseStream, description: &mut Description) -> syn::Result<()> {
    input.parse::<Token![crate]>()?;
    input.parse::<Token![=]>()?;
    description.runtime = input.call(syn::Path::parse_mod_style)?;
    Ok(())
}
