//! A mesh of triangles from the text of an OBJ file.

use std::str::SplitWhitespace;

use crate::prelude::*;

/// The triangles of an OBJ file, or an error that begins with the number of the
/// line, as in `line 7: there is no corner 9`.
pub fn read_obj(text: &str) -> Result<Vec<Triangle>, String> {
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    for (number, line) in (1..).zip(text.lines()) {
        let mut words = line.split_whitespace();
        let read = match words.next() {
            Some("v") => corner(words).map(|corner| corners.push(corner)),
            Some("f") => face(words, &corners).map(|face| triangles.extend(face)),
            _ => Ok(()),
        };
        read.map_err(|reason| {
            missing!("the number of the line", reason, {
                format!("line {number}: {reason}")
            })
        })?;
    }
    Ok(triangles)
}

/// The point of three coordinates, `Point3::new(x, y, z)`.
fn corner(words: SplitWhitespace) -> Result<Point3, String> {
    missing!("the coordinates of a corner", Ok(Point3::ORIGIN), {
        let numbers = words.take(3).map(str::parse).collect::<Result<Vec<_>, _>>();
        match numbers.as_deref() {
            Ok(&[x, y, z]) => Ok(Point3::new(x, y, z)),
            _ => Err("a corner has three coordinates".to_owned()),
        }
    })
}

/// The corner that a word of a face names: `7`, `7/1/2` or `-1`, by the number before the
/// first slash.
fn named(word: &str, corners: &[Point3]) -> Result<Point3, String> {
    missing!("the corner of this name", Ok(Point3::ORIGIN), {
        let name = word.split('/').next().unwrap_or_default();
        let index = match name.parse::<isize>() {
            Ok(back) if back < 0 => corners.len().checked_add_signed(back),
            Ok(number) => number.unsigned_abs().checked_sub(1),
            Err(_) => None,
        };
        let corner = index.and_then(|index| corners.get(index).copied());
        corner.ok_or_else(|| format!("there is no corner {name}"))
    })
}

/// The triangles of a face of three or more corners: all of them meet in the first.
/// `Triangle::new(a, b, c)` is an error if the corners lie on a line.
fn face(words: SplitWhitespace, corners: &[Point3]) -> Result<Vec<Triangle>, String> {
    missing!("the triangles of a face", Ok(Vec::new()), {
        let around = words.map(|word| named(word, corners));
        match around.collect::<Result<Vec<_>, _>>()?.as_slice() {
            [first, rest @ ..] if rest.len() > 1 => {
                let triangles = rest.windows(2).map(|b| Triangle::new(*first, b[0], b[1]));
                let triangles: Result<_, _> = triangles.collect();
                triangles.map_err(|error| error.to_string())
            }
            _ => Err("a face has three corners or more".to_owned()),
        }
    })
}

testing::examples! {
    let corners = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 5e-1 -3\n";
    let read = |line: &str| read_obj(&format!("{corners}{line}\n"));
    // A ray from above meets the triangle at the height 0.25.
    let hit = |line: &str| {
        let triangles = read(line).unwrap();
        hit_from([1.0, 3.0, -1.5], [0.0, -1.0, 0.0], triangles.first()?)
            .map(|hit| [hit.t, hit.normal.y()])
    };
    let upwards = 6.0 / 37_f64.sqrt();
    assert_close!(hit("f 1 2 4"), Some([2.75, upwards]));
    assert_close!(hit("f 1/7 2/8 -1"), Some([2.75, upwards]));
    assert_close!(read("f 1 2 3 4").map_or(0, |triangles| triangles.len()), 2, "triangles of four corners");
    assert!(read("f 1 2 9").is_err_and(|error| error.starts_with("line 5: ")), "an error in line 5");
}
