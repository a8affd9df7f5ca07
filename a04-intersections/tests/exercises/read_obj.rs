//! Texts that are right, broken, and random, compared with the solution.

use a04_intersections::kinds::{Content, ShapeKind};

use crate::prelude::*;

yours! { read_obj }

type Code = fn(&str) -> Result<Vec<Triangle>, String>;

/// Lines after three corners.
const LINES: [&str; 19] = [
    "",
    "f 1 2 3",
    "  f   1 2\t3  ",
    "# f 1 1 1\n\nf 1/7 2/8 3/9",
    "vt 0 0\nf 1//1 2//1 3//1",
    "f 1/1/1 -2/1/1 3/1/1\nv 9 9 9",
    "v 1 2",
    "v 1 2 three",
    "f 1 2",
    "f 1 2 4",
    "f 0 1 2",
    "f -4 -2 -1",
    "v 4 4 0\nf 1 2 -6",
    "f 1 2 x",
    "f 1 1 2",
    "\n# x\nf 1 2 9",
    "vn 1 2 3\nf -3 -2 -1",
    "vt 1 2 3\nf -3 -2 -1",
    "f 1 2 3\r",
];

/// A house whose gables have five corners.
const HOUSE: &str = "\
v -1 0 1\nv 1 0 1\nv 1 1 1\nv 0 1.8 1\nv -1 1 1
v -1 0 -1.5\nv 1 0 -1.5\nv 1 1 -1.5\nv 0 1.8 -1.5\nv -1 1 -1.5
f 1 2 3 4 5\nf 10 9 8 7 6\nf 2 7 8 3\nf 6 1 5 10\nf 3 8 9 4\nf 4 9 10 5
";

pub fn exercise() -> Exercise<Code> {
    let texts = Questions {
        words: "the text {}",
        simple: LINES
            .map(|line| format!("v 0 0 0\nv 4 0 0\nv 0 5e-1 -3\n{line}\n"))
            .to_vec(),
        others: random(mesh),
        answer: |read_obj: &Code, text: String| answer(read_obj(&text)),
    };
    Exercise {
        questions: texts.into(),
        picture: Picture::own(|read_obj: &Code, settings| {
            let house = read_obj(HOUSE).into_iter().flatten();
            let house = house.map(|triangle| Box::new(triangle) as Shape);
            let eye = Eye {
                from: [4.0, 3.0, 5.0],
                to: [0.0, 0.8, -0.2],
            };
            eye.show_shapes(house, settings)
        }),
        ..Exercise::default()
    }
}

/// The corners of the triangles, or the beginning of the error.
fn answer(read: Result<Vec<Triangle>, String>) -> Answer {
    Answer::words(match read {
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

/// A random face among random corners, which are named in all ways.
fn mesh(random: &mut Random) -> String {
    let count = 6 + random.below(7);
    let corners = (0..count).map(|_| random.triple(9.0).map(|x| x.to_string()).join(" "));
    let corners: String = corners.map(|xyz| ["v ", &xyz, "\n"].concat()).collect();
    let (first, sides) = (random.below(count), 3 + random.below(4));
    let names = (first..first + sides).map(|corner| match (corner % count, random.below(3)) {
        (corner, 0) => format!(" {}", i64::from(corner) - i64::from(count)),
        (corner, 1) => format!(" {}/7/8", corner + 1),
        (corner, _) => format!(" {}", corner + 1),
    });
    format!("{corners}f{}\nv 0 0 0\n", names.collect::<String>())
}
