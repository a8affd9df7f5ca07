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

/// The known name that is nearest to a misspelt one, or all if none is near, as the end of an
/// error.
pub(crate) fn nearest(known: &[&str], name: &str) -> String {
    let nearness = |known: &str| strsim::normalized_damerau_levenshtein(known, name);
    let known_by_nearness = known.iter().map(|known| (nearness(known), known));
    match known_by_nearness.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((0.5.., nearest)) => format!("; the nearest is {nearest}"),
        Some(_) if known.len() <= 16 => format!("; there is {}", known.join(", ")),
        _ => String::new(),
    }
}
