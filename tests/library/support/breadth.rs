//! The breadth of the default run: of long lists of cases every other one, of all if asked for.

/// Every other item of a list, the first included; all of them where the environment has
/// `INFOSCENE_THOROUGH`.
pub fn some_of<T>(all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(step())
}

fn step() -> usize {
    if std::env::var_os("INFOSCENE_THOROUGH").is_some() {
        1
    } else {
        2
    }
}
