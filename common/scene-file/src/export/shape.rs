//! The text of a shape.

use engine::{Shape, Transform};
use glam::DMat4;

use crate::Phrases;

/// A shape under transforms, from the outermost to the innermost, and the use of its material.
pub fn text(
    language: Phrases,
    shape: &Shape,
    steps: &[Transform],
    mut used: &str,
) -> Result<String, String> {
    let (mut text, mut groups, mut transforms) = (String::new(), String::new(), String::new());
    for step in steps {
        let rows = |matrix: DMat4| [0, 1, 2].map(|i| matrix.row(i).to_array());
        let ([x, y, z], [ix, iy, iz]) = (rows(step.matrix), rows(step.inverse));
        let columns = [0, 1, 2, 3].map(|i| step.matrix.col(i).truncate().to_array());
        if let Ok(outwards) = language.find("outwards", "columns", &[columns.as_flattened()]) {
            transforms = outwards + &transforms;
            continue;
        }
        let group = language.find("inwards", "x y z ix iy iz", &[&x, &y, &z, &ix, &iy, &iz])?;
        text += &group.replace("[groups]", &groups).replace("[use]", used);
        groups += "group.";
        used = "";
    }
    let find = |phrase, names, values: &[&[f64]]| language.find(phrase, names, values);
    let words = match shape {
        Shape::Sphere(s) => find("sphere", "center radius", &[s.center.as_ref(), &[s.radius]]),
        Shape::Plane(p) => {
            let height = p.point.dot(p.normal);
            let values: [&[f64]; 3] = [p.point.as_ref(), p.normal.as_ref(), &[height]];
            find("plane", "point normal height", &values)
        }
        Shape::Box(b) => find("box", "lbf run", &[&b.min, &b.max]),
        Shape::Disc(d) => {
            let (center, normal) = (d.plane.point.as_ref(), d.plane.normal.as_ref());
            let values: [&[f64]; 3] = [center, normal, &[d.radius]];
            find("disc", "center normal radius", &values)
        }
        Shape::Triangle(t) => {
            let is_smooth = t.normals != [t.face; 3];
            let phrase = ["triangle", "smooth triangle"][usize::from(is_smooth)];
            let [a, b, c] = t.corners.map(|v| v.to_array());
            let [u, v, w] = t.normals.map(|v| v.to_array());
            find(phrase, "a b c u v w", &[&a, &b, &c, &u, &v, &w])
        }
        Shape::Transformed(_) | Shape::Other(_) => find("shape by formula", "", &[]),
    }?;
    text += &words.replace("[groups]", &groups).replace("[use]", used);
    Ok(text.replace("[transforms]", &transforms))
}
