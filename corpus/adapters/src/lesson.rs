//! The lesson's shapes.

use corpus::CASES;

use crate::Adapter;

pub const ADAPTER: Adapter = Adapter {
    name: "lesson",
    title: "the lesson",
    cases: CASES,
    ask: |question| {
        let hit = || corpus_lesson::lesson(question).ok();
        let hit = corpus_lesson::lesson_has(question).then(hit)??;
        Some(hit.map(|hit| hit.t))
    },
};
