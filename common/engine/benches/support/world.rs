//! Scenes as those of the engine.

use common::{Color, Settings};
use engine::{
    AxisAlignedBox, Camera, Disc, Light, LightKind, Phong, Plane, Renderer, Shading, Shape, Sphere,
    Surface, Transform, Triangle,
};
use glam::{DMat4, DVec3};

use super::scene::{AMBIENT, HALF_ANGLE, Item, Kind, Scene};

/// A scene with its structure for rays.
pub fn prepare(scene: &Scene, settings: &Settings) -> Renderer<'static> {
    let mut world = engine::Scene::new(Color::BLACK, Color::gray(AMBIENT), scene.depth);
    let (mut surfaces, mut transforms) = (Vec::new(), Vec::new());
    for item in scene.items(settings.size) {
        let [a, b, c, d, ..] = item.vectors;
        if let Kind::Material = item.kind {
            surfaces.push(world.add_surface(Surface {
                shading: Shading::Phong(Phong {
                    diffuse: color(a),
                    specular: Color::gray(b.x),
                    exponent: b.y,
                }),
                reflection: Color::gray(b.z),
            }));
        } else if let Kind::Transform = item.kind {
            let [x, y, z] = [a, b, c].map(|axis| axis.extend(0.0));
            let matrix = DMat4::from_cols(x, y, z, d.extend(1.0));
            let inverse = matrix.inverse();
            transforms.push(Transform { matrix, inverse });
        } else if let Some(kind) = light(&item) {
            let casts_shadows = true;
            world.add_light(Light {
                kind,
                casts_shadows,
            });
        } else if let Some(shape) = shape(&item) {
            let transforms = transforms.drain(..);
            let shape = transforms.fold(shape, |shape, transform| shape.transformed(&transform));
            world.add_shape(shape, surfaces[item.color]);
        }
    }
    let camera = Camera::Perspective {
        basis: scene.basis(),
        half_tangent: libm::tan(HALF_ANGLE),
    };
    Renderer::new(world, camera, settings)
}

fn color(vector: DVec3) -> Color {
    let [r, g, b] = vector.to_array();
    Color::new(r, g, b)
}

fn light(item: &Item) -> Option<LightKind<'static>> {
    let [first, position, direction, _, angle, ..] = item.vectors;
    let color = color(first);
    Some(match item.kind {
        Kind::Point => LightKind::Point { color, position },
        Kind::Spot => LightKind::Spot {
            color,
            position,
            direction,
            cos_half_angle: libm::cos(angle.x.to_radians()),
        },
        Kind::Directional => LightKind::Directional { color, direction },
        _ => return None,
    })
}

fn shape(item: &Item) -> Option<Shape<'static>> {
    let [a, b, c, d, e, f, _] = item.vectors;
    let plane = |point, normal| Plane { point, normal };
    let sphere = |center, radius| Sphere { center, radius };
    let solid = |min, max| AxisAlignedBox { min, max };
    let disc = |plane, radius| Disc { plane, radius };
    let face = (b - a).cross(c - a).normalize();
    let triangle = |normals| Triangle {
        corners: [a, b, c],
        normals,
        face,
    };
    Some(match item.kind {
        Kind::Plane => Shape::Plane(plane(DVec3::ZERO, a)),
        Kind::Sphere => Shape::Sphere(sphere(a, b.x)),
        Kind::Cube => Shape::Box(solid(a.to_array(), b.to_array())),
        Kind::Disc => Shape::Disc(disc(plane(a, b), c.x)),
        Kind::Triangle => Shape::Triangle(triangle([face; 3])),
        Kind::Smooth => Shape::Triangle(triangle([d, e, f])),
        _ => return None,
    })
}
