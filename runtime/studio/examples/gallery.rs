//! The pictures of all examples on a page, each with the program that makes it:
//! `target/liftoff/gallery/index.html`.

use liftoff_studio::html::{escaped, page};
use std::fmt::Write;

mod drawing;
mod motion_page;
mod pattern;
mod portrait;
mod reactions;
mod sweep_map;
mod trails;
mod work_precision;

type Made = Result<(), Box<dyn std::error::Error>>;

/// An example: the name of its files, its program, and how it is run.
struct Example(&'static str, &'static str, fn() -> Made);

const EXAMPLES: [Example; 8] = [
    Example("drawing.svg", include_str!("drawing.rs"), drawing::main),
    Example("reactions.svg", include_str!("reactions.rs"), reactions::main),
    Example("pattern.svg", include_str!("pattern.rs"), pattern::main),
    Example("trails.svg", include_str!("trails.rs"), trails::main),
    Example("portrait.svg", include_str!("portrait.rs"), portrait::main),
    Example("work_precision.svg", include_str!("work_precision.rs"), work_precision::main),
    Example("sweep-map.svg", include_str!("sweep_map.rs"), sweep_map::main),
    Example("motion.html", include_str!("motion_page.rs"), motion_page::main),
];

const STYLE: &str = "h2 { overflow-wrap: anywhere; }\n\
                     figure img, figure iframe { display: block; width: 100%; border: 0; }\n\
                     figure iframe { height: 44rem; }\n\
                     pre { overflow-x: auto; font-size: .8rem; }\n";

fn main() -> Made {
    let mut body =
        String::from("<h1>Gallery</h1>\n<p>Each picture is one short program, shown below it.</p>\n");
    for Example(file, program, make) in EXAMPLES {
        make()?;
        write!(body, "<h2>{}</h2>\n<figure class=wide>\n{}", title(program), shown(file))?;
        let program = escaped(program);
        write!(body, "<details><summary>Program</summary>\n<pre>{program}</pre></details>\n</figure>\n")?;
    }
    std::fs::write("target/liftoff/gallery/index.html", page("Gallery", STYLE, &body))?;
    println!("target/liftoff/gallery/index.html");
    Ok(())
}

/// The first line of a program's documentation.
fn title(program: &str) -> String {
    let line = program.lines().next().unwrap_or_default();
    escaped(line.trim_start_matches("//!").trim().trim_end_matches('.'))
}

fn shown(file: &str) -> String {
    if file.ends_with(".html") {
        return format!("<iframe src={file} title=\"A motion\"></iframe>\n");
    }
    format!("<img src={file} alt=\"\">\n")
}
