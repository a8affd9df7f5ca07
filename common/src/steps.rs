//! `steps`: the steps of a computation, recorded while the lesson's own functions take them.
//!
//! Wrappers around the parts of a scene record the numbers that go in and out. Steps follow one
//! another as the headings and paragraphs of a text do: the level of a step says to which
//! earlier step it belongs. Each thread has a record of its own; where none is kept, the cost
//! is one test of a flag.

use std::cell::{Cell, RefCell};
use std::fmt::Debug;

/// A step of a computation.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The number of steps that this one is a part of.
    pub level: usize,
    /// The kind of the step, a word for programs.
    pub kind: &'static str,
    /// The name of the step, which distinguishes it from the steps beside it.
    pub name: String,
    /// The outcome in words; may be empty.
    pub outcome: String,
    /// Numbers, points, vectors and colours, by the symbols of the book.
    pub values: Vec<(&'static str, Vec<f64>)>,
    /// The section of the book that explains the step: the page below `book/src`, and the anchor
    /// that mdBook makes of the heading.
    pub section: &'static str,
}

impl Step {
    /// A step without outcome and values.
    pub fn new(kind: &'static str, name: impl Into<String>, section: &'static str) -> Self {
        Self {
            level: 0,
            kind,
            name: name.into(),
            outcome: String::new(),
            values: Vec::new(),
            section,
        }
    }

    /// This step with one more value.
    #[must_use]
    pub fn with(mut self, symbol: &'static str, value: impl Into<Vec<f64>>) -> Self {
        self.values.push((symbol, value.into()));
        self
    }

    /// The value of this symbol, if it has this many numbers.
    #[must_use]
    pub fn value<const N: usize>(&self, symbol: &str) -> Option<[f64; N]> {
        let value = self.values.iter().find(|(name, _)| *name == symbol);
        value.and_then(|(_, value)| value.as_slice().try_into().ok())
    }
}

/// The kind of a ray from the camera.
pub const RAY: &str = "ray";
/// The kind of a ray that a surface mirrors.
pub const REFLECTED: &str = "reflected ray";
/// The kind of a test of an object for a hit.
pub const TEST: &str = "test";
/// The kind of the nearest hit, which is shaded; and the outcome of a test that finds a hit.
pub const HIT: &str = "hit";
/// The name of the step at which a ray without a hit takes the background.
pub const NO_HIT: &str = "no hit: the background";

#[derive(Default)]
struct Record {
    steps: Vec<Step>,
    /// The level of headings, and whether there was one on it.
    level: usize,
    has_heading: bool,
}

thread_local! {
    static IS_ON: Cell<bool> = const { Cell::new(false) };
    static RECORD: RefCell<Record> = RefCell::default();
}

/// Runs `task`, and returns its result and the steps that it took in this thread. Tests for a
/// hit that are beside each other are in the order of `t`.
pub fn recorded<T>(task: impl FnOnce() -> T) -> (T, Vec<Step>) {
    let (outer, was_on) = (RECORD.take(), IS_ON.replace(true));
    let result = task();
    IS_ON.set(was_on);
    (result, in_order(&RECORD.replace(outer).steps))
}

/// Runs `task` without recording its steps.
pub fn paused<T>(task: impl FnOnce() -> T) -> T {
    let was_on = IS_ON.replace(false);
    let result = task();
    IS_ON.set(was_on);
    result
}

/// Whether steps are recorded in this thread.
#[inline]
#[must_use]
pub fn is_on() -> bool {
    IS_ON.get()
}

/// Reads and changes the steps so far.
pub fn so_far<T>(edit: impl FnOnce(&mut Vec<Step>) -> T) -> T {
    RECORD.with_borrow_mut(|record| edit(&mut record.steps))
}

/// Records a step, if steps are recorded.
pub fn push(step: Step) {
    if is_on() {
        RECORD.with_borrow_mut(|record| {
            let level = record.level + usize::from(record.has_heading);
            record.steps.push(Step { level, ..step });
        });
    }
}

/// Records a step to which the following ones belong, up to the next heading.
pub fn heading(step: Step) {
    if is_on() {
        RECORD.with_borrow_mut(|record| record.has_heading = false);
        push(step);
        RECORD.with_borrow_mut(|record| record.has_heading = true);
    }
}

/// Runs `task`, whose steps belong to the last step.
pub fn inside<T>(task: impl FnOnce() -> T) -> T {
    if !is_on() {
        return task();
    }
    let outer = RECORD.with_borrow_mut(|record| {
        let outer = (record.level, record.has_heading);
        record.level += 1 + usize::from(record.has_heading);
        record.has_heading = false;
        outer
    });
    let result = task();
    RECORD.with_borrow_mut(|record| (record.level, record.has_heading) = outer);
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
