//! Makes the objects of the scenes.

use std::f64::consts::TAU;

use engine::{AxisAlignedBox, Disc, Plane, Shape, Sphere, Transform, Triangle};
use glam::{DMat4, DVec3, dvec3};

use super::Numbers;

/// A shape, and the index of its colour.
pub struct Object {
    pub shape: Shape<'static>,
    pub color: usize,
}

/// Objects made one after the other: a list of them would count among the memory of the program
/// that we measure.
pub type Objects = Box<dyn Iterator<Item = Object>>;

/// The index of the dark grey, which is also the number of colours before it.
const GREY: usize = 6;

/// The objects of a scene, but the floor.
pub fn objects(scene: &str) -> Objects {
    match scene {
        "objects" => Box::new(one_of_each().into_iter()),
        "sizes" => random(50_000, of_any_size),
        "boxes" => random(800, floating_cube),
        "discs" => random(5_000, disc),
        "nodes" => Box::new(branches(&[]).into_iter()),
        "lamps" => random(300, standing_on_the_floor),
        "hills" => surface(320, |x, z| waves(40.0 * x - 20.0, 40.0 * z - 20.0)),
        _ => {
            let head = Object {
                shape: sphere(DVec3::ZERO, 1.0),
                color: GREY,
            };
            Box::new(hairs(10_000).chain([head]))
        }
    }
}

fn one_of_each() -> [Object; 3] {
    let corners = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 1.0, -1.0]];
    [
        Object {
            shape: sphere(DVec3::ONE, 0.5),
            color: 1,
        },
        Object {
            shape: cube(dvec3(-1.0, 1.0, 1.0), 0.5),
            color: 2,
        },
        Object {
            shape: triangle(corners.map(DVec3::from), None),
            color: 3,
        },
    ]
}

/// The `i`-th of 50,000 spheres, whose radii fall from 3 to 0.003.
fn of_any_size(i: usize, numbers: &mut Numbers) -> Shape<'static> {
    let radius = 3.0 * libm::pow((i + 1) as f64, -3.0 / libm::log10(50_000.0));
    sphere(numbers.in_cube(10.0), radius)
}

fn floating_cube(_: usize, numbers: &mut Numbers) -> Shape<'static> {
    let center = numbers.in_box(dvec3(-10.0, 0.5, -10.0), dvec3(10.0, 7.0, 10.0));
    cube(center, numbers.between(0.15, 0.45))
}

fn disc(_: usize, numbers: &mut Numbers) -> Shape<'static> {
    let plane = Plane {
        point: numbers.in_cube(10.0),
        normal: numbers.in_cube(1.0).normalize(),
    };
    let radius = numbers.between(0.2, 0.5);
    Shape::Disc(Disc { plane, radius })
}

/// A ball or a cube.
fn standing_on_the_floor(i: usize, numbers: &mut Numbers) -> Shape<'static> {
    let center = numbers.in_cube(10.0);
    let half = numbers.between(0.15, 0.6);
    let center = center.with_y(half);
    if (i / 6).is_multiple_of(2) {
        sphere(center, half)
    } else {
        cube(center, half)
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
        Object {
            shape: make(index, &mut Numbers::new(0, i)),
            color: index % GREY,
        }
    }))
}

/// Whether a sphere or cube is not too near to an eye or a lamp.
pub fn has_room(shape: &Shape, kept_free: &[DVec3]) -> bool {
    let (center, radius) = match shape {
        Shape::Sphere(sphere) => (sphere.center, sphere.radius),
        Shape::Box(cube) => {
            let [a, b] = [cube.min, cube.max].map(DVec3::from);
            (a.midpoint(b), a.distance(b) / 2.0)
        }
        _ => return true,
    };
    let mut kept_free = kept_free.iter();
    kept_free.all(|point| point.distance(center) > radius + 0.25)
}

/// A branch of a tree, and all branches that it bears. The transforms lead from its base to
/// the floor.
fn branches(base: &[DMat4]) -> Vec<Object> {
    const LEVELS: usize = 5;
    let level = base.len();
    let shape = if level == LEVELS {
        cube(DVec3::ZERO, 1.0)
    } else {
        sphere(DVec3::ZERO, 1.0)
    };
    let mut objects = vec![Object {
        shape: branch(shape, base),
        color: level,
    }];
    if level == LEVELS {
        return objects;
    }
    for i in 0..4 {
        let step = DMat4::from_translation(DVec3::Y * 0.95)
            * DMat4::from_rotation_y(TAU * (f64::from(i) / 4.0 + 0.05))
            * DMat4::from_rotation_z(0.7)
            * DMat4::from_scale(dvec3(0.7, 0.75, 0.65));
        objects.extend(branches(&[&[step], base].concat()));
    }
    objects
}

/// A shape stretched into a branch that stands on its base.
fn branch(mut shape: Shape<'static>, base: &[DMat4]) -> Shape<'static> {
    let stretched = DMat4::from_scale(dvec3(0.12, 0.55, 0.12));
    let raised = DMat4::from_translation(DVec3::Y * 0.5) * stretched;
    for matrix in [&raised].into_iter().chain(base) {
        shape = shape.transformed(&Transform::new(*matrix, matrix.inverse()));
    }
    shape
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

/// The point of a hilly country above (x, z).
fn waves(x: f64, z: f64) -> DVec3 {
    let wave = |x_step: f64, z_step: f64| libm::sin(x * x_step + z * z_step);
    let height = wave(0.35, 0.2)
        + wave(-0.3, 0.55)
        + 0.4 * wave(1.3, 0.4) * wave(-0.7, 1.1)
        + 0.05 * wave(5.0, 1.0) * wave(2.0, -6.0);
    dvec3(x, height, z)
}

/// A point of a mesh.
#[derive(Clone, Copy)]
struct Vertex {
    position: DVec3,
    normal: DVec3,
}

impl Vertex {
    /// The point at two parameters of a surface, with the normal by differences.
    fn new(x: f64, y: f64, point: impl Fn(f64, f64) -> DVec3) -> Self {
        const STEP: f64 = 1e-5;
        let along = point(x + STEP, y) - point(x - STEP, y);
        let across = point(x, y + STEP) - point(x, y - STEP);
        Self {
            position: point(x, y),
            normal: across.cross(along).normalize(),
        }
    }
}

/// A mesh of two triangles in each cell of a square lattice on a surface, whose points have two
/// parameters from 0 to 1.
fn surface(steps: usize, point: impl Fn(f64, f64) -> DVec3) -> Objects {
    let mut vertices = Vec::with_capacity((steps + 1) * (steps + 1));
    for i in 0..=steps {
        for j in 0..=steps {
            let [x, y] = [i, j].map(|index| index as f64 / steps as f64);
            vertices.push(Vertex::new(x, y, &point));
        }
    }
    let triangles = (0..steps * steps).flat_map(move |cell| {
        let (i, j) = (cell / steps, cell % steps);
        let vertex = |i: usize, j: usize| vertices[i * (steps + 1) + j];
        let (a, b) = (vertex(i, j), vertex(i, j + 1));
        let (c, d) = (vertex(i + 1, j), vertex(i + 1, j + 1));
        [smooth([a, b, d]), smooth([a, d, c])]
    });
    Box::new(triangles)
}

fn smooth(vertices: [Vertex; 3]) -> Object {
    let corners = vertices.map(|vertex| vertex.position);
    let normals = vertices.map(|vertex| vertex.normal);
    Object {
        shape: triangle(corners, Some(normals)),
        color: 1,
    }
}
