//! Reads OBJ files (Wavefront, *Advanced Visualizer*, appendix B, *Object Files*): corners, normals
//! and faces.

use std::borrow::Cow;

use common::text::{is_unseen, name};

use super::NONE;
use super::ply_numbers::number;
use super::polygons::Polygons;

/// The corners, normals and faces. The error is a clause.
pub fn read(bytes: &[u8]) -> Result<Polygons, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut polygons = Polygons::default();
    // Old programs end lines with CR alone.
    let line_end = if text.contains('\n') { '\n' } else { '\r' };
    let mut lines = (1..).zip(text.split(line_end).map(str::trim_end));
    while let Some((place, line)) = lines.next() {
        let mut words = line.trim_ascii_start();
        if !words.starts_with(['v', 'f']) {
            continue;
        }
        words = without_comment(words);
        let unseen = |letter: &char| is_unseen(*letter) && !letter.is_ascii_whitespace();
        if let Some(letter) = words.chars().find(unseen) {
            let letter = letter.escape_unicode();
            return Err(format!(
                "line {place} has the character {letter}, which nobody sees"
            ));
        }
        let keyword = words.split_ascii_whitespace().next().unwrap_or_default();
        // A name of a material or of a group may end in a backslash, too, so that only lines that
        // are read go on in the next one.
        if !["v", "vn", "f", "v\\", "vn\\", "f\\"].contains(&keyword) {
            continue;
        }
        let mut statement = Cow::Borrowed(words);
        while let Some(before) = statement.trim_ascii_end().strip_suffix('\\') {
            let mut joined = before.to_owned();
            // Appending to the same text keeps the time of many lines linear.
            for (_, next) in lines.by_ref() {
                joined.push(' ');
                let next = without_comment(next).trim_ascii_end();
                if let Some(next) = next.strip_suffix('\\') {
                    joined.push_str(next);
                } else {
                    joined.push_str(next);
                    break;
                }
            }
            statement = Cow::Owned(joined);
        }
        add(&statement, place, &mut polygons).map_err(|mistake| match mistake {
            Mistake::Form(right) => format!("line {place} is \"{}\", but {right}", name(line)),
            Mistake::Corner(number) => polygons.missing_corner(place, &number),
        })?;
    }
    Ok(polygons)
}

/// What is wrong in a line.
enum Mistake {
    /// Its form; this is the right one.
    Form(&'static str),
    /// The number of a corner before the first.
    Corner(String),
}

const CORNER: Mistake = Mistake::Form("a corner is three numbers, as v 0 1 0");
const FACE: Mistake = Mistake::Form("a face is the numbers of three corners or more, as f 1 2 3");

/// Adds a corner, a normal or a face.
fn add(statement: &str, place: usize, polygons: &mut Polygons) -> Result<(), Mistake> {
    let mut words = statement.split_ascii_whitespace();
    match words.next() {
        Some("v") => {
            let corner = vector(words).ok_or(CORNER)?;
            polygons.add_position(corner, format_args!("line {place}"));
        }
        // A normal that cannot be read is as good as none.
        Some("vn") => polygons
            .normals
            .push(vector(words).unwrap_or([f64::NAN; 3])),
        _ => {
            for word in words {
                let corner = corner(word, polygons)?;
                polygons.corners.push(corner);
            }
            polygons.end_face(place);
        }
    }
    Ok(())
}

/// The first three numbers; the weight or the colour behind them is ignored.
fn vector<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<[f64; 3]> {
    let mut numbers = [0.0; 3];
    for coordinate in &mut numbers {
        *coordinate = number(words.next()?)?;
    }
    Some(numbers)
}

/// The indices of a corner and of its normal, as in `1`, `1/2`, `1//3` and `1/2/3`. Nothing
/// behind a slash means none, as in `1//`.
fn corner(word: &str, polygons: &Polygons) -> Result<[u32; 2], Mistake> {
    let mut parts = word.split('/');
    let name = parts.next().unwrap_or_default();
    let number = name.parse().map_err(|_| FACE)?;
    let missing = || Mistake::Corner(name.to_owned());
    let corner = index(number, polygons.positions.len()).ok_or_else(missing)?;
    let normal = match parts.nth(1) {
        None | Some("") => NONE,
        Some(name) => {
            let number = name.parse().map_err(|_| FACE)?;
            // One less than none, so that it counts as a normal that the file lacks.
            index(number, polygons.normals.len()).unwrap_or(NONE - 1)
        }
    };
    Ok([corner, normal])
}

/// An index from 0, by a number from 1, or by one below 0 that counts back from the last line.
fn index(number: i64, lines: usize) -> Option<u32> {
    let index = if number < 0 {
        number.checked_add(lines as i64)?
    } else {
        number - 1
    };
    index.try_into().ok().filter(|index| *index < NONE - 1)
}

/// The line before its comment, which begins with `#`, but not behind a point as in `1.#IND`.
fn without_comment(line: &str) -> &str {
    let mut marks = line.match_indices('#').map(|(at, _)| at);
    let comment = marks.find(|at| !line[..*at].ends_with('.'));
    &line[..comment.unwrap_or(line.len())]
}
