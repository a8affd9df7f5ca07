//! Texts that are right, broken, and random, compared with the solution.

use a04_intersections::registry::{Content, ShapeKind};

use crate::prelude::*;

yours! { read_obj }

type Code = fn(&str) -> Result<Vec<Triangle>, String>;

/// A house whose gables have five corners.
const HOUSE: &str = "\
v -1 0 1\nv 1 0 1\nv 1 1 1\nv 0 1.8 1\nv -1 1 1
v -1 0 -1.5\nv 1 0 -1.5\nv 1 1 -1.5\nv 0 1.8 -1.5\nv -1 1 -1.5
f 1 2 3 4 5\nf 10 9 8 7 6\nf 2 7 8 3\nf 6 1 5 10\nf 3 8 9 4\nf 4 9 10 5
";

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|read_obj: &Code, settings| {
            let house = read_obj(HOUSE).into_iter().flatten();
            let house = house.map(|triangle| Box::new(triangle) as Shape);
            let eye = Eye {
                from: [4.0, 3.0, 5.0],
                to: [0.0, 0.8, -0.2],
            };
            eye.show_shapes(house, settings)
        }),
        ..Exercise::asked(|read_obj: &Code, text: String| answer(read_obj(&text)))
    }
}

/// The corners of the triangles, or the beginning of the error.
fn answer(read: Result<Vec<Triangle>, String>) -> Answer {
    Answer::words(match read {
        Ok(read) if read.is_empty() => "no triangles, and no error".to_owned(),
        Ok(read) => read.iter().map(corners).collect::<Vec<_>>().join("; "),
        Err(error) => error.split(':').take(1).collect(),
    })
}

/// The corners of a triangle in their order around it, with which of them it may begin.
fn corners(triangle: &Triangle) -> String {
    let Content::Values(values) = triangle.content() else {
        return String::new();
    };
    let corners = values[0].1.chunks(3);
    let mut corners: Vec<_> = corners.map(|corner| format!("{corner:?}")).collect();
    let first = (0..corners.len()).min_by_key(|index| &corners[*index]);
    corners.rotate_left(first.unwrap_or_default());
    corners.join("-")
}
