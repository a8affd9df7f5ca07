//! Each anchor of a page has a figure in the recording.

use std::fs;
use std::path::Path;

use measure::recorded::{Anchor, Recording};

use crate::files::{Files, complaint};

/// The anchors without a figure.
pub fn anchors(files: &Files) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let [here, elsewhere] = ["recording.csv", "elsewhere.csv"]
        .map(|file| fs::read_to_string(folder.join(file)).expect("a recording"));
    let recording = Recording::parse(&here).expect("the recording");
    let recording = recording
        .with_elsewhere(&elsewhere)
        .expect("quotients that turn");
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
