//! The equations of the full state: M, f, J, b of all rows, and the forces of hinges.

use super::Library;
use super::function::{CFunction, places};
use crate::Analysis;
use crate::emit::Entries;
use crate::functions::{Mass, Paths};
use crate::program::Id;

/// Both components of the force of each hinge with friction.
pub(super) fn hinge_forces(analysis: &Analysis) -> Vec<Id> {
    let hinges = analysis.motion.contacts.iter().filter_map(|contact| contact.force).flatten();
    hinges.map(|place| analysis.functions.quantities[place].value).collect()
}

impl Library<'_> {
    pub(super) fn equations_of(&self, entries: Entries<'_>) -> String {
        let kernel = &self.analysis.functions.kernel;
        let (n, rows) = (kernel.force.len(), kernel.gap.len());
        let grid = |name: &str, rows: usize| -> Vec<String> {
            (0..rows * n).map(|i| format!("e->{name}[{}][{}]", i / n, i % n)).collect()
        };
        let line = |name: &str, size: usize| (0..size).map(|i| format!("e->{name}[{i}]")).collect::<Vec<_>>();
        let (mass, around) = match &kernel.mass {
            Mass::Entries(_) => (grid("mass", n), Default::default()),
            Mass::Paths(paths) => (path_places(n), by_paths(paths)),
        };
        let rest = kernel.force.iter().chain(&kernel.gap).chain(kernel.jacobian.iter().flatten());
        let rest = rest.chain(&kernel.bias).chain(&kernel.prescribed_gap_rate).chain(&kernel.friction);
        self.function(&CFunction {
            head: format!("void {}_equations_of", self.names.prefix),
            entries,
            takes: &format!("{}_equations *e", self.names.prefix),
            outputs: kernel.mass.written(n).into_iter().chain(rest.copied()).collect(),
            places: [
                mass,
                line("force", n),
                line("gap", rows),
                grid("jacobian", rows),
                line("bias", rows),
                line("drift", rows),
                line("friction", rows),
            ]
            .concat(),
            derivative: None,
            around,
        })
    }

    /// The hinges with friction, and their forces.
    pub(super) fn hinges(&self, entries: Entries<'_>) -> String {
        let outputs = hinge_forces(self.analysis);
        let contacts = self.analysis.motion.contacts.iter().enumerate();
        let hinges: Vec<String> =
            contacts.filter(|(_, contact)| contact.force.is_some()).map(|(i, _)| i.to_string()).collect();
        let (count, hinges) = (hinges.len(), hinges.join(", "));
        let forces = self.function(&CFunction {
            head: "static void hinge_forces".to_owned(),
            entries,
            takes: "const double *acceleration, const double *multiplier, double *out",
            places: places(outputs.len()),
            outputs,
            derivative: None,
            around: Default::default(),
        });
        format!(
            "enum {{ HINGES = {count} }};\n\n/* The contacts that are hinges with friction. */\n\
             static const int hinges[] = {{{hinges}}};\n\n/* Both components of the force of each. */\n{forces}"
        )
    }
}

fn path_places(n: usize) -> Vec<String> {
    let vectors =
        |name: &str| (0..2 * n).map(|i| format!("{name}[{}][{}]", i / 2, i % 2)).collect::<Vec<_>>();
    [vectors("reach"), vectors("moment"), (0..n).map(|i| format!("own[{i}]")).collect()].concat()
}

/// M of a long tree: `M_jj` its own, `M_ij = e·s` of a coordinate and one that carries it, e of the
/// child of i on the way to j.
fn by_paths(paths: &Paths) -> [String; 2] {
    let parents =
        paths.parents.iter().map(|parent| parent.map_or_else(|| "-1".to_owned(), |i| i.to_string()));
    let parents: Vec<String> = parents.collect();
    let before = "    double reach[COORDINATES][2], moment[COORDINATES][2], own[COORDINATES];\n";
    let behind = format!(
        "    {{\n        static const int parent[] = {{{}}};\n        int i, j, child;\n        \
         for (i = 0; i < COORDINATES; i++)\n            for (j = 0; j < COORDINATES; j++)\n                \
         e->mass[i][j] = i == j ? own[i] : 0.0;\n        \
         for (j = 0; j < COORDINATES; j++)\n            for (child = j; parent[child] >= 0; child = parent[child]) {{\n                \
         i = parent[child];\n                e->mass[i][j] = reach[child][0]*moment[j][0] + reach[child][1]*moment[j][1];\n                \
         e->mass[j][i] = e->mass[i][j];\n            }}\n    }}\n",
        parents.join(", ")
    );
    [before.to_owned(), behind]
}
