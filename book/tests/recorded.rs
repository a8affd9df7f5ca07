//! Times and their quotients stand in the recordings, and nowhere else: pages name them by
//! anchors, and plots are drawn from them.

use std::fs;
use std::path::Path;

use measure::recorded::{Anchor, Texts};

use crate::files::{Files, blocks, complaint};

/// Where the recordings are.
fn texts() -> Texts {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("recordings");
    Texts::read(&folder).expect("the recordings")
}

/// The anchors without a figure, and those whose sentence says something else than the measurement
/// of a build.
pub fn anchors(files: &Files) -> Vec<String> {
    let texts = texts();
    let recordings = texts.recordings().expect("the recordings");
    let mut complaints = Vec::new();
    for (page, text) in pages(files) {
        let mut start = 0;
        while let Some(anchor) = Anchor::first(&text[start..]) {
            if let Err(why) = recordings.figure(anchor.words) {
                complaints.push(complaint(page, text, start + anchor.start, &why));
            }
            start += anchor.end;
        }
    }
    complaints
}

/// The plots that are not those of the recordings; `cargo record --draw` draws them again.
pub fn plots(files: &Files) -> Vec<String> {
    let texts = texts();
    let recordings = texts.recordings().expect("the recordings");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/pictures");
    let text: String = files.pages().map(|(_, text)| text).collect();
    let mut complaints = Vec::new();
    for plot in recordings.plots() {
        let is_shown = text.contains(&format!("](pictures/{})", plot.name));
        let drawn = fs::read_to_string(folder.join(&plot.name)).unwrap_or_default();
        if is_shown && drawn != plot.svg {
            complaints.push(format!("{} is not the plot of its recording", plot.name));
        }
    }
    complaints
}

/// The pages with text for readers: those of the book, and the README.
fn pages(files: &Files) -> impl Iterator<Item = (&str, &str)> {
    let readme = files.text("README.md").map(|text| ("README.md", text));
    files.pages().chain(readme)
}

/// Words behind a number that make it a quotient of times.
const QUOTIENTS: [&str; 12] = [
    "as long",
    "as fast",
    "faster",
    "slower",
    "longer than",
    "of the time",
    "times the time",
    "the time of",
    "of their time",
    "off their time",
    "of its time",
    "the rays of",
];

/// Numbers that words stand for.
const NUMBERS: [&str; 15] = [
    "twice", "half", "third", "thirds", "quarter", "quarters", "fifth", "sixth", "eighth", "tenth",
    "two", "three", "four", "five", "ten",
];

/// Units of time, as words behind a number.
const UNITS: [&str; 8] = [
    "ns",
    "µs",
    "us",
    "ms",
    "s",
    "seconds",
    "milliseconds",
    "microseconds",
];

/// A time or a quotient that is typed into a page.
#[derive(Debug, PartialEq, Eq)]
struct Typed<'t> {
    /// Its first byte.
    at: usize,
    words: &'t str,
}

/// Times and quotients that are no measurement of the lessons and the engine by `cargo record`: a page,
/// words of the sentence, and what the number is.
const ALLOWED: &[[&str; 3]] = &[
    [
        "README.md",
        "off their time",
        "two builds of one program side by side, which no program can time by itself",
    ],
    [
        "book/src/first-run.md",
        "0.2 s",
        "the whole commands of a first run, measured by hand",
    ],
    [
        "book/src/first-run.md",
        "2 min 52 s",
        "all tests, measured by hand",
    ],
    [
        "book/src/for-lecturers.md",
        "and 180 s to compile",
        "limits that the grader sets",
    ],
    [
        "book/src/left-out.md",
        "",
        "measured scene by scene with and without the work, which `render --explain` does",
    ],
    [
        "book/src/same-pictures-faster.md",
        "",
        "measured by the benchmarks of the engine, beside programs that have to be installed",
    ],
    [
        "book/src/a02-exercises.md",
        "twice as long is the same axis",
        "the length of a vector",
    ],
    [
        "book/src/a05-exercises.md",
        "almost twice as long",
        "the length of a vector",
    ],
    [
        "book/src/a04-intersections.md",
        "seven million times as long as high",
        "the shape of a triangle",
    ],
    [
        "book/src/a06-shadows-reflection.md",
        "times as long as thick",
        "the shape of a triangle",
    ],
    [
        "book/src/a07-transforms.md",
        "six times as long, a little higher",
        "the shape of a body",
    ],
];

/// The times and quotients in pages that are typed by hand.
pub fn typed_by_hand(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for (page, text) in pages(files) {
        for (at, block) in blocks(text) {
            // What a program prints, and code.
            if block.starts_with("```") {
                continue;
            }
            for typed in typed(block) {
                let is_allowed =
                    |[of, words, _]: &&[&str; 3]| *of == page && in_one_line(block).contains(words);
                if !ALLOWED.iter().any(|allowed| is_allowed(&allowed)) {
                    let wrong = format!("\"{}\" is no figure of the recordings", typed.words);
                    complaints.push(complaint(page, text, at + typed.at, &wrong));
                }
            }
        }
    }
    complaints
}

fn in_one_line(block: &str) -> String {
    block.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A word of a block, with its first byte.
struct Word<'t> {
    at: usize,
    text: &'t str,
}

impl Word<'_> {
    /// The word without marks around it.
    fn bare(&self) -> &str {
        let is_mark = |letter: char| !letter.is_alphanumeric() && letter != '×' && letter != '%';
        self.text.trim_matches(is_mark)
    }

    /// Whether it says how many.
    fn is_number(&self) -> bool {
        let bare = self.bare();
        bare.starts_with(|letter: char| letter.is_ascii_digit()) || NUMBERS.contains(&bare)
    }
}

/// The times and quotients in a block without its anchors.
fn typed(block: &str) -> Vec<Typed<'_>> {
    let mut words = Vec::new();
    let mut start = 0;
    while let Some(anchor) = Anchor::first(&block[start..]) {
        words.extend(words_of(block, start, start + anchor.start));
        start += anchor.end;
    }
    words.extend(words_of(block, start, block.len()));
    let mut found = Vec::new();
    for (n, word) in words.iter().enumerate() {
        let next = words.get(n + 1).map_or("", Word::bare);
        if let Some(end) = end_of_a_time(word, next) {
            let last = if end { &words[n + 1] } else { word };
            found.push(Typed {
                at: word.at,
                words: &block[word.at..last.at + last.text.len()],
            });
        } else if word.is_number() {
            // A number belongs to a quotient that follows in a few words.
            let last = &words[(n + 4).min(words.len() - 1)];
            let part = &block[word.at..last.at + last.text.len()];
            // A decimal point ends no sentence.
            let sentence = part[word.text.len()..].split(['.', ';', ':', '|']).next();
            let behind = sentence.unwrap_or_default();
            let one_line = in_one_line(behind);
            if QUOTIENTS.iter().any(|quotient| one_line.contains(quotient)) {
                found.push(Typed {
                    at: word.at,
                    words: &part[..word.text.len() + behind.len()],
                });
            }
        }
    }
    found
}

/// Whether a number is a time: some, and whether its unit is the next word.
fn end_of_a_time(word: &Word, next: &str) -> Option<bool> {
    let bare = word.bare();
    let number = bare.trim_end_matches(|letter: char| !letter.is_ascii_digit());
    let is_formula = word.text.contains('$');
    if is_formula || !bare.starts_with(|letter: char| letter.is_ascii_digit()) {
        return None;
    }
    let unit = &bare[number.len()..];
    if UNITS.contains(&unit) || unit == "×" {
        return Some(false);
    }
    // A full stop or a comma ends the number.
    let is_followed = unit.is_empty() && !word.text.ends_with(['.', ',', ';', ')']);
    (is_followed && UNITS.contains(&next)).then_some(true)
}

/// The words of a part of a block.
fn words_of(block: &str, start: usize, end: usize) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let part = &block[start..end];
    for text in part.split_whitespace() {
        words.push(Word {
            at: start + (text.as_ptr() as usize - part.as_ptr() as usize),
            text,
        });
    }
    words
}

#[test]
fn times_and_quotients_are_found() {
    for words in [
        "takes 12 ms.",
        "takes 3.4µs",
        "1.3 times as long",
        "half of the time",
        "0.76× that",
        "twice as fast",
        "33 % off their time",
        "two and a half times as long",
        "is 87 times slower",
    ] {
        assert!(!typed(words).is_empty(), "{words}");
    }
    for words in [
        "takes {{recorded time a04.x.a/b}} as b",
        "twice the number",
        "12 metres, at most 15 minutes",
        "three lines. The time of a frame",
        "as long as possible",
    ] {
        assert_eq!(typed(words), [], "{words}");
    }
}
