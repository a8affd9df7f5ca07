//! `name_hang`: what a student's check was asked last, if it does not end.

use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// How long before its end a check says what it was asked last.
const BEFORE_END: Duration = Duration::from_millis(500);

/// What the student's code does now, in words.
static NOW: Mutex<String> = Mutex::new(String::new());

/// Notes what the student's code does now.
pub fn note(words: &str) {
    words.clone_into(&mut NOW.lock().unwrap_or_else(PoisonError::into_inner));
}

/// Says what the student's code does shortly before the end of this time, if the program still runs.
pub fn name_hang(seconds: u64, say: fn(&str)) {
    thread::spawn(move || {
        thread::sleep(Duration::from_secs(seconds).saturating_sub(BEFORE_END));
        let now = NOW.lock().unwrap_or_else(PoisonError::into_inner);
        say(&format!("it does not end at: {now}"));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    static SAID: Mutex<String> = Mutex::new(String::new());

    #[test]
    fn a_check_without_end_says_what_it_was_asked() {
        note("the first question");
        note("the question that hangs");
        name_hang(0, |words| SAID.lock().unwrap().push_str(words));
        while SAID.lock().unwrap().is_empty() {
            thread::yield_now();
        }
        assert_eq!(
            *SAID.lock().unwrap(),
            "it does not end at: the question that hangs"
        );
    }
}
