//! `Phrases`: a language for scenes: a file with a phrase for each kind of item, in a line.
//!
//! `[center]` in a phrase stands for the numbers of that name, and `[center.0]` for the first.

/// The language of scene files. The numbers that are read again have the same bits.
pub const TOML: Phrases = Phrases(include_str!("languages/toml.txt"), ", ");
/// The language of POV-Ray 3.7.
pub const POV_RAY: Phrases = Phrases(include_str!("languages/povray.txt"), ", ");

/// The phrases of a language, and the text between two numbers.
#[derive(Clone, Copy, Debug)]
pub struct Phrases(pub &'static str, pub &'static str);

impl Phrases {
    /// The phrase of this name, with numbers for these names, which have spaces between them. It
    /// is an error if the language has no such phrase.
    pub(crate) fn find(
        self,
        phrase: &str,
        names: &str,
        values: &[&[f64]],
    ) -> Result<String, String> {
        let mut lines = self.0.lines();
        let found = lines.find_map(|line| line.strip_prefix(phrase)?.strip_prefix(':'));
        let found = found.ok_or_else(|| format!("the language has no words for a {phrase}"))?;
        let mut text = found.trim_start_matches(' ').replace("\\n", "\n");
        for (name, numbers) in names.split(' ').zip(values) {
            let numbers: Vec<_> = numbers.iter().map(|n| number(*n)).collect();
            text = text.replace(&format!("[{name}]"), &numbers.join(self.1));
            text = text.replace(&format!("[{name}.0]"), &numbers[0]);
        }
        Ok(text)
    }

    /// The phrase of this name; empty if the language has none.
    pub(crate) fn word(self, phrase: &str) -> String {
        self.find(phrase, "", &[]).unwrap_or_default()
    }
}

/// A number in the shortest form that keeps its bits: integers have no sign of zero.
pub(crate) fn number(number: f64) -> String {
    let text = format!("{number:?}");
    match text.strip_suffix(".0") {
        Some("-0") | None => text,
        Some(short) => short.to_owned(),
    }
}
