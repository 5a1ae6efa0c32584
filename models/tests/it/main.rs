//! The program over the models, and what it writes: one program, as each is linked with all models.

mod audit;
mod cases;
mod chatter;
mod command;
mod examples;
mod export;
mod export_c;
mod files;
mod memory;
mod moving;
mod pictures;
mod processes;
mod readme;
mod shards;
mod stability;
mod sweep;
mod unfolded;
mod upright;
