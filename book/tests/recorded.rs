//! Each anchor of a page has a figure in the recording.

use std::fs;
use std::path::Path;

use measure::recorded::{Anchor, Recording};

use crate::files::{Files, complaint};

/// The anchors without a figure.
pub fn anchors(files: &Files) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("recording.csv");
    let text = fs::read_to_string(path).expect("the recording");
    let recording = Recording::parse(&text).expect("the recording");
    let (mut anchors, mut complaints) = (0, Vec::new());
    for (page, text) in files.pages() {
        let mut start = 0;
        while let Some(anchor) = Anchor::first(&text[start..]) {
            if let Err(why) = recording.figure(anchor.words) {
                complaints.push(complaint(page, text, start + anchor.start, &why));
            }
            start += anchor.end;
            anchors += 1;
        }
    }
    assert!(anchors > 50, "only {anchors} anchors");
    complaints
}
