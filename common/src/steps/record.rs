//! The record of the steps that the lesson's own functions take.
//!
//! Wrappers around the parts of a scene record the numbers that go in and out. Each thread has a
//! record of its own; where none is kept, the cost is one test of a flag.

use std::cell::RefCell;
use std::fmt::Debug;
use std::mem;

use super::{HIT, Step, TEST};

#[derive(Default)]
struct Record {
    steps: Vec<Step>,
    /// The level of the next heading, and of the next other step.
    levels: [usize; 2],
}

// No record: the thread records nothing.
thread_local!(static RECORD: RefCell<Option<Record>> = const { RefCell::new(None) });

/// Runs `task` with another record, and returns its result and the record.
fn with_record<T>(record: Option<Record>, task: impl FnOnce() -> T) -> (T, Option<Record>) {
    let outer = RECORD.replace(record);
    let result = task();
    (result, RECORD.replace(outer))
}

/// Changes the record, if there is one.
fn edit<T>(edit: impl FnOnce(&mut Record) -> T) -> Option<T> {
    RECORD.with_borrow_mut(|record| record.as_mut().map(edit))
}

/// Runs `task`, and returns its result and the steps that it took in this thread. Tests for a
/// hit that are beside each other are in the order of `t`.
pub fn recorded<T>(task: impl FnOnce() -> T) -> (T, Vec<Step>) {
    let (result, record) = with_record(Some(Record::default()), task);
    (result, in_order(&record.unwrap_or_default().steps))
}

/// Runs `task` without recording its steps.
pub fn paused<T>(task: impl FnOnce() -> T) -> T {
    with_record(None, task).0
}

/// Whether steps are recorded in this thread.
#[must_use]
pub fn is_on() -> bool {
    RECORD.with_borrow(Option::is_some)
}

/// Reads and changes the steps so far, if steps are recorded.
pub fn so_far<T>(change: impl FnOnce(&mut Vec<Step>) -> T) -> Option<T> {
    edit(|record| change(&mut record.steps))
}

/// Records a step, if steps are recorded.
pub fn push(step: impl FnOnce() -> Step) {
    if is_on() {
        let step = step();
        edit(|record| {
            let level = record.levels[1];
            record.steps.push(Step { level, ..step });
        });
    }
}

/// Records a step to which the following ones belong, up to the next heading.
pub fn heading(step: impl FnOnce() -> Step) {
    edit(|record| record.levels[1] = record.levels[0]);
    push(step);
    edit(|record| record.levels[1] += 1);
}

/// Records a step, and runs `task`, whose steps belong to it.
pub fn inside<T>(step: impl FnOnce() -> Step, task: impl FnOnce() -> T) -> T {
    push(step);
    let outer = edit(|record| {
        let inner = [record.levels[1] + 1; 2];
        mem::replace(&mut record.levels, inner)
    });
    let result = task();
    edit(|record| record.levels = outer.unwrap_or_default());
    result
}

/// The steps with tests that are beside each other in the order of `t`; last those whose `t` is
/// not above 0, or that have none. Only the first hit is the nearest.
fn in_order(steps: &[Step]) -> Vec<Step> {
    let level = steps.first().map_or(0, |step| step.level);
    let blocks = steps.chunk_by(|_, next| next.level > level);
    let mut blocks: Vec<_> = blocks
        .map(|block| [&block[..1], &in_order(&block[1..])].concat())
        .collect();
    for tests in blocks.chunk_by_mut(|a, b| a[0].kind == TEST && b[0].kind == TEST) {
        let t = |test: &[Step]| match test[0].value("t") {
            Some([t]) if t > 0.0 => t,
            Some(_) => f64::INFINITY,
            None => f64::NAN,
        };
        tests.sort_by(|a, b| t(a).total_cmp(&t(b)));
        for farther in tests
            .iter_mut()
            .filter(|test| test[0].outcome == HIT)
            .skip(1)
        {
            "farther than the nearest hit".clone_into(&mut farther[0].outcome);
        }
    }
    blocks.concat()
}

/// The name of a value's type, with which its `Debug` output begins.
pub fn type_name(value: &(impl Debug + ?Sized)) -> String {
    let text = format!("{value:?}");
    let name = text.split(|c: char| !c.is_alphanumeric());
    name.take(1).collect()
}
