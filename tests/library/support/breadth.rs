//! The breadth of the default run: of long lists of cases one in four, of all if asked for.

/// Every fourth item of a list, from the first on; all of them where the environment has
/// `INFOSCENE_THOROUGH`.
pub fn some_of<T>(all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(step())
}

fn step() -> usize {
    if std::env::var_os("INFOSCENE_THOROUGH").is_some() {
        1
    } else {
        4
    }
}
