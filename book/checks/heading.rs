//! The names by which links reach the headings of a page.

use std::collections::HashSet;

use pulldown_cmark::{Event, Tag, TagEnd};

use crate::page::Page;

/// The ids that mdBook gives to the headings and the defined terms of a page.
pub fn ids(page: Page) -> HashSet<String> {
    let mut ids = HashSet::new();
    let mut text = None;
    for (event, _) in page.events() {
        match event {
            Event::Start(Tag::Heading { id: Some(id), .. }) => {
                ids.insert(id.into_string());
            }
            Event::Start(Tag::Heading { .. } | Tag::DefinitionListTitle) => {
                text = Some(String::new());
            }
            Event::Text(part) | Event::Code(part) => {
                if let Some(text) = &mut text {
                    text.push_str(&part);
                }
            }
            Event::End(TagEnd::Heading(_) | TagEnd::DefinitionListTitle) => {
                if let Some(text) = text.take() {
                    let id = unused(id(&text), &ids);
                    ids.insert(id);
                }
            }
            _ => {}
        }
    }
    ids
}

/// Letters, digits, hyphens and underscores, small; hyphens for spaces.
fn id(text: &str) -> String {
    let small = text.trim().to_lowercase();
    let kept = small.chars().filter_map(|c| match c {
        '_' | '-' => Some(c),
        _ if c.is_alphanumeric() => Some(c),
        _ => c.is_whitespace().then_some('-'),
    });
    kept.collect()
}

/// A second heading of the same text is counted.
fn unused(id: String, ids: &HashSet<String>) -> String {
    let counted = (1..).map(|n| format!("{id}-{n}"));
    let mut candidates = std::iter::once(id.clone()).chain(counted);
    candidates.find(|id| !ids.contains(id)).unwrap_or(id)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids_of(text: &str) -> Vec<String> {
        let mut ids: Vec<_> = ids(Page { path: "", text }).into_iter().collect();
        ids.sort();
        ids
    }

    /// Expected are the ids in mdBook's own output.
    #[test]
    fn ids_are_those_of_mdbook() {
        assert_eq!(ids_of("## The dot product"), ["the-dot-product"]);
        assert_eq!(
            ids_of("# Vectors, points, normals"),
            ["vectors-points-normals"]
        );
        assert_eq!(
            ids_of("## 1. `hit()` -- *first* Größe"),
            ["1-hit--first-größe"]
        );
        assert_eq!(
            ids_of("## The protocol's problem"),
            ["the-protocols-problem"]
        );
        assert_eq!(ids_of("## a - b"), ["a---b"]);
        assert_eq!(
            ids_of("## Same\n## Same\n## Same"),
            ["same", "same-1", "same-2"]
        );
        assert_eq!(ids_of("## Long name {#short}"), ["short"]);
    }

    #[test]
    fn code_has_no_headings() {
        assert!(ids_of("```text\n# no heading\n```").is_empty());
    }
}
