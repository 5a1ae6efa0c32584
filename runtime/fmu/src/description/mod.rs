//! `modelDescription.xml`, in the order of FMI 3.0's schema.

mod structure;
mod units;
mod variables;

use crate::interface::{Interface, contact_states};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use std::io::Result;

type Xml = Writer<Vec<u8>>;

/// An attribute; left out where it has no value.
type Attribute<'a> = (&'a str, Option<String>);

/// Relative tolerance for importers that integrate: events are then located to about as many
/// digits.
const TOLERANCE: f64 = 1e-9;

/// The category of messages.
pub const ERRORS: &str = "logStatusError";

/// What the description says beside the variables.
pub(crate) struct Head<'a> {
    pub(crate) name: &'a str,
    /// A name in C, of the binary too.
    pub(crate) identifier: &'a str,
    pub(crate) token: &'a str,
    pub(crate) summary: &'a str,
    /// When the default run ends, if it does.
    pub(crate) stop: Option<f64>,
}

/// The description of a model.
pub(crate) fn description(head: &Head, interface: &Interface) -> Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let attributes = [
        ("fmiVersion", Some("3.0".to_owned())),
        ("modelName", Some(head.name.to_owned())),
        ("instantiationToken", Some(head.token.to_owned())),
        ("description", Some(head.summary.to_owned()).filter(|summary| !summary.is_empty())),
        ("generationTool", Some(concat!("liftoff ", env!("CARGO_PKG_VERSION")).to_owned())),
        ("variableNamingConvention", Some("flat".to_owned())),
    ];
    parent(&mut xml, "fmiModelDescription", &attributes, |xml| {
        if interface.exchange_lacks.is_none() {
            element(xml, "ModelExchange", &[("modelIdentifier", Some(head.identifier.to_owned()))])?;
        }
        co_simulation(xml, head)?;
        units::write(xml, interface)?;
        parent(xml, "TypeDefinitions", &[], contact_type)?;
        parent(xml, "LogCategories", &[], |xml| {
            element(xml, "Category", &[("name", Some(ERRORS.to_owned()))])
        })?;
        let experiment = [
            ("startTime", Some("0".to_owned())),
            ("stopTime", head.stop.map(number)),
            ("tolerance", Some(number(TOLERANCE))),
        ];
        element(xml, "DefaultExperiment", &experiment)?;
        parent(xml, "ModelVariables", &[], |xml| variables::write(xml, interface))?;
        parent(xml, "ModelStructure", &[], |xml| structure::write(xml, interface))
    })?;
    let mut text = xml.into_inner();
    text.push(b'\n');
    String::from_utf8(text).map_err(std::io::Error::other)
}

fn co_simulation(xml: &mut Xml, head: &Head) -> Result<()> {
    let can = || Some("true".to_owned());
    let attributes = [
        ("modelIdentifier", Some(head.identifier.to_owned())),
        ("canHandleVariableCommunicationStepSize", can()),
        ("mightReturnEarlyFromDoStep", can()),
        ("hasEventMode", can()),
    ];
    element(xml, "CoSimulation", &attributes)
}

/// The enumeration of what a contact may be.
fn contact_type(xml: &mut Xml) -> Result<()> {
    parent(xml, "EnumerationType", &[("name", Some("Contact".to_owned()))], |xml| {
        contact_states().try_for_each(|(name, value)| {
            element(xml, "Item", &[("name", Some(name.to_owned())), ("value", Some(value.to_string()))])
        })
    })
}

/// A number that is read back as the same.
fn number(x: f64) -> String {
    format!("{x:?}")
}

/// An element without content.
fn element(xml: &mut Xml, name: &str, attributes: &[Attribute]) -> Result<()> {
    let given = attributes.iter().filter_map(|(name, value)| Some((*name, value.as_deref()?)));
    xml.create_element(name).with_attributes(given).write_empty().map(|_| ())
}

/// An element with others inside.
fn parent(
    xml: &mut Xml,
    name: &str,
    attributes: &[Attribute],
    inside: impl FnOnce(&mut Xml) -> Result<()>,
) -> Result<()> {
    let given = attributes.iter().filter_map(|(name, value)| Some((*name, value.as_deref()?)));
    xml.create_element(name).with_attributes(given).write_inner_content(inside).map(|_| ())
}
