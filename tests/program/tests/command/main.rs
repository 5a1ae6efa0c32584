//! The command line that a user's own program has, as its users meet it: output, files, exit codes.

mod analysis;
mod animate;
mod bad_input;
mod colours;
mod completions;
mod diagnostics;
mod ends;
mod examples;
mod files;
mod first_steps;
mod fit;
mod help;
mod interrupted;
mod output;
mod program;
mod report;
mod stability;
