//! Scenes of triangles.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{FLOOR, GREY, camera, object, palette, random, white};
use crate::description::{Description, LightKind, Mesh, Object, Shape};

/// A ring of 20,000 smooth triangles.
pub fn torus() -> Description {
    Description {
        name: "torus",
        about: "20,000 triangles of a ring",
        is_incoherent: false,
        camera: camera([0.0, 5.0, 6.5], [0.0, -5.8, -6.5]),
        lights: white(LightKind::Point([8.0, 6.0, 2.0])),
        ambient: 0.1,
        depth: 1,
        materials: palette(0.5, 0.0),
        objects: || of_mesh(surface([200, 50], true, |x, y| ring(x, y, 0.0))),
    }
}

/// A ring with bumps stands on a mirror.
pub fn mesh() -> Description {
    Description {
        name: "mesh",
        about: "90,000 mirroring triangles of a bumpy ring above a mirror, three deep",
        depth: 3,
        camera: camera([0.0, 5.5, 11.0], [0.0, -2.4, -11.0]),
        lights: white(LightKind::Point([6.0, 12.0, 8.0])),
        materials: palette(0.5, 0.4),
        objects: || {
            let mesh = surface([450, 100], true, |x, y| {
                let ring = ring(x, y, 0.1);
                DVec3::new(ring.x, 3.8 - ring.z, ring.y)
            });
            Box::new(of_mesh(mesh).chain([FLOOR]))
        },
        ..torus()
    }
}

/// Hills under a low sun.
pub fn hills() -> Description {
    Description {
        name: "hills",
        about: "204,800 triangles of hills under a low sun",
        camera: camera([0.0, 7.0, 22.0], [0.0, -6.0, -22.0]),
        lights: white(LightKind::Directional([-1.0, -0.35, -0.3])),
        objects: || {
            of_mesh(surface([320; 2], false, |x, z| {
                let (x, z) = (40.0 * x - 20.0, 40.0 * z - 20.0);
                let wave = |x_step: f64, z_step: f64| libm::sin(x * x_step + z * z_step);
                let height = wave(0.35, 0.2)
                    + wave(-0.3, 0.55)
                    + 0.4 * wave(1.3, 0.4) * wave(-0.7, 1.1)
                    + 0.05 * wave(5.0, 1.0) * wave(2.0, -6.0);
                DVec3::new(x, height, z)
            }))
        },
        ..torus()
    }
}

/// A ball with hair.
pub fn hairs() -> Description {
    const COUNT: u32 = 10_000;
    Description {
        name: "hairs",
        about: "10,000 triangles, 100 times as long as wide",
        camera: camera([0.0, 1.0, 6.2], [0.0, -1.0, -6.2]),
        lights: white(LightKind::Point([6.0, 9.0, 8.0])),
        materials: palette(0.3, 0.0),
        objects: || {
            let hairs = random(COUNT, |i, random| {
                // Points evenly distributed on a sphere.
                let y = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(COUNT);
                let (around, beside) = (random.between(0.0, TAU, 0), libm::sqrt(1.0 - y * y));
                let root = DVec3::new(beside * libm::cos(around), y, beside * libm::sin(around));
                let bent = DVec3::from([1, 2, 3].map(|n| random.between(-0.6, 0.6, n)));
                let tip = root + 1.5 * (root + bent).normalize();
                let across = root.any_orthonormal_vector() * 0.0075;
                Shape::Triangle([root - across, root + across, tip].map(Into::into))
            });
            Box::new(hairs.chain([object(Shape::Sphere([0.0; 3], 1.0), GREY)]))
        },
        ..torus()
    }
}

fn of_mesh(mesh: Mesh) -> Box<dyn Iterator<Item = Object>> {
    Box::new(std::iter::once(object(Shape::Mesh(mesh), 1)))
}

/// The point of a torus of radii 2.5 and 1 around the y axis: `x` of its way around the
/// axis and `y` of its way around the tube, on which bumps have this height.
fn ring(x: f64, y: f64, bump: f64) -> DVec3 {
    let (a, b) = (TAU * x, TAU * y);
    let radius = 1.0 + bump * libm::sin(19.0 * a) * libm::sin(8.0 * b);
    let from_axis = 2.5 + radius * libm::cos(b);
    DVec3::new(
        from_axis * libm::cos(a),
        radius * libm::sin(b),
        from_axis * libm::sin(a),
    )
}

/// Two triangles in each cell of a lattice on a surface. Its points have two parameters
/// from 0 to 1; where it `is_closed`, it ends where it begins.
fn surface(steps: [usize; 2], is_closed: bool, point: impl Fn(f64, f64) -> DVec3) -> Mesh {
    let [rows, columns] = steps.map(|steps| steps + usize::from(!is_closed));
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
    let place = |[i, j]: [usize; 2]| [i as f64 / steps[0] as f64, j as f64 / steps[1] as f64];
    let normal = |[x, y]: [f64; 2]| {
        const STEP: f64 = 1e-5;
        let along = point(x + STEP, y) - point(x - STEP, y);
        let across = point(x, y + STEP) - point(x, y - STEP);
        across.cross(along).normalize().to_array()
    };
    let index = |i: usize, j: usize| ((i % rows) * columns + j % columns) as u32;
    let cells = (0..steps[0]).flat_map(|i| (0..steps[1]).map(move |j| (i, j)));
    Mesh {
        corners: (places.clone().map(place))
            .map(|[x, y]| point(x, y).to_array())
            .collect(),
        normals: places.map(place).map(normal).collect(),
        triangles: cells
            .flat_map(|(i, j)| {
                let [a, b] = [index(i, j), index(i, j + 1)];
                let [c, d] = [index(i + 1, j), index(i + 1, j + 1)];
                [[a, b, d], [a, d, c]]
            })
            .collect(),
    }
}
