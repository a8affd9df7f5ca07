//! Every picture is shown by a page.

use std::collections::HashSet;

use pulldown_cmark::{Event, Tag};

use crate::Files;
use crate::files::resolve;
use crate::page::complaint;

const PICTURES: &str = "book/src/pictures/";

/// The pictures that no page shows.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut shown = HashSet::new();
    for page in files.pages() {
        for (event, _) in page.events() {
            if let Event::Start(Tag::Image { dest_url, .. }) = event {
                shown.extend(resolve(page.path, &dest_url));
            }
        }
    }
    let pictures = files.below(PICTURES).map(|(path, _)| path);
    let unseen = pictures.filter(|path| !shown.contains(*path));
    unseen
        .map(|path| complaint(path, 1, "no page shows this picture"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_no_page_shows_is_found() {
        let files = Files::of([
            ("book/src/a.md", "![b](pictures/b.png)"),
            ("book/src/pictures/b.png", ""),
            ("book/src/pictures/c.png", ""),
        ]);
        assert_eq!(
            complaints(&files),
            ["book/src/pictures/c.png:1: no page shows this picture"]
        );
    }
}
