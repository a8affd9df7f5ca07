//! What the name of a file or folder in a hand-in says: which exercise, who, and when.
//!
//! Learning platforms and browsers add names, numbers and times to the names that students give.

/// A time in a name: its digits, from the year on.
pub type Time = String;

/// A name without the time in it, and the time: 14, 12 or 8 digits; or year, month and
/// day, and so on to the second.
pub fn split_time(name: &str) -> (String, Option<Time>) {
    let words = words(name);
    for first in 0..words.len() {
        if let Some((count, time)) = time_in(&words[first..]) {
            let (start, last) = (words[first].0, words[first + count - 1]);
            let is_mark = |c: char| !c.is_alphanumeric() && !"()[]".contains(c);
            let before = name[..start].trim_end_matches(is_mark);
            let behind = &name[last.0 + last.1.len()..];
            let behind = match before {
                "" => behind.trim_start_matches(is_mark),
                _ => behind,
            };
            return ([before, behind].concat(), Some(time));
        }
    }
    (name.to_owned(), None)
}

/// The words of letters and digits in a name, and where they begin.
fn words(name: &str) -> Vec<(usize, &str)> {
    let mut words = Vec::new();
    let mut at = 0;
    for word in name.split(|c: char| !c.is_alphanumeric()) {
        if !word.is_empty() {
            words.push((at, word));
        }
        at = at
            + word.len()
            + name[at + word.len()..]
                .chars()
                .next()
                .map_or(0, char::len_utf8);
    }
    words
}

/// How many of the first words are a time, and its digits.
fn time_in(words: &[(usize, &str)]) -> Option<(usize, Time)> {
    let word = |n: usize| words.get(n).map_or("", |(_, word)| *word);
    let is_digits = |n: usize, count: usize| word(n).len() == count && is_number(word(n));
    if [8, 12, 14].iter().any(|count| is_digits(0, *count)) && word(0).starts_with("20") {
        return Some((1, word(0).to_owned()));
    }
    let is_year = is_digits(0, 4) && word(0).starts_with("20");
    if !(is_year && is_digits(1, 2) && is_digits(2, 2)) {
        return None;
    }
    let mut count = 3;
    while count < 6 && is_digits(count, 2) {
        count += 1;
    }
    Some((count, (0..count).map(word).collect()))
}

fn is_number(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_digit())
}

/// Whether a name says that something is late.
pub fn is_late(name: &str) -> bool {
    words(name)
        .iter()
        .any(|(_, word)| ["late", "LATE", "Late"].contains(word))
}

/// The name without time, extension, and the number that a further file of a name gets, as in
/// `sphere-1`, `sphere (1)` and `sphere(1)`; and its extension.
pub fn stem(name: &str) -> (String, String) {
    let (name, _) = split_time(name);
    let (stem, extension) = name.rsplit_once('.').unwrap_or((&name, ""));
    let mut own = stem;
    if let Some((name, number)) = stem.rsplit_once(['-', '('])
        && is_number(number.trim_end_matches(')'))
    {
        own = name.trim_end();
    }
    // Some systems add an extension to `sphere.rs`.
    let own = own.strip_suffix(".rs").unwrap_or(own);
    (own.to_owned(), extension.to_lowercase())
}

/// Who has handed in a file whose stem ends with the name of an exercise: the words before it,
/// without a number of the file. Empty if there are none.
pub fn person<'a>(stem: &'a str, exercise: &str) -> Option<&'a str> {
    let before = stem.get(..stem.len().checked_sub(exercise.len())?)?;
    if !stem[before.len()..].eq_ignore_ascii_case(exercise) {
        return None;
    }
    let person = before.trim_end_matches(|c: char| !c.is_alphanumeric());
    // `xray` is no `ray`.
    if person.len() == before.len() && !person.is_empty() {
        return None;
    }
    match person.rsplit_once(['_', '-', ' ']) {
        Some((name, number))
            if is_number(number) && name.contains(|c: char| c.is_ascii_digit()) =>
        {
            Some(name)
        }
        _ => Some(person),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_in_names_are_found_and_compared() {
        for (name, without, time) in [
            ("20261001123045_ray.rs", "ray.rs", "20261001123045"),
            (
                "W 4_ada_attempt_2026-10-01-12-30-45_ray.rs",
                "W 4_ada_attempt_ray.rs",
                "20261001123045",
            ),
            ("Bob - 2026-11-04 09-01", "Bob", "202611040901"),
            ("Müller_2711", "Müller_2711", ""),
            ("mayor 5 rays.rs", "mayor 5 rays.rs", ""),
        ] {
            let (found, at) = split_time(name);
            assert_eq!(
                (&*found, &*at.unwrap_or_default()),
                (without, time),
                "{name}"
            );
        }
    }

    #[test]
    fn names_and_numbers_around_an_exercise_are_no_part_of_it() {
        for name in ["ray-1.rs", "ray (2).RS", "20261001123045_ray.rs"] {
            assert_eq!(stem(name), ("ray".to_owned(), "rs".to_owned()), "{name}");
        }
        for (stem, who) in [
            ("ray", Some("")),
            ("byronada_11_501_ray", Some("byronada_11")),
            ("Ada Lovelace - Ray", Some("Ada Lovelace")),
            ("xray", None),
        ] {
            assert_eq!(person(stem, "ray"), who, "{stem}");
        }
        assert!(is_late("colebob_LATE_12") && !is_late("plate"));
    }
}
