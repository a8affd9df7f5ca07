//! `Error`: a mistake in a scene file, and its position.

use common::text;

/// Most letters of the known names in an error.
const LONGEST_LIST: usize = 250;

/// A mistake in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// Its position: the bytes before it.
    pub at: usize,
    /// The mistake, and what would be right.
    pub text: String,
}

impl Error {
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
    let nearness = |known: &str| strsim::normalized_damerau_levenshtein(known, name);
    let known_by_nearness = known.iter().map(|known| (nearness(known), known));
    match known_by_nearness.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((0.5.., nearest)) => format!("; the nearest is {}", text::name(nearest)),
        Some(_) => {
            let all = known.join(", ");
            if all.len() <= LONGEST_LIST {
                format!("; there is {}", text::visible(&all))
            } else {
                String::new()
            }
        }
        None => String::new(),
    }
}
