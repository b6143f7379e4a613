//! The command as its users meet it: keys, exit status, refusals.
#![expect(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]

mod answers;
mod colours;
mod conversions;
mod discontinuities;
#[cfg(feature = "proptest")]
mod fuzzing;
mod gradient_cuts;
mod grids;
mod keys;
mod light;
mod materials;
mod matrices;
mod points;
#[cfg(unix)]
mod ranks;
mod refining;
mod refusals;
mod reports;
mod resolution;
mod sampling;
mod scene_files;
mod scene_options;
mod scenes;
mod stores;
mod studies;
mod summed_rows;

use assert_cmd::Command;

fn infoscene(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("infoscene").unwrap();
    command.args(arguments);
    command
}

/// Standard output of a run that succeeds.
fn stdout(arguments: &[&str]) -> String {
    let output = infoscene(arguments)
        .assert()
        .success()
        .get_output()
        .stdout
        .clone();
    String::from_utf8(output).unwrap()
}

fn json(arguments: &[&str]) -> serde_json::Value {
    let mut arguments = arguments.to_vec();
    arguments.extend(["--format", "json"]);
    serde_json::from_str(&stdout(&arguments)).unwrap()
}
