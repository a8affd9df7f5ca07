//! Pixels in which the scene says that no object can be seen: no ray through them meets one, and
//! around small objects they are nearly all.

use common::{Color, Settings, Size};
use engine::adaptive::PixelRandom;
use engine::{
    AxisAlignedBox, Basis, Camera, Disc, Plane, Renderer, Sampler, Scene, Shading, Shape, Sphere,
    Surface,
};
use glam::{DVec3, dvec3};

/// Random numbers of a scene, one after another.
struct Numbers(PixelRandom, u64);

impl Numbers {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.1 += 1;
        least + (most - least) * self.0.uniform(self.1)
    }

    fn point(&mut self, extent: f64) -> DVec3 {
        let mut x = || self.between(-extent, extent);
        dvec3(x(), x(), x())
    }
}

/// The corners of each pixel, and many random places.
struct Many;

impl Sampler for Many {
    fn samples(&self) -> u32 {
        100
    }

    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        if i < 4 {
            return (f64::from(i % 2), f64::from(i / 2));
        }
        let random = PixelRandom::new(7, column, row);
        let i = 2 * u64::from(i);
        (random.uniform(i), random.uniform(i + 1))
    }
}

fn shape(numbers: &mut Numbers) -> Shape<'static> {
    let (point, radius) = (numbers.point(3.0), numbers.between(0.02, 0.8));
    let normal = numbers.point(1.0).normalize();
    let plane = Plane { point, normal };
    match numbers.between(0.0, 8.0) as u32 {
        0 => Shape::Plane(plane),
        1 | 2 => Shape::Disc(Disc { plane, radius }),
        3 | 4 => Shape::Box(AxisAlignedBox {
            min: point.to_array(),
            max: (point + numbers.point(radius).abs()).to_array(),
        }),
        _ => Shape::Sphere(Sphere {
            center: point,
            radius,
        }),
    }
}

fn camera(numbers: &mut Numbers) -> Camera<'static> {
    let w = numbers.point(1.0).normalize();
    let u = numbers.point(1.0).cross(w).normalize();
    let basis = Basis {
        e: w * numbers.between(4.0, 12.0) + numbers.point(1.0),
        u,
        v: w.cross(u),
        w,
    };
    if numbers.between(0.0, 3.0) < 1.0 {
        let scale = numbers.between(1.0, 12.0);
        return Camera::Orthographic { basis, scale };
    }
    Camera::Perspective {
        basis,
        half_tangent: numbers.between(0.05, 1.5),
    }
}

/// White shapes in the dark.
fn scene(shapes: impl IntoIterator<Item = Shape<'static>>) -> Scene<'static> {
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    let white = scene.add_surface(Surface::matt(Shading::SingleColor(Color::WHITE)));
    for shape in shapes {
        scene.add_shape(shape, white);
    }
    scene
}

#[test]
fn no_ray_meets_an_object_in_pixels_without_objects() {
    let mut without = 0;
    for seed in 0..150 {
        let mut numbers = Numbers(PixelRandom::new(seed, 0, 0), 0);
        let shapes: Vec<_> = (0..=seed % 4).map(|_| shape(&mut numbers)).collect();
        let camera = camera(&mut numbers);
        let size = [[24, 18], [17, 1], [1, 9]][seed as usize % 3];
        let settings = Settings {
            size: Size::new(size[0], size[1]).unwrap(),
            ..Settings::default()
        };
        let scene = scene(shapes);
        let known = scene.known_light(&camera, settings.size);
        let renderer = Renderer::new(scene, camera, &settings);
        let image = renderer.render(&Many, &settings, &()).unwrap();
        for (light, is_without) in image.pixels().iter().zip(known.without_objects) {
            assert!(!is_without || *light == Color::BLACK, "seed {seed}");
            without += usize::from(is_without);
        }
    }
    assert!(without > 2000, "{without}");
}

/// From the eye at the origin, upright, along the negative z axis.
fn without_objects(shape: Shape<'static>) -> usize {
    let camera = Camera::Perspective {
        basis: Basis {
            e: DVec3::ZERO,
            u: DVec3::X,
            v: DVec3::Y,
            w: DVec3::Z,
        },
        half_tangent: 0.5,
    };
    let size = Size::new(24, 17).unwrap();
    let known = scene([shape]).known_light(&camera, size);
    let without = known.without_objects.into_iter();
    without.filter(|is_without| *is_without).count()
}

/// A pixel is 1/17 of the distance wide. A ball of half a pixel lies in at most two rows and two
/// columns; the horizon of a floor is in the middle row, and eight rows are above.
#[test]
fn pixels_without_objects_are_all_but_those_around_an_object() {
    let ball = |x: f64| {
        Shape::Sphere(Sphere {
            center: dvec3(x, 0.3, -10.0),
            radius: 0.14,
        })
    };
    for x in [0.0, 0.1, 0.2, 1.7] {
        assert!(without_objects(ball(x)) >= 24 * 17 - 4, "{x}");
    }
    let floor = Shape::Plane(Plane {
        point: dvec3(3.0, -1.0, 8.0),
        normal: DVec3::Y,
    });
    assert_eq!(without_objects(floor), 8 * 24);
    // Part of it is behind the eye.
    let around = Shape::Box(AxisAlignedBox {
        min: [-1.0; 3],
        max: [1.0; 3],
    });
    assert_eq!(without_objects(around), 0);
}
