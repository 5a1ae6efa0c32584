//! Attributes that the compiler would refuse, told where a file is read without it.

use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Data, DeriveInput, Meta, Path, Token};

use super::attribute::ATTRIBUTES;
use super::{Report, nearest, plain, value};

/// Attributes of the compiler that may stand on a struct or a field.
const BUILT_IN: [&str; 15] = [
    "derive",
    "doc",
    "allow",
    "expect",
    "warn",
    "deny",
    "forbid",
    "cfg",
    "cfg_attr",
    "inline",
    "must_use",
    "deprecated",
    "repr",
    "non_exhaustive",
    "automatically_derived",
];

/// Helper attributes that bear neither the name of their derive nor that of its crate.
const HELPERS: [(&str, &str); 3] = [("Serialize", "serde"), ("Deserialize", "serde"), ("Parser", "clap")];

/// Derives without helper attributes on a struct.
const STANDARD: [&str; 9] =
    ["Clone", "Copy", "Debug", "Default", "Eq", "Hash", "Ord", "PartialEq", "PartialOrd"];

/// What other programs call the parts of a system, and how these are written here.
const SYNONYMS: [(&[&str], &str); 21] = [
    (
        &[
            "collision",
            "collide",
            "collider",
            "contact",
            "obstacle",
            "floor",
            "wall",
            "plane",
            "ground_plane",
            "half_space",
            "unilateral",
        ],
        "#[support(A = floor)]",
    ),
    (&["friction"], "#[support(A = floor, friction = mu)]"),
    (&["restitution", "bounce", "impact"], "#[support(A = floor, restitution = e)]"),
    (&["rope", "cable", "string", "tendon", "wire", "tether", "line"], "#[thread(AB, length = s)]"),
    (&["damper", "dashpot", "damping"], "#[spring(AB, damping = c)]"),
    (&["motor", "actuator", "servo", "motion", "prescribed"], "#[drive(phi = omega * t)]"),
    (&["load"], "#[force(P = (fx, fy))]"),
    (&["torque", "moment"], "#[couple(AB = c)]"),
    (
        &["revolute", "revolute_joint", "pin_joint", "joint", "pivot", "fixed", "anchor", "rotational"],
        "#[pin(O = (0, 0))]",
    ),
    (
        &["rigid_body", "plate", "polygon", "shape", "outline"],
        "#[body(hull, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m)]",
    ),
    (&["rod", "link", "beam", "segment", "stick"], "#[bar(AB, mass = m, length = l)]"),
    (&["ball", "bob", "point_mass"], "#[particle(P, mass = m)]"),
    (&["wheel", "circle", "roller", "cylinder"], "#[disc(P, radius = r)]"),
    (
        &["prismatic", "prismatic_joint", "guide", "rail", "track", "translational"],
        "#[slider(P = horizontal(0))]",
    ),
    (&["gear", "gears"], "#[equal(phi, 2 * psi)]"),
    (&["rigid", "glue", "fix"], "#[weld(AB, BC)]"),
    (&["angle", "dof", "generalised", "generalized"], "#[coordinate(phi = angle(AB), from = right)]"),
    (&["position", "place", "geometry", "pose"], "#[figure(A = (0, 0), B = (l, 0))]"),
    (&["until", "start", "initial", "end"], "#[run(start = \"phi = 0.1\", limit = 10)]"),
    (&["range", "bounds", "stops", "joint_limit"], "#[limit(angle(AB, BC), low = 0, high = pi / 2)]"),
    (&["symmetry", "symmetric"], "#[mirror(x = 0)]"),
];

/// The same of fields.
const FIELD_SYNONYMS: [(&[&str], &str); 1] =
    [(&["default", "unit", "param", "parameter", "set"], "#[value(9.81, unit = \"m/s²\")]")];

/// Reports attributes of an item and its fields that the compiler would refuse, and those whose
/// condition only the compiler knows.
///
/// # Errors
/// Each at its place.
pub fn check_attributes(item: &DeriveInput) -> syn::Result<()> {
    let mut report = Report::default();
    let helpers: Vec<String> =
        item.attrs.iter().flat_map(|attribute| find_helpers(&attribute.meta)).collect();
    let mut own: Vec<&str> = ATTRIBUTES.iter().map(|(name, ..)| *name).collect();
    // On a field they are reported as misplaced, on the struct `value` is.
    own.push(value::NAME);
    let of_struct =
        Allowed { own: &own, shown: &own[1..own.len() - 1], synonyms: &SYNONYMS, helpers: &helpers };
    let of_fields = Allowed { shown: &own[own.len() - 1..], synonyms: &FIELD_SYNONYMS, ..of_struct };
    of_struct.check(&item.attrs, &mut report);
    if let Data::Struct(data) = &item.data {
        for field in &data.fields {
            of_fields.check(&field.attrs, &mut report);
        }
    }
    report.finish()
}

/// What may stand at a place.
struct Allowed<'a> {
    own: &'a [&'a str],
    /// Those that are listed where nothing is near.
    shown: &'a [&'a str],
    synonyms: &'a [(&'a [&'a str], &'a str)],
    helpers: &'a [String],
}

impl Allowed<'_> {
    fn check(&self, attributes: &[Attribute], report: &mut Report) {
        for attribute in attributes {
            match parse_conditional(&attribute.meta) {
                Some(inside) => inside.iter().for_each(|meta| self.check_conditional(meta, report)),
                None => self.check_path(attribute.path(), report),
            }
        }
    }

    fn check_conditional(&self, meta: &Meta, report: &mut Report) {
        match meta.path().get_ident() {
            Some(name) if self.own.contains(&plain(name).as_str()) => {
                report
                    .over(meta, "conditions are not evaluated here; write the attribute without `cfg_attr`");
            }
            _ => self.check_path(meta.path(), report),
        }
    }

    fn check_path(&self, path: &Path, report: &mut Report) {
        let Some(name) = path.get_ident() else {
            let last = path.segments.last().map(|segment| plain(&segment.ident)).unwrap_or_default();
            if path.segments[0].ident == "liftoff" && self.own.contains(&last.as_str()) {
                report.over(path, format!("an attribute of a bar system has no path; write `{last}`"));
            }
            return;
        };
        let text = plain(name);
        let is_known = |known: &[&str]| known.contains(&text.as_str());
        if is_known(self.own) || is_known(&BUILT_IN) || self.helpers.contains(&text) {
            return;
        }
        let synonym = self.synonyms.iter().find(|(words, _)| is_known(words)).map(|(_, example)| *example);
        let hint = match synonym.or_else(|| nearest(&text, self.shown)) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("those of a bar system are `{}`", self.shown.join("`, `")),
        };
        report.add_message(name.span(), format!("there is no attribute `{name}`; {hint}"));
    }
}

/// The arguments of an attribute of this name.
fn parse_list<T>(meta: &Meta, name: &str, parse: fn(ParseStream) -> syn::Result<T>) -> Option<T> {
    let Meta::List(list) = meta else { return None };
    if list.path.is_ident(name) { list.parse_args_with(parse).ok() } else { None }
}

/// The attributes of `cfg_attr(condition, …)`.
fn parse_conditional(meta: &Meta) -> Option<Vec<Meta>> {
    let inside = parse_list(meta, "cfg_attr", Punctuated::<Meta, Token![,]>::parse_terminated)?;
    Some(inside.into_iter().skip(1).collect())
}

/// Names that the helper attributes of a `derive` may have: those of the derive and of its crate.
fn find_helpers(meta: &Meta) -> Vec<String> {
    if let Some(inside) = parse_conditional(meta) {
        return inside.iter().flat_map(find_helpers).collect();
    }
    let derives = parse_list(meta, "derive", Punctuated::<Path, Token![,]>::parse_terminated);
    let derives = derives.into_iter().flatten();
    let segments = derives.flat_map(|path| path.segments.into_iter().map(|segment| plain(&segment.ident)));
    segments
        .filter(|name| !STANDARD.contains(&name.as_str()))
        .flat_map(|name| {
            let helper =
                HELPERS.iter().filter(|(derive, _)| *derive == name).map(|(_, helper)| (*helper).into());
            helper.chain([name.to_lowercase()]).collect::<Vec<String>>()
        })
        .collect()
}
