//! `#[hinge(A, friction = mu, static = mu_s, radius = r)]`, of a pinned point also
//! `#[pin(A, friction = mu, radius = r)]`; `#[pin(O = (x, y), while("…"), breaks("…"))]`.

use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::Description;
use super::contact_law::{FrictionLaw, friction};
use super::drive::{DriveDeclaration, Target};
use super::figure;
use super::options::{self, CONDITIONS, Options};

/// A hinge with friction: a journal of a radius in its bearing.
#[derive(Clone, Debug)]
pub struct HingeDeclaration {
    /// The point.
    pub point: Ident,
    /// Coulomb friction of the journal.
    pub friction: FrictionLaw,
    /// The radius of the journal.
    pub radius: Expr,
}

/// Reads the friction of a hinge.
pub(super) fn parse(input: ParseStream) -> syn::Result<HingeDeclaration> {
    let point: Ident = input.parse()?;
    if input.is_empty() {
        let text = format!(
            "bars that share a point are hinged there without an attribute; with friction: \
             `hinge({point}, friction = mu, radius = r)`"
        );
        return Err(syn::Error::new(point.span(), text));
    }
    if options::is_condition_ahead(input) {
        // A point that bodies share has one place in the equations.
        let text = format!(
            "what shares a point does not come apart: give each body a point of its own there, `{point}` and `Q`, and hold `Q` by \
             `drive(along(Q, BAR) = s, while(\"…\"))` and one `support` under it on either side of the bar, `bar(BAR)`, with the same condition"
        );
        return Err(syn::Error::new(point.span(), text));
    }
    let mut options = Options::with_flags(input, &["friction", "static", "radius"], &[])?;
    let radius = options.take("radius");
    let law = friction(&mut options, false)?;
    let missing = |what: &str| syn::Error::new(point.span(), format!("hinge `{point}` has no {what}"));
    let friction = law.ok_or_else(|| {
        missing("friction; add `friction = mu`. Other resistance to rotation is a `torsion` with `damping`")
    })?;
    let radius = radius.ok_or_else(|| {
        missing("radius; add the radius of its journal, `radius = r`, the lever of the friction couple")
    })?;
    Ok(HingeDeclaration { point, friction, radius })
}

/// Refuses options behind the place of a pin but conditions: its friction is an attribute of its own.
fn refuse_friction_of_place(input: ParseStream) -> syn::Result<()> {
    let ahead = input.fork();
    let place = ahead.parse::<Ident>().and_then(|point| options::assigned(&ahead).map(|_| point));
    let Ok(point) = place else { return Ok(()) };
    let option = ahead.fork();
    let name = option.parse::<Token![,]>().and_then(|_| option.call(Ident::parse_any));
    match name {
        Ok(name) if ["friction", "static", "radius"].iter().any(|word| name == word) => {
            let text = format!(
                "declare the friction of a pin by a separate attribute: `#[pin({point}, friction = mu, radius = r)]`"
            );
            Err(syn::Error::new(name.span(), text))
        }
        _ if options::is_condition_ahead(&ahead) => Ok(()),
        _ => options::refuse_contact_options(&ahead),
    }
}

/// Reads pins, or the friction of one that is declared.
pub(super) fn pin(input: ParseStream, description: &mut Description) -> syn::Result<()> {
    if input.peek(Ident) && input.peek2(Token![,]) {
        return parse(input).map(|hinge| description.hinges.push(hinge));
    }
    refuse_friction_of_place(input)?;
    if input.is_empty() {
        return Err(input.error("expected a point and its position"));
    }
    let mut pins = vec![figure::position(input)?];
    while !input.is_empty() && !options::is_condition_ahead(input) {
        input.parse::<Token![,]>()?;
        if !input.is_empty() {
            pins.push(figure::position(input)?);
        }
    }
    let mut options = Options::parse(input, &CONDITIONS)?;
    let (armed, breaks) = (options.take_switch(), options.take_break());
    if armed.is_none() && breaks.is_none() {
        description.pins.extend(pins);
        return Ok(());
    }
    let drives = pins.iter().flat_map(|(point, place)| {
        let values = place.iter().cloned().enumerate();
        values.map(|(axis, value)| (Target::Position(point.clone(), axis), value))
    });
    description.drives.extend(drives.map(|(target, value)| DriveDeclaration {
        target,
        value,
        armed: armed.clone(),
        breaks: breaks.clone(),
    }));
    description.loose_pins.extend(pins);
    Ok(())
}
