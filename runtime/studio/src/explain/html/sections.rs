//! What a page consists of.

use core::fmt::{Display, Write};

use liftoff_codegen::math::{Equation, Math};
use liftoff_codegen::text::{Equations, PhaseEquations};

use super::{anchor, escaped, word};

/// A page in the making.
#[derive(Default)]
pub(super) struct Sections {
    pub body: String,
}

impl Sections {
    fn line(&mut self, text: impl Display) {
        let _ = writeln!(self.body, "{text}");
    }

    pub fn title(&mut self, name: &str) {
        self.line(format_args!("<h1>{}</h1>", escaped(name)));
    }

    pub fn head(&mut self, equations: &Equations, modes: bool) {
        self.title(&equations.name);
        if !equations.summary.is_empty() {
            self.line(format_args!("<p>{}</p>", prose(&equations.summary)));
        }
        self.line("<nav><a href=\"#model\">Model</a><a href=\"#system\">Whole system</a>");
        for (i, phase) in equations.sections().enumerate() {
            let title = match phase.multipliers.as_slice() {
                [] => capital(&escaped(&phase.title())),
                _ => "With multipliers".to_owned(),
            };
            self.line(format_args!("<a href=\"#{}\">{title}</a>", anchor(i)));
        }
        if modes {
            self.line("<a href=\"#modes\">Modes</a>");
        }
        self.line("<a href=\"#operations\">Operations</a><a href=\"#left-out\">Left out</a></nav>");
    }

    pub fn model(&mut self, equations: &Equations, drawing: Option<&str>) {
        self.line("<h2 id=model>Model</h2>");
        if let Some(svg) = drawing {
            self.line(format_args!("<figure class=model>{svg}</figure>"));
        }
        self.line("<div class=tables>");
        let rows = equations.coordinates.iter();
        let rows = rows.map(|c| {
            format!(
                "<tr><td class=word>{}</td><td class=\"word wide\">{}</td></tr>",
                tex(&c.symbol),
                escaped(&c.meaning)
            )
        });
        self.table("Coordinates", "", rows.collect());
        let rows = equations.parameters.iter().map(|p| {
            format!(
                "<tr><td class=word>{}</td><td class=\"word wide\">{}</td></tr>",
                tex(&p.symbol),
                prose(&p.meaning)
            )
        });
        self.table("Parameters", "", rows.collect());
        let head = "<thead><tr><th class=word>name<th class=word>points<th class=word>mass<th class=word>length\
                    <th class=word>moment of inertia</thead>\n";
        let rows = equations.bodies.iter().map(|body| {
            let optional = |math: &Option<Math>| math.as_ref().map(tex).unwrap_or_default();
            let named = format!("{} {}", body.kind, body.name);
            let numbers = [tex(&body.mass), optional(&body.length), optional(&body.inertia)];
            let numbers = numbers.map(|number| format!("<td class=word>{number}</td>")).concat();
            format!("<tr>{}{}{numbers}</tr>", word(&named), word(&body.points.join(", ")))
        });
        self.table("Bodies", head, rows.collect());
        self.line("</div>");
    }

    fn table(&mut self, caption: &str, head: &str, rows: Vec<String>) {
        if !rows.is_empty() {
            let rows = rows.join("\n");
            self.line(format_args!(
                "<div class=table><table><caption>{caption}</caption>\n{head}<tbody>\n{rows}\n</tbody></table></div>"
            ));
        }
    }

    pub fn system(&mut self, equations: &Equations) {
        self.line("<h2 id=system>Whole system</h2>");
        self.equations("Energies", &equations.energies);
        self.columns(
            "Mass matrix",
            "M a + h = Q + Jᵀ λ; M is symmetric, its other entries are zero.",
            &equations.mass,
        );
        self.columns("Velocity terms", "Those that do not vanish.", &equations.velocity_terms);
        self.columns("Generalised forces", "Those that do not vanish.", &equations.forces);
        self.equations("Where", &equations.definitions);
        self.columns("Gaps", "Zero where a contact is closed, positive where it is open.", &equations.gaps);
        let joints = equations.joints.iter().map(|(name, constraint)| {
            let equation = Equation::new(Math::ZERO, constraint.clone());
            format!(
                "<div class=equation><span class=name>{}</span> {}</div>",
                escaped(name),
                tex_equation(&equation)
            )
        });
        let joints: Vec<String> = joints.collect();
        self.group("Constraints that keep multipliers", "", "equations", &joints);
    }

    fn equations(&mut self, title: &str, equations: &[Equation]) {
        self.group(title, "", "equations", &equations.iter().map(displayed).collect::<Vec<_>>());
    }

    fn columns(&mut self, title: &str, remark: &str, equations: &[Equation]) {
        self.group(title, remark, "equations columns", &equations.iter().map(displayed).collect::<Vec<_>>());
    }

    fn group(&mut self, title: &str, remark: &str, class: &str, equations: &[String]) {
        if equations.is_empty() {
            return;
        }
        self.line(format_args!("<h3>{title}</h3>"));
        if !remark.is_empty() {
            self.line(format_args!("<p class=remark>{remark}</p>"));
        }
        self.line(format_args!("<div class=\"{class}\">\n{}\n</div>", equations.join("\n")));
    }

    pub fn phase(&mut self, index: usize, phase: &PhaseEquations) {
        let title = capital(&escaped(&phase.title()));
        self.line(format_args!("<h2 id={}>{title}</h2>", anchor(index)));
        let head = match phase.multipliers.as_slice() {
            [] => "What the contacts determine",
            _ => "What the closed contacts ask for",
        };
        self.equations(head, &phase.eliminated);
        self.equations("Energies", &phase.energies);
        self.equations("Motion", &phase.motion);
        self.equations("Reactions", &phase.reactions);
        if let Some(cost) = phase.cost {
            self.line(format_args!("<p class=remark>Right-hand side: {cost}.</p>"));
        }
    }

    pub fn modes(&mut self, drawing: Option<&str>) {
        if let Some(svg) = drawing {
            self.line("<h2 id=modes>Modes</h2>");
            self.line(format_args!("<figure class=graph>{svg}</figure>"));
        }
    }

    pub fn costs(&mut self, phases: &[PhaseEquations]) {
        self.line("<h2 id=operations>Operations of a right-hand side</h2>");
        let head = "<thead><tr><th class=word>contact set<th>+<th>×<th>× with +<th>÷<th>√<th>sin and cos<th>flops</thead>\n";
        let rows = phases.iter().filter_map(|phase| {
            let cost = phase.cost?;
            let counts =
                [cost.additions, cost.multiplications, cost.fused, cost.divisions, cost.roots, cost.angles];
            let counts: String =
                counts.iter().chain([&cost.flops()]).map(|count| format!("<td>{count}</td>")).collect();
            Some(format!("<tr>{}{counts}</tr>", word(&phase.title())))
        });
        self.table("What parameters alone determine is computed once and not counted.", head, rows.collect());
    }

    pub fn left_out(&mut self, left_out: &[String]) {
        self.line("<h2 id=left-out>Left out</h2>\n<p>What this scene does not have, and its code does not contain:</p>\n<ul>");
        for text in left_out {
            self.line(format_args!("<li>{}</li>", escaped(text)));
        }
        self.line("</ul>");
    }
}

fn displayed(equation: &Equation) -> String {
    format!("<div class=equation>{}</div>", tex_equation(equation))
}

fn tex(math: &Math) -> String {
    format!("<span class=tex>{}</span>", escaped(&math.latex()))
}

fn tex_equation(equation: &Equation) -> String {
    format!("<span class=tex>{}</span>", escaped(&equation.latex()))
}

/// A line of documentation; what stands between backticks is code.
fn prose(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let set = |(i, part): (usize, &str)| match i % 2 {
        0 => escaped(part),
        _ => format!("<code>{}</code>", escaped(part)),
    };
    parts.map(set).collect()
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
