//! The source.

use super::Library;
use super::function::{CFunction, places};
use super::text::{ended, string};
use crate::emit::Entries;
use crate::program::Id;

/// What solves the equations of any contact set, whatever the model; its names begin with `model_`.
const SOLVE: &str = include_str!("solve.c");
/// The motion without friction in hinges, and with it.
const MOTION: [&str; 2] = [include_str!("plain.c"), include_str!("hinges.c")];

impl Library<'_> {
    pub(super) fn source(&self) -> String {
        let (p, functions) = (&self.names.prefix, &self.analysis.functions);
        let all: Vec<usize> = (0..self.analysis.motion.n).collect();
        let entries = Entries { kept: &all, moving: &all, motion: &self.analysis.motion };
        let of_state = |name: &str, outputs: &[Id]| {
            self.function(&CFunction {
                head: format!("void {p}_{name}"),
                entries,
                takes: "double *out",
                outputs: outputs.to_vec(),
                places: places(outputs.len()),
                derivative: None,
                around: Default::default(),
            })
        };
        let [plain, hinged] = MOTION.map(|text| text.replace("model_", &format!("{p}_")));
        let hinges = self.analysis.motion.has_hinges();
        [
            self.head(),
            format!("#include \"{p}.h\"\n#include <math.h>\n#include <stddef.h>\n\n"),
            self.tables(),
            self.constants_of(),
            of_state("gaps", &functions.kernel.gap),
            of_state("energy", &functions.energy),
            of_state("points", &functions.points),
            self.equations_of(entries),
            SOLVE.replace("model_", &format!("{p}_")),
            if hinges { self.hinges(entries) + &hinged } else { plain },
            self.phases(),
        ]
        .concat()
    }

    /// Numbers of things, and whose each row is.
    fn tables(&self) -> String {
        let (p, c, motion) = (&self.names.prefix, &self.names.capital, &self.analysis.motion);
        let coordinates =
            self.analysis.kinematics.coordinates.iter().map(|coordinate| string(&coordinate.name));
        let contacts = motion.contacts.iter().map(|contact| string(&contact.label(&self.analysis.system)));
        let contact_of = (0..motion.rows.len()).map(|row| match row {
            _ if row < motion.contacts.len() && motion.contacts[row].force.is_some() => "EMPTY".to_owned(),
            _ if row < motion.contacts.len() => row.to_string(),
            _ if row < motion.slips() => "JOINT".to_owned(),
            _ => motion.tangents[row - motion.slips()].to_string(),
        });
        format!(
            "enum {{\n    COORDINATES = {c}_COORDINATES,\n    CONTACTS = {c}_CONTACTS,\n    ROWS = {c}_ROWS,\n    \
             SLIPS = {slips}, /* the first row of a slip */\n    UNKNOWNS = COORDINATES + ROWS,\n    \
             JOINT = -1,\n    EMPTY = -2\n}};\n\n\
             /* The contact of each row; the row of a hinge with friction is empty, for it holds without. */\n\
             static const int contact_of[] = {{{contact_of}}};\n\n\
             const char *const {p}_coordinate_names[] = {{{coordinates}}};\n\
             const char *const {p}_contact_names[] = {{{contacts}}};\n\n",
            slips = motion.slips(),
            contact_of = ended(contact_of, "EMPTY"),
            coordinates = ended(coordinates, "NULL"),
            contacts = ended(contacts, "NULL"),
        )
    }
}
