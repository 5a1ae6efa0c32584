//! Equations in a struct's own documentation, as HTML with MathML, which browsers set without
//! scripts.

use core::fmt::Write;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{DeriveInput, parse_quote};

use crate::math::{Equation, Math};
use crate::text::{Equations, PhaseEquations};

/// More phases than this are folded up.
const UNFOLDED: usize = 2;
const PARAGRAPH: &str = "<p style=\"padding-left: 2em; text-indent: -2em; line-height: 2\">";

/// Puts [`documented`] over an item where it is documented; nothing else is done where it is
/// compiled.
pub fn document(runtime: TokenStream, item: TokenStream) -> TokenStream {
    let runtime = if runtime.is_empty() { quote!(::liftoff) } else { runtime };
    quote!(#[cfg_attr(doc, #runtime::documented)] #item)
}

/// The item with its equations at the end of its documentation; mistakes are left to the derive
/// macro.
pub fn documented(item: TokenStream) -> TokenStream {
    let Ok(mut input) = syn::parse2::<DeriveInput>(item.clone()) else { return item };
    let mut declaration = input.clone();
    declaration.attrs.retain(|attribute| !attribute.path().is_ident("derive"));
    let Ok(equations) = crate::equations(declaration.into_token_stream()) else { return item };
    let text = format!("\n\n# Equations\n\n{}", html(&equations));
    input.attrs.push(parse_quote!(#[doc = #text]));
    input.into_token_stream()
}

/// Equations as HTML with MathML; without empty lines, which would end the HTML of a documentation.
pub fn html(equations: &Equations) -> String {
    let mut text = "<div>\n".to_owned();
    let coordinates = equations.coordinates.iter();
    let coordinates = coordinates.map(|c| format!("<li>{}: {}</li>", c.symbol.mathml(), escaped(&c.meaning)));
    let _ = writeln!(text, "<ul>{}</ul>", coordinates.collect::<String>());
    let system = equations.energies.iter().chain(&equations.mass).chain(&equations.velocity_terms);
    let system = system.chain(&equations.forces).chain(&equations.definitions).chain(&equations.gaps);
    paragraphs(system, &mut text);
    for (name, constraint) in &equations.joints {
        let equation = Equation::new(Math::ZERO, constraint.clone());
        let _ = writeln!(text, "{PARAGRAPH}{}: {}</p>", escaped(name), equation.mathml());
    }
    let open = if equations.phases.len() > UNFOLDED { "" } else { " open" };
    equations.sections().for_each(|each| phase(each, open, &mut text));
    text + "</div>\n"
}

fn phase(phase: &PhaseEquations, open: &str, text: &mut String) {
    let _ = writeln!(text, "<details{open}><summary>{}</summary>", escaped(&phase.title()));
    let equations = phase.eliminated.iter().chain(&phase.energies).chain(&phase.motion);
    paragraphs(equations.chain(&phase.reactions), text);
    if let Some(cost) = phase.cost {
        let _ = writeln!(text, "<p>Right-hand side: {cost}.</p>");
    }
    *text += "</details>\n";
}

fn paragraphs<'a>(equations: impl Iterator<Item = &'a Equation>, text: &mut String) {
    for equation in equations {
        let _ = writeln!(text, "{PARAGRAPH}{}</p>", equation.mathml());
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}
