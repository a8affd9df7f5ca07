//! The shapes, materials and lights of a scene of the engine as the values that a language has words for.

use common::Color;
use engine::{Emitter, Scene, Shading, Shape};
use glam::DVec3;
use scene_export::{Values, WrittenLight, WrittenShape};

/// The shapes in their order; a shape that is a function has no words.
pub fn written(scene: &Scene) -> Vec<WrittenShape> {
    let mut written = Vec::new();
    scene.for_each_shape(|transforms, shape, surface| {
        written.push(WrittenShape {
            transforms: transforms.to_vec(),
            surface: surface as usize,
            ..in_words(shape)
        });
    });
    written
}

/// The word for a shape, and its numbers.
fn in_words(shape: &Shape) -> WrittenShape {
    let (key, values) = match shape {
        Shape::Sphere(sphere) => (
            "sphere",
            vec![
                ("center", sphere.center.to_array().into()),
                ("radius", vec![sphere.radius]),
            ],
        ),
        Shape::Plane(plane) => (
            "plane",
            vec![
                ("point", plane.point.to_array().into()),
                ("normal", plane.normal.to_array().into()),
            ],
        ),
        Shape::Box(aab) => (
            "box",
            vec![("lbf", aab.min.into()), ("run", aab.max.into())],
        ),
        Shape::Disc(disc) => (
            "disc",
            vec![
                ("center", disc.plane.point.to_array().into()),
                ("normal", disc.plane.normal.to_array().into()),
                ("radius", vec![disc.radius]),
            ],
        ),
        Shape::Triangle(triangle) => {
            let corners = triangle.corners.map(|corner| corner.to_array());
            let mut values = vec![("corners", corners.as_flattened().into())];
            let [u, v, w] = triangle.normals;
            if u != v || v != w {
                let normals = triangle.normals.map(|normal| normal.to_array());
                values.push(("normals", normals.as_flattened().into()));
            }
            ("triangle", values)
        }
        Shape::Transformed(_) | Shape::Instance(_) | Shape::Other(_) => {
            ("shape by formula", Vec::new())
        }
    };
    WrittenShape {
        key: Some(key),
        values,
        used: None,
        transforms: Vec::new(),
        surface: 0,
    }
}

/// The materials of the surfaces; a material that is a function has no words.
pub fn written_materials(scene: &Scene) -> Vec<Option<Values>> {
    let mut written = Vec::new();
    for surface in &scene.surfaces {
        let color = |name, color: Color| (name, color.channels().into());
        written.push(match &surface.shading {
            Shading::SingleColor(own) => Some(vec![color("color", *own)]),
            Shading::Phong(phong) => {
                let mut values = vec![color("diffuse", phong.diffuse)];
                if phong.specular != Color::BLACK {
                    values.push(color("specular", phong.specular));
                    values.push(("exponent", vec![phong.exponent]));
                }
                values.push(color("reflection", surface.reflection));
                Some(values)
            }
            Shading::Other(_) => None,
        });
    }
    written
}

/// The lights in their order; a light that is a function has no words.
pub fn written_lights(scene: &Scene) -> Vec<WrittenLight> {
    let lights = scene.lights.iter();
    lights.map(|light| light_in_words(&light.kind)).collect()
}

fn light_in_words(light: &Emitter) -> WrittenLight {
    let color = |color: &Color| ("color", color.channels().into());
    let vector = |name, vector: &DVec3| (name, vector.to_array().into());
    let (key, values) = match light {
        Emitter::Point {
            color: own,
            position,
        } => (
            "point_light",
            vec![color(own), vector("position", position)],
        ),
        Emitter::Spot {
            color: own,
            position,
            direction,
            cos_half_angle,
        } => {
            let half_angle = libm::acos(*cos_half_angle).to_degrees();
            let values = vec![
                color(own),
                vector("position", position),
                vector("direction", direction),
                ("half_angle", vec![half_angle]),
            ];
            ("spot_light", values)
        }
        Emitter::Directional {
            color: own,
            direction,
        } => (
            "directional_light",
            vec![color(own), vector("direction", direction)],
        ),
        Emitter::Other(_) => ("light by formula", Vec::new()),
    };
    WrittenLight {
        key: Some(key),
        values,
    }
}
