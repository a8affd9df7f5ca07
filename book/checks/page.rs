//! `Page`: a page of the book, read the way mdBook reads it.

use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser};

/// A page and where it lies.
#[derive(Clone, Copy)]
pub struct Page<'a> {
    /// From the top of the repository.
    pub path: &'a str,
    /// As it was written, before listings are put in.
    pub text: &'a str,
}

impl<'a> Page<'a> {
    /// The events of mdBook's parser for the text, each with its place.
    pub fn events(self) -> impl Iterator<Item = (Event<'a>, Range<usize>)> {
        let options = Options::ENABLE_TABLES
            | Options::ENABLE_FOOTNOTES
            | Options::ENABLE_STRIKETHROUGH
            | Options::ENABLE_TASKLISTS
            | Options::ENABLE_HEADING_ATTRIBUTES
            | Options::ENABLE_SMART_PUNCTUATION
            | Options::ENABLE_DEFINITION_LIST
            | Options::ENABLE_GFM
            | Options::ENABLE_MATH;
        Parser::new_ext(self.text, options).into_offset_iter()
    }

    /// A complaint about the byte `at` of the text.
    pub fn complain(self, at: usize, what: &str) -> String {
        let line = self.text[..at].matches('\n').count() + 1;
        complaint(self.path, line, what)
    }
}

/// A mistake in a line of a file; lines are counted from 1.
pub fn complaint(path: &str, line: usize, what: &str) -> String {
    format!("{path}:{line}: {what}")
}

#[cfg(test)]
mod tests {
    use pulldown_cmark::Tag;

    use super::*;

    #[test]
    fn a_complaint_names_the_line() {
        let text = "one\ntwo\nthree\n";
        let page = Page { path: "a.md", text };
        assert_eq!(page.complain(0, "no"), "a.md:1: no");
        assert_eq!(page.complain(4, "no"), "a.md:2: no");
        assert_eq!(page.complain(text.len() - 1, "no"), "a.md:3: no");
    }

    /// Each of these is a plain text or paragraph to a reader of less.
    #[test]
    fn all_is_read_that_mdbook_reads() {
        let seen = |text, found: fn(&Event) -> bool| {
            let page = Page { path: "a.md", text };
            page.events().any(|(event, _)| found(&event))
        };
        let start = |text, found: fn(&Tag) -> bool| {
            let page = Page { path: "a.md", text };
            let mut events = page.events();
            events.any(|(event, _)| matches!(event, Event::Start(tag) if found(&tag)))
        };
        assert!(start("| a |\n|---|\n", |tag| matches!(tag, Tag::Table(_))));
        assert!(start("[^a]\n\n[^a]: note", |tag| matches!(
            tag,
            Tag::FootnoteDefinition(_)
        )));
        assert!(start("~~a~~", |tag| matches!(tag, Tag::Strikethrough)));
        assert!(seen("- [x] a", |event| matches!(
            event,
            Event::TaskListMarker(true)
        )));
        assert!(start("# A {#b}", |tag| matches!(
            tag,
            Tag::Heading { id: Some(_), .. }
        )));
        assert!(seen("it's", |event| *event == Event::Text("’".into())));
        assert!(start("a\n: b", |tag| matches!(tag, Tag::DefinitionList)));
        assert!(start("> [!NOTE]\n> a", |tag| matches!(
            tag,
            Tag::BlockQuote(Some(_))
        )));
        assert!(seen("$a$", |event| matches!(event, Event::InlineMath(_))));
    }
}
