//! Kinds of pictures of scenes, rendered by the engine; some were kept aside while the
//! sampler was tuned.

use common::{Color, Settings};
use engine::{
    AxisAlignedBox, Camera, Light as Source, LightKind, Phong, Plane, Renderer, Scene, Shading,
    Shape, Sphere, Surface, Transform,
};
use glam::{DMat4, DVec3};

use crate::kinds::{Kind, Light, Numbers, ray};

pub const SCENES: [Kind; 4] = [
    kind("scene: spheres on a mirror", mirrors),
    kind("scene: posts in a spot light", spot),
    kind("scene: flat ellipsoids in nodes", nodes),
    kind("scene: many far spheres", crowd),
];

const fn kind(name: &'static str, make: fn(Numbers) -> Light) -> Kind {
    Kind { name, make }
}

fn surface(color: Color, reflection: f64) -> Surface<'static> {
    Surface {
        shading: Shading::Phong(Phong {
            diffuse: color,
            specular: Color::gray(0.5),
            exponent: 64.0,
        }),
        reflection: Color::gray(reflection),
    }
}

/// A floor that mirrors by a share, and a light.
fn scene(floor: f64, kind: LightKind<'static>) -> Scene<'static> {
    let mut scene = Scene::new(Color::new(0.2, 0.3, 0.5), Color::gray(0.1), 4);
    scene.add_light(Source {
        kind,
        casts_shadows: true,
    });
    let floor = scene.add_surface(surface(Color::gray(0.5), floor));
    let plane = Plane {
        point: DVec3::ZERO,
        normal: DVec3::Y,
    };
    scene.add_shape(Shape::Plane(plane), floor);
    scene
}

fn lamp() -> LightKind<'static> {
    LightKind::Point {
        color: Color::WHITE,
        position: DVec3::new(5.0, 9.0, 6.0),
    }
}

fn seen(scene: Scene<'static>) -> Light {
    let camera = Camera::Other(Box::new(|_, x, y| ray(x, y)));
    let renderer = Renderer::new(scene, camera, &Settings::default());
    Box::new(move |x, y| {
        let mut light = [Color::BLACK];
        renderer.trace(&[ray(x, y)], &mut light);
        light[0]
    })
}

fn spheres(scene: &mut Scene<'static>, numbers: &mut Numbers, count: u32, most: f64, mirror: f64) {
    for _ in 0..count {
        let surface = scene.add_surface(surface(numbers.color(), mirror));
        let radius = numbers.between(0.1 * most, most);
        let (x, z) = (numbers.between(-2.0, 2.0), numbers.between(-4.0, 1.5));
        let center = DVec3::new(x, radius * numbers.between(1.0, 2.0), z);
        scene.add_shape(Shape::Sphere(Sphere { center, radius }), surface);
    }
}

fn post(scene: &mut Scene<'static>, numbers: &mut Numbers) {
    let surface = scene.add_surface(surface(numbers.color(), 0.0));
    let (x, z) = (numbers.between(-1.5, 1.5), numbers.between(-3.0, 1.0));
    let (width, height) = (numbers.between(0.004, 0.04), numbers.between(0.3, 1.2));
    let (min, max) = ([x, 0.0, z], [x + width, height, z + width]);
    scene.add_shape(Shape::Box(AxisAlignedBox { min, max }), surface);
}

fn mirrors(mut numbers: Numbers) -> Light {
    let mut scene = scene(numbers.between(0.2, 0.8), lamp());
    spheres(&mut scene, &mut numbers, 12, 0.4, 0.5);
    for _ in 0..4 {
        post(&mut scene, &mut numbers);
    }
    seen(scene)
}

fn spot(mut numbers: Numbers) -> Light {
    let target = DVec3::new(numbers.between(-0.5, 0.5), 0.0, numbers.between(-1.0, 0.5));
    let position = DVec3::new(numbers.between(-2.0, 2.0), 4.0, 2.0);
    let mut scene = scene(
        0.0,
        LightKind::Spot {
            color: Color::WHITE,
            position,
            direction: (target - position).normalize(),
            cos_half_angle: libm::cos(numbers.between(0.02, 0.2)),
        },
    );
    for _ in 0..8 {
        post(&mut scene, &mut numbers);
    }
    seen(scene)
}

fn nodes(mut numbers: Numbers) -> Light {
    let mut scene = scene(0.0, lamp());
    for _ in 0..8 {
        let surface = scene.add_surface(surface(numbers.color(), 0.0));
        let (angle, flat) = (numbers.between(-1.0, 1.0), numbers.between(0.005, 0.05));
        let (x, z) = (numbers.between(-1.5, 1.5), numbers.between(-3.0, 1.0));
        let matrix = DMat4::from_translation(DVec3::new(x, numbers.between(0.2, 1.2), z))
            * DMat4::from_rotation_z(angle)
            * DMat4::from_scale(DVec3::new(numbers.between(0.1, 0.6), flat, 0.3));
        let transform = Transform {
            matrix,
            inverse: matrix.inverse(),
        };
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        });
        scene.add_shape(sphere.transformed(&transform), surface);
    }
    seen(scene)
}

fn crowd(mut numbers: Numbers) -> Light {
    let mut scene = scene(0.0, lamp());
    let count = numbers.between(20.0, 300.0) as u32;
    spheres(&mut scene, &mut numbers, count, 0.04, 0.0);
    seen(scene)
}
