//! The text of a shape.

use engine::Transform;
use glam::{DMat4, DVec3};

use super::WrittenShape;
use crate::phrases::number;
use crate::{Phrases, kind};

/// The smallest distance between two of a triangle's unit normals that is written for a language
/// in which a triangle of equal normals is flat.
///
/// POV-Ray takes a `smooth_triangle` for a flat one if the squared distances of its second and
/// third normal from the first are at most its `EPSILON` of 1e-10, so if both distances are at
/// most 1e-5. The third normal is moved by at most twice this distance, and the cosine in Lambert's
/// law changes by as much at most, which is 1/160 of a step of a channel of 8 bits. A highlight with
/// the exponent n changes by at most 2 sqrt(n / e) times as much: a quarter of a step for n = 1000.
const DISTINCT: f64 = 1.2e-5;

/// A shape, or the use of a definition of this name, behind a prefix of its table, and the use of its
/// material.
pub fn text(
    language: Phrases,
    shape: &WrittenShape,
    definition: Option<&str>,
    prefix: &str,
    used: &str,
) -> Result<String, String> {
    let (mut text, mut groups, mut transforms) = (String::new(), prefix.to_owned(), String::new());
    let mut used = used;
    for Transform {
        matrix, inverse, ..
    } in &shape.transforms
    {
        let columns = [0, 1, 2, 3].map(|i| matrix.col(i).truncate().to_array());
        if let Ok(outwards) = language.find("outwards", "columns", &[columns.as_flattened()]) {
            transforms = outwards + &transforms;
            continue;
        }
        let rows = |matrix: &DMat4| [0, 1, 2].map(|i| matrix.row(i).to_array());
        let ([x, y, z], [ix, iy, iz]) = (rows(matrix), rows(inverse));
        let group = language.find("inwards", "x y z ix iy iz", &[&x, &y, &z, &ix, &iy, &iz])?;
        text += &group.replace("[groups]", &groups).replace("[use]", used);
        groups += "group.";
        used = "";
    }
    let words = match definition {
        Some(name) => language.find("use", "", &[])?.replace("[name]", name),
        None => words(language, shape)?,
    };
    // The table of a use, [[use]], is no place for the use of a material.
    text += &words.replace("[use]", used).replace("[groups]", &groups);
    Ok(text.replace("[transforms]", &transforms))
}

/// The words for a shape: by the phrase for its table, or by the one for all tables.
fn words(language: Phrases, shape: &WrittenShape) -> Result<String, String> {
    let Some(key) = shape.key else {
        return language.find("shape by formula", "", &[]);
    };
    if let Ok(any) = language.find("any shape", "", &[]) {
        let values = shape.values.iter();
        let values: String = values
            .map(|(name, numbers)| line(shape, name, numbers))
            .collect();
        return Ok(any.replace("[key]", key).replace("[values]", &values));
    }
    let value = |name| {
        let mut values = shape.values.iter();
        let found = values.find(|(own, _)| *own == name);
        found.map_or(&[][..], |(_, numbers)| &**numbers)
    };
    let smooth = value("normals");
    let phrase = if smooth.is_empty() {
        key.to_owned()
    } else {
        format!("smooth {key}")
    };
    let (mut names, mut numbers) = (String::new(), Vec::new());
    for (name, list) in &shape.values {
        names = names + name + " ";
        numbers.push(&**list);
    }
    // What a language may need besides the values: the height of a plane, and corners one by one.
    let height = match (value("point"), value("normal")) {
        (&[x, y, z], &[u, v, w]) => [DVec3::new(x, y, z).dot(DVec3::new(u, v, w))],
        _ => [0.0],
    };
    let distinct_w = distinct_third(smooth);
    names += "height a b c u v w distinct_w";
    numbers.push(&height);
    numbers.extend(value("corners").chunks(3).chain(smooth.chunks(3)));
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

/// The line of a scene file with a value, in the form that its key has.
fn line(shape: &WrittenShape, name: &str, numbers: &[f64]) -> String {
    let list = |numbers: &[f64]| {
        let numbers: Vec<_> = numbers.iter().map(|n| number(*n)).collect();
        numbers.join(", ")
    };
    let kind = kind::find(shape.key.unwrap_or_default());
    let lengths = kind.key(name).and_then(|key| key.form.lengths());
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
