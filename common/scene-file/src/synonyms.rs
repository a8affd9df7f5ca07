//! `synonyms`: names of other programs for tables and keys of a scene file.

use common::text::plain;

/// Names of tables and keys, and behind each those that other programs have for it.
const SYNONYMS: &str = include_str!("synonyms.txt");

/// Shapes, and what has their form where no stage has a table for them.
const OTHER_SHAPES: &[(&str, &str)] = &[
    ("capsule", "a mesh"),
    ("cone", "a mesh"),
    ("cylinder", "a mesh"),
    ("ellipsoid", "a sphere with a scale in its transform"),
    ("pyramid", "a mesh, or triangles"),
    ("quad", "two triangles, or a box that is flat"),
    ("rectangle", "two triangles, or a box that is flat"),
    ("square", "two triangles, or a box that is flat"),
    ("torus", "a mesh"),
    ("tube", "a mesh"),
];

/// What has the form of another program's shape, if it is one.
pub fn form_of(name: &str) -> Option<&'static str> {
    let name = name.to_lowercase();
    let found = OTHER_SHAPES.iter().find(|(shape, _)| *shape == name);
    found.map(|(_, form)| *form)
}

/// The known name for another program's, or for one in another spelling such as `rotateZ`.
pub fn known_for<'a>(known: &[&'a str], name: &str) -> Option<&'a str> {
    let name = plain(name);
    let mut same = known.iter().copied();
    if let Some(same) = same.find(|known| plain(known) == name) {
        return Some(same);
    }
    for line in SYNONYMS.lines() {
        let (own, foreign) = line.split_once(": ")?;
        let own = known.iter().find(|known| **known == own);
        if own.is_some() && foreign.split(' ').any(|foreign| plain(foreign) == name) {
            return own.copied();
        }
    }
    None
}
