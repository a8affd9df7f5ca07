//! `wrap`: breaks a text that is longer than the window is wide.

/// The lines of a text, each of at most this many characters, broken at spaces
/// where there are some.
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
    fn what_fits_stays_one_line() {
        assert_eq!(wrap("saved a.png", 11), ["saved a.png"]);
        assert_eq!(wrap("", 5), [""]);
    }

    #[test]
    fn what_does_not_fit_is_broken_at_spaces() {
        assert_eq!(wrap("saved a.png", 10), ["saved", "a.png"]);
        assert_eq!(wrap("one two  six", 7), ["one two", "six"]);
        assert_eq!(
            wrap("a name/without/spaces", 8),
            ["a", "name/wit", "hout/spa", "ces"]
        );
    }

    #[test]
    fn characters_count_not_bytes() {
        assert_eq!(wrap("äöüß", 2), ["äö", "üß"]);
        assert_eq!(wrap("→→→", 1), ["→", "→", "→"]);
    }

    #[test]
    fn a_space_in_front_ends_no_line() {
        assert_eq!(wrap(" abcdef", 3), [" ab", "cde", "f"]);
    }
}
