//! Makes the lights and objects of the scenes.

use std::f64::consts::TAU;

use glam::{DMat4, DVec3, dvec3};

use super::Numbers;
use super::scene::{GREY, Item, Items, Kind, item};

pub fn lamp(position: DVec3) -> Item {
    item(Kind::Point, &[DVec3::ONE, position], 0)
}

pub fn sun(color: DVec3, direction: DVec3) -> Item {
    let direction = direction.normalize();
    item(
        Kind::Directional,
        &[color, direction * -1000.0, direction],
        0,
    )
}

/// A cone from above towards the middle of the floor.
pub fn spot(color: DVec3, x: f64, z: f64) -> Item {
    let (position, direction) = (dvec3(x, 9.0, z), dvec3(-x, -9.0, -z - 2.0).normalize());
    let (target, angle) = (position + direction, DVec3::splat(18.0));
    item(Kind::Spot, &[color, position, direction, target, angle], 0)
}

pub fn floor() -> Item {
    item(Kind::Plane, &[DVec3::Y], GREY)
}

pub fn sphere(center: DVec3, radius: f64, color: usize) -> Item {
    item(Kind::Sphere, &[center, DVec3::splat(radius)], color)
}

/// The cube with half of its edge.
pub fn cube(center: DVec3, half: f64, color: usize) -> Item {
    item(Kind::Cube, &[center - half, center + half], color)
}

/// Objects of all colours, each made of random numbers of its own.
pub fn random(count: u32, make: impl Fn(usize, &mut Numbers) -> Item + 'static) -> Items {
    Box::new((0..count).map(move |i| Item {
        color: i as usize % GREY,
        ..make(i as usize, &mut Numbers::new(0, i))
    }))
}

/// Spheres anywhere in a cube around the origin, with radii between two.
pub fn scattered(count: u32, smallest: f64, largest: f64) -> Items {
    random(count, move |_, numbers| {
        let center = numbers.in_cube(10.0);
        sphere(center, numbers.between(smallest, largest), 0)
    })
}

/// The spheres and cubes that are not too near to an eye or a lamp.
pub fn leaving_room(places: [DVec3; 2], objects: Items) -> Items {
    const ROOM: f64 = 0.25;
    Box::new(objects.filter(move |object| {
        let [a, b, ..] = object.vectors;
        let (center, radius) = match object.kind {
            Kind::Cube => (a.midpoint(b), a.distance(b) / 2.0),
            _ => (a, b.x),
        };
        let mut distances = places.iter().map(|place| place.distance(center));
        distances.all(|distance| distance > radius + ROOM)
    }))
}

/// A branch of a tree, and all branches that it bears. The transforms lead from its base to
/// the floor.
pub fn branches(base: &[DMat4]) -> Vec<Item> {
    const LEVELS: usize = 5;
    let level = base.len();
    let stretched = DMat4::from_scale(dvec3(0.12, 0.55, 0.12));
    let raised = DMat4::from_translation(DVec3::Y * 0.5) * stretched;
    let transform = |matrix: &DMat4| {
        let columns = [0, 1, 2, 3].map(|i| matrix.col(i).truncate());
        item(Kind::Transform, &columns, 0)
    };
    let mut items: Vec<_> = std::iter::once(&raised)
        .chain(base)
        .map(transform)
        .collect();
    if level == LEVELS {
        items.push(cube(DVec3::ZERO, 1.0, level));
        return items;
    }
    items.push(sphere(DVec3::ZERO, 1.0, level));
    for i in 0..4 {
        let step = DMat4::from_translation(DVec3::Y * 0.95)
            * DMat4::from_rotation_y(TAU * (f64::from(i) / 4.0 + 0.05))
            * DMat4::from_rotation_z(0.7)
            * DMat4::from_scale(dvec3(0.7, 0.75, 0.65));
        items.extend(branches(&[&[step], base].concat()));
    }
    items
}

/// Thin triangles on a ball around the origin, evenly distributed.
pub fn hairs(count: u32) -> Items {
    random(count, move |i, numbers| {
        let y = 1.0 - 2.0 * (i as f64 + 0.5) / f64::from(count);
        let (around, beside) = (numbers.between(0.0, TAU), libm::sqrt(1.0 - y * y));
        let root = dvec3(beside * libm::cos(around), y, beside * libm::sin(around));
        let tip = root + 1.5 * (root + numbers.in_cube(0.6)).normalize();
        let across = root.any_orthonormal_vector() * 0.0075;
        item(Kind::Triangle, &[root - across, root + across, tip], 0)
    })
}

/// The point of a torus of radii 2.5 and 1 around the y axis: `x` of its way around the
/// axis and `y` of its way around the tube, on which bumps have this height.
pub fn ring(x: f64, y: f64, bump: f64) -> DVec3 {
    let (a, b) = (TAU * x, TAU * y);
    let radius = 1.0 + bump * libm::sin(19.0 * a) * libm::sin(8.0 * b);
    let from_axis = 2.5 + radius * libm::cos(b);
    let (sin, cos) = libm::sincos(a);
    dvec3(from_axis * cos, radius * libm::sin(b), from_axis * sin)
}

/// The point of a hilly country above (x, z).
pub fn waves(x: f64, z: f64) -> DVec3 {
    let wave = |x_step: f64, z_step: f64| libm::sin(x * x_step + z * z_step);
    let height = wave(0.35, 0.2)
        + wave(-0.3, 0.55)
        + 0.4 * wave(1.3, 0.4) * wave(-0.7, 1.1)
        + 0.05 * wave(5.0, 1.0) * wave(2.0, -6.0);
    dvec3(x, height, z)
}

/// A mesh of two triangles in each cell of a lattice on a surface. Its points have two
/// parameters from 0 to 1; where it `is_closed`, it ends where it begins.
pub fn surface(steps: [usize; 2], is_closed: bool, point: impl Fn(f64, f64) -> DVec3) -> Items {
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
        [[a, b, d], [a, d, c]]
            .map(|[a, b, c]| item(Kind::Smooth, &[a.0, b.0, c.0, a.1, b.1, c.1], 1))
    });
    let [begin, end] = [Kind::Mesh, Kind::EndOfMesh].map(|kind| item(kind, &[], 1));
    Box::new(std::iter::once(begin).chain(triangles).chain([end]))
}
