//! The header: what the library has.

use super::Library;
use super::text::{comment, unit};
use crate::syntax::plain;
use crate::text::TextWriter;

/// What every library declares, whatever the model; its names begin with `model_` and `MODEL_`.
const DECLARATIONS: &str = include_str!("declarations.h");

impl Library<'_> {
    pub(super) fn header(&self) -> String {
        let (p, c) = (&self.names.prefix, &self.names.capital);
        let sizes: Vec<String> = self.sizes().collect();
        let declarations =
            DECLARATIONS.replace("model_", &format!("{p}_")).replace("MODEL_", &format!("{c}_"));
        [
            self.head(),
            format!("#ifndef {c}_H\n#define {c}_H\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n"),
            format!("enum {{\n{}\n}};\n\n", sizes.join("\n")),
            "/* In the units of the SI, or of any other coherent system. */\n".to_owned(),
            format!("typedef struct {{\n{}}} {p}_parameters;\n\n", self.parameters()),
            "/* What follows from parameters, and from the senses of contacts that slide. */\n".to_owned(),
            format!("typedef struct {{\n{}}} {p}_constants;\n\n", self.fields()),
            format!("/* Entries of a state:\n{}. */\n\n", self.entries_of_states().join(",\n")),
            format!("/* Rows of constraints:\n{}. */\n\n", self.rows().join(",\n")),
            format!("/* Points: {}. */\n\n", self.points()),
            declarations,
            self.prototypes(),
            "#ifdef __cplusplus\n}\n#endif\n\n#endif\n".to_owned(),
        ]
        .concat()
    }

    /// What the file is.
    pub(super) fn head(&self) -> String {
        let system = &self.analysis.system;
        let summary = comment(&system.summary);
        let summary = if summary.is_empty() { summary } else { format!("\n\n   {summary}") };
        let (name, version) = (plain(&system.ident), env!("CARGO_PKG_VERSION"));
        format!("/* {name}, derived by liftoff {version}.{summary} */\n\n")
    }

    /// Numbers of things, each with what it counts.
    fn sizes(&self) -> impl Iterator<Item = String> {
        let (motion, functions) = (&self.analysis.motion, &self.analysis.functions);
        let contacts = motion.contacts.len();
        let capital = &self.names.capital;
        let all = [
            ("COORDINATES", motion.n, ","),
            ("STATE", motion.entries(), ", /* entries of a state */"),
            ("CONTACTS", contacts, ","),
            ("ROWS", motion.rows.len(), ", /* of contacts, then of joints, then of slips */"),
            ("REACTIONS", contacts + motion.frictions().count(), ", /* of contacts, then friction forces */"),
            ("POINTS", functions.points.len() / 2, ","),
            ("PHASES", functions.phases.len(), " /* contact sets in closed form */"),
        ];
        all.into_iter().map(move |(name, size, what)| format!("    {capital}_{name} = {size}{what}"))
    }

    fn parameters(&self) -> String {
        let system = &self.analysis.system;
        let line = |(i, name): (usize, &String)| {
            let unit = self.analysis.dimensions.parameters[i].as_ref().map(unit);
            let said = [unit.unwrap_or_default(), comment(&system.meanings[i])];
            let said: Vec<String> = said.into_iter().filter(|text| !text.is_empty()).collect();
            let said = if said.is_empty() { String::new() } else { format!(" /* {} */", said.join("; ")) };
            format!("    double {name};{said}\n")
        };
        let fields: String = self.names.parameters.iter().enumerate().map(line).collect();
        if fields.is_empty() { "    char none;\n".to_owned() } else { fields }
    }

    fn fields(&self) -> String {
        let fields: String = self.constants.values().map(|name| format!("    double {name};\n")).collect();
        if fields.is_empty() { "    char none;\n".to_owned() } else { fields }
    }

    fn entries_of_states(&self) -> Vec<String> {
        let Self { analysis, .. } = self;
        let writer = TextWriter::new(analysis);
        let n = analysis.motion.n;
        let mut lines: Vec<String> = Vec::new();
        for (i, coordinate) in analysis.kinematics.coordinates.iter().enumerate() {
            let unit = if coordinate.is_angle() { "rad" } else { "m" };
            let meaning = comment(&writer.meaning(&coordinate.reading));
            lines.push(format!(
                "   {i} {} in {unit}, {meaning}; {} its rate",
                comment(&coordinate.name),
                n + i
            ));
        }
        let timed = usize::from(analysis.motion.is_timed());
        if timed == 1 {
            lines.push(format!("   {} the time in s", 2 * n));
        }
        for (i, switch) in analysis.system.switches.iter().enumerate() {
            let (label, condition) = (comment(&switch.label), comment(&switch.condition));
            lines.push(format!("   {} is 1 while {label} acts ({condition}), else 0", 2 * n + timed + i));
        }
        if lines.is_empty() { vec!["   none".to_owned()] } else { lines }
    }

    fn rows(&self) -> Vec<String> {
        let Self { analysis, .. } = self;
        let motion = &analysis.motion;
        let contacts = motion.contacts.iter().map(|contact| comment(&contact.label(&analysis.system)));
        let joints = analysis.kinematics.joints.iter().map(|joint| comment(&joint.name));
        let slips = motion.tangents.iter();
        let slips =
            slips.map(|&of| format!("slip of {}", comment(&motion.contacts[of].label(&analysis.system))));
        let lines = contacts.map(|label| format!("contact {label}")).chain(joints).chain(slips).enumerate();
        let lines: Vec<String> = lines.map(|(i, name)| format!("   {i} {name}")).collect();
        if lines.is_empty() { vec!["   none".to_owned()] } else { lines }
    }

    fn points(&self) -> String {
        let names = self.analysis.system.points.iter().map(|point| comment(&point.name));
        names.collect::<Vec<_>>().join(", ")
    }

    /// The functions of each closed form.
    fn prototypes(&self) -> String {
        let p = &self.names.prefix;
        let all = self.phases.iter().zip(&self.analysis.functions.phases);
        all.map(|(name, phase)| {
            let takes = format!("const {p}_constants *k, const double *state, double *out");
            format!(
                "{}void {name}_restriction(const double *state, double *out);\n\
                 void {name}_derivative({takes});\n\
                 void {name}_reactions({takes});\n\
                 void {name}_embedding({takes});\n\n",
                self.about(phase),
            )
        })
        .collect()
    }
}
