//! `wrap`: breaks text between words where the terminal ends.

use textwrap::{Options, WordSeparator, WordSplitter};

/// Longer lines are hard to read, however wide the terminal is.
const MAX_WIDTH: usize = 100;

/// Breaks lines that are longer than the width, and indents what follows as their beginning.
pub fn wrap(text: &str, width: usize) -> String {
    let lines: Vec<_> = text.lines().map(|line| wrap_line(line, width)).collect();
    lines.join("\n")
}

fn wrap_line(line: &str, width: usize) -> String {
    let indent = &line[..line.len() - line.trim_start_matches(' ').len()];
    // A path is one word, also where it is too long for the line, so that it can be copied.
    let options = Options::new(width.min(MAX_WIDTH))
        .initial_indent(indent)
        .subsequent_indent(indent)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .break_words(false);
    textwrap::fill(line.trim_start_matches(' '), options)
}

/// Joins the lines of each paragraph of a page of the book, and breaks them at the width. Code,
/// lists and tables keep their lines, and links are shown by their words.
pub fn wrap_markdown(text: &str, width: usize) -> String {
    let mut lines = Vec::new();
    let mut paragraph = String::new();
    let mut is_code = false;
    for line in text.lines() {
        let is_fence = line.starts_with("```");
        let is_own_line = is_code || line.is_empty() || line.starts_with(['-', '|', ' ', '>']);
        if (is_fence || is_own_line) && !paragraph.is_empty() {
            lines.push(wrap(&without_links(&paragraph), width));
            paragraph.clear();
        }
        if is_fence {
            is_code = !is_code;
        } else if is_code {
            lines.push(format!("    {line}"));
        } else if is_own_line {
            lines.push(wrap(&without_links(line), width));
        } else {
            if !paragraph.is_empty() {
                paragraph.push(' ');
            }
            paragraph += line;
        }
    }
    lines.push(wrap(&without_links(&paragraph), width));
    lines.join("\n").trim_end().to_owned()
}

/// The text with `words` instead of each `[words](page)`.
fn without_links(text: &str) -> String {
    let mut words = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("](") {
        let link = before.rsplit_once('[');
        let (Some((before, link)), Some((_, after))) = (link, after.split_once(')')) else {
            break;
        };
        words += before;
        words += link;
        rest = after;
    }
    words + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words() {
        assert_eq!(
            wrap("looks along g, with t upwards", 12),
            "looks along\ng, with t\nupwards"
        );
        assert_eq!(wrap("  a bc\nd", 5), "  a\n  bc\nd");
        let path = "out/exercises/a01-image-display-set_pixel.png";
        assert_eq!(
            wrap(&format!("picture: {path}"), 20),
            format!("picture:\n{path}")
        );
    }

    #[test]
    fn paragraphs_are_joined_and_code_is_not() {
        let text = "One\nline of [stage 3](a03.md#ray).\n\n```text\na  b\nc\n```\n\n- a\n- b";
        let wrapped = "One line of\nstage 3.\n\n    a  b\n    c\n\n- a\n- b";
        assert_eq!(wrap_markdown(text, 12), wrapped);
        assert_eq!(wrap_markdown("n[0](x", 9), "n[0](x");
    }
}
