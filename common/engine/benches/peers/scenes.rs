//! The scenes, by kind, and the camera that they share.

mod meshes;
mod solids;
mod spheres;

use std::f64::consts::FRAC_PI_4;

use glam::DVec3;

use crate::description::{
    Camera, Description, Light, LightKind, Material, Object, Objects, Shape, Triple,
};
use crate::random::PixelRandom;

/// All scenes.
pub fn all() -> Vec<Description> {
    vec![
        spheres::mirrors(),
        solids::objects(),
        spheres::spheres(),
        meshes::torus(),
        spheres::swarm(),
        spheres::sizes(),
        spheres::cloud(),
        solids::boxes(),
        solids::discs(),
        solids::nodes(),
        solids::lamps(),
        meshes::mesh(),
        meshes::hills(),
        meshes::hairs(),
    ]
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

/// A single white light.
fn white(kind: LightKind) -> Vec<Light> {
    let color = [1.0; 3];
    vec![Light { color, kind }]
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

const COLORS: u32 = 6;
const GREY: usize = 6;

const fn object(shape: Shape, material: usize) -> Object {
    Object { shape, material }
}

const FLOOR: Object = object(Shape::Plane([0.0, 1.0, 0.0]), GREY);

/// Shapes of all colours, each made of random numbers of its own.
fn random(count: u32, shape: impl Fn(u32, Random) -> Shape + 'static) -> Objects {
    Box::new((0..count).map(move |i| {
        let random = Random(PixelRandom::new(0, i, 0));
        object(shape(i, random), (i % COLORS) as usize)
    }))
}

/// The spheres and cubes that leave room for eye and lamp.
fn around(places: [Triple; 2], objects: Objects) -> Objects {
    const ROOM: f64 = 0.25;
    Box::new(objects.filter(move |object| {
        let (center, radius) = match object.shape {
            Shape::Sphere(center, radius) => (center, radius),
            Shape::Cube(center, half) => (center, half * libm::sqrt(3.0)),
            _ => return true,
        };
        let distance = |place| DVec3::from(place).distance(center.into());
        places.iter().all(|place| distance(*place) > radius + ROOM)
    }))
}

/// The random numbers of an object.
#[derive(Clone, Copy)]
struct Random(PixelRandom);

impl Random {
    /// The `n`-th number, between two.
    fn between(self, from: f64, to: f64, n: u64) -> f64 {
        from + (to - from) * self.0.uniform(n)
    }

    /// The numbers 0, 1 and 2: a point anywhere between two corners.
    fn point(self, from: Triple, to: Triple) -> Triple {
        [0, 1, 2].map(|axis| self.between(from[axis], to[axis], axis as u64))
    }
}
