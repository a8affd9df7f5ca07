//! `Scene`: a scene of the benchmarks, a row of `scenes.md`, which makes the engine's.
//!
//! The background is black, because Tachyon paints it, unweakened, where the last mirror
//! that a ray may meet would show something. All lights cast shadows: Tachyon has no other.

use std::sync::LazyLock;

use common::{Color, Settings};
use engine::{Camera, Emitter, Light, Phong, Plane, Renderer, Shading, Shape, Surface};
use glam::DVec3;

use super::objects::{Object, has_room, objects};

/// The scenes in the order of the tables.
pub static SCENES: LazyLock<Vec<Scene>> = LazyLock::new(|| {
    let mut scenes = Vec::new();
    for row in include_str!("scenes.md").lines().skip(2) {
        let mut cells = row.split('|').skip(1).map(str::trim);
        let mut cell = || cells.next().unwrap_or_default();
        scenes.push(Scene {
            name: cell(),
            about: cell(),
            eye: vectors(cell())[0],
            gaze: vectors(cell())[0],
            depth: cell().parse().expect("a depth"),
            shine: vectors(cell())[0],
            floor: cell().parse().ok(),
            lights: cell(),
        });
    }
    scenes
});

/// A scene in numbers.
#[derive(Clone, Copy)]
pub struct Scene {
    pub name: &'static str,
    pub about: &'static str,
    /// The position of the camera.
    pub eye: DVec3,
    /// The direction in which it looks.
    gaze: DVec3,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    /// Highlight, mirror and exponent, the same for all materials.
    shine: DVec3,
    /// The color of the plane through the origin, if there is one: Tachyon misplaces others.
    floor: Option<usize>,
    lights: &'static str,
}

/// Six colours and a dark grey.
const COLORS: [[f64; 3]; 7] = [
    [0.8, 0.1, 0.1],
    [0.1, 0.7, 0.2],
    [0.1, 0.2, 0.8],
    [0.8, 0.7, 0.1],
    [0.7, 0.1, 0.7],
    [0.1, 0.7, 0.7],
    [0.2, 0.2, 0.2],
];
/// The fraction of each colour that is seen without any light.
const AMBIENT: f64 = 0.1;

impl Scene {
    /// The scene and the camera for the engine. Nothing is too near to the eye or a lamp.
    pub fn world(&self) -> (engine::Scene<'static>, Camera<'static>) {
        let mut world = engine::Scene::new(Color::BLACK, Color::gray(AMBIENT), self.depth);
        let surfaces = COLORS.map(|[r, g, b]| {
            world.add_surface(Surface {
                shading: Shading::Phong(Phong {
                    diffuse: Color::new(r, g, b),
                    specular: Color::gray(self.shine.x),
                    exponent: self.shine.z,
                }),
                reflection: Color::gray(self.shine.y),
            })
        });
        // The eye and the lamps.
        let mut kept_free = vec![self.eye];
        for light in self.lights.split("; ") {
            let kind = kind(light);
            if let Emitter::Point { position, .. } = kind {
                kept_free.push(position);
            }
            world.add_light(Light {
                kind,
                casts_shadows: true,
            });
        }
        for Object { shape, color } in objects(self.name) {
            if has_room(&shape, &kept_free) {
                world.add_shape(shape, surfaces[color]);
            }
        }
        if let Some(color) = self.floor {
            let floor = Plane {
                point: DVec3::ZERO,
                normal: DVec3::Y,
            };
            world.add_shape(Shape::Plane(floor), surfaces[color]);
        }
        let half_tangent = libm::tan(std::f64::consts::FRAC_PI_8);
        let camera = super::camera(self.eye, self.gaze, half_tangent);
        (world, camera)
    }

    /// The scene with its structure for rays.
    pub fn prepare(&self, settings: &Settings) -> Renderer<'static> {
        let (world, camera) = self.world();
        Renderer::new(world, camera, settings)
    }
}

/// A light: its kind, colour, place and direction.
fn kind(light: &str) -> Emitter<'static> {
    let vectors = vectors(light);
    let [r, g, b] = vectors[0].to_array();
    let (color, position) = (Color::new(r, g, b), vectors[1]);
    match vectors.get(2).map(|direction| direction.normalize()) {
        None => Emitter::Point { color, position },
        Some(direction) if light.starts_with("far") => Emitter::Directional { color, direction },
        Some(direction) => Emitter::Spot {
            color,
            position,
            direction,
            cos_half_angle: libm::cos(18_f64.to_radians()),
        },
    }
}

/// The numbers among the words of a text, in threes.
fn vectors(text: &str) -> Vec<DVec3> {
    let numbers = super::numbers_in(text);
    let threes = numbers.as_chunks().0.iter();
    threes.copied().map(DVec3::from_array).collect()
}
