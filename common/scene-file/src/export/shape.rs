//! The text of a shape.

use engine::Transform;
use glam::{DMat4, DVec3};

use super::WrittenShape;
use crate::phrases::number;
use crate::{KINDS, Phrases};

/// A shape, and the use of its material.
pub fn text(language: Phrases, shape: &WrittenShape, used: &str) -> Result<String, String> {
    let (mut text, mut groups, mut transforms) = (String::new(), String::new(), String::new());
    let mut used = used;
    for Transform { matrix, inverse } in &shape.transforms {
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
    text += &words(language, shape)?
        .replace("[groups]", &groups)
        .replace("[use]", used);
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
    names += "height a b c u v w";
    numbers.push(&height);
    numbers.extend(value("corners").chunks(3).chain(smooth.chunks(3)));
    language.find(&phrase, &names, &numbers)
}

/// The line of a scene file with a value, in the form that its key has.
fn line(shape: &WrittenShape, name: &str, numbers: &[f64]) -> String {
    let list = |numbers: &[f64]| {
        let numbers: Vec<_> = numbers.iter().map(|n| number(*n)).collect();
        numbers.join(", ")
    };
    let mut kinds = KINDS.iter();
    let kind = kinds.find(|kind| Some(kind.name) == shape.key);
    let own = shape.own_keys.iter().find(|key| key.name == name);
    let key = own.or_else(|| kind.and_then(|kind| kind.key(name)));
    let form = key.map_or("", |key| key.form);
    // Such as `3 x 4 numbers`.
    let rows = form.split_once(" x ");
    let columns = rows.and_then(|(_, columns)| columns.split(' ').next()?.parse().ok());
    let value = match (columns, numbers) {
        (Some(columns), _) => {
            let rows: Vec<_> = numbers
                .chunks(columns)
                .map(|row| format!("[{}]", list(row)))
                .collect();
            format!("[{}]", rows.join(", "))
        }
        (None, [one]) => number(*one),
        (None, many) => format!("[{}]", list(many)),
    };
    format!("{name} = {value}\n")
}
