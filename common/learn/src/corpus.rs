//! `cargo learn corpus`: how the student's own shapes answer the rays that broke ray tracers.

use std::time::Duration;

use crate::exercise::Exercise;
use crate::files;
use crate::judgement::judge;
use crate::phase::Phase;
use crate::progress::Progress;
use crate::screen::Space;

/// The exercises whose checks ask the corpus.
const SHAPES: [&str; 5] = ["plane", "axis_aligned_box", "triangle", "sphere", "disc"];

/// The first words of the check's remark about the corpus.
const REMARK: &str = "The corpus of ray failures:";

/// Checks the files of shapes that are begun, and returns what their checks say of the corpus.
pub fn ask(
    course: &[Exercise],
    progress: &mut Progress,
    space: Space,
    watcher: &mut dyn FnMut(Phase, Duration) -> bool,
) -> Result<String, String> {
    let mut words = Vec::new();
    for e in course {
        if !SHAPES.contains(&e.name) || !files::is_begun(e) {
            continue;
        }
        let report = judge(e, progress, space, watcher);
        let remark = report.remarks.lines().find(|line| line.starts_with(REMARK));
        words.push(match remark {
            Some(line) => line.trim_start_matches(REMARK).trim().to_owned(),
            // Code that is wrong at simple rays is asked no hard ones.
            None => format!("{}; the corpus waits until it is done", report.verdict),
        });
    }
    if words.is_empty() {
        let names = SHAPES.join(", ");
        return Err(format!(
            "the corpus asks your shapes, and none is begun: `cargo learn NAME` begins {names}"
        ));
    }
    Ok(words.join("\n"))
}
