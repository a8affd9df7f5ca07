//! The text of a shape.

use engine::Transform;
use glam::DMat4;

use crate::{Phrases, WrittenShape, words};

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
        None => match shape.key {
            Some(key) => words::of_table(language, "any shape", key, &shape.values)?,
            None => language.find("shape by formula", "", &[])?,
        },
    };
    // The table of a use, [[use]], is no place for the use of a material.
    text += &words.replace("[use]", used).replace("[groups]", &groups);
    Ok(text.replace("[transforms]", &transforms))
}
