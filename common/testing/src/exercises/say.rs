//! `say`: prints what a check says, apart from what the student's program prints.

use std::env;

use exercise::{MARKED, REMARK_MARK, WORDS_MARK};

/// Prints words that all students read.
pub(super) fn say(words: &str) {
    print_lines(WORDS_MARK, words);
}

/// Prints words for those who want to know more than the verdict.
pub(super) fn remark(words: &str) {
    print_lines(REMARK_MARK, words);
}

/// Begins each line with a mark, if the reader asks for it.
fn print_lines(mark: char, words: &str) {
    let is_marked = env::var_os(MARKED).is_some();
    for line in words.lines() {
        if is_marked {
            println!("{mark}{line}");
        } else {
            println!("{line}");
        }
    }
}
