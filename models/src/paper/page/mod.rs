//! `index.html`: one page that needs nothing beside itself.

mod accuracy;
mod equations;
mod numbers;
mod strict;

use super::figure::CaptionedFigure;
use super::findings::Finding;
use super::printed::GRAVITY;
use super::quantity::Row;
use super::reference::References;
use super::strict::comparison::Line;
use liftoff_studio::html::page;
use liftoff_studio::work_precision::WorkPrecisionRow as Measured;

const TITLE: &str = "Bar systems that leave their supports";

/// What the page shows.
pub struct Page<'a> {
    /// Tolerance of the runs.
    pub tolerance: f64,
    /// The results.
    pub rows: &'a [Row],
    /// What the paper prints, and the references.
    pub tables: &'a References,
    /// Fig. 1: both systems.
    pub schemes: &'a [CaptionedFigure],
    /// What follows from the runs.
    pub findings: &'a [Finding],
    /// Figs. 2 to 10.
    pub figures: &'a [CaptionedFigure],
    /// As published against strict, in two sentences.
    pub difference: Option<String>,
    /// As published against strict, in numbers.
    pub lines: Vec<Line>,
    /// As published against strict, and the strict system by itself, drawn.
    pub strict: &'a [CaptionedFigure],
    /// Error against run time, drawn.
    pub precision: Vec<CaptionedFigure>,
    /// Error against run time, in numbers.
    pub measured: &'a [Measured],
}

impl Page<'_> {
    /// The page.
    pub fn html(&self) -> String {
        let sections = [
            ("systems", "The two systems", figures(self.schemes)),
            ("table1", "Table 1 and the other printed numbers", self.printed()),
            ("findings", "What the runs show", self.statements()),
            ("equations", "The equations, derived and as the paper has them", equations::html()),
            ("figures", "The paper's figures", figures(self.figures)),
            ("strict", "Fig. 1b with every support watched on its own", self.strict()),
            ("accuracy", "Accuracy", self.accuracy()),
            ("time", "Error against run time", self.time()),
        ];
        let links: String =
            sections.iter().map(|(id, title, _)| format!("<a href=#{id}>{title}</a> ")).collect();
        let sections: String =
            sections.iter().map(|(id, title, text)| format!("<h2 id={id}>{title}</h2>\n{text}")).collect();
        let body = format!(
            "<h1>{TITLE}</h1>\n\
             <p>Rozenblat and Grishakin (<i>Rus. J. Nonlin. Dyn.</i> 2023, 19(2), 187–200, \
             <a href=\"https://doi.org/10.20537/nd230202\">doi:10.20537/nd230202</a>) correct two problems of a well-known \
             problem book, which forget that a support can only push. Here both systems are declared, their equations derived \
             and integrated, and everything the paper prints is set beside what comes out. Everything “computed” was read off \
             simulations at a relative tolerance of {tolerance:e}. Numbers in SI units are for <i>l</i> = 1 m, <i>m</i> = 1 kg and \
             <i>g</i> = {GRAVITY} m/s², which the paper does not print but its digits fit.</p>\n\
             <nav>{links}</nav>\n{sections}",
            tolerance = self.tolerance,
        );
        page(TITLE, STYLE, &body)
    }

    fn statements(&self) -> String {
        let statement =
            |Finding { anchor, title, text }: &Finding| format!("<dt id={anchor}>{title}<dd>{text}\n");
        format!("<dl>\n{}</dl>\n", self.findings.iter().map(statement).collect::<String>())
    }
}

const STYLE: &str = "dl { max-width: 46rem; } dt { font-weight: 600; margin-top: .8rem; } dd { margin: .2rem 0 0 0; }\n\
                     td.print { color: var(--faint); } td.differs { color: var(--vermilion); }\n\
                     .equations pre { white-space: pre-wrap; font: 1rem \"STIX Two Text\", \"Cambria\", \"DejaVu Serif\", serif; line-height: 1.6; margin: .2rem 0 1rem; }\n\
                     nav a { display: inline-block; }\n";

fn figures(figures: &[CaptionedFigure]) -> String {
    let drawn: String = figures.iter().map(figure).collect();
    format!("<div class=figures style=\"margin-top:1.25rem\">\n{drawn}</div>\n")
}

fn figure(CaptionedFigure { anchor, title, caption, svg }: &CaptionedFigure) -> String {
    let class = if svg.contains("width=\"860\"") { " class=wide" } else { "" };
    let anchor = if anchor.is_empty() { String::new() } else { format!(" id={anchor}") };
    format!("<figure{anchor}{class}>\n{svg}<figcaption><b>{title}.</b> {caption}</figcaption></figure>\n")
}

fn dash() -> String {
    "–".into()
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}
