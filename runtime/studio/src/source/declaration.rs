//! The declarations of a file as they stand in it, to be written into another.

use super::{Mistake, declared, parse_file};
use crate::run_spec::{PointImpulse, RunSpec, Values};
use syn::spanned::Spanned;
use syn::{Data, DeriveInput, Visibility};

/// A struct that derives `BarSystem`.
pub struct Declaration {
    /// Name of the struct.
    pub name: String,
    text: String,
    /// Where the struct begins behind its attributes, and each of its fields, with their names:
    /// bytes of the text.
    places: Vec<(usize, String)>,
}

/// Every item of a file that derives `BarSystem`, in order.
///
/// # Errors
/// What is no Rust.
pub fn declarations(source: &str) -> Result<Vec<Declaration>, Vec<Mistake>> {
    let items = parse_file(source)?.items.into_iter().flat_map(declared);
    Ok(items.map(|item| Declaration::from_item(source, &item)).collect())
}

impl Declaration {
    fn from_item(source: &str, item: &DeriveInput) -> Self {
        let all = item.span().byte_range();
        let begin = |visibility: &Visibility, own: usize| match visibility {
            Visibility::Inherited => own,
            given => given.span().byte_range().start,
        };
        let mut places = Vec::new();
        if let Data::Struct(data) = &item.data {
            places.push((begin(&item.vis, data.struct_token.span.byte_range().start), String::new()));
            let named = data.fields.iter().filter_map(|field| Some((field, field.ident.as_ref()?)));
            places.extend(
                named.map(|(field, name)| {
                    (begin(&field.vis, name.span().byte_range().start), name.to_string())
                }),
            );
        }
        let places = places.into_iter().map(|(at, name)| (at - all.start, name)).collect();
        Self { name: item.ident.to_string(), text: source[all].to_owned(), places }
    }

    /// The text with a run, and values of parameters, that it does not declare: attributes, and
    /// what they do not express as an implementation of `DefaultRun`.
    pub fn with_run(&self, run: &RunSpec) -> String {
        let mut text = self.text.clone();
        for (at, name) in self.places.iter().rev() {
            let attribute = match name.as_str() {
                "" => run_attribute(run),
                name => value_of(&run.parameters, name).map(|value| format!("#[value({value:?})]")),
            };
            if let Some(attribute) = attribute {
                let indent: String = text[..*at].chars().rev().take_while(|c| *c == ' ').collect();
                text.insert_str(*at, &format!("{attribute}\n{indent}"));
            }
        }
        match is_declarable(run) {
            true => text,
            false => format!("{text}\n\n{}", implementation(&self.name, run)),
        }
    }

    /// The text as it stands.
    pub fn text(&self) -> &str {
        &self.text
    }
}

fn value_of(values: &Values, name: &str) -> Option<f64> {
    values.iter().find(|(known, _)| known == name).map(|(_, value)| *value)
}

/// Whether attributes express a run.
fn is_declarable(run: &RunSpec) -> bool {
    let declared =
        RunSpec { parameters: Vec::new(), start: Vec::new(), until: Vec::new(), limit: None, ..run.clone() };
    declared == RunSpec::with(&[])
}

/// `#[run(start = "phi = 1", until = "t = 2")]`.
fn run_attribute(run: &RunSpec) -> Option<String> {
    let start: Vec<String> = run.start.iter().map(|(name, value)| format!("{name} = {value:?}")).collect();
    let until = (!run.until.is_empty()).then(|| format!("until = {:?}", run.until.join(" or ")));
    let start = (!start.is_empty()).then(|| format!("start = {:?}", start.join(", ")));
    let parts: Vec<String> =
        start.into_iter().chain(until).chain(run.limit.map(|limit| format!("limit = {limit:?}"))).collect();
    (is_declarable(run) && !parts.is_empty()).then(|| format!("#[run({})]", parts.join(", ")))
}

/// `impl DefaultRun for …` with everything of the run.
fn implementation(name: &str, run: &RunSpec) -> String {
    let mut chain = vec![format!("RunSpec::with(&{:?})", borrowed(&run.parameters))];
    let mut add = |method: &str, arguments: String| chain.push(format!(".{method}({arguments})"));
    if !run.start.is_empty() {
        add("start", format!("&{:?}", borrowed(&run.start)));
    }
    if !run.energy_of.is_empty() {
        add("energy_of", format!("&{:?}", borrowed(&run.energy_of)));
    }
    if !run.hold.is_empty() {
        add("hold", format!("&{:?}", run.hold));
    }
    run.release.iter().for_each(|(support, at)| add("release", format!("{support:?}, {at:?}")));
    run.cut.iter().for_each(|(thread, condition)| add("cut", format!("{thread:?}, {condition:?}")));
    for PointImpulse { point, impulse, at } in &run.impulses {
        add("impulse", format!("{point:?}, {impulse:?}, {at:?}"));
    }
    run.until.iter().for_each(|condition| add("until", format!("{condition:?}")));
    run.limit.iter().for_each(|limit| add("limit", format!("{limit:?}")));
    if run.tolerance != RunSpec::with(&[]).tolerance {
        add("tolerance", format!("{:?}", run.tolerance));
    }
    let chain = chain.join("\n            ");
    let made = match run.stop_at_impacts {
        true => format!("RunSpec {{\n            stop_at_impacts: true,\n            ..{chain}\n        }}"),
        false => chain,
    };
    format!(
        "impl liftoff_cli::DefaultRun for {name} {{\n    fn default_run() -> liftoff_cli::RunSpec {{\n        \
         use liftoff_cli::RunSpec;\n        {made}\n    }}\n}}"
    )
}

fn borrowed(values: &Values) -> Vec<(&str, f64)> {
    values.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source;

    const ROD: &str = "/// A rod.\n#[derive(BarSystem)]\n#[bar(OA, mass = m, length = l)]\n#[pin(O = (0, 0))]\n\
                       #[figure(A = (0, -l))]\n#[coordinate(phi = angle(OA), from = down)]\npub struct Rod {\n    \
                       /// Mass.\n    pub m: f64,\n    pub l: f64,\n}";

    /// What is written reads back as the run that it was written for.
    #[test]
    fn a_run_is_written_into_its_declaration() {
        let source = format!("use liftoff::prelude::*;\n{ROD}\nfn main() {{}}\n");
        let found = declarations(&source).ok().and_then(|mut all| all.pop()).expect("a declaration");
        assert_eq!((found.name.as_str(), found.text()), ("Rod", ROD));
        let run = RunSpec::with(&[("m", 1.0), ("l", 0.5)]).start(&[("phi", 1.25)]).until("t = 2").limit(3.0);
        let text = found.with_run(&run);
        assert!(text.contains("    /// Mass.\n    #[value(1.0)]\n    pub m: f64,\n"), "{text}");
        let models = source::models(&text).expect("a model");
        assert_eq!(models[0].default_run(), run);
        let two = found.with_run(&run.clone().until("phi = 0"));
        assert!(two.contains("until = \"t = 2 or phi = 0\""), "{two}");
        let held = found.with_run(&run.hold(&["P"]).tolerance(1e-9));
        assert!(
            held.contains(".hold(&[\"P\"])") && held.contains(".tolerance(1e-9)") && !held.contains("#[run")
        );
    }
}
