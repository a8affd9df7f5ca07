//! The engine, `--fast`.

use corpus::CASES;

use crate::Adapter;

pub const ADAPTER: Adapter = Adapter {
    name: "engine",
    title: "the engine, `--fast`",
    cases: CASES,
    ask: |question| {
        let found = || corpus_lesson::engine(question).ok();
        corpus_lesson::engine_has(question).then(found)?
    },
};
