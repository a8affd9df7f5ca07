//! Checks the book's tables of the work that is skipped.

use std::path::Path;

use common::comparison::Comparison;
use common::omitted_work::Words;
use common::{Omission, Stage};

use super::TestPaths;
use super::invariance::small;

/// Checks that the book's tables of the skipped work have the words of the program, and the counted
/// numbers, for all scenes of the stage in which the lesson leaves something out, in pictures of 96x72 pixels.
pub fn check_book(stage: &Stage, places: &TestPaths) {
    let path = Path::new(places.stage).join("../book/src/left-out.md");
    let mut page = std::fs::read_to_string(&path).expect("the page");
    for omission in Omission::OF_LESSON {
        let Words { work, because } = Words::of(omission);
        let row = format!("| {work} | {because} |");
        assert!(page.contains(&row), "the book lacks: {row}");
    }
    let mut wrong = Vec::new();
    for scene in stage.scenes.iter().filter(|scene| scene.uses.sampling) {
        let (number, _) = stage.name.split_once('-').expect("a number");
        let name = format!("{number} {}", scene.name);
        let comparison = Comparison::new(scene, &small(scene)).expect("the scene renders");
        assert_eq!(comparison.difference, 0.0, "{name}");
        // A bold number is the lesson's, beside that of all work.
        let row = Some(comparison.row(&name)).filter(|row| row.contains("**"));
        let begin = format!("| {name} |");
        let found = page.lines().find(|line| line.starts_with(&begin));
        if found != row.as_deref() {
            let row = row.unwrap_or_else(|| format!("no row of {name}, which leaves out nothing"));
            page = found.map_or_else(|| page.clone(), |found| page.replace(found, &row));
            wrong.push(row);
        }
    }
    if std::env::var("INSTA_UPDATE").as_deref() == Ok("always") {
        std::fs::write(&path, page).expect("the page is written");
    } else {
        assert!(wrong.is_empty(), "it is:\n{}", wrong.join("\n"));
    }
}
