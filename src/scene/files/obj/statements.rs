//! The statements of an OBJ file: lines without comments, and the keywords that they begin with.

use crate::scene::files::source::Source;
use std::borrow::Cow;

/// Statements that give a name: all of the line, `#` included.
const NAMING: [&str; 4] = ["o", "g", "usemtl", "mtllib"];

/// Statements without an effect on the shape of a face or on diffuse light.
pub(super) const SILENT: [&str; 14] = [
    "vt",
    "vn",
    "vp",
    "s",
    "mg",
    "bevel",
    "lod",
    "maplib",
    "usemap",
    "shadow_obj",
    "trace_obj",
    "c_interp",
    "d_interp",
    "deg",
];

/// Free-form geometry.
pub(super) const FREE_FORM: [&str; 17] = [
    "cstype", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
    "con", "ctech", "stech", "call", "csh",
];

/// Lines without comments; those that end in a backslash are joined with the next.
pub(super) fn logical_lines(source: &Source) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = source.lines();
    std::iter::from_fn(move || {
        let (line, text) = lines.next()?;
        let keyword = text.split_whitespace().next().unwrap_or_default();
        let comment = if NAMING.contains(&keyword) {
            None
        } else {
            Some('#')
        };
        let bare = |text: &'_ str| {
            text.split(|c| Some(c) == comment)
                .next()
                .map_or(0, str::len)
        };
        let text = &text[..bare(text)];
        let Some(start) = text.trim_end().strip_suffix('\\') else {
            return Some((line, Cow::Borrowed(text)));
        };
        let mut joined = start.to_owned();
        for (_, text) in lines.by_ref() {
            let text = text[..bare(text)].trim_end();
            joined.push(' ');
            joined.push_str(text.strip_suffix('\\').unwrap_or(text));
            if !text.ends_with('\\') {
                break;
            }
        }
        Some((line, Cow::Owned(joined)))
    })
}

/// The keyword of a line, and the rest.
pub(super) fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    text.split_once(char::is_whitespace).unwrap_or((text, ""))
}
