//! The trace of a computation: its steps in their order, written down.

use std::mem;

use super::recorder::{Mode, RECORDER, mode};
use super::{Outcome, Step, StepKind, count};

/// The steps so far.
#[derive(Default)]
pub(super) struct Trace {
    steps: Vec<Step>,
    /// The level of the next heading.
    heading_level: usize,
    /// The level of the next other step.
    level: usize,
}

impl Trace {
    /// No steps.
    pub const EMPTY: Self = Self {
        steps: Vec::new(),
        heading_level: 0,
        level: 0,
    };
}

/// Runs `task` with a recorder in another mode, and returns its result.
fn in_mode<T>(mode: Mode, task: impl FnOnce() -> T) -> T {
    let set = |mode| RECORDER.with(|recorder| recorder.mode.replace(mode));
    let outer = set(mode);
    let result = task();
    set(outer);
    result
}

/// Changes the trace, if steps are traced.
fn edit<T>(edit: impl FnOnce(&mut Trace) -> T) -> Option<T> {
    is_tracing().then(|| RECORDER.with(|recorder| edit(&mut recorder.trace.borrow_mut())))
}

/// Runs `task`, and returns its result and the steps that it took in this thread. Tests for a
/// hit that are beside each other are in the order of `t`.
pub fn traced<T>(task: impl FnOnce() -> T) -> (T, Vec<Step>) {
    let swap = |trace| RECORDER.with(|recorder| recorder.trace.replace(trace));
    let outer = swap(Trace::EMPTY);
    let result = in_mode(Mode::Tracing, task);
    let trace = swap(outer);
    (result, in_order(trace.steps))
}

/// Runs `task` without writing down its steps. Where steps are counted, its steps count.
pub fn untraced<T>(task: impl FnOnce() -> T) -> T {
    match mode() {
        Mode::Tracing => in_mode(Mode::Off, task),
        Mode::Off | Mode::Counting => task(),
    }
}

/// Whether steps are written down in this thread.
#[inline]
#[must_use]
pub fn is_tracing() -> bool {
    mode() == Mode::Tracing
}

/// Reads and changes the steps so far, if steps are traced.
pub fn so_far<T>(change: impl FnOnce(&mut Vec<Step>) -> T) -> Option<T> {
    edit(|trace| change(&mut trace.steps))
}

/// Reports a step of a kind: it is counted, or written down as `step` describes it.
pub fn push(kind: StepKind, step: impl FnOnce(StepKind) -> Step) {
    count(kind, 1);
    write_down(kind, step);
}

/// Reports a step to which the following ones belong, up to the next heading.
pub fn heading(kind: StepKind, step: impl FnOnce(StepKind) -> Step) {
    edit(|trace| trace.level = trace.heading_level);
    push(kind, step);
    edit(|trace| trace.level += 1);
}

/// Reports a step that counts `times`, and runs `task`, whose steps belong to it.
pub fn inside<T>(
    kind: StepKind,
    times: u64,
    step: impl FnOnce(StepKind) -> Step,
    task: impl FnOnce() -> T,
) -> T {
    count(kind, times);
    write_down(kind, step);
    let outer = edit(|trace| {
        let inner = trace.level + 1;
        (
            mem::replace(&mut trace.heading_level, inner),
            mem::replace(&mut trace.level, inner),
        )
    });
    let result = task();
    edit(|trace| (trace.heading_level, trace.level) = outer.unwrap_or_default());
    result
}

fn write_down(kind: StepKind, step: impl FnOnce(StepKind) -> Step) {
    if is_tracing() {
        let step = step(kind);
        edit(|trace| {
            let level = trace.level;
            trace.steps.push(Step { level, ..step });
        });
    }
}

/// The steps with tests that are beside each other in the order of `t`; last those whose `t` is
/// not above 0, or that have none. Only the first hit is the nearest.
fn in_order(steps: Vec<Step>) -> Vec<Step> {
    let level = steps.first().map_or(0, |step| step.level);
    // A step with those that belong to it.
    let mut blocks: Vec<(Step, Vec<Step>)> = Vec::new();
    for step in steps {
        match blocks.last_mut() {
            Some((_, parts)) if step.level > level => parts.push(step),
            _ => blocks.push((step, Vec::new())),
        }
    }
    let is_test = |block: &(Step, _)| block.0.kind == StepKind::Test;
    for tests in blocks.chunk_by_mut(|a, b| is_test(a) && is_test(b)) {
        let t = |(test, _): &(Step, Vec<Step>)| match test.value("t") {
            Some([t]) if t > 0.0 => t,
            Some(_) => f64::INFINITY,
            None => f64::NAN,
        };
        tests.sort_by(|a, b| t(a).total_cmp(&t(b)));
        let hits = tests
            .iter_mut()
            .filter(|(test, _)| test.outcome == Outcome::Hit);
        for (farther, _) in hits.skip(1) {
            farther.outcome = Outcome::FartherHit;
        }
    }
    let mut all = Vec::new();
    for (step, parts) in blocks {
        all.push(step);
        all.extend(in_order(parts));
    }
    all
}
