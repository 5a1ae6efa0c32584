//! The struct itself: named `f64` fields, no generics.

use syn::{Attribute, Data, DeriveInput, Expr, ExprLit, Fields, Lit, Meta, Type};

use super::{Description, attribute, value};

/// Reads the fields; a field of another type is reported and kept.
pub(super) fn fields(input: &DeriveInput, description: &mut Description) -> syn::Result<()> {
    let wrong = |what: &str| -> syn::Result<()> {
        let text = format!(
            "{what} cannot be a bar system; declare a struct with one named `f64` field for each parameter: \
             `struct {} {{ pub m: f64, pub l: f64 }}`",
            input.ident
        );
        Err(syn::Error::new(input.ident.span(), text))
    };
    let named = match &input.data {
        Data::Enum(_) => return wrong("an enum"),
        Data::Union(_) => return wrong("a union"),
        Data::Struct(data) => match &data.fields {
            Fields::Named(named) => named.named.iter().collect::<Vec<_>>(),
            Fields::Unnamed(_) => return wrong("a tuple struct"),
            Fields::Unit => Vec::new(),
        },
    };
    if !input.generics.params.is_empty() {
        let text = "a bar system has no generic parameters; its parameters are `f64` fields";
        return Err(syn::Error::new_spanned(&input.generics, text));
    }
    for field in named {
        let Some(name) = &field.ident else { continue };
        if !is_f64(&field.ty) {
            let text = format!("parameter `{name}` must be an `f64`");
            description.report.over(&field.ty, text);
        }
        attribute::misplaced(field, description);
        if name == "pi" {
            description.report.add_message(name.span(), "`pi` is the number π here; rename the field");
        }
        description.fields.push(name.clone());
        description.meanings.push(summary(&field.attrs));
        value::parse(field, description);
    }
    Ok(())
}

/// The first paragraph of the documentation, in one line.
pub(super) fn summary(attributes: &[Attribute]) -> String {
    let documented = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    });
    let text = documented.collect::<Vec<_>>().join("\n");
    let lines = text.lines().map(str::trim);
    lines.skip_while(|line| line.is_empty()).take_while(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}

fn is_f64(ty: &Type) -> bool {
    matches!(ty, Type::Path(path) if path.path.segments.last().is_some_and(|s| s.ident == "f64"))
}
