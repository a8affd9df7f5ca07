//! `Kind`: a kind of pictures, with variants by random numbers.

use common::{Color, Settings};
use engine::{Camera, Hit, Ray, Renderer, Shading, Shape, Surface};
use glam::{DVec3, dvec3};

use crate::pictures::PICTURES;
use crate::support::Numbers;
use crate::support::scene::{SCENES, Scene};
use crate::things::{Things, things};

/// A kind of pictures.
pub struct Kind {
    pub name: &'static str,
    /// An upper bound of its light, infinite where lights and materials have no simple one.
    pub brightest: f64,
    subject: Subject,
}

/// What the pictures show.
enum Subject {
    /// A picture, or a scene, that a function makes.
    Made(Make),
    Things(Things),
    /// A scene of the benchmark `peers`.
    Scene(Scene),
}

/// Makes the variant of these numbers.
pub type Make = fn(&mut Numbers, &Settings) -> Renderer<'static>;

/// Scenes of the benchmark `peers`, whose bounds follow from their lights and materials.
const SEEN: [&str; 11] = [
    "mirrors", "objects", "spheres", "torus", "swarm", "boxes", "discs", "nodes", "lamps", "hills",
    "hairs",
];

/// All kinds.
pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    for things in things() {
        kinds.push(Kind {
            name: things.name,
            brightest: things.brightest,
            subject: Subject::Things(things),
        });
    }
    for picture in PICTURES {
        kinds.push(Kind {
            name: picture.name,
            brightest: picture.brightest,
            subject: Subject::Made(picture.make),
        });
    }
    for scene in SCENES.iter() {
        if SEEN.contains(&scene.name) {
            kinds.push(Kind {
                name: scene.name,
                brightest: f64::INFINITY,
                subject: Subject::Scene(*scene),
            });
        }
    }
    kinds
}

impl Kind {
    /// The renderer of a variant.
    pub fn prepare(&self, variant: u32, settings: &Settings) -> Renderer<'static> {
        let seed = common::fnv1a(self.name.as_bytes());
        let mut numbers = Numbers::new(seed, variant);
        match &self.subject {
            Subject::Made(make) => make(&mut numbers, settings),
            Subject::Things(things) => things.picture(&mut numbers, settings),
            Subject::Scene(scene) => {
                // From a random position.
                let mut scene = *scene;
                scene.eye += numbers.in_cube(0.3);
                scene.prepare(settings)
            }
        }
    }
}

impl Numbers {
    pub fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.between(0.05, 1.0));
        Color::new(r, g, b)
    }

    /// A position in the picture.
    pub fn position(&mut self) -> Position {
        Position {
            x: self.between(0.0, 1.0),
            y: self.between(0.0, 0.75),
        }
    }

    /// Any angle.
    pub fn turn(&mut self) -> Turn {
        let (sin, cos) = libm::sincos(self.between(0.0, std::f64::consts::TAU));
        Turn { sin, cos }
    }

    /// A whole number from `least` to `most`.
    pub fn count(&mut self, [least, most]: [f64; 2]) -> u32 {
        self.between(least, most + 1.0) as u32
    }
}

/// A position in a picture: `x` is from 0 to 1 over the width, and `y` upwards from 0 to the
/// height, 0.75.
#[derive(Clone, Copy)]
pub struct Position {
    pub x: f64,
    pub y: f64,
}

/// An angle, by its sine and cosine.
#[derive(Clone, Copy)]
pub struct Turn {
    pub sin: f64,
    pub cos: f64,
}

/// A scene that shows the light at each position. The rays start at their positions.
pub fn picture(
    settings: &Settings,
    light: impl Fn(Position) -> Color + Send + Sync + 'static,
) -> Renderer<'static> {
    let mut scene = engine::Scene::new(Color::BLACK, Color::BLACK, 1);
    let shading = Shading::Other(Box::new(move |ray, _| {
        let DVec3 { x, y, .. } = ray.origin;
        light(Position { x, y })
    }));
    let surface = scene.add_surface(Surface::matt(shading));
    scene.add_shape(Shape::other(|_| Some(Hit::new(1.0, DVec3::Z))), surface);
    let camera = Camera::Other(Box::new(|size, x, y| {
        let [x, y] = [x, y].map(|pixel| (pixel + 0.5) / f64::from(size.width()));
        Ray {
            origin: dvec3(x, y, 0.0),
            direction: DVec3::NEG_Z,
        }
    }));
    Renderer::new(scene, camera, settings)
}
