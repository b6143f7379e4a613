//! Tells the program which compiler made it, and how, for the timings that it writes.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(compiler).arg("--version").output().ok();
    let version = version.and_then(|output| String::from_utf8(output.stdout).ok());
    let version = version
        .as_deref()
        .map_or("rustc, version unknown", str::trim);
    println!("cargo::rustc-env=INFOSCENE_COMPILER={version}");
    let profile = std::env::var("PROFILE").unwrap_or_default();
    println!("cargo::rustc-env=INFOSCENE_PROFILE={profile}");
}
