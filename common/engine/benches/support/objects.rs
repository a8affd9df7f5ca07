//! Makes the objects of the scenes.

use std::f64::consts::TAU;

use engine::{AxisAlignedBox, Disc, Plane, Shape, Sphere, Transform, Triangle};
use glam::{DMat4, DVec3, dvec3};

use super::Numbers;

/// Shapes, each with the index of its colour, made one after the other: a list of them would
/// count among the memory of the program that we measure.
pub type Objects = Box<dyn Iterator<Item = (Shape<'static>, usize)>>;

/// The index of the dark grey, which is also the number of colours before it.
const GREY: usize = 6;

/// The objects of a scene, but the floor.
pub fn objects(scene: &str) -> Objects {
    match scene {
        "mirrors" => Box::new((0..9).map(|i| {
            let [x, z] = [i % 3, i / 3].map(|place| 2.5 * (place as f64 - 1.0));
            (sphere(dvec3(x, 1.0, z), 1.0), i % GREY)
        })),
        "objects" => {
            let corners = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 1.0, -1.0]];
            let triangle = triangle(corners.map(DVec3::from), None);
            let (sphere, cube) = (sphere(DVec3::ONE, 0.5), cube(dvec3(-1.0, 1.0, 1.0), 0.5));
            Box::new([(sphere, 1), (cube, 2), (triangle, 3)].into_iter())
        }
        "spheres" => scattered(1_000, 0.3, 0.8),
        "torus" => surface([200, 50], true, |x, y| ring(x, y, 0.0)),
        "swarm" => scattered(100_000, 0.05, 0.15),
        "sizes" => random(50_000, |i, numbers| {
            let radius = 3.0 * libm::pow((i + 1) as f64, -3.0 / libm::log10(50_000.0));
            sphere(numbers.in_cube(10.0), radius)
        }),
        "cloud" => scattered(60_000, 0.05, 0.15),
        "boxes" => random(800, |_, numbers| {
            let center = numbers.in_box(dvec3(-10.0, 0.5, -10.0), dvec3(10.0, 7.0, 10.0));
            cube(center, numbers.between(0.15, 0.45))
        }),
        "discs" => random(5_000, |_, numbers| {
            let (point, normal) = (numbers.in_cube(10.0), numbers.in_cube(1.0).normalize());
            let plane = Plane { point, normal };
            let radius = numbers.between(0.2, 0.5);
            Shape::Disc(Disc { plane, radius })
        }),
        "nodes" => Box::new(branches(&[]).into_iter()),
        "lamps" => random(300, |i, numbers| {
            let center = numbers.in_cube(10.0);
            let half = numbers.between(0.15, 0.6);
            let center = center.with_y(half);
            [sphere, cube][(i / 6) % 2](center, half)
        }),
        "mesh" => surface([450, 100], true, |x, y| {
            let ring = ring(x, y, 0.1);
            dvec3(ring.x, 3.8 - ring.z, ring.y)
        }),
        "hills" => surface([320; 2], false, |x, z| {
            waves(40.0 * x - 20.0, 40.0 * z - 20.0)
        }),
        _ => Box::new(hairs(10_000).chain([(sphere(DVec3::ZERO, 1.0), GREY)])),
    }
}

fn sphere(center: DVec3, radius: f64) -> Shape<'static> {
    Shape::Sphere(Sphere { center, radius })
}

/// The cube with half of its edge: Tachyon turns the faces of other boxes.
fn cube(center: DVec3, half: f64) -> Shape<'static> {
    let [min, max] = [center - half, center + half].map(|corner| corner.to_array());
    Shape::Box(AxisAlignedBox { min, max })
}

/// A triangle, with the normals of its corners if it is smooth.
fn triangle([a, b, c]: [DVec3; 3], normals: Option<[DVec3; 3]>) -> Shape<'static> {
    let across = (b - a).cross(c - a);
    let geometric_normal = across.normalize();
    let longest = (b - a).length().max((c - a).length()).max((c - b).length());
    Shape::Triangle(Triangle {
        corners: [a, b, c],
        normals: normals.unwrap_or([geometric_normal; 3]),
        geometric_normal,
        scale: longest * longest * longest / across.length(),
    })
}

/// Objects of all colours, each made of random numbers of its own.
fn random(count: u32, make: impl Fn(usize, &mut Numbers) -> Shape<'static> + 'static) -> Objects {
    Box::new((0..count).map(move |i| {
        let index = i as usize;
        (make(index, &mut Numbers::new(0, i)), index % GREY)
    }))
}

/// Spheres anywhere in a cube around the origin, with radii between two.
fn scattered(count: u32, smallest: f64, largest: f64) -> Objects {
    random(count, move |_, numbers| {
        let center = numbers.in_cube(10.0);
        sphere(center, numbers.between(smallest, largest))
    })
}

/// Whether a sphere or cube is not too near to an eye or a lamp.
pub fn has_room(shape: &Shape, places: &[DVec3]) -> bool {
    let (center, radius) = match shape {
        Shape::Sphere(sphere) => (sphere.center, sphere.radius),
        Shape::Box(cube) => {
            let [a, b] = [cube.min, cube.max].map(DVec3::from);
            (a.midpoint(b), a.distance(b) / 2.0)
        }
        _ => return true,
    };
    let mut places = places.iter();
    places.all(|place| place.distance(center) > radius + 0.25)
}

/// A branch of a tree, and all branches that it bears. The transforms lead from its base to
/// the floor.
fn branches(base: &[DMat4]) -> Vec<(Shape<'static>, usize)> {
    const LEVELS: usize = 5;
    let level = base.len();
    let stretched = DMat4::from_scale(dvec3(0.12, 0.55, 0.12));
    let raised = DMat4::from_translation(DVec3::Y * 0.5) * stretched;
    let moved = |shape: Shape<'static>| {
        std::iter::once(&raised)
            .chain(base)
            .fold(shape, |shape, matrix| {
                let (matrix, inverse) = (*matrix, matrix.inverse());
                shape.transformed(&Transform { matrix, inverse })
            })
    };
    if level == LEVELS {
        return vec![(moved(cube(DVec3::ZERO, 1.0)), level)];
    }
    let mut objects = vec![(moved(sphere(DVec3::ZERO, 1.0)), level)];
    for i in 0..4 {
        let step = DMat4::from_translation(DVec3::Y * 0.95)
            * DMat4::from_rotation_y(TAU * (f64::from(i) / 4.0 + 0.05))
            * DMat4::from_rotation_z(0.7)
            * DMat4::from_scale(dvec3(0.7, 0.75, 0.65));
        objects.extend(branches(&[&[step], base].concat()));
    }
    objects
}

/// Thin triangles on a ball around the origin, evenly distributed.
fn hairs(count: u32) -> Objects {
    random(count, move |i, numbers| {
        let y = 1.0 - 2.0 * (i as f64 + 0.5) / f64::from(count);
        let (around, beside) = (numbers.between(0.0, TAU), libm::sqrt(1.0 - y * y));
        let root = dvec3(beside * libm::cos(around), y, beside * libm::sin(around));
        let tip = root + 1.5 * (root + numbers.in_cube(0.6)).normalize();
        let across = root.any_orthonormal_vector() * 0.0075;
        triangle([root - across, root + across, tip], None)
    })
}

/// The point of a torus of radii 2.5 and 1 around the y axis: `x` of its way around the
/// axis and `y` of its way around the tube, on which bumps have this height.
fn ring(x: f64, y: f64, bump: f64) -> DVec3 {
    let (a, b) = (TAU * x, TAU * y);
    let radius = 1.0 + bump * libm::sin(19.0 * a) * libm::sin(8.0 * b);
    let from_axis = 2.5 + radius * libm::cos(b);
    let (sin, cos) = libm::sincos(a);
    dvec3(from_axis * cos, radius * libm::sin(b), from_axis * sin)
}

/// The point of a hilly country above (x, z).
fn waves(x: f64, z: f64) -> DVec3 {
    let wave = |x_step: f64, z_step: f64| libm::sin(x * x_step + z * z_step);
    let height = wave(0.35, 0.2)
        + wave(-0.3, 0.55)
        + 0.4 * wave(1.3, 0.4) * wave(-0.7, 1.1)
        + 0.05 * wave(5.0, 1.0) * wave(2.0, -6.0);
    dvec3(x, height, z)
}

/// A mesh of two triangles in each cell of a lattice on a surface. Its points have two
/// parameters from 0 to 1; where it `is_closed`, it ends where it begins.
fn surface(steps: [usize; 2], is_closed: bool, point: impl Fn(f64, f64) -> DVec3) -> Objects {
    const STEP: f64 = 1e-5;
    let [rows, columns] = steps.map(|steps| steps + usize::from(!is_closed));
    let place = |n: usize| {
        let (x, y) = (n / columns, n % columns);
        let (x, y) = (x as f64 / steps[0] as f64, y as f64 / steps[1] as f64);
        let along = point(x + STEP, y) - point(x - STEP, y);
        let across = point(x, y + STEP) - point(x, y - STEP);
        (point(x, y), across.cross(along).normalize())
    };
    let places: Vec<_> = (0..rows * columns).map(place).collect();
    let triangles = (0..steps[0] * steps[1]).flat_map(move |n| {
        let (i, j) = (n / steps[1], n % steps[1]);
        let place = |i: usize, j: usize| places[(i % rows) * columns + j % columns];
        let [a, b, c, d] = [
            place(i, j),
            place(i, j + 1),
            place(i + 1, j),
            place(i + 1, j + 1),
        ];
        [[a, b, d], [a, d, c]].map(|corners| {
            let normals = Some(corners.map(|(_, normal)| normal));
            (triangle(corners.map(|(corner, _)| corner), normals), 1)
        })
    });
    Box::new(triangles)
}
