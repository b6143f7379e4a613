//! The command `infoscene`.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
