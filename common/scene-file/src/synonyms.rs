//! `synonyms`: names of other programs for tables and keys of a scene file.

use common::text::plain;

/// Names of tables and keys, and behind each those that other programs have for it.
const SYNONYMS: &str = include_str!("synonyms.txt");

/// The names, and those of other programs with spaces between them.
fn rows() -> impl Iterator<Item = (&'static str, &'static str)> {
    let rows = SYNONYMS.lines();
    rows.map(|line| line.split_once(": ").unwrap_or((line, "")))
}

/// The known name for another program's, or for one in another spelling such as `rotateZ`.
pub fn known_for<'a>(known: &[&'a str], name: &str) -> Option<&'a str> {
    let name = plain(name);
    let mut same = known.iter().copied();
    if let Some(same) = same.find(|known| plain(known) == name) {
        return Some(same);
    }
    for (own, foreign) in rows() {
        let own = known.iter().find(|known| **known == own);
        if own.is_some() && foreign.split(' ').any(|foreign| plain(foreign) == name) {
            return own.copied();
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FILE, TABLES};

    #[test]
    fn every_row_has_a_known_name_and_others() {
        let is_known = |name| {
            TABLES
                .iter()
                .chain([&*FILE])
                .any(|kind| kind.key(name).is_some())
        };
        for (own, foreign) in rows() {
            assert!(is_known(own) && !foreign.is_empty(), "{own}: {foreign}");
        }
    }
}
