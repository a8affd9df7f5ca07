//! `UseSearch`: whether code uses an item of the workbook, and not one of its own that has the same name.

use proc_macro2::{TokenStream, TokenTree};

use super::code_text::{has, is_of_name, joined};
use super::lessons::words_of;

/// The words before a name that code defines.
const BEFORE_OWN: [&str; 8] = [
    "const", "enum", "fn", "let", "mut", "struct", "trait", "type",
];

/// Looks for uses of an item that has a name and is not the file's own.
pub struct UseSearch<'a> {
    pub name: &'a str,
    /// The file, as [`joined`] writes it.
    pub text: &'a str,
}

impl UseSearch<'_> {
    /// Whether tokens have the name by an import, in a path, as a method, or alone where the code does
    /// not define it. `is_own` says that the code around them defines it, and `is_file` that nothing is around them.
    pub fn finds_use(&self, tokens: TokenStream, is_own: bool, is_file: bool) -> bool {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let words: Vec<_> = tokens.iter().map(word).collect();
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        let mut is_own = is_own;
        let mut defines = false;
        for (at, word) in words.iter().enumerate() {
            defines |= *word == self.name && at > 0 && BEFORE_OWN.contains(&words[at - 1]);
            if *word != "use" {
                continue;
            }
            let rest = tokens[at + 1..].iter().cloned();
            let import = joined(rest.take_while(|token| token.to_string() != ";").collect());
            let has_name = has(&import, self.name);
            if self.is_own(&import) {
                defines |= has_name;
            } else if has_name {
                return true;
            } else if import.contains('*') && words_of("::").any(|root| has(&import, root)) {
                // It gives the name to other code, or hides the file's own.
                if words[..at].ends_with(&["pub"]) || words[..at].ends_with(&["pub", "("]) {
                    return true;
                }
                is_own &= is_file;
            }
        }
        is_own |= defines;
        let is_type = self.name.starts_with(char::is_uppercase);
        for (at, token) in tokens.iter().enumerate() {
            if let TokenTree::Group(bracket) = token
                && self.finds_use(bracket.stream(), is_own, false)
            {
                return true;
            }
            if words[at] != self.name {
                continue;
            }
            let (before, next) = (&words[..at], words.get(at + 1));
            let is_called = matches!(next, Some(&("(" | ":")));
            let is_used = if before.ends_with(&[":", ":"]) {
                !self.is_own(&path_before(before))
            } else if before.ends_with(&["."]) && !before.ends_with(&[".", "."]) {
                is_called
            } else {
                !is_own && (is_type || next == Some(&"("))
            };
            if is_used {
                return true;
            }
        }
        false
    }

    /// Whether a path begins in the file.
    fn is_own(&self, path: &str) -> bool {
        match path.split("::").next().unwrap_or_default() {
            "self" | "super" | "Self" => !path.contains("super::super"),
            first => first.starts_with(is_of_name) && has(self.text, &format!("mod~{first}")),
        }
    }
}

/// The word of a token, or the beginning of a bracket.
fn word(token: &TokenTree) -> String {
    let word = token.to_string();
    match token {
        TokenTree::Group(_) => word.chars().take(1).collect(),
        TokenTree::Literal(_) => String::new(),
        // Any name may be written as a raw one.
        _ => word.trim_start_matches("r#").to_owned(),
    }
}

/// The path at the end of these words.
fn path_before(words: &[&str]) -> String {
    let mut start = words.len();
    while words[..start].ends_with(&[":", ":"]) {
        start -= 2;
        if start > 0 && words[start - 1].starts_with(is_of_name) {
            start -= 1;
        }
    }
    words[start..].concat()
}
