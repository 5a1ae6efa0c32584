//! `#[slider(P = horizontal(h))]`, `vertical(x)`, `line(angle, (x, y))`, `circle((x, y), r)`,
//! `bar(AB)`; `of = P`; `stops` at the ends of a bar; `friction = mu`, `static = mu_s`, `jams`.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::contact_law::{CONTACT_LAW, ContactLaw, FrictionLaw};
use super::options::{self, Options};
use super::{Pair, unknown};

/// A point kept on a guide, two-sided.
#[derive(Clone, Debug)]
pub struct SliderDeclaration {
    /// Its name.
    pub name: Ident,
    /// The point, if it is not the name.
    pub of: Option<Ident>,
    /// What the point slides along.
    pub guide: Track,
    /// How the ends of the bar act, if they stop it.
    pub stops: Option<ContactLaw>,
    /// Coulomb friction in the guide.
    pub friction: Option<FrictionLaw>,
}

/// What a point slides along.
#[derive(Clone, Debug)]
pub enum Track {
    /// The horizontal at a height.
    Horizontal(Expr),
    /// The vertical at an x.
    Vertical(Expr),
    /// The line of a direction through a point, the origin if absent.
    Line(Expr, Option<Box<Pair>>),
    /// A circle about a place.
    Circle(Box<Pair>, Expr),
    /// The axis of a bar.
    Bar(Ident),
}

const TRACKS: [&str; 5] = ["horizontal", "vertical", "line", "circle", "bar"];

/// Reads a slider.
pub(super) fn parse(input: ParseStream) -> syn::Result<SliderDeclaration> {
    let name: Ident = input.parse()?;
    input.parse::<Token![=]>()?;
    let kind: Ident = input.parse()?;
    let guide = track(&kind, options::arguments(input)?)?;
    let allowed = [&["of", "friction", "static"], &CONTACT_LAW[..]].concat();
    let mut options = Options::with_flags(input, &allowed, &["stops", "stop", "slide_off", "jams"])?;
    if let (true, Track::Bar(bar)) = (options.flag("slide_off"), &guide) {
        let text = format!(
            "a slider stays on the line of its bar beyond the ends; a point that is to leave a bar at its end lies on one side of \
             it, `support({name} = bar({bar}))`, or is stopped there: `stops`"
        );
        return Err(syn::Error::new(kind.span(), text));
    }
    let of = options.take_name("of")?;
    let stops = options.flag("stops");
    let mut law = ContactLaw::take(&mut options)?;
    let friction = law.friction.take();
    if stops && !matches!(guide, Track::Bar(_)) {
        return Err(syn::Error::new(
            kind.span(),
            "only a bar has ends that stop; a support stops a point on a line of the ground",
        ));
    }
    if !stops && (law.armed.is_some() || law.breaks.is_some()) {
        let text = format!(
            "a slider is always there, its `stops` may come and go; a point that is to leave a bar lies on one side of it: \
             `support({name} = {kind}({}), while(\"…\"))`",
            if let Track::Bar(bar) = &guide { bar.to_string() } else { "…".to_owned() }
        );
        return Err(syn::Error::new(kind.span(), text));
    }
    if !stops && (law.restitution.is_some() || law.stop) {
        return Err(syn::Error::new(
            kind.span(),
            "`restitution`, `law` and `stop` apply to the ends of the bar; add `stops`",
        ));
    }
    Ok(SliderDeclaration { name, of, guide, stops: stops.then_some(law), friction })
}

fn track(kind: &Ident, arguments: Vec<Expr>) -> syn::Result<Track> {
    let wrong = |text: &str| Err(syn::Error::new(kind.span(), text));
    let count = arguments.len();
    let mut arguments = arguments.into_iter();
    match (kind.to_string().as_str(), count, arguments.next(), arguments.next()) {
        ("horizontal", 1, Some(height), _) => Ok(Track::Horizontal(height)),
        ("vertical", 1, Some(x), _) => Ok(Track::Vertical(x)),
        ("line", 1 | 2, Some(angle), through) => {
            let through = through.map(options::pair).transpose()?;
            Ok(Track::Line(angle, through.map(Box::new)))
        }
        ("circle", 2, Some(centre), Some(r)) => Ok(Track::Circle(Box::new(options::pair(centre)?), r)),
        ("bar", 1, Some(bar), _) => options::identifier(&bar).map(Track::Bar),
        ("horizontal", ..) => wrong("write `horizontal(height)`"),
        ("vertical", ..) => wrong("write `vertical(x)`"),
        ("line", ..) => wrong("write `line(angle)` or `line(angle, (x, y))`"),
        ("circle", ..) => wrong("write `circle((x, y), radius)`"),
        ("bar", ..) => wrong("write `bar(AB)`"),
        _ => wrong(&unknown("guide of the kind", kind, TRACKS)),
    }
}
