//! `Error`: a mistake in a scene file, and its position.

use common::text;

use crate::synonyms::known_for;

/// Most letters of the known names in an error.
const MAX_LISTED: usize = 250;

/// A mistake in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// Its position: the bytes before it.
    pub at: usize,
    /// The mistake, and what would be right.
    pub text: String,
    /// Whether something is missing, for which another mistake in the file may be the reason.
    pub is_missing: bool,
}

impl Error {
    /// A mistake at a position.
    pub(crate) fn new(at: usize, text: impl Into<String>) -> Self {
        Self {
            at,
            text: text.into(),
            is_missing: false,
        }
    }

    /// Something that is missing from the table at a position.
    pub(crate) fn missing(at: usize, text: impl Into<String>) -> Self {
        Self {
            is_missing: true,
            ..Self::new(at, text)
        }
    }

    /// One sentence with the line and the column in the text of the file, from 1.
    #[must_use]
    pub fn within(&self, file: &str) -> String {
        let before = file.get(..self.at).unwrap_or(file);
        let line = before.matches('\n').count() + 1;
        let left = before.rsplit('\n').next().unwrap_or_default();
        // A byte order mark has no column.
        let column = left.trim_start_matches('\u{FEFF}').chars().count() + 1;
        format!("{line}:{column}: {}", self.text)
    }
}

/// The known name that is nearest to a misspelt one, or all if none is near, as the end of an
/// error.
pub(crate) fn nearest(known: &[&str], name: &str) -> String {
    if let Some(own) = known_for(known, name) {
        return format!("; here it is {own}");
    }
    if let Some(nearest) = text::nearest(known, name) {
        return format!("; the nearest is {}", text::name(nearest));
    }
    let all = known.join(", ");
    if known.is_empty() || all.len() > MAX_LISTED {
        return String::new();
    }
    format!("; there is {}", text::visible(&all))
}
