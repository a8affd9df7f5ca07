//! The list of what a file must not use.

/// For each exercise, what of the workbook does what it asks for. Behind `*`, words that no file needs, and
/// behind `::` those that lead to the workbook.
const LESSONS: &str = include_str!("../lessons.txt");

/// The words after a name in the list of lessons.
pub fn words_of(name: &str) -> impl Iterator<Item = &'static str> {
    let after_name = |line: &'static str| line.strip_prefix(name)?.strip_prefix(' ');
    let words = LESSONS.lines().find_map(after_name);
    words.unwrap_or_default().split_whitespace()
}
