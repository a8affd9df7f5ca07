//! `synonyms`: names of other programs for tables and keys of a scene file.

use common::text::plain;

/// Names of tables and keys, and behind each those that other programs have for it.
const SYNONYMS: &str = include_str!("synonyms.txt");

/// The known name for another program's, or for one in another spelling such as `rotateZ`.
pub fn known_for<'a>(known: &[&'a str], name: &str) -> Option<&'a str> {
    let name = plain(name);
    let mut same = known.iter().copied();
    if let Some(same) = same.find(|known| plain(known) == name) {
        return Some(same);
    }
    for line in SYNONYMS.lines() {
        let (own, foreign) = line.split_once(": ")?;
        let own = known.iter().find(|known| **known == own);
        if own.is_some() && foreign.split(' ').any(|foreign| plain(foreign) == name) {
            return own.copied();
        }
    }
    None
}
