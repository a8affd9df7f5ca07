//! `Scene`: a scene of the benchmarks, which makes the engine's.
//!
//! The background is black, because Tachyon paints it, unweakened, where the last mirror
//! that a ray may meet would show something. All lights cast shadows: Tachyon has no other.

use common::{Color, Settings};
use engine::{Basis, Camera, Light, LightKind, Phong, Renderer, Shading, Shape, Surface};
use glam::{DVec3, dvec3};

/// A scene in numbers.
pub struct Scene {
    pub name: &'static str,
    pub about: &'static str,
    /// The place of the camera, and the direction in which it looks.
    pub view: [DVec3; 2],
    pub lights: fn() -> Vec<LightKind<'static>>,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    /// The shares of light in highlights and mirrors, the same for all materials.
    pub shares: [f64; 2],
    /// Makes the objects one after the other: a list of them would count among
    /// the memory of the program that we measure.
    pub objects: fn() -> Objects,
}

/// Shapes, each with the index of its colour.
pub type Objects = Box<dyn Iterator<Item = (Shape<'static>, usize)>>;

/// Six colours and a dark grey.
const COLORS: [DVec3; 7] = [
    dvec3(0.8, 0.1, 0.1),
    dvec3(0.1, 0.7, 0.2),
    dvec3(0.1, 0.2, 0.8),
    dvec3(0.8, 0.7, 0.1),
    dvec3(0.7, 0.1, 0.7),
    dvec3(0.1, 0.7, 0.7),
    dvec3(0.2, 0.2, 0.2),
];

/// The index of the grey, which is also the number of colours before it.
pub const GREY: usize = 6;
/// The share of each colour that is seen without any light.
const AMBIENT: f64 = 0.1;
/// Half the vertical opening angle of all cameras, in radians.
const HALF_ANGLE: f64 = std::f64::consts::FRAC_PI_8;

pub fn color(vector: DVec3) -> Color {
    let [r, g, b] = vector.to_array();
    Color::new(r, g, b)
}

impl Scene {
    /// The scene and the camera for the engine.
    pub fn world(&self) -> (engine::Scene<'static>, Camera<'static>) {
        let mut world = engine::Scene::new(Color::BLACK, Color::gray(AMBIENT), self.depth);
        let surfaces = COLORS.map(|diffuse| {
            world.add_surface(Surface {
                shading: Shading::Phong(Phong {
                    diffuse: color(diffuse),
                    specular: Color::gray(self.shares[0]),
                    exponent: 32.0,
                }),
                reflection: Color::gray(self.shares[1]),
            })
        });
        for kind in (self.lights)() {
            let casts_shadows = true;
            world.add_light(Light {
                kind,
                casts_shadows,
            });
        }
        for (shape, color) in (self.objects)() {
            world.add_shape(shape, surfaces[color]);
        }
        let camera = Camera::Perspective {
            basis: self.basis(),
            half_tangent: libm::tan(HALF_ANGLE),
        };
        (world, camera)
    }

    /// The scene with its structure for rays.
    pub fn prepare(&self, settings: &Settings) -> Renderer<'static> {
        let (world, camera) = self.world();
        Renderer::new(world, camera, settings)
    }

    /// The axes of the camera, which is held upright.
    fn basis(&self) -> Basis {
        let [e, gaze] = self.view;
        let w = -gaze.normalize();
        let u = DVec3::Y.cross(w).normalize();
        let v = w.cross(u);
        Basis { e, u, v, w }
    }
}
