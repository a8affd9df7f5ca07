//! Rust by its tokens: a word in a comment or in a text is none of the code, and a bracket ends where Rust ends it.

use std::ops::Range;

use proc_macro2::{LexError, TokenStream, TokenTree};

/// The first of these tokens that are replaced, and the text instead of them; none if none is replaced.
pub type Change = Option<(usize, String)>;

/// The tokens of a text. A bracket is one token, with those up to its end.
pub fn read(text: &str) -> Result<TokenStream, String> {
    let tokens = text.parse();
    tokens.map_err(|error: LexError| {
        let line = error.span().start().line;
        format!("line {line} is no Rust: a bracket or a quotation mark without end, or an unknown letter")
    })
}

/// Whether tokens begin with these ones.
#[must_use]
pub fn begin(tokens: &[TokenTree], words: &[&str]) -> bool {
    let beginning = tokens.iter().map(ToString::to_string).take(words.len());
    beginning.eq(words.iter().copied())
}

/// Where tokens stand in their text.
#[must_use]
pub fn range(tokens: &[TokenTree]) -> Range<usize> {
    let place = |token: Option<&TokenTree>| token.map_or(0..0, |token| token.span().byte_range());
    place(tokens.first()).start..place(tokens.last()).end
}

/// The text with each change. From each token on, `change` is given those up to the next end of a bracket.
pub fn replace(
    text: &str,
    change: &dyn Fn(&[TokenTree]) -> Result<Change, String>,
) -> Result<String, String> {
    let mut places = Vec::new();
    find(read(text)?, change, &mut places)?;
    let mut changed = text.to_owned();
    // The last place first, so that those before it do not move.
    for (place, words) in places.into_iter().rev() {
        changed.replace_range(place, &words);
    }
    Ok(changed)
}

/// Adds the places of changes, in the order of the text.
fn find(
    tokens: TokenStream,
    change: &dyn Fn(&[TokenTree]) -> Result<Change, String>,
    places: &mut Vec<(Range<usize>, String)>,
) -> Result<(), String> {
    let tokens: Vec<_> = tokens.into_iter().collect();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if let Some((count, words)) = change(&tokens[at..])? {
            places.push((range(&tokens[at..at + count]), words));
            at += count;
            continue;
        }
        if let TokenTree::Group(bracket) = token {
            find(bracket.stream(), change, places)?;
        }
        at += 1;
    }
    Ok(())
}
