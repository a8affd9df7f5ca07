//! `Task`: the task that the command line selects.

/// A task of the runner of exercises.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Shows students their progress.
    Check,
    /// Proves that starters are untouched and fail.
    Starters,
    /// Proves that solutions pass.
    Solutions,
    /// Makes the starters from the solutions.
    WriteStarters,
}

/// The task and the names in the arguments. The flags of Rust's test harness and
/// their values are not names.
pub fn asked_for(mut arguments: impl Iterator<Item = String>) -> (Task, Vec<String>) {
    let (mut task, mut names) = (Task::Check, Vec::new());
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--starters" => task = Task::Starters,
            "--solutions" => task = Task::Solutions,
            "--write-starters" => task = Task::WriteStarters,
            "--test-threads" | "--skip" | "--format" | "--color" | "--logfile"
            | "--shuffle-seed" | "-Z" => {
                arguments.next();
            }
            flag if flag.starts_with('-') => {}
            _ => names.push(argument),
        }
    }
    (task, names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_of_the_test_harness_and_their_values_are_not_names() {
        let given = |line: &str| asked_for(line.split_whitespace().map(str::to_owned));
        let names = |line: &str| given(line).1.join(" ");
        assert_eq!(names("--nocapture --test-threads 1 -q cube"), "cube");
        assert_eq!(names("--exact sphere --skip cube --color=always"), "sphere");
        assert!(given("--nocapture").0 == Task::Check);
        assert!(given("cube --solutions").0 == Task::Solutions);
        assert_eq!(names("--write-starters cube"), "cube");
    }
}
