//! Code as one text without space, comments and the texts in it, in which words are found.

use proc_macro2::{Group, Literal, TokenStream, TokenTree};

/// Whether a letter is part of a name.
pub fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// The tokens, of which the texts are empty.
fn without_texts(tokens: TokenStream) -> TokenStream {
    let without_text = |token| match token {
        TokenTree::Literal(literal) if literal.to_string().contains(['"', '\'']) => {
            Literal::string("").into()
        }
        TokenTree::Group(bracket) => {
            Group::new(bracket.delimiter(), without_texts(bracket.stream())).into()
        }
        other => other,
    };
    tokens.into_iter().map(without_text).collect()
}

/// The code without space and comments, and with `~` between two names.
pub fn joined(tokens: TokenStream) -> String {
    // Any name may be written as a raw one.
    let code = without_texts(tokens).to_string().replace("r#", "");
    let mut joined = String::new();
    for word in code.split_whitespace() {
        if joined.ends_with(is_of_name) && word.starts_with(is_of_name) {
            joined.push('~');
        }
        joined += word;
    }
    joined
}

/// Whether a text has a word that neither begins nor ends within a longer name; one that ends with `_` is
/// the beginning of names.
pub fn has(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + word.len()..]);
        let begins_within = word.starts_with(is_of_name) && before.ends_with(is_of_name);
        let ends_within = word.ends_with(char::is_alphanumeric) && after.starts_with(is_of_name);
        !begins_within && !ends_within
    })
}
