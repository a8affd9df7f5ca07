//! Classroom 50's file of results:
//! <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>.

use std::env;

use super::super::outcome::{Graded, Judged, State};
use super::json;

/// The fields that its runner gives in the environment, and the variables.
const FROM_RUNNER: [(&str, &str); 7] = [
    ("classroom", "CLASSROOM"),
    ("assignment", "ASSIGNMENT"),
    ("submission", "SUBMISSION_TAG"),
    ("commit", "COMMIT_URL"),
    ("release", "RELEASE_URL"),
    ("review", "REVIEW_URL"),
    ("datetime", "SUBMISSION_DATETIME"),
];

pub fn text(graded: &[Graded]) -> String {
    let mut text = Vec::new();
    for submission in graded {
        text.push("{\"schema\": \"classroom50/result/v1\"".to_owned());
        for (field, variable) in FROM_RUNNER {
            let value = env::var(variable).unwrap_or_default();
            text.push(format!(", \"{field}\": {}", json(&value)));
        }
        let (points, most) = (submission.points(), submission.most());
        text.push(format!(
            ", \"score\": {points}, \"max-score\": {most}, \"tests\": [\n"
        ));
        let tests: Vec<_> = submission.results.iter().map(test).collect();
        text.push(tests.join(",\n"));
        text.push("\n]}\n".to_owned());
    }
    text.concat()
}

fn test(judged: &Judged) -> String {
    let name = judged.exercise.name;
    let is_right = judged.outcome.state == State::Right;
    let (points, most) = (judged.points, judged.most);
    let message = json(&judged.outcome.message);
    format!(
        "{{\"test-name\": \"{name}\", \"passed\": {is_right}, \"score\": {points}, \
         \"max-score\": {most}, \"message\": {message}}}"
    )
}
