//! The shapes of a scene of the engine as the values that a language has words for.

use engine::{Scene, Shape};
use scene_file::WrittenShape;

/// The shapes in their order; a shape that is a function has no words.
pub fn written(scene: &Scene) -> Vec<WrittenShape> {
    let mut written = Vec::new();
    scene.for_each_shape(|transforms, shape, surface| {
        let (key, values) = match shape {
            Shape::Sphere(s) => (
                "sphere",
                vec![
                    ("center", s.center.to_array().into()),
                    ("radius", vec![s.radius]),
                ],
            ),
            Shape::Plane(p) => (
                "plane",
                vec![
                    ("point", p.point.to_array().into()),
                    ("normal", p.normal.to_array().into()),
                ],
            ),
            Shape::Box(b) => ("box", vec![("lbf", b.min.into()), ("run", b.max.into())]),
            Shape::Disc(d) => (
                "disc",
                vec![
                    ("center", d.plane.point.to_array().into()),
                    ("normal", d.plane.normal.to_array().into()),
                    ("radius", vec![d.radius]),
                ],
            ),
            Shape::Triangle(t) => {
                let corners = t.corners.map(|corner| corner.to_array());
                ("triangle", vec![("corners", corners.as_flattened().into())])
            }
            Shape::Transformed(_) | Shape::Other(_) => ("shape by formula", Vec::new()),
        };
        written.push(WrittenShape {
            key: Some(key),
            own_keys: &[],
            values,
            transforms: transforms.to_vec(),
            surface: surface as usize,
        });
    });
    written
}
