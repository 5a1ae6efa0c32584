//! What runs from point to point: `AD`, `shin = knee -> foot`, `rope = A -> O -> B`.

use syn::parse::ParseStream;
use syn::{Ident, Token};

/// Reads a name and the two points it joins; `kind` is what is named.
pub(super) fn ends(kind: &str, input: ParseStream) -> syn::Result<(Ident, [Ident; 2])> {
    let (name, points) = route(kind, input)?;
    let wrong = |_| syn::Error::new(name.span(), format!("{kind} `{name}` joins two points, no more"));
    points.try_into().map(|ends| (name.clone(), ends)).map_err(wrong)
}

/// Reads a name and the points passed, two or more.
pub(super) fn route(kind: &str, input: ParseStream) -> syn::Result<(Ident, Vec<Ident>)> {
    let name: Ident = input.parse()?;
    if !input.peek(Token![=]) {
        return letters(kind, &name).map(|ends| (name, ends));
    }
    input.parse::<Token![=]>()?;
    let mut points = vec![input.parse()?];
    while points.len() < 2 || input.peek(Token![->]) {
        input.parse::<Token![->]>()?;
        points.push(input.parse()?);
    }
    Ok((name, points))
}

/// `AD` goes from `A` to `D`.
fn letters(kind: &str, name: &Ident) -> syn::Result<Vec<Ident>> {
    let wrong = || {
        let text =
            format!("{kind} `{name}` needs its ends: `{name} = A -> D`; two letters alone name both ends");
        syn::Error::new(name.span(), text)
    };
    let point = |letter: char| {
        let mut point: Ident = syn::parse_str(&letter.to_string()).map_err(|_| wrong())?;
        point.set_span(name.span());
        Ok(point)
    };
    let letters: Vec<Ident> = super::plain(name).chars().map(point).collect::<syn::Result<_>>()?;
    if letters.len() == 2 { Ok(letters) } else { Err(wrong()) }
}
