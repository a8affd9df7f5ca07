//! A hit with lights at known angles around its normal; and the scenes of this stage,
//! with the student's code in them.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{AxisAlignedBox, Hit, Plane, Sphere, Triangle};
use a05_lighting::{Illumination, Light, Lighting, LitWorld, Material, PointLight, stage};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

pub fn color(random: &mut Random) -> Color {
    let [r, g, b] = [(); 3].map(|()| random.between(0.0, 1.0));
    Color::new(r, g, b)
}

/// Three unit vectors perpendicular to each other.
pub fn frame(random: &mut Random) -> [Vector3; 3] {
    random.frame().map(|v| Vector3::from_glam(v.into()))
}

/// A hit with the normal `n`, seen by an eye in the direction `e`, and its lights.
pub struct Shot {
    pub n: Vector3,
    pub e: Vector3,
    ambient: Color,
    lights: Vec<Illumination>,
}

impl Shot {
    pub fn new(random: &mut Random, ambient: Color) -> Self {
        let [n, side, _] = frame(random);
        Self {
            n,
            e: at_cosine(n, side, random.between(0.1, 1.0)),
            ambient,
            lights: Vec::new(),
        }
    }

    /// Adds a light whose direction has this cosine with the normal, and returns its
    /// colour.
    pub fn light(&mut self, random: &mut Random, cosine: f64) -> Color {
        let side = loop {
            let side = frame(random)[0].cross(self.n);
            if let Some(side) = side.normalized() {
                break side;
            }
        };
        self.light_from(random, at_cosine(self.n, side, cosine))
    }

    /// Adds a light from this direction, and returns its colour.
    pub fn light_from(&mut self, random: &mut Random, direction: Vector3) -> Color {
        let (color, distance) = (color(random), random.between(1.0, 9.0));
        self.lights.push(Illumination {
            color,
            direction,
            distance,
        });
        color
    }

    /// Directions of a light and of an eye: at the cosine `lit` between normal and light,
    /// and `seen` between the mirrored light and the eye.
    pub fn turn(&self, random: &mut Random, lit: f64, seen: f64) -> Option<(Vector3, Vector3)> {
        let side = frame(random)[0].cross(self.n).normalized()?;
        let (l, mirrored) = (at_cosine(self.n, side, lit), at_cosine(self.n, -side, lit));
        // Perpendicular to the mirrored light, upwards.
        let across = side * lit + self.n * (1.0 - lit * lit).sqrt();
        let e = at_cosine(mirrored, across, seen);
        Some((l, e))
    }

    pub fn seen(&self, material: &dyn Material) -> [f64; 3] {
        let ray = Ray::derived(Point3::ORIGIN + self.e * 2.0, -self.e);
        let hit = Hit::new(2.0, self.n.as_normal());
        material.color_for(&ray, &hit, self).channels()
    }
}

/// The unit vector at this cosine from `n`, towards the perpendicular `side`.
pub fn at_cosine(n: Vector3, side: Vector3, cosine: f64) -> Vector3 {
    n * cosine + side * (1.0 - cosine * cosine).sqrt()
}

impl Lighting for Shot {
    fn ambient(&self) -> Color {
        self.ambient
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.lights.iter().for_each(shade);
    }
}

/// Position of the camera and of the lights in all scenes.
pub const CORNER: Point3 = Point3::new(4.0, 4.0, 4.0);
pub const INWARDS: Vector3 = Vector3::new(-1.0, -1.0, -1.0);

/// Compares a scene of this stage that contains the student's code with its lock. Camera
/// and world are from `src/scenes.rs`.
pub fn expect_scene(
    check: &mut Check,
    name: &str,
    world: impl FnOnce() -> Result<LitWorld, ArgumentError>,
) {
    check.scene(&stage(), name, |settings| {
        let (world, up) = (world()?, Vector3::new(0.0, 1.0, 0.0));
        let camera = PerspectiveCamera::new(CORNER, INWARDS, up, FRAC_PI_4)?;
        render(&camera, |ray: &Ray| world.color_for(ray), settings, &())
    });
}

pub fn objects(
    material: impl Fn(Color) -> Result<Box<dyn Material>, ArgumentError>,
    ambient: Color,
) -> Result<LitWorld, ArgumentError> {
    let sphere = Sphere::new(Point3::new(1.0, 1.0, 1.0), 0.5)?;
    let (lbf, run) = (Point3::new(-1.5, 0.5, 0.5), Point3::new(-0.5, 1.5, 1.5));
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)];
    let [a, b, c] = corners.map(|(x, y)| Point3::new(x, y, -1.0));
    Ok(LitWorld::new(Color::BLACK, ambient)?
        .with(
            Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?,
            material(Color::RED)?,
        )
        .with(sphere, material(Color::GREEN)?)
        .with(AxisAlignedBox::new(lbf, run)?, material(Color::BLUE)?)
        .with(Triangle::new(a, b, c)?, material(Color::YELLOW)?))
}

pub fn lamp() -> Result<Box<dyn Light>, ArgumentError> {
    Ok(Box::new(PointLight::new(Color::WHITE, CORNER)?))
}
