//! The introduction maps every section of both protocols to its place in the book and
//! in the code.

use std::collections::HashSet;

use crate::Files;

const MAP: &str = "book/src/introduction.md";

/// The heads of the tables, and the number of sections of each protocol.
const TABLES: [(&str, usize); 2] = [("| first protocol |", 53), ("| second protocol |", 4)];

/// The tables that lack a section, and the rows without a place.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let text = files.text(MAP).unwrap_or_default();
    let mut complaints = Vec::new();
    for (head, sections) in TABLES {
        let table = text.lines().skip_while(|line| !line.starts_with(head));
        let rows = table.take_while(|line| line.starts_with('|')).skip(2);
        let mut numbers = HashSet::new();
        for row in rows {
            // Number, name, place in the book, files in the code.
            let cells: Vec<_> = row.split('|').map(str::trim).collect();
            numbers.insert(cells.get(1).copied());
            let has_page = cells.get(3).is_some_and(|page| page.contains("]("));
            let paths = cells.get(4).into_iter().flat_map(|cell| cell.split('`'));
            let mut paths = paths.skip(1).step_by(2).peekable();
            let has_files = paths.peek().is_some() && paths.all(|path| files.text(path).is_some());
            if !(has_page && has_files) {
                complaints.push(format!("{MAP}: a place is missing in {row}"));
            }
        }
        if numbers.len() != sections {
            let found = numbers.len();
            complaints.push(format!("{MAP}: {head} {found} of {sections} sections"));
        }
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The complaints about a map of the second protocol with this last row.
    fn complaints_about(row: &str) -> usize {
        let rows = [1, 2, 3].map(|n| format!("| 3.{n} | Name | [a](a.md) | `a.rs`, `b.rs` |\n"));
        let head = "| second protocol | | in the book | in the code |\n|---|---|---|---|\n";
        let text = format!("{head}{}{row}\n", rows.concat());
        let files = Files::of([(MAP, &text), ("a.rs", ""), ("b.rs", "")]);
        // The table of the first protocol is missing.
        complaints(&files).len() - 1
    }

    #[test]
    fn missing_sections_and_places_are_found() {
        assert_eq!(complaints_about("| 3.4 | Name | [a](a.md#b) | `b.rs` |"), 0);
        for row in [
            "",
            "| 3.3 | Twice | [a](a.md) | `a.rs` |",
            "| 3.4 | Name | somewhere | `a.rs` |",
            "| 3.4 | Name | [a](a.md) | a.rs |",
            "| 3.4 | Name | [a](a.md) | `a.rs`, `gone.rs` |",
        ] {
            assert_eq!(complaints_about(row), 1, "{row}");
        }
    }
}
