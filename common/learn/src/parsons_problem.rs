//! A Parsons problem: the lines of a solution in shuffled order, as the first hint of an exercise of
//! the core path. (Parsons and Haden, Parson's Programming Puzzles, 2006)

use common::fnv1a;

use crate::exercise::Exercise;
use crate::files;

/// A part of the lesson, or of a right solution in a check.
struct Part {
    exercise: &'static str,
    file: &'static str,
    /// The beginning of the line that opens the part. Of a loop, it belongs to the part.
    opening: &'static str,
}

const fn part(exercise: &'static str, file: &'static str, opening: &'static str) -> Part {
    Part {
        exercise,
        file,
        opening,
    }
}

/// The parts in the order in which the hint shows them. Where the lesson's code is of another form
/// than the student's, a right solution of the check stands here.
#[rustfmt::skip]
const PARTS: [Part; 37] = [
    part("set_pixel", "common/src/image.rs", "fn set("),
    part("set_pixel", "common/src/image.rs", "fn index("),
    part("diagonal", "a01-image-display/tests/exercises/diagonal.rs", "fn over_one_side("),
    part("products", "a02-math/tests/exercises/products.rs", "fn dot_of_coordinates("),
    part("products", "a02-math/tests/exercises/products.rs", "fn cross_of_coordinates("),
    part("angle", "a02-math/src/vector3.rs", "fn angle("),
    part("reflected", "a02-math/src/vector3.rs", "fn reflected_on("),
    part("ray", "a03-rays-cameras/src/ray.rs", "fn at("),
    part("ray", "a03-rays-cameras/src/ray.rs", "fn t_of("),
    part("perspective", "a03-rays-cameras/src/camera.rs", "fn new("),
    part("perspective", "a03-rays-cameras/src/perspective_camera.rs", "fn ray_for("),
    part("pinhole", "a03-rays-cameras/src/pinhole_camera.rs", "fn generate_ray("),
    part("stripe", "a03-rays-cameras/src/striped_sky.rs", "fn stripe("),
    part("picture", "a03-rays-cameras/src/render.rs", "for place in sampler.places("),
    part("plane", "a04-intersections/src/plane.rs", "fn hit("),
    part("sphere", "a04-intersections/src/sphere.rs", "fn hit("),
    part("axis_aligned_box", "a04-intersections/src/axis_aligned_box.rs", "fn hit("),
    part("triangle", "a04-intersections/tests/exercises/triangle.rs", "Ok(own(move |ray: &Ray"),
    part("nearest", "a04-intersections/src/world.rs", "fn hit("),
    part("nearest", "a04-intersections/src/world.rs", "fn facing("),
    part("orthographic", "a03-rays-cameras/src/orthographic_camera.rs", "fn ray_for("),
    part("orthographic", "a03-rays-cameras/src/orthographic_camera.rs", "fn from_middle("),
    part("lambert", "a05-lighting/src/lambert.rs", "fn color_for("),
    part("lambert", "a05-lighting/src/lambert.rs", "fn diffuse_term("),
    part("phong", "a05-lighting/src/phong.rs", "fn color_for("),
    part("phong", "a05-lighting/src/phong.rs", "fn highlight("),
    part("point_light", "a05-lighting/src/point_light.rs", "fn illumination("),
    part("directional_light", "a05-lighting/tests/exercises/directional_light.rs", "fn reversed("),
    part("spot_light", "a05-lighting/src/spot_light.rs", "fn illumination("),
    part("shadowed", "a06-shadows-reflection/tests/exercises/shadowed.rs", "Arc::new(move |world"),
    part("leaving", "a06-shadows-reflection/src/secondary_ray.rs", "fn secondary_ray("),
    part("leaving", "a06-shadows-reflection/src/secondary_ray.rs", "fn rounding_error("),
    part("mirror", "a06-shadows-reflection/src/recursive_tracer.rs", "fn trace("),
    part("chain", "a07-transforms/tests/exercises/chain.rs", "fn product("),
    part("under_transform", "a07-transforms/src/transform.rs", "fn normal_from_object("),
    part("node", "a07-transforms/src/node.rs", "fn hit("),
    part("disc", "a07-transforms/src/disc.rs", "fn hit("),
];

/// The hint of an exercise; none of an exercise beyond the core path, and where the workbook lacks
/// the code.
pub fn hint(exercise: &str) -> Option<String> {
    let mut blocks = Vec::new();
    for part in PARTS.iter().filter(|part| part.exercise == exercise) {
        let pieces = pieces(&body(part)?);
        if !pieces.is_empty() {
            let lines = shuffled(exercise, &pieces).join("\n");
            blocks.push(format!("\n```text\n{lines}\n```\n"));
        }
    }
    if blocks.is_empty() {
        return None;
    }
    let blocks = blocks.concat();
    Some(format!(
        "\nHint: the lines in another order\n\nThese are lines of a solution in shuffled order, without \
         indents,\ncomments and brackets that stand alone. Which line needs the result of which?\n{blocks}"
    ))
}

/// The lines of a part, which a bracket opens and another one at the same depth closes.
fn body(part: &Part) -> Option<String> {
    let text = files::read(part.file).ok()?;
    let (_, rest) = text.split_once(part.opening)?;
    let (header, rest) = rest.split_once("{\n")?;
    let mut depth = 1;
    let end = rest.find(|letter| {
        depth += match letter {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        depth == 0
    })?;
    let body = &rest[..end];
    if part.opening.starts_with("for ") {
        return Some([part.opening, header, "{\n", body].concat());
    }
    Some(body.to_owned())
}

/// The pieces of the code in their right order: its statements and the beginnings of its blocks, or,
/// of a single statement, the terms of its expression. None if there is nothing to put in order.
fn pieces(body: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    for line in body.lines().map(str::trim) {
        if line.starts_with("//") {
            continue;
        }
        if let Some(before) = pieces.last_mut()
            && (line.starts_with('.') || is_unfinished(before))
        {
            let is_member = line.starts_with('.') && !line.starts_with("..");
            let has_space = !is_member && !line.starts_with(')') && !before.ends_with('(');
            *before += if has_space { " " } else { "" };
            *before += line;
            *before = before.replace(",)", ")").replace(", }", " }");
        } else if !line.chars().all(|letter| "(){}[];,".contains(letter)) {
            pieces.push(line.to_owned());
        }
    }
    if let [line] = &*pieces {
        pieces = terms(line);
    }
    if pieces.len() < 2 {
        pieces.clear();
    }
    pieces
}

/// Whether a statement goes on in the next line, because of its brackets. A block is no part of the
/// statement that begins it.
fn is_unfinished(statement: &str) -> bool {
    let count = |bracket| statement.matches(bracket).count();
    let is_open = count('(') > count(')') || count('{') > count('}');
    statement.ends_with('=') || is_open && !begins_block(statement)
}

/// Whether a block begins at the end of a statement, and not the fields of a structure, whose name
/// has a capital letter.
fn begins_block(statement: &str) -> bool {
    let Some(before) = statement.strip_suffix(" {") else {
        return false;
    };
    let name = before.rsplit([' ', '(', ':']).next().unwrap_or_default();
    let has_condition = ["if ", "} else if "]
        .iter()
        .any(|word| statement.starts_with(word));
    has_condition || !name.starts_with(char::is_uppercase)
}

/// An expression, cut before the operators outside of inner brackets. An expression in brackets is
/// cut inside of them, unless they hold several arguments.
fn terms(line: &str) -> Vec<String> {
    let mut depths = Vec::new();
    let mut depth = 0;
    for letter in line.chars() {
        depth += match letter {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depths.push(depth);
    }
    let letters: Vec<char> = line.chars().collect();
    let is_operator = |at: usize| matches!(letters[at..], [' ', '+' | '-' | '*' | '/', ' ', ..]);
    let least = (0..letters.len())
        .filter(|at| is_operator(*at))
        .map(|at| depths[at])
        .min();
    let has_arguments =
        (0..letters.len()).any(|at| letters[at] == ',' && Some(depths[at]) == least);
    if has_arguments {
        return vec![line.to_owned()];
    }
    let mut terms = vec![String::new()];
    for (at, letter) in letters.iter().enumerate() {
        if is_operator(at) && Some(depths[at]) == least {
            terms.push(String::new());
        } else if let Some(term) = terms.last_mut() {
            term.push(*letter);
        }
    }
    terms
}

/// The pieces in another order, which is always the same for an exercise.
fn shuffled(exercise: &str, pieces: &[String]) -> Vec<String> {
    let mut shuffled = pieces.to_vec();
    shuffled.sort_by_cached_key(|piece| fnv1a([exercise, piece].concat().as_bytes()));
    if shuffled == pieces {
        shuffled.rotate_left(1);
    }
    shuffled
}

/// The first hint of an exercise, if it has lines to put in order, and then the others.
pub fn add_first_hint(exercise: &mut Exercise) {
    if let Some(hint) = hint(exercise.name) {
        exercise.hints.insert(0, hint);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::exercise;

    #[test]
    fn each_core_exercise_has_its_lines_in_another_order() {
        // A handout lacks the stages above.
        let is_here = |part: &&Part| {
            let folder = part.file.split('/').next().unwrap_or_default();
            files::shortest(folder).is_dir()
        };
        for part in PARTS.iter().filter(is_here) {
            let name = part.exercise;
            let right = pieces(&body(part).unwrap_or_else(|| panic!("{name}: {}", part.opening)));
            let shuffled = shuffled(name, &right);
            assert!(right.len() > 1, "{name}: {right:?}");
            assert_ne!(shuffled, right, "{name}");
            assert!(
                shuffled.iter().all(|line| line.trim() == line),
                "{name}: {shuffled:?}"
            );
            let [mut left, mut right] = [shuffled, right];
            left.sort();
            right.sort();
            assert_eq!(left, right, "{name}");
        }
        let course = exercise::read_all().unwrap();
        let core: BTreeSet<_> = course
            .iter()
            .filter(|e| e.is_core)
            .map(|e| e.name)
            .collect();
        let with_lines: BTreeSet<_> = PARTS
            .iter()
            .filter(is_here)
            .map(|part| part.exercise)
            .collect();
        assert_eq!(with_lines, core);
        for e in course {
            let first = &e.hints[0];
            assert_eq!(
                first.contains("shuffled order"),
                e.is_core,
                "{}: {first}",
                e.name
            );
            assert!(e.hints.len() > usize::from(e.is_core), "{}", e.name);
        }
    }

    #[test]
    fn a_line_alone_is_cut_before_its_operators() {
        assert_eq!(
            pieces("    a.b() * (c - 1.0) + d\n"),
            ["a.b()", "* (c - 1.0)", "+ d"]
        );
        assert_eq!(
            pieces("Self(a * (b - c) - d)"),
            ["Self(a", "* (b - c)", "- d)"]
        );
        assert!(pieces("    f(a * b, c)\n").is_empty());
        assert!(pieces("// Words.\n-a\n").is_empty());
    }

    #[test]
    fn lines_are_whole_statements_without_indents() {
        let code =
            "let a =\n    b;\n// Why.\nlet c = a\n    .d();\nif c {\n    return;\n}\n(a, c)\n";
        let pieces = pieces(code);
        assert_eq!(
            pieces,
            [
                "let a = b;",
                "let c = a.d();",
                "if c {",
                "return;",
                "(a, c)"
            ]
        );
        let brackets = "f(\n    a,\n    b,\n);\nif a == B {\n    c(|d| {\n        e\n    });\n}\nSome(A {\n    b,\n    ..c\n})";
        let lines = [
            "f(a, b);",
            "if a == B {",
            "c(|d| {",
            "e",
            "Some(A { b, ..c })",
        ];
        assert_eq!(super::pieces(brackets), lines);
        // An order that the hashes find right is changed, too.
        for name in ["a", "b", "c", "d", "e", "f", "g", "h"] {
            assert_ne!(shuffled(name, &pieces[..2]), pieces[..2]);
        }
    }
}
