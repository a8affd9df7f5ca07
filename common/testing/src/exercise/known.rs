//! `Known`: recognises a known mistake by the results of a student's code, with the mistake in
//! the place of the lesson.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::vec::IntoIter;

use super::{Answer, Check, Input, Mistakes, Variant};

/// The answer of a student's code at an input, and whether it is wrong; none where the lesson's
/// answer depends on rounding.
pub(super) type Result = Option<(Answer, bool)>;

/// The results of a student's code, compared with those of one mistake.
#[derive(Default)]
pub(super) struct Known {
    results: IntoIter<Result>,
    pub inputs: IntoIter<Vec<f64>>,
    /// The wrong results that the mistake has, too, and the results that it has not.
    same: usize,
    misses: usize,
    /// The most misses of a mistake that is near.
    most: usize,
}

impl Known {
    /// Compares the next result, and returns whether the mistake is still near. An answer of the
    /// mistake may differ by rounding, as one of the lesson.
    pub fn compare_at<I: Input>(
        &mut self,
        unit: f64,
        is_simple: bool,
        input: &I,
        mistake: &dyn Fn(I) -> Answer,
    ) -> bool {
        let Some(Some((yours, is_wrong))) = self.results.next() else {
            return true;
        };
        let run = || {
            let answer = mistake(input.clone());
            let is_near = |allowed: Vec<f64>| answer.difference(&yours, &allowed).is_none();
            let is_equal = is_near(answer.tolerances(unit, [].into_iter())?);
            if is_equal || is_simple {
                return Some(is_equal);
            }
            let moved = input.moved(unit).map(|pair| pair.map(mistake));
            answer.tolerances(unit, moved).map(is_near)
        };
        match catch_unwind(AssertUnwindSafe(run)) {
            Ok(Some(true)) => self.same += usize::from(is_wrong),
            Ok(None) => {}
            _ => self.misses += 1,
        }
        self.misses <= self.most
    }
}

/// A sentence about the mistake that has the results of a checked code, or of the one that is
/// clearly nearest to it. The solution makes the usual mistakes.
pub(super) fn recognised(found: &Check, (solution, variants): Mistakes) -> Option<String> {
    let most = found.differ / 20;
    let usual = (0..).zip(&found.usual);
    let usual = usual.map(|(index, about)| (*about, solution, Some(index)));
    let wrong =
        |Variant(is_right, about, check): &Variant| (!is_right).then_some((*about, *check, None));
    let mut known: Vec<_> = usual
        .chain(variants.iter().filter_map(wrong))
        .map(|(about, run, mistake)| {
            let mut check = Check::new(false, mistake);
            let known = check.known.insert(Known::default());
            known.results = found.results.clone().into_iter();
            known.inputs = found.inputs.clone().into_iter();
            known.most = most;
            let fails = catch_unwind(AssertUnwindSafe(|| run(&mut check))).is_err();
            let Known { same, misses, .. } = check.known.unwrap_or_default();
            (misses + usize::from(fails), same, about)
        })
        .collect();
    known.retain(|(misses, same, _)| *misses <= most && 2 * same >= found.differ.max(1));
    known.sort_by_key(|(misses, same, _)| (*misses, usize::MAX - same));
    let differ = found.differ;
    match *known.as_slice() {
        [(0, _, about), ..] => Some(format!(
            "this is a known mistake; it overlooks that {about}"
        )),
        [(_, same, about)] => Some(format!(
            "the nearest known mistake, at {same} of {differ} differences, overlooks that {about}"
        )),
        _ => None,
    }
}
