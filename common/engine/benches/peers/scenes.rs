//! The five scenes.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::description::{Camera, Description, Light, Material, Mesh, Object, Shape, Triple};
use crate::random::PixelRandom;

/// All scenes, from few objects to many.
pub fn all() -> Vec<Description> {
    vec![
        mirrors(),
        four_objects(),
        spheres(),
        torus(),
        many_spheres(),
    ]
}

/// Nine mirroring spheres on a mirroring plane.
fn mirrors() -> Description {
    Description {
        name: "s1",
        camera: camera([0.0, 7.0, 10.0], [0.0, -6.6, -10.0]),
        light: Light::Point([6.0, 12.0, 5.0]),
        ambient: 0.1,
        depth: 8,
        materials: palette(0.5, 0.5),
        objects: || {
            let plane = object(Shape::Plane([0.0; 3], [0.0, 1.0, 0.0]), 6);
            let spheres = (0..9).map(|i| {
                let [x, z] = [i % 3, i / 3].map(|place| 2.5 * (place as f64 - 1.0));
                object(Shape::Sphere([x, 1.0, z], 1.0), i % 6)
            });
            Box::new(spheres.chain([plane]))
        },
    }
}

/// The four objects of the course, matt and under a far light.
fn four_objects() -> Description {
    Description {
        name: "s2",
        camera: camera([4.0; 3], [-1.0; 3]),
        light: Light::Directional([-1.0, -3.0, -2.0]),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.0, 0.0),
        objects: || {
            let triangle = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 1.0, -1.0]];
            Box::new(
                [
                    Shape::Plane([0.0; 3], [0.0, 1.0, 0.0]),
                    Shape::Sphere([1.0; 3], 0.5),
                    Shape::Box([-1.5, 0.5, 0.5], [-0.5, 1.5, 1.5]),
                    Shape::Triangle(triangle),
                ]
                .into_iter()
                .zip(0..)
                .map(|(shape, material)| object(shape, material)),
            )
        },
    }
}

/// A thousand shiny spheres.
fn spheres() -> Description {
    Description {
        name: "s3",
        camera: camera([0.0, 8.0, 26.0], [0.0, -8.0, -26.0]),
        light: Light::Point([15.0, 30.0, 25.0]),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.5, 0.0),
        objects: || scattered(1_000, 0.3, 0.8),
    }
}

/// A ring of 20,000 smooth triangles.
fn torus() -> Description {
    Description {
        name: "s4",
        camera: camera([0.0, 5.0, 6.5], [0.0, -5.8, -6.5]),
        light: Light::Point([8.0, 6.0, 2.0]),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.5, 0.0),
        objects: || {
            let ring = object(Shape::Mesh(ring(200, 50)), 1);
            Box::new(std::iter::once(ring))
        },
    }
}

/// A hundred thousand small spheres.
fn many_spheres() -> Description {
    Description {
        name: "s5",
        objects: || scattered(100_000, 0.05, 0.15),
        ..spheres()
    }
}

/// A camera with the course's opening, held upright.
fn camera(eye: Triple, gaze: Triple) -> Camera {
    Camera {
        eye,
        gaze,
        up: [0.0, 1.0, 0.0],
        angle: FRAC_PI_4,
    }
}

/// Six colours and a dark grey.
fn palette(specular: f64, reflection: f64) -> Vec<Material> {
    let colors = [
        [0.8, 0.1, 0.1],
        [0.1, 0.7, 0.2],
        [0.1, 0.2, 0.8],
        [0.8, 0.7, 0.1],
        [0.7, 0.1, 0.7],
        [0.1, 0.7, 0.7],
        [0.2, 0.2, 0.2],
    ];
    let material = |color| Material {
        color,
        specular,
        exponent: 32.0,
        reflection,
    };
    colors.map(material).into()
}

const fn object(shape: Shape, material: usize) -> Object {
    Object { shape, material }
}

/// Spheres anywhere in a cube around the origin, with radii between two.
fn scattered(count: u32, smallest: f64, largest: f64) -> Box<dyn Iterator<Item = Object>> {
    Box::new((0..count).map(move |i| {
        let random = PixelRandom::new(0, i, 0);
        let centre = [0, 1, 2].map(|axis| 20.0 * random.uniform(axis) - 10.0);
        let radius = smallest + (largest - smallest) * random.uniform(3);
        object(Shape::Sphere(centre, radius), i as usize % 6)
    }))
}

/// A torus of radii 2.5 and 1 around the y axis, with `around` steps around the axis,
/// `tube` steps around the tube, and two triangles in each square between them.
fn ring(around: usize, tube: usize) -> Mesh {
    let places = || (0..around).flat_map(move |i| (0..tube).map(move |j| (i, j)));
    let normal = |(i, j): (usize, usize)| {
        let (a, b) = (TAU * i as f64 / around as f64, TAU * j as f64 / tube as f64);
        let outwards = libm::cos(b);
        [
            outwards * libm::cos(a),
            libm::sin(b),
            outwards * libm::sin(a),
        ]
    };
    let corner = |(i, j): (usize, usize)| {
        let [x, y, z] = normal((i, j));
        let a = TAU * i as f64 / around as f64;
        [2.5 * libm::cos(a) + x, y, 2.5 * libm::sin(a) + z]
    };
    let index = |i: usize, j: usize| (i % around) * tube + j % tube;
    Mesh {
        corners: places().map(corner).collect(),
        normals: places().map(normal).collect(),
        triangles: places()
            .flat_map(|(i, j)| {
                let [a, b] = [index(i, j), index(i, j + 1)];
                let [c, d] = [index(i + 1, j), index(i + 1, j + 1)];
                [[a, b, d], [a, d, c]]
            })
            .collect(),
    }
}
