//! The table of helper attributes: what each is called, how it is written, what reads it.

use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Field, Ident, LitBool, Meta, Token};

use super::{
    Beam, Description, bar, body, budget, chain, constant, coordinate, couple, disc, drive, equal, figure,
    force, gravity, hinge, identifiers, joint_limit, mass, mirror, options, particle, point, run, section,
    slider, spring, support, thread, torsion, value, weld,
};

type AttributeParser = fn(ParseStream, &mut Description) -> syn::Result<()>;

pub(super) const ATTRIBUTES: [(&str, &str, AttributeParser); 30] = [
    ("liftoff", "#[liftoff(crate = path, sets = 16)]", settings),
    ("budget", "#[budget(flops = 120)]", |input, d| {
        budget::parse(input).map(|budget| d.budgets.push(budget))
    }),
    ("constant", "#[constant(h = l / 2)]", |input, d| {
        constant::parse(input).map(|constant| d.constants.push(constant))
    }),
    ("gravity", "#[gravity(g)]", |input, d| gravity::parse(input, &mut d.gravity)),
    ("bar", "#[bar(AD, mass = m, length = l)]", |input, d| {
        bar::parse(input).map(|bar| d.beams.push(Beam::Bar(bar)))
    }),
    ("chain", "#[chain(c, links = 16, from = O, mass = m, length = l)]", |input, d| {
        chain::parse(input).map(|chain| d.beams.push(Beam::Chain(chain)))
    }),
    ("body", "#[body(hull, points(A = (0, 0), B = (l, 0), C = (l / 2, h)), mass = m)]", |input, d| {
        body::parse(input).map(|body| d.beams.push(Beam::Body(body)))
    }),
    ("particle", "#[particle(P, mass = m)]", |input, d| {
        particle::parse(input).map(|particle| d.particles.push(particle))
    }),
    ("point", "#[point(G = AD, at = l / 2)]", |input, d| {
        point::parse(input).map(|point| d.points.push(point))
    }),
    ("mass", "#[mass(A, m)]", |input, d| mass::parse(input).map(|mass| d.masses.push(mass))),
    ("disc", "#[disc(P, radius = r)]", |input, d| disc::parse(input).map(|disc| d.discs.push(disc))),
    ("pin", "#[pin(O = (0, 0))]", hinge::pin),
    ("ground", "#[ground(O = (0, 0))]", |input, d| {
        figure::positions(input).map(|points| d.ground.extend(points))
    }),
    ("weld", "#[weld(AB, BC)]", weld::parse),
    ("slider", "#[slider(P = horizontal(0))]", |input, d| {
        slider::parse(input).map(|slider| d.sliders.push(slider))
    }),
    ("drive", "#[drive(phi = omega * t)]", |input, d| drive::parse(input).map(|drive| d.drives.push(drive))),
    ("spring", "#[spring(AB, stiffness = k, length = l)]", |input, d| {
        spring::parse(input).map(|spring| d.springs.push(spring))
    }),
    ("torsion", "#[torsion(AB, BC, stiffness = k)]", |input, d| {
        torsion::parse(input).map(|torsion| d.torsions.push(torsion))
    }),
    ("force", "#[force(P = (fx, fy))]", |input, d| force::parse(input).map(|force| d.forces.push(force))),
    ("couple", "#[couple(AB = c)]", |input, d| couple::parse(input).map(|couple| d.couples.push(couple))),
    ("section", "#[section(S = AB, at = l / 2)]", |input, d| {
        section::parse(input).map(|section| d.sections.push(section))
    }),
    ("thread", "#[thread(AB, length = s)]", |input, d| {
        thread::parse(input).map(|thread| d.threads.push(thread))
    }),
    ("limit", "#[limit(angle(AB, BC), low = 0, high = pi / 2)]", |input, d| {
        joint_limit::parse(input).map(|limit| d.limits.push(limit))
    }),
    ("support", "#[support(A = floor)]", |input, d| {
        support::parse(input).map(|support| d.supports.push(support))
    }),
    ("coordinate", "#[coordinate(phi = angle(AD), from = horizontal)]", |input, d| {
        coordinate::parse(input).map(|coordinate| d.coordinates.push(coordinate))
    }),
    ("equal", "#[equal(angle(AB), angle(CD))]", |input, d| {
        equal::parse(input).map(|equal| d.equal.push(equal))
    }),
    ("figure", "#[figure(A = (0, 0), D = (l, 0))]", |input, d| {
        figure::positions(input).map(|places| d.figure.extend(places))
    }),
    ("run", "#[run(start = \"phi = 0.1\", until = \"phi = pi/2\")]", |input, d| {
        run::parse(input, &mut d.run)
    }),
    ("hinge", "#[hinge(A, friction = mu, radius = r)]", |input, d| {
        hinge::parse(input).map(|hinge| d.hinges.push(hinge))
    }),
    ("mirror", "#[mirror(x = 0)]", |input, d| mirror::parse(input, &mut d.mirror)),
];

/// Reads one attribute of the struct; those of others are left alone.
pub(super) fn parse(attribute: &Attribute, description: &mut Description) {
    value::misplaced(attribute, description);
    let kind = ATTRIBUTES.iter().find(|(name, ..)| attribute.path().is_ident(name));
    let Some(&(name, example, reader)) = kind else {
        return;
    };
    let result = match &attribute.meta {
        // What is missing at the end is missing at the closing bracket.
        Meta::List(list) => list.parse_args_with(|input: ParseStream| reader(input, description)),
        meta => Err(syn::Error::new_spanned(meta, "expected arguments in parentheses")),
    };
    if let Err(errors) = result {
        description.broken.push(name);
        description.malformed.extend(mentioned(attribute));
        for error in errors {
            description.report.add_message(error.span(), format!("{error} (for example `{example}`)"));
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

/// Most contact sets that can be asked for.
const MOST_SETS: usize = 4096;

fn settings(input: ParseStream, description: &mut Description) -> syn::Result<()> {
    while !input.is_empty() {
        let name = input.call(Ident::parse_any)?;
        match name.to_string().as_str() {
            "crate" => {
                input.parse::<Token![=]>()?;
                description.runtime = input.call(syn::Path::parse_mod_style)?;
            }
            "sets" => {
                description.sets = Some(options::whole("sets", &options::assigned(input)?, 0..=MOST_SETS)?);
            }
            "names" => {
                input.parse::<Token![=]>()?;
                if !input.parse::<LitBool>()?.value {
                    description.names = None;
                }
            }
            "dimensionless" => description.dimensionless = true,
            _ => {
                let text = "expected `crate = path`, `sets = 16`, `names = false` or `dimensionless`";
                return Err(syn::Error::new(name.span(), text));
            }
        }
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    Ok(())
}
