//! Rooms of a few shapes, where the scene says before the first ray which pixels can hide
//! something.

use common::{Color, Settings};
use engine::{
    AxisAlignedBox, Disc, Light, LightKind, Phong, Plane, Renderer, Scene, Shading, Shape, Sphere,
    Surface,
};
use glam::{DVec3, dvec3};

use crate::support::{Numbers, camera};

/// A room of some shapes, from specks to walls, under lamps that may cast shadows.
pub fn room(
    numbers: &mut Numbers,
    settings: &Settings,
    shapes: [f64; 2],
    casts_shadows: bool,
) -> Renderer<'static> {
    let mut scene = Scene::new(numbers.color(), Color::gray(numbers.between(0.0, 0.2)), 3);
    let count = numbers.between(shapes[0], shapes[1] + 1.0) as u32;
    for _ in 0..count {
        let surface = scene.add_surface(surface(numbers));
        let shape = shape(numbers);
        scene.add_shape(shape, surface);
    }
    for _ in 0..2 {
        let kind = lamp(numbers);
        scene.add_light(Light {
            kind,
            casts_shadows,
        });
    }
    let eye = dvec3(0.0, 1.0, 6.0) + numbers.in_cube(0.5);
    let half_tangent = numbers.between(0.2, 0.8);
    Renderer::new(scene, camera(eye, -eye, half_tangent), settings)
}

fn surface(numbers: &mut Numbers) -> Surface<'static> {
    let is_shiny = numbers.between(0.0, 1.0) < 0.5;
    let is_mirror = numbers.between(0.0, 1.0) < 0.3;
    let black_unless = |is, color: Color| if is { color } else { Color::BLACK };
    Surface {
        shading: Shading::Phong(Phong {
            diffuse: numbers.color() * 0.7,
            specular: black_unless(is_shiny, numbers.color() * 0.3),
            exponent: libm::exp(numbers.between(0.0, 6.0)),
        }),
        reflection: black_unless(is_mirror, numbers.color() * 0.5),
    }
}

fn shape(numbers: &mut Numbers) -> Shape<'static> {
    let point = numbers.in_cube(2.0);
    let normal = (dvec3(0.0, 0.5, 1.0) + numbers.in_cube(1.0)).normalize();
    let radius = libm::exp(numbers.between(-5.0, 1.0));
    let plane = Plane { point, normal };
    match numbers.between(0.0, 5.0) as u32 {
        0 => Shape::Plane(Plane {
            point: point - DVec3::Z * 3.0,
            normal,
        }),
        1 => Shape::Disc(Disc { plane, radius }),
        2 => Shape::Box(AxisAlignedBox {
            min: (point - radius).to_array(),
            max: (point + radius).to_array(),
        }),
        _ => Shape::Sphere(Sphere {
            center: point,
            radius,
        }),
    }
}

fn lamp(numbers: &mut Numbers) -> LightKind<'static> {
    let color = numbers.color() * 0.6;
    let position = dvec3(0.0, 4.0, 3.0) + numbers.in_cube(3.0);
    match numbers.between(0.0, 3.0) as u32 {
        0 => LightKind::Directional {
            color,
            direction: -position.normalize(),
        },
        1 => LightKind::Point { color, position },
        _ => LightKind::Spot {
            color,
            position,
            direction: (numbers.in_cube(1.0) - position).normalize(),
            cos_half_angle: numbers.between(0.8, 0.999),
        },
    }
}
