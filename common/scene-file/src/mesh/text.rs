//! Lines and numbers of text files, whatever system wrote them.

/// The lines of a text, which end with LF, CR LF or CR.
pub fn lines(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.split('\n');
    lines.flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'))
}

/// A number. Windows writes NaN and infinity as `-nan(ind)` or `1.#QNAN`: they are as good as NaN.
pub fn number(word: &str) -> Option<f64> {
    let is_of_windows = word.contains("nan(") || word.contains(".#");
    word.parse().ok().or(is_of_windows.then_some(f64::NAN))
}

/// The line before its comment, which begins with `#`, but not behind a point as in `1.#IND`.
pub fn without_comment(line: &str) -> &str {
    let mut marks = line.match_indices('#').map(|(at, _)| at);
    let comment = marks.find(|at| !line[..*at].ends_with('.'));
    &line[..comment.unwrap_or(line.len())]
}
