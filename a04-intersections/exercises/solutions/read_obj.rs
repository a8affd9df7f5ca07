//! A mesh of triangles from the text of an OBJ file.

use std::str::SplitWhitespace;

use a02_math::Point3;
use a04_intersections::Triangle;

/// The triangles of an OBJ file, or an error that begins with the number of the
/// line, as in `line 7: there is no corner 9`.
///
/// Lines begin with `v`, three coordinates of a corner, or with `f`, the numbers
/// of the corners of a face. Lines that begin with anything else are passed over.
pub fn read_obj(text: &str) -> Result<Vec<Triangle>, String> {
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    for (number, line) in (1..).zip(text.lines()) {
        let mut words = line.split_whitespace();
        let read = match words.next() {
            Some("v") => corner(words).map(|corner| corners.push(corner)),
            Some("f") => face(words, &corners).map(|face| triangles.extend(face)),
            _ => Ok(()),
        };
        read.map_err(|reason| format!("line {number}: {reason}"))?;
    }
    Ok(triangles)
}

/// The point of three coordinates.
fn corner(words: SplitWhitespace) -> Result<Point3, String> {
    let number = |word: &str| {
        let number = word.parse::<f64>();
        number.map_err(|_| format!("\"{word}\" is no number"))
    };
    let coordinates = words.take(3).map(number).collect::<Result<Vec<_>, _>>()?;
    let &[x, y, z] = coordinates.as_slice() else {
        return Err("a corner has three coordinates".to_owned());
    };
    Ok(Point3::new(x, y, z))
}

/// The corner that a word of a face names: `7`, `7/1/2` or `-1`. Only the number
/// before the first slash counts: from the first corner, 1, or, if it is
/// negative, back from the last corner read.
fn named(word: &str, corners: &[Point3]) -> Result<Point3, String> {
    let name = word.split('/').next().unwrap_or_default();
    let number: isize = name
        .parse()
        .map_err(|_| format!("\"{word}\" is no number of a corner"))?;
    let index = if number < 0 {
        corners.len().checked_add_signed(number)
    } else {
        number.unsigned_abs().checked_sub(1)
    };
    index
        .and_then(|index| corners.get(index).copied())
        .ok_or_else(|| format!("there is no corner {number}"))
}

/// The triangles of a face of three or more corners: all of them meet in the
/// first.
fn face(words: SplitWhitespace, corners: &[Point3]) -> Result<Vec<Triangle>, String> {
    let around = words
        .map(|word| named(word, corners))
        .collect::<Result<Vec<_>, _>>()?;
    let [first, rest @ ..] = around.as_slice() else {
        return Err("a face has three corners or more".to_owned());
    };
    if rest.len() < 2 {
        return Err("a face has three corners or more".to_owned());
    }
    let triangle = |pair: &[Point3]| Triangle::new(*first, pair[0], pair[1]);
    rest.windows(2)
        .map(|pair| triangle(pair).map_err(|error| error.to_string()))
        .collect()
}
