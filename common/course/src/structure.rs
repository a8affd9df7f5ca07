//! `Structure`: the code of a file without its names, comments and layout, by which copies are found.

use std::collections::BTreeMap;

use learn::tokens;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Files with fewer tokens are alike by chance.
const MIN_TOKENS: usize = 150;

/// Code in which a name is the number of its first appearance.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Structure(Vec<String>);

impl Structure {
    /// The structure of a file; none if it is no Rust, or too short.
    pub fn read(text: &str) -> Option<Self> {
        let mut structure = Self::default();
        structure.add(tokens::read(text).ok()?, &mut BTreeMap::new());
        (structure.0.len() >= MIN_TOKENS).then_some(structure)
    }

    fn add(&mut self, tokens: TokenStream, names: &mut BTreeMap<String, usize>) {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let others = not_compared(&tokens[at..]);
            if others > 0 {
                at += others;
                continue;
            }
            at += 1;
            match token {
                TokenTree::Group(group) => {
                    self.0.push(format!("{:?}", group.delimiter()));
                    self.add(group.stream(), names);
                    self.0.push("end".to_owned());
                }
                TokenTree::Ident(name) => {
                    let next = names.len();
                    let number = *names.entry(name.to_string()).or_insert(next);
                    self.0.push(format!("name {number}"));
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => self.0.push(token.to_string()),
            }
        }
    }
}

/// How many of these tokens, from the first on, are a comment of documentation, or what the workbook gives to all: the
/// examples of an exercise, and a function `main`, whose lines stand in the book.
fn not_compared(tokens: &[TokenTree]) -> usize {
    let is_doc = |token: Option<&TokenTree>| {
        let Some(TokenTree::Group(bracket)) = token else {
            return false;
        };
        let inner: Vec<_> = bracket.stream().into_iter().collect();
        bracket.delimiter() == Delimiter::Bracket && tokens::begin(&inner, &["doc", "="])
    };
    let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    if tokens::begin(tokens, &["#"]) && is_doc(tokens.get(1)) {
        2
    } else if tokens::begin(tokens, &["#", "!"]) && is_doc(tokens.get(2)) {
        3
    } else if tokens::begin(tokens, &["fn", "main"])
        || tokens::begin(tokens, &["testing", ":", ":", "examples", "!"])
    {
        tokens.iter().position(is_body).map_or(0, |body| body + 1)
    } else {
        0
    }
}

/// A file of a hand-in that is compared with those of others.
#[derive(Debug)]
pub struct ComparedFile {
    pub path: String,
    pub structure: Structure,
}

impl ComparedFile {
    /// The file of a text; none if it is no Rust, or too short.
    pub fn read(path: &str, text: &str) -> Option<Self> {
        Some(Self {
            path: path.to_owned(),
            structure: Structure::read(text)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_workbook_gives_is_not_compared() {
        let long = "x = x * x + 3.0;".repeat(30);
        let whole = |head: &str| Structure::read(&format!("{head} {{ {long} }}\n"));
        assert!(whole("fn other() -> u8").is_some());
        assert_eq!(whole("fn main() -> Result<(), Error>"), None);
        assert_eq!(whole("testing::examples!"), None);
        assert_eq!(Structure::read("pub fn a() {}"), None);
    }
}
