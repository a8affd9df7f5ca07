//! `wrap`: breaks a text that is wider than the window.

/// The lines of a text, each of at most this many characters, broken at spaces if
/// there are some.
pub fn wrap(mut text: &str, columns: usize) -> Vec<&str> {
    let mut lines = Vec::new();
    while let Some((end, _)) = text.char_indices().nth(columns) {
        let (head, tail) = text.split_at(end);
        let is_whole_word = tail.starts_with(' ');
        let space = head.rfind(' ').filter(|at| *at > 0 && !is_whole_word);
        let (line, rest) = text.split_at(space.unwrap_or(end));
        lines.push(line);
        text = rest.trim_start();
    }
    lines.push(text);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_is_broken_at_spaces_if_there_are_some() {
        for (text, columns, lines) in [
            ("", 5, &[""][..]),
            ("saved a.png", 10, &["saved", "a.png"]),
            ("one two  six", 7, &["one two", "six"]),
            ("a name/without", 8, &["a", "name/wit", "hout"]),
            ("äöüß", 2, &["äö", "üß"]),
        ] {
            assert_eq!(wrap(text, columns), lines);
        }
    }
}
