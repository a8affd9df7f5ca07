//! Gradescope's file of results:
//! <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.

use super::super::outcome::{Graded, Judged, State};
use super::json;

pub fn text(graded: &[Graded]) -> String {
    let mut text = Vec::new();
    for submission in graded {
        let points = submission.points();
        text.push(format!(
            "{{\"score\": {points}, \"visibility\": \"visible\", \"tests\": [\n"
        ));
        let tests: Vec<_> = submission.results.iter().map(test).collect();
        text.push(tests.join(",\n"));
        text.push("\n]}\n".to_owned());
    }
    text.concat()
}

fn test(judged: &Judged) -> String {
    let name = json(judged.exercise.title);
    let (points, most) = (judged.points, judged.most);
    let status = match judged.outcome.state {
        State::Right => "passed",
        _ => "failed",
    };
    let output = json(&judged.outcome.message);
    format!(
        "{{\"name\": {name}, \"score\": {points}, \"max_score\": {most}, \
         \"status\": \"{status}\", \"output\": {output}, \"output_format\": \"text\"}}"
    )
}
