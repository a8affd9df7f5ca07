//! The scenes that are compared, as one table.

use engine::{Disc, LightKind, Plane, Shape};
use glam::{DVec3, dvec3};

use super::objects::{
    branches, cube, floor, hairs, lamp, leaving_room, random, ring, scattered, sphere, spot, sun,
    surface, triangle, waves,
};
use super::scene::{GREY, Scene, color};

/// The scene from which the others differ.
const SPHERES: Scene = Scene {
    name: "spheres",
    about: "1,000 spheres",
    view: [dvec3(0.0, 8.0, 26.0), dvec3(0.0, -8.0, -26.0)],
    lights: || vec![lamp(dvec3(15.0, 30.0, 25.0))],
    depth: 1,
    shares: [0.5, 0.0],
    objects: || scattered(1_000, 0.3, 0.8),
};

/// All scenes, in the order of the tables.
pub const SCENES: [Scene; 14] = [
    Scene {
        name: "mirrors",
        about: "nine mirrors on a mirror, eight deep",
        view: [dvec3(0.0, 7.0, 10.0), dvec3(0.0, -6.6, -10.0)],
        lights: || vec![lamp(dvec3(6.0, 12.0, 5.0))],
        depth: 8,
        shares: [0.5, 0.5],
        objects: || {
            let spheres = (0..9).map(|i| {
                let [x, z] = [i % 3, i / 3].map(|place| 2.5 * (place as f64 - 1.0));
                (sphere(dvec3(x, 1.0, z), 1.0), i % GREY)
            });
            Box::new(spheres.chain([floor()]))
        },
    },
    Scene {
        name: "objects",
        about: "the course's four objects",
        view: [dvec3(4.0, 4.0, 4.0), dvec3(-1.0, -1.0, -1.0)],
        lights: || vec![sun(DVec3::ONE, dvec3(-1.0, -3.0, -2.0))],
        shares: [0.0, 0.0],
        objects: || {
            let corners = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 1.0, -1.0]];
            let sphere = sphere(DVec3::ONE, 0.5);
            let cube = cube(dvec3(-1.0, 1.0, 1.0), 0.5);
            let triangle = triangle(corners.map(DVec3::from), None);
            Box::new([(floor().0, 0), (sphere, 1), (cube, 2), (triangle, 3)].into_iter())
        },
        ..SPHERES
    },
    SPHERES,
    Scene {
        name: "torus",
        about: "20,000 triangles of a ring",
        view: [dvec3(0.0, 5.0, 6.5), dvec3(0.0, -5.8, -6.5)],
        lights: || vec![lamp(dvec3(8.0, 6.0, 2.0))],
        objects: || surface([200, 50], true, |x, y| ring(x, y, 0.0)),
        ..SPHERES
    },
    Scene {
        name: "swarm",
        about: "100,000 small spheres",
        objects: || scattered(100_000, 0.05, 0.15),
        ..SPHERES
    },
    Scene {
        name: "sizes",
        about: "50,000 spheres with radii from 0.003 to 3",
        view: [dvec3(0.0, 4.0, 14.0), dvec3(0.0, -4.0, -14.0)],
        objects: || {
            random(50_000, |i, numbers| {
                let radius = 3.0 * libm::pow((i + 1) as f64, -3.0 / libm::log10(50_000.0));
                sphere(numbers.in_cube(10.0), radius)
            })
        },
        ..SPHERES
    },
    Scene {
        name: "cloud",
        about: "60,000 mirrors around eye and lamp, two deep",
        view: [DVec3::ZERO, dvec3(0.0, 0.0, -1.0)],
        lights: || vec![lamp(dvec3(1.0, 1.5, -2.0))],
        depth: 2,
        shares: [0.5, 0.5],
        objects: || {
            let spheres = scattered(60_000, 0.05, 0.15);
            leaving_room([DVec3::ZERO, dvec3(1.0, 1.5, -2.0)], spheres)
        },
    },
    Scene {
        name: "boxes",
        about: "800 mirroring boxes above a mirror, four deep",
        view: [dvec3(0.0, 3.0, 9.0), dvec3(0.0, -0.5, -9.0)],
        lights: || vec![lamp(dvec3(2.0, 6.0, 4.0))],
        depth: 4,
        shares: [0.5, 0.5],
        objects: || {
            let cubes = random(800, |_, numbers| {
                let center = numbers.in_box(dvec3(-10.0, 0.5, -10.0), dvec3(10.0, 7.0, 10.0));
                cube(center, numbers.between(0.15, 0.45))
            });
            let cubes = leaving_room([dvec3(0.0, 3.0, 9.0), dvec3(2.0, 6.0, 4.0)], cubes);
            Box::new(cubes.chain([floor()]))
        },
    },
    Scene {
        name: "discs",
        about: "5,000 discs",
        objects: || {
            random(5_000, |_, numbers| {
                let (point, normal) = (numbers.in_cube(10.0), numbers.in_cube(1.0).normalize());
                let plane = Plane { point, normal };
                let radius = numbers.between(0.2, 0.5);
                Shape::Disc(Disc { plane, radius })
            })
        },
        ..SPHERES
    },
    Scene {
        name: "nodes",
        about: "1,365 nodes, turned and stretched, nested six deep",
        view: [dvec3(0.0, 2.2, 4.6), dvec3(0.0, -1.0, -4.6)],
        lights: || vec![lamp(dvec3(6.0, 9.0, 5.0))],
        objects: || Box::new(branches(&[]).into_iter().chain([floor()])),
        ..SPHERES
    },
    Scene {
        name: "lamps",
        about: "two points, three spots and a far light on 300 solids",
        view: [dvec3(0.0, 7.0, 13.0), dvec3(0.0, -7.0, -12.0)],
        lights: || {
            let point = |light, position| {
                let color = color(light);
                LightKind::Point { color, position }
            };
            vec![
                point(dvec3(0.4, 0.3, 0.2), dvec3(-9.0, 5.0, 6.0)),
                point(dvec3(0.2, 0.3, 0.4), dvec3(9.0, 5.0, 6.0)),
                sun(DVec3::splat(0.3), dvec3(1.0, -2.0, -1.0)),
                spot(dvec3(0.6, 0.2, 0.2), -6.0, 0.0),
                spot(dvec3(0.2, 0.6, 0.2), 6.0, 0.0),
                spot(dvec3(0.2, 0.2, 0.6), 0.0, 6.0),
            ]
        },
        depth: 2,
        shares: [0.5, 0.2],
        objects: || {
            let solids = random(300, |i, numbers| {
                let center = numbers.in_cube(10.0);
                let half = numbers.between(0.15, 0.6);
                let center = center.with_y(half);
                match (i / 6) % 2 {
                    0 => sphere(center, half),
                    _ => cube(center, half),
                }
            });
            Box::new(solids.chain([floor()]))
        },
    },
    Scene {
        name: "mesh",
        about: "90,000 mirroring triangles of a bumpy ring above a mirror, three deep",
        view: [dvec3(0.0, 5.5, 11.0), dvec3(0.0, -2.4, -11.0)],
        lights: || vec![lamp(dvec3(6.0, 12.0, 8.0))],
        depth: 3,
        shares: [0.5, 0.4],
        objects: || {
            let mesh = surface([450, 100], true, |x, y| {
                let ring = ring(x, y, 0.1);
                dvec3(ring.x, 3.8 - ring.z, ring.y)
            });
            Box::new(mesh.chain([floor()]))
        },
    },
    Scene {
        name: "hills",
        about: "204,800 triangles of hills under a low sun",
        view: [dvec3(0.0, 7.0, 22.0), dvec3(0.0, -6.0, -22.0)],
        lights: || vec![sun(DVec3::ONE, dvec3(-1.0, -0.35, -0.3))],
        objects: || {
            surface([320; 2], false, |x, z| {
                waves(40.0 * x - 20.0, 40.0 * z - 20.0)
            })
        },
        ..SPHERES
    },
    Scene {
        name: "hairs",
        about: "10,000 triangles, 100 times as long as wide",
        view: [dvec3(0.0, 1.0, 6.2), dvec3(0.0, -1.0, -6.2)],
        lights: || vec![lamp(dvec3(6.0, 9.0, 8.0))],
        shares: [0.3, 0.0],
        objects: || Box::new(hairs(10_000).chain([(sphere(DVec3::ZERO, 1.0), GREY)])),
        ..SPHERES
    },
];
