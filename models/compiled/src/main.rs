//! The `liftoff` command over compiled models.

/// As the command itself has it.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() {
    liftoff_cli::run_with::<liftoff_models::command::Command>(liftoff_compiled::models())
}
