//! `Known`: recognises a known mistake by the results of a student's code, with the mistake in
//! the place of the lesson.

use std::cmp::Reverse;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::vec::IntoIter;

use super::tape::Tape;
use super::{Answer, Check, Input, Mistakes, Variant};

/// The answer of a student's code at an input, and whether it is wrong; none where the lesson's
/// answer depends on rounding.
pub(super) type Result = Option<(Answer, bool)>;

/// The results of a student's code, compared with those of one mistake.
pub(super) struct Known {
    results: IntoIter<Result>,
    /// The wrong results that the mistake has, too.
    same: usize,
    /// Whether the mistake has another result.
    differs: bool,
}

impl Known {
    /// Compares the next result, and returns whether the mistake has it, too. An answer of the
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
            _ => self.differs = true,
        }
        !self.differs
    }
}

/// A sentence about the mistake that has all results of a checked code. The solution makes the
/// usual mistakes.
pub(super) fn recognised(found: &Check, (solution, variants): Mistakes) -> Option<String> {
    let usual = (0..).zip(&found.usual);
    let usual = usual.map(|(index, about)| (*about, solution, Some(index)));
    let wrong =
        |Variant(is_right, about, check): &Variant| (!is_right).then_some((*about, *check, None));
    let mistakes = usual.chain(variants.iter().filter_map(wrong));
    let known = mistakes.filter_map(|(about, run, mistake)| {
        let mut check = Check::new(false, mistake);
        check.lesson = Tape::Read(found.inputs.clone().into_iter());
        check.known = Some(Known {
            results: found.results.clone().into_iter(),
            same: 0,
            differs: false,
        });
        catch_unwind(AssertUnwindSafe(|| run(&mut check))).ok()?;
        let known = check.known.filter(|known| !known.differs)?;
        (2 * known.same >= found.differ.max(1)).then_some((known.same, about))
    });
    let (_, about) = known.min_by_key(|(same, _)| Reverse(*same))?;
    Some(format!(
        "this is a known mistake; it overlooks that {about}"
    ))
}
