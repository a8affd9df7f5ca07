//! `JUnit`'s file of results, as Artemis, GitLab and Jenkins read it:
//! <https://github.com/jenkinsci/xunit-plugin>, `junit-10.xsd`.

use super::super::outcome::{Graded, Judged, State};
use super::message;

pub fn text(graded: &[Graded]) -> String {
    let mut text = vec!["<testsuites>\n".to_owned()];
    for submission in graded {
        let name = xml(&submission.name);
        let tests = submission.results.len();
        let errors = submission.count(State::NeedsALook);
        let failures = tests - errors - submission.count(State::Right);
        text.push(format!(
            "<testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\" \
             errors=\"{errors}\">\n"
        ));
        for judged in &submission.results {
            text.push(case(judged));
        }
        text.push("</testsuite>\n".to_owned());
    }
    text.push("</testsuites>\n".to_owned());
    text.concat()
}

/// An exercise. One that needs a look is an error, as of a test that could not run.
fn case(judged: &Judged) -> String {
    let kind = match judged.outcome.state {
        State::Right => "",
        State::NeedsALook => "error",
        State::Wrong | State::NotHandedIn => "failure",
    };
    let (stage, name) = (judged.exercise.stage, judged.exercise.name);
    let case = format!("<testcase classname=\"{stage}\" name=\"{name}\"");
    if kind.is_empty() {
        return case + "/>\n";
    }
    let words = xml(&judged.outcome.message);
    let first = words.lines().next().unwrap_or_default();
    format!("{case}><{kind} message=\"{first}\">{words}</{kind}></testcase>\n")
}

fn xml(text: &str) -> String {
    let text = message(text).replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}
