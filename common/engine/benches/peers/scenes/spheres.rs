//! Scenes of spheres.

use super::{FLOOR, around, camera, object, palette, random, white};
use crate::description::{Description, LightKind, Objects, Shape, Triple};

/// Nine mirroring spheres on a mirroring plane.
pub fn mirrors() -> Description {
    Description {
        name: "mirrors",
        about: "nine mirrors on a mirror, eight deep",
        is_incoherent: false,
        camera: camera([0.0, 7.0, 10.0], [0.0, -6.6, -10.0]),
        lights: white(LightKind::Point([6.0, 12.0, 5.0])),
        ambient: 0.1,
        depth: 8,
        materials: palette(0.5, 0.5),
        objects: || {
            let spheres = (0..9).map(|i| {
                let [x, z] = [i % 3, i / 3].map(|place| 2.5 * (place as f64 - 1.0));
                object(Shape::Sphere([x, 1.0, z], 1.0), i % 6)
            });
            Box::new(spheres.chain([FLOOR]))
        },
    }
}

/// A thousand shiny spheres.
pub fn spheres() -> Description {
    Description {
        name: "spheres",
        about: "1,000 spheres",
        is_incoherent: false,
        camera: camera([0.0, 8.0, 26.0], [0.0, -8.0, -26.0]),
        lights: white(LightKind::Point([15.0, 30.0, 25.0])),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.5, 0.0),
        objects: || scattered(1_000, 0.3, 0.8),
    }
}

/// A hundred thousand small spheres.
pub fn swarm() -> Description {
    Description {
        name: "swarm",
        about: "100,000 small spheres",
        objects: || scattered(100_000, 0.05, 0.15),
        ..spheres()
    }
}

/// Few large spheres among many small ones.
pub fn sizes() -> Description {
    const COUNT: u32 = 50_000;
    Description {
        name: "sizes",
        about: "50,000 spheres with radii from 0.003 to 3",
        camera: camera([0.0, 4.0, 14.0], [0.0, -4.0, -14.0]),
        objects: || {
            random(COUNT, |i, random| {
                let radius = 3.0 * libm::pow(f64::from(i + 1), -3.0 / libm::log10(COUNT.into()));
                Shape::Sphere(random.point([-10.0; 3], [10.0; 3]), radius)
            })
        },
        ..spheres()
    }
}

/// The eye and the lamp.
const IN_THE_CLOUD: [Triple; 2] = [[0.0; 3], [1.0, 1.5, -2.0]];

/// Eye and lamp are in the middle of mirroring spheres.
pub fn cloud() -> Description {
    let [eye, lamp] = IN_THE_CLOUD;
    Description {
        name: "cloud",
        about: "60,000 mirrors around eye and lamp, two deep",
        is_incoherent: true,
        camera: camera(eye, [0.0, 0.0, -1.0]),
        lights: white(LightKind::Point(lamp)),
        depth: 2,
        materials: palette(0.5, 0.5),
        objects: || around(IN_THE_CLOUD, scattered(60_000, 0.05, 0.15)),
        ..spheres()
    }
}

/// Spheres anywhere in a cube around the origin, with radii between two.
fn scattered(count: u32, smallest: f64, largest: f64) -> Objects {
    random(count, move |_, random| {
        let radius = random.between(smallest, largest, 3);
        Shape::Sphere(random.point([-10.0; 3], [10.0; 3]), radius)
    })
}
