//! Pictures with the eye in the plane of a triangle: all renderers draw the same.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, PixelRandom};
use a04_intersections::Triangle;
use a04_intersections::fast::shapes;
use a05_lighting::{Lambert, PointLight};
use a06_shadows_reflection::{LightSource, ShadowedWorld, View, traced_scene};
use common::{ArgumentError, Color, Renderer, Settings, Size};

/// A vector of eighths from -2 to 2.
fn eighths(random: PixelRandom, first: u64) -> Vector3 {
    let [x, y, z] = [0, 1, 2].map(|i| (33.0 * random.uniform(first + i)).floor() / 8.0 - 2.0);
    Vector3::new(x, y, z)
}

/// Four triangles, and an eye in the plane of the first.
fn view(seed: u64) -> Result<View, ArgumentError> {
    let random = PixelRandom::new(seed, 0, 0);
    let corner = |v: Vector3| Point3::ORIGIN + v;
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 5.0, 4.0))?;
    let mut world = ShadowedWorld::empty(Color::new(0.1, 0.2, 0.3), Color::gray(0.2))?
        .lit_by(LightSource::new(lamp, true));
    for i in 0..4 {
        let [a, b, c] = [0, 3, 6].map(|n| corner(eighths(random, 9 * i + n)));
        let matt = Lambert::new(Color::new(0.9, 0.2 * i as f64, 0.4))?;
        if let Ok(triangle) = Triangle::new(a, b, c) {
            world = world.with(triangle, Box::new(matt));
        }
    }
    let [a, b, c] = [0, 3, 6].map(|n| eighths(random, n));
    let eye = corner(a + (b - a) * 2.5 + (c - a) * 1.25);
    let middle = corner((a + b + c) * (1.0 / 3.0));
    let up = (b - a).cross(c - a);
    let camera = PerspectiveCamera::new(eye, middle - eye, up, 0.9)?;
    Ok((Box::new(camera), world))
}

#[test]
fn pictures_from_the_plane_of_a_triangle_are_the_same() {
    let mut pictures = 0;
    for seed in (0..).filter(|seed| view(*seed).is_ok()) {
        let scene = traced_scene("plane", "an eye in a plane", move |_| view(seed), shapes);
        let [lesson, engine, all] = Renderer::ALL.map(|renderer| {
            let settings = Settings {
                size: Size::new(40, 31).unwrap(),
                renderer,
                ..Settings::default()
            };
            scene.render(&settings, &()).unwrap()
        });
        assert!(engine == lesson, "the engine differs, seed {seed}");
        assert!(all == lesson, "all work differs, seed {seed}");
        pictures += 1;
        if pictures == 600 {
            return;
        }
    }
}
