//! `Error`: a mistake in a scene file, and its position.

/// A position in a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The line, from 1.
    pub line: usize,
    /// The character of the line, from 1.
    pub column: usize,
}

/// A mistake in a scene file, in one sentence with its line and column.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}:{}: {text}", place.line, place.column)]
pub struct Error {
    /// The position of the mistake.
    pub place: Place,
    /// The mistake, and what would be right.
    pub text: String,
}

/// The known name that is nearest to a misspelt one, as the end of an error.
pub(crate) fn nearest<'a>(known: impl Iterator<Item = &'a str>, name: &str) -> String {
    let nearness = |known: &&str| strsim::jaro(known, name);
    let nearest = known.max_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    nearest.map_or_else(String::new, |nearest| format!("; the nearest is {nearest}"))
}
