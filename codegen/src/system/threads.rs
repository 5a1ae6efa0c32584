//! Inextensible threads between points; what they pass on the way is smooth, whether it moves or
//! not.

use std::fmt::Display;

use syn::Ident;

use super::OneSided;
use super::bodies::Structure;
use super::contact_law::{Contacts, restitution};
use super::figure::{Figure, NEAR};
use super::mass_properties::positive;
use super::scope::Scope;
use crate::syntax::{ThreadDeclaration, plain};

/// Resolves all threads.
pub(super) fn resolve(
    scope: &mut Scope,
    structure: &Structure,
    figure: Option<&Figure>,
    contacts: &mut Contacts,
) {
    let description = scope.description;
    for declared in &description.threads {
        let name = &declared.name;
        let help = format!("give one another name: `other = {} -> …`", declared.path[0]);
        contacts.claim(scope, "thread", name, plain(name), &help);
        let length = positive(scope, "the length", name, &declared.length);
        let restitution = restitution(scope, name, &declared.contact_law);
        let path = path(scope, structure, declared);
        if let (Some(length), Some(path)) = (length, path) {
            refuse_discs(scope, structure, declared, &path);
            let given = figure.filter(|figure| !path.iter().any(|&point| figure.assumed[point]));
            let drawn = given.and_then(|figure| drawn(scope, figure, &path));
            if let Some((drawn, length)) = drawn.zip(scope.literal(&length)) {
                too_short(scope, declared, drawn, length);
            }
            let contact = OneSided::Thread { path, length };
            contacts.push(
                name,
                plain(name),
                (contact, None),
                (&declared.contact_law, restitution),
                (None, None),
            );
        }
    }
}

fn path(scope: &mut Scope, structure: &Structure, declared: &ThreadDeclaration) -> Option<Vec<usize>> {
    let points: Vec<Option<usize>> = declared.path.iter().map(|name| structure.point(scope, name)).collect();
    let path: Vec<usize> = points.into_iter().collect::<Option<_>>()?;
    let (first, last) = (*path.first()?, *path.last()?);
    let held = |a: usize, b: usize| structure.fixed(a).and(structure.fixed(b)).is_some();
    let text = if path.windows(2).any(|pair| pair[0] == pair[1]) || first == last {
        format!("thread `{}` must join different points", declared.name)
    } else if path.windows(2).all(|pair| structure.rigid(pair[0], pair[1]) || held(pair[0], pair[1])) {
        match &declared.path[..] {
            [a, b] => nothing_moves("thread", &declared.name, [a, b]),
            _ => {
                format!("thread `{}` has no effect: none of its parts ever changes its length", declared.name)
            }
        }
    } else {
        return Some(path);
    };
    scope.report.add_message(declared.name.span(), text);
    None
}

/// A thread passes its inner points as smooth eyes; about a disc it would take another way.
fn refuse_discs(scope: &mut Scope, structure: &Structure, declared: &ThreadDeclaration, path: &[usize]) {
    let inner = declared.path.iter().zip(path).take(path.len() - 1).skip(1);
    for (point, _) in inner.filter(|(_, at)| structure.disc(**at).is_some()) {
        let text = format!(
            "thread `{}` passes `{point}`, which has a disc; a thread does not wrap round discs: \
             lead it through a second point there, without a disc",
            declared.name
        );
        scope.report.add_message(point.span(), text);
    }
}

/// What is said of a thread or spring whose ends keep their distance.
pub(super) fn nothing_moves(kind: &str, name: &impl Display, [a, b]: [&Ident; 2]) -> String {
    format!("{kind} `{name}` has no effect: the distance of `{a}` and `{b}` never changes")
}

/// The length along the points, if no parameter changes it.
fn drawn(scope: &Scope, figure: &Figure, path: &[usize]) -> Option<f64> {
    let places: Option<Vec<_>> =
        path.iter().map(|&point| scope.literal_pair(&figure.positions[point])).collect();
    let distance = |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
    Some(places?.windows(2).map(distance).sum())
}

fn too_short(scope: &mut Scope, declared: &ThreadDeclaration, drawn: f64, length: f64) {
    if drawn > length * (1.0 + NEAR) {
        let text = format!(
            "thread `{}` is {length} long, but its points are {drawn} apart in the figure",
            declared.name
        );
        scope.report.over(&declared.length, text);
    }
}
