//! `liftoff watch`: the motion of a file's model on a page that follows every save.

mod made;
mod server;

use crate::CommandError;
use crate::errors::interrupted::is_interrupted;
use crate::options::files;
use crate::options::run_args::RunArgs;
use crate::output::print::print;
use clap::Args;
use liftoff_studio::registry::MethodId;
use made::Making;
use server::{Server, Shown};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

/// How often the file is looked at.
const TICK: Duration = Duration::from_millis(100);

#[derive(Args, Debug)]
pub struct Watch {
    /// A Rust file; it need not compile
    #[arg(value_name = "FILE.rs")]
    file: PathBuf,
    #[command(flatten)]
    run_args: RunArgs,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: MethodId,
    /// An expression to draw over time, besides coordinates, reactions and energies
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// The port on this computer [default: a free one]
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    port: u16,
    /// Open it in the browser
    #[arg(long)]
    open: bool,
}

/// What a page is made with.
#[derive(Debug)]
struct Request {
    run_args: RunArgs,
    method: MethodId,
    output: Vec<String>,
    /// Of several models this one.
    model: Option<String>,
}

impl Watch {
    /// Serves the page until Ctrl-C is pressed, made anew whenever the file is another.
    pub fn execute(self, model: Option<String>) -> Result<(), CommandError> {
        let Self { file, run_args, method, output, port, open } = self;
        // A pipe has no second text.
        if file.exists() && !file.is_file() {
            return Err(CommandError::Usage(format!("{} is no file", file.display())));
        }
        files::text(&file)?;
        let shown = Arc::<Shown>::default();
        let server = Server::begin(port, Arc::clone(&shown))?;
        print(&format!("{}\n", server.address()))?;
        if open {
            open::that_detached(server.address()).map_err(|error| {
                CommandError::Failed(format!("cannot open {}: {error}", server.address()))
            })?;
        }
        let request = Arc::new(Request { run_args, method, output, model });
        follow(&file, &request, &shown);
        Ok(())
    }
}

/// Makes the page of each text that the file has, until Ctrl-C; what was being made of the last one is given up.
fn follow(file: &Path, request: &Arc<Request>, shown: &Arc<Shown>) {
    let mut last: Option<(Result<String, String>, Making)> = None;
    let path = file.display().to_string();
    while !is_interrupted() {
        // An editor may have taken the file away for a moment.
        let text = files::text(file).map_err(|error| error.to_string());
        if last.as_ref().is_none_or(|(known, _)| *known != text) {
            let path = path.clone();
            let making = Making::begin((path, text.clone()), Arc::clone(request), Arc::clone(shown));
            last = Some((text, making));
        }
        thread::sleep(TICK);
    }
}
