//! The public items of a file, such as `pub fn dot`: a check imports those of the starter, and the student's own
//! program takes them instead of the workbook's.

use proc_macro2::{TokenStream, TokenTree};

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
    /// How it begins, up to its body.
    pub signature: String,
    /// The signature without the names of parameters, by which a caller cannot tell it from another one.
    pub types: String,
}

/// The public items of a text.
pub fn public_items(text: &str) -> Result<Vec<PublicItem>, String> {
    let tokens: Vec<_> = tokens::read(text)?.into_iter().collect();
    let words: Vec<_> = tokens.iter().map(ToString::to_string).collect();
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
            let is_before_body = |word: &&String| !word.starts_with(['{', ';', '=']);
            let length = words[at..].iter().take_while(is_before_body).count();
            let signature = &tokens[at..at + length];
            items.push(PublicItem {
                name: name.clone(),
                beginning: format!("pub {}", rest[..=count].join(" ")),
                signature: on_one_line(&text[tokens::range(signature)]),
                types: without_names(signature.iter().cloned().collect()),
            });
        }
    }
    Ok(items)
}

fn on_one_line(code: &str) -> String {
    let line = code.split_whitespace().collect::<Vec<_>>().join(" ");
    line.replace("( ", "(").replace(", )", ")")
}

/// The words of a signature without the names of its parameters.
fn without_names(signature: TokenStream) -> String {
    let tokens: Vec<_> = signature.into_iter().collect();
    let is = |at: usize, sign: &str| {
        tokens
            .get(at)
            .is_some_and(|token| token.to_string() == sign)
    };
    let is_name = |at: usize| {
        matches!(tokens.get(at), Some(TokenTree::Ident(_))) && is(at + 1, ":") && !is(at + 2, ":")
    };
    let mut words = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let is_of_name = is_name(at) || (at > 0 && is_name(at - 1));
        let is_mutable_name = is(at, "mut") && is_name(at + 1);
        let is_last_comma = is(at, ",") && at + 1 == tokens.len();
        if is_of_name || is_mutable_name || is_last_comma {
            continue;
        }
        words.push(match token {
            TokenTree::Group(bracket) => format!("({})", without_names(bracket.stream())),
            token => token.to_string(),
        });
    }
    words.join(" ")
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

    #[test]
    fn a_signature_is_told_from_another_by_its_types_alone() {
        let item = |text| public_items(text).unwrap().remove(0);
        let starter = item("pub fn at(ray: &Ray, t: f64) -> Point3 { a }");
        let same = item("pub fn at(\n    r: &Ray,\n    mut length: f64,\n) -> Point3 { b }");
        assert_eq!(same.types, starter.types);
        assert_eq!(
            same.signature,
            "pub fn at(r: &Ray, mut length: f64) -> Point3"
        );
        for other in [
            "pub fn at(ray: Ray, t: f64) -> Point3 { a }",
            "pub fn at(t: f64, ray: &Ray) -> Point3 { a }",
            "pub fn at(ray: &Ray, t: f64) -> Option<Point3> { a }",
            "pub fn at(ray: &mut Ray, t: f64) -> Point3 { a }",
            "pub fn at(ray: &Ray) -> Point3 { a }",
        ] {
            assert_ne!(item(other).types, starter.types, "{other}");
        }
    }
}
