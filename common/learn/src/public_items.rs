//! The public items of a file, such as `pub fn dot`: a check imports those of the starter, and the student's own
//! program takes them instead of the workbook's.

use crate::tokens;

/// The words between `pub` and the name of an item.
const BEFORE_NAME: [&str; 10] = [
    "async", "const", "enum", "fn", "mut", "static", "struct", "trait", "type", "unsafe",
];

#[derive(Debug, PartialEq, Eq)]
pub struct PublicItem {
    pub name: String,
    /// How it begins, up to its name.
    pub beginning: String,
}

/// The public items of a text.
pub fn public_items(text: &str) -> Result<Vec<PublicItem>, String> {
    let tokens = tokens::read(text)?.into_iter();
    let words: Vec<_> = tokens.map(|token| token.to_string()).collect();
    let mut items = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let mut rest = &words[at + 1..];
        // Of `pub(crate)`.
        if rest.first().is_some_and(|word| word.starts_with('(')) {
            rest = &rest[1..];
        }
        let is_named = |word: &String| BEFORE_NAME.contains(&&**word);
        let count = rest.iter().take_while(|word| is_named(word)).count();
        if let Some(name) = rest.get(count)
            && word == "pub"
            && count > 0
        {
            items.push(PublicItem {
                name: name.clone(),
                beginning: format!("pub {}", rest[..=count].join(" ")),
            });
        }
    }
    Ok(items)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn public_names_are_found_behind_all_words() {
        let text = "pub const fn dot() {}\npub const LIMIT: f64 = 1.0;\npub unsafe fn raw() {}\n\
            pub trait Shade {}\npub use std::fmt;\nfn own() {}\nimpl A {\npub fn method() {}\n}\n\
            /*\npub fn old() {}\n*/ #[inline] pub async unsafe fn later<T>() {}\n    pub(crate) fn near() {}\n\
            const A: &str = r#\"\npub fn told() {}\"#;\nmacro_rules! a { () => { pub fn made() {} } }";
        let items = public_items(text).unwrap();
        let names: Vec<_> = items.iter().map(|item| &*item.name).collect();
        assert_eq!(names, ["dot", "LIMIT", "raw", "Shade", "later", "near"]);
        assert_eq!(items[0].beginning, "pub const fn dot");
    }
}
