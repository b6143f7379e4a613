//! The command `infoscene`.

use std::process::ExitCode;

fn main() -> ExitCode {
    infoscene::cli::run()
}
