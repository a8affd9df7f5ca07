//! Scenes of other solids, of nodes, and of many lights.

use std::f64::consts::TAU;

use glam::{DMat4, DVec3};

use super::{COLORS, FLOOR, around, camera, object, palette, random, white};
use crate::description::{Description, Light, LightKind, Object, Shape, Triple};

/// The four objects of the course, matt and under a far light.
pub fn objects() -> Description {
    Description {
        name: "objects",
        about: "the course's four objects",
        is_incoherent: false,
        camera: camera([4.0; 3], [-1.0; 3]),
        lights: white(LightKind::Directional([-1.0, -3.0, -2.0])),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.0, 0.0),
        objects: || {
            let triangle = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 1.0, -1.0]];
            Box::new(
                [
                    Shape::Plane([0.0, 1.0, 0.0]),
                    Shape::Sphere([1.0; 3], 0.5),
                    Shape::Cube([-1.0, 1.0, 1.0], 0.5),
                    Shape::Triangle(triangle),
                ]
                .into_iter()
                .zip(0..)
                .map(|(shape, material)| object(shape, material)),
            )
        },
    }
}

/// The eye and the lamp.
const AMONG_BOXES: [Triple; 2] = [[0.0, 3.0, 9.0], [2.0, 6.0, 4.0]];

/// Mirroring cubes hover above a mirror, and the eye and the lamp among them.
pub fn boxes() -> Description {
    let [eye, lamp] = AMONG_BOXES;
    Description {
        name: "boxes",
        about: "800 mirroring boxes above a mirror, four deep",
        is_incoherent: true,
        camera: camera(eye, [0.0, -0.5, -9.0]),
        lights: white(LightKind::Point(lamp)),
        depth: 4,
        materials: palette(0.5, 0.5),
        objects: || {
            let cubes = random(800, |_, random| {
                let center = random.point([-10.0, 0.5, -10.0], [10.0, 7.0, 10.0]);
                Shape::Cube(center, random.between(0.15, 0.45, 3))
            });
            around(AMONG_BOXES, Box::new(cubes.chain([FLOOR])))
        },
        ..objects()
    }
}

/// Coins in the air.
pub fn discs() -> Description {
    Description {
        name: "discs",
        about: "5,000 discs",
        camera: camera([0.0, 8.0, 26.0], [0.0, -8.0, -26.0]),
        lights: white(LightKind::Point([15.0, 30.0, 25.0])),
        materials: palette(0.5, 0.0),
        objects: || {
            random(5_000, |_, random| {
                let normal = [3, 4, 5].map(|n| random.between(-1.0, 1.0, n));
                let center = random.point([-10.0; 3], [10.0; 3]);
                Shape::Disc(center, normal, random.between(0.2, 0.5, 6))
            })
        },
        ..objects()
    }
}

/// A tree whose branches carry branches.
pub fn nodes() -> Description {
    Description {
        name: "nodes",
        about: "1,365 nodes, turned and stretched, nested six deep",
        camera: camera([0.0, 2.2, 4.6], [0.0, -1.0, -4.6]),
        lights: white(LightKind::Point([6.0, 9.0, 5.0])),
        materials: palette(0.5, 0.0),
        objects: || {
            let mut branches = Vec::new();
            branch(&[], &mut branches);
            Box::new(branches.into_iter().chain([FLOOR]))
        },
        ..objects()
    }
}

/// How often a branch bears branches.
const LEVELS: usize = 5;

/// A branch and all that it bears. The transforms lead from its base to the floor, the
/// outermost first.
fn branch(outwards: &[DMat4], branches: &mut Vec<Object>) {
    let level = outwards.len();
    let thickness = DVec3::new(0.12, 0.55, 0.12);
    let stretched = DMat4::from_translation(DVec3::Y * 0.5) * DMat4::from_scale(thickness);
    let shape = match level {
        LEVELS => Shape::Cube([0.0; 3], 1.0),
        _ => Shape::Sphere([0.0; 3], 1.0),
    };
    let steps = [stretched]
        .into_iter()
        .chain(outwards.iter().rev().copied());
    branches.push(object(Shape::Node(Box::new(shape), steps.collect()), level));
    if level < LEVELS {
        for i in 0..4 {
            let turned = DMat4::from_rotation_y(TAU * (f64::from(i) / 4.0 + 0.05));
            let step = DMat4::from_translation(DVec3::Y * 0.95)
                * turned
                * DMat4::from_rotation_z(0.7)
                * DMat4::from_scale(DVec3::new(0.7, 0.75, 0.65));
            branch(&[outwards, &[step]].concat(), branches);
        }
    }
}

/// Spheres and cubes on a floor, under lights of all kinds.
pub fn lamps() -> Description {
    let light = |color, kind| Light { color, kind };
    let spot = |color, [x, z]: [f64; 2]| {
        light(
            color,
            LightKind::Spot([x, 9.0, z], [-x, -9.0, -z - 2.0], 18.0),
        )
    };
    Description {
        name: "lamps",
        about: "two points, three spots and a far light on 300 solids",
        camera: camera([0.0, 7.0, 13.0], [0.0, -7.0, -12.0]),
        lights: vec![
            light([0.4, 0.3, 0.2], LightKind::Point([-9.0, 5.0, 6.0])),
            light([0.2, 0.3, 0.4], LightKind::Point([9.0, 5.0, 6.0])),
            light([0.3; 3], LightKind::Directional([1.0, -2.0, -1.0])),
            spot([0.6, 0.2, 0.2], [-6.0, 0.0]),
            spot([0.2, 0.6, 0.2], [6.0, 0.0]),
            spot([0.2, 0.2, 0.6], [0.0, 6.0]),
        ],
        depth: 2,
        materials: palette(0.5, 0.2),
        objects: || {
            let solids = random(300, |i, random| {
                let [x, _, z] = random.point([-10.0; 3], [10.0; 3]);
                let half = random.between(0.15, 0.6, 3);
                match (i / COLORS) % 2 {
                    0 => Shape::Sphere([x, half, z], half),
                    _ => Shape::Cube([x, half, z], half),
                }
            });
            Box::new(solids.chain([FLOOR]))
        },
        ..objects()
    }
}
