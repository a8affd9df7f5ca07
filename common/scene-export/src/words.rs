//! The words for a table, of a shape or a light, and its values.

use glam::DVec3;
use scene_file::TABLES;

use crate::phrases::number;
use crate::{Phrases, Values};

/// The smallest distance between two of a triangle's unit normals that is written for a language
/// in which a triangle of equal normals is flat.
///
/// POV-Ray takes a `smooth_triangle` for a flat one if the squared distances of its second and
/// third normal from the first are at most its `EPSILON` of 1e-10, so if both distances are at
/// most 1e-5. The third normal is moved by at most twice this distance, and the cosine in Lambert's
/// law changes by as much at most, which is 1/160 of a step of a channel of 8 bits. A highlight with
/// the exponent n changes by at most 2 sqrt(n / e) times as much: a quarter of a step for n = 1000.
const DISTINCT: f64 = 1.2e-5;

/// The words for a table: by the phrase `any` for all tables of its kind, or by the one of its name.
pub fn of_table(
    language: Phrases,
    any: &str,
    key: &str,
    values: &Values,
) -> Result<String, String> {
    if let Ok(any) = language.find(any, "", &[]) {
        let any = any.replace("[key]", key);
        return Ok(any.replace("[values]", &lines(key, values)));
    }
    let vector = |name| match value(values, name) {
        &[x, y, z] => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    };
    let smooth = value(values, "normals");
    let phrase = if smooth.is_empty() {
        key.to_owned()
    } else {
        format!("smooth {key}")
    };
    let (mut names, mut numbers) = (String::new(), Vec::new());
    for (name, list) in values {
        names = names + name + " ";
        numbers.push(&**list);
    }
    // What a language may need besides the values: the height of a plane, a point on the axis of a spot
    // light, a place far away from which a directional one shines, and corners one by one.
    let height = [vector("point").dot(vector("normal"))];
    let target = (vector("position") + vector("direction")).to_array();
    let far = (vector("direction") * -1e4).to_array();
    let distinct_w = distinct_third(smooth);
    names += "height target far a b c u v w distinct_w";
    numbers.extend([&height[..], &target, &far]);
    let corners = value(values, "corners");
    numbers.extend(corners.chunks(3).chain(smooth.chunks(3)));
    numbers.extend(distinct_w.as_ref().map(<[f64; 3]>::as_slice));
    language.find(&phrase, &names, &numbers)
}

/// The third of a triangle's unit normals, moved to the distance [`DISTINCT`] from the first one if
/// both others are nearer to it; none of a flat triangle.
fn distinct_third(normals: &[f64]) -> Option<[f64; 3]> {
    let &[a, b, c, d, e, f, g, h, i] = normals else {
        return None;
    };
    let first = DVec3::new(a, b, c);
    let [second, third] = [[d, e, f], [g, h, i]].map(DVec3::from_array);
    let is_near = |normal: DVec3| normal.distance(first) < DISTINCT;
    let distinct = if is_near(second) && is_near(third) {
        first + DISTINCT * first.any_orthonormal_vector()
    } else {
        third
    };
    Some(distinct.to_array())
}

/// The numbers of a key; empty if it has none.
pub fn value<'v>(values: &'v Values, key: &str) -> &'v [f64] {
    let found = values.iter().find(|(own, _)| *own == key);
    found.map_or(&[], |(_, numbers)| numbers)
}

/// The lines of a scene file with the values of a table.
pub fn lines(key: &str, values: &Values) -> String {
    let lines = values.iter();
    lines
        .map(|(name, numbers)| line(key, name, numbers))
        .collect()
}

/// The line of a scene file with a value, in the form that its key has.
fn line(key: &str, name: &str, numbers: &[f64]) -> String {
    let list = |numbers: &[f64]| {
        let numbers: Vec<_> = numbers.iter().map(|n| number(*n)).collect();
        numbers.join(", ")
    };
    let kind = TABLES.iter().find(|kind| kind.name == key);
    let lengths = kind.and_then(|kind| kind.key(name)?.form.lengths());
    let value = match (lengths, numbers) {
        (Some([_, columns]), _) => {
            let rows: Vec<_> = numbers
                .chunks(*columns)
                .map(|row| format!("[{}]", list(row)))
                .collect();
            format!("[{}]", rows.join(", "))
        }
        (_, [one]) => number(*one),
        (_, many) => format!("[{}]", list(many)),
    };
    format!("{name} = {value}\n")
}
