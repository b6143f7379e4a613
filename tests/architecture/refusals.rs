//! Refusals that one room passes on from another: remedies are looked for behind all of them.

use crate::{code, sources};
use std::fs;

/// The variants of errors in code whose message is that of the error inside, as `Error::Variant`.
fn passed_on(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut error = "";
    let mut is_next = false;
    for line in code.lines().map(str::trim) {
        if let Some(name) = line.strip_prefix("pub enum ") {
            error = name.trim_end_matches(" {");
        }
        let variant = line.split('(').next().unwrap_or("");
        if is_next && line.starts_with(char::is_uppercase) {
            found.push(format!("{error}::{variant}"));
            is_next = false;
        }
        is_next |= line == "#[error(transparent)]";
    }
    found
}

/// The variants behind which the walk to the cause of a refusal looks.
fn looked_behind(code: &str) -> Vec<String> {
    let list = code.split("passed_on! { error:").nth(1).unwrap();
    let list = list.split('}').next().unwrap();
    let lines = list.split(';').filter_map(|line| line.split_once(':'));
    let lines = lines.flat_map(|(error, variants)| {
        let error = error.split_whitespace().last().unwrap();
        let variants = variants.split('|').map(str::trim);
        variants.map(move |variant| format!("{error}::{variant}"))
    });
    lines.collect()
}

/// Errors of the report stand behind those of questions, and are told by themselves.
#[test]
fn remedies_are_looked_for_behind_every_error_that_passes_another_on() {
    let all = sources("src").into_iter();
    let before = all.filter(|path| !path.components().any(|part| part.as_os_str() == "report"));
    let before = before.map(|path| code(&fs::read_to_string(path).unwrap()));
    let mut there: Vec<String> = before.flat_map(|code| passed_on(&code)).collect();
    let mut looked = looked_behind(&code(include_str!("../../src/question/remedy.rs")));
    there.sort();
    looked.sort();
    assert!(there.len() > 40, "only {there:?} are seen");
    assert_eq!(there, looked);
}
