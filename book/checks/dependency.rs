//! CONTRIBUTING.md gives a reason for every foreign crate.

use std::collections::BTreeSet;

use crate::Files;

/// The page with the table, whose rows begin with the crate's name.
const PAGE: &str = "CONTRIBUTING.md";

/// The crates of `[workspace.dependencies]` without a row, and the rows without
/// a crate.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let crates = foreign_crates(files.text("Cargo.toml").unwrap_or_default());
    let rows = rows(files.text(PAGE).unwrap_or_default());
    let missing = crates
        .difference(&rows)
        .map(|name| format!("{PAGE}: the table of dependencies has no row for {name}"));
    let too_many = rows
        .difference(&crates)
        .map(|name| format!("{PAGE}: no crate of the workspace depends on {name}"));
    missing.chain(too_many).collect()
}

/// The names in `[workspace.dependencies]` that are not our own.
fn foreign_crates(manifest: &str) -> BTreeSet<&str> {
    let section = section(manifest, "[workspace.dependencies]\n", "\n[");
    let entries = section.lines().filter_map(|line| line.split_once(" = "));
    let foreign = entries.filter(|(_, source)| !source.contains("path = "));
    foreign.map(|(name, _)| name).collect()
}

/// The names that the rows of the table begin with.
fn rows(page: &str) -> BTreeSet<&str> {
    let section = section(page, "## Dependencies\n", "\n## ");
    let rows = section.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| Some(row.split_once('`')?.0))
        .collect()
}

/// What stands between `begin` and `end`, or the end of the text.
fn section<'a>(text: &'a str, begin: &str, end: &str) -> &'a str {
    let (_, behind) = text.split_once(begin).unwrap_or_default();
    behind
        .split_once(end)
        .map_or(behind, |(section, _)| section)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MANIFEST: &str = "[workspace.dependencies]\na01 = { path = \"a01\" }\n\n\
                            libm = \"0.2\"\nwide = { version = \"1\" }\n\n[profile]\nlto = \"thin\"\n";

    fn complaints_about(table: &str) -> Vec<String> {
        let page = format!("| `other` | table |\n## Dependencies\n\n{table}\n\n## More\n| `x` |\n");
        complaints(&Files::of([("Cargo.toml", MANIFEST), (PAGE, &page)]))
    }

    #[test]
    fn a_row_for_each_crate_is_right() {
        let table = "| crate | for |\n|---|---|\n| `libm` | sines |\n| `wide` | lanes |";
        assert_eq!(complaints_about(table), [""; 0]);
    }

    #[test]
    fn a_crate_without_a_row_and_a_row_without_a_crate_are_found() {
        assert_eq!(
            complaints_about("| `libm` | sines |\n| `rand` | dice |"),
            [
                "CONTRIBUTING.md: the table of dependencies has no row for wide",
                "CONTRIBUTING.md: no crate of the workspace depends on rand",
            ]
        );
    }
}
