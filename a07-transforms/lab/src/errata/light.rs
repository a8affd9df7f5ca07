//! Highlights, whether a light reaches a point, and reflected rays.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::{Hit, Interval, Plane, Sphere, World};
use a05_lab::protocol as material;
use a05_lighting::{
    DirectionalLight, Illumination, Light, Lighting, LitWorld, Material, Phong, PointLight,
    SpotLight,
};
use a06_lab::protocol::{self, OneCounter};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, is_shadowed,
};
use common::{Color, Error, Scene, Settings};

use super::{Made, beside, camera, shade, traced};

pub fn highlight() -> Scene {
    beside(
        "highlight",
        "the highlight multiplied by the colour of the surface, and not",
        |_| balls(|color| Ok(Box::new(ProtocolPhong(color)))),
        |_| balls(|color| Ok(Box::new(Phong::new(color, Color::WHITE, EXPONENT)?))),
    )
}

const EXPONENT: f64 = 64.0;

/// Phong's material as the formula is printed.
#[derive(Debug)]
struct ProtocolPhong(Color);

impl Material for ProtocolPhong {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = Color::BLACK;
        lighting.for_each_light(ray, hit, &mut |light| {
            let mirrored = light.direction.reflected_on(hit.normal);
            let cosine = (-ray.direction()).dot(mirrored);
            let highlight = material::highlight(cosine, EXPONENT);
            let n_l = hit.normal.dot(light.direction);
            let (ca, cl) = (lighting.ambient().r, light.color.r);
            color = self.0.map(|cr| material::phong(cr, ca, cl, n_l, highlight));
        });
        color
    }
}

fn balls(material: fn(Color) -> Made<Box<dyn Material>>) -> Result<View, Error> {
    let mut world = LitWorld::new(Color::BLACK, Color::gray(0.2))?;
    for (x, color) in [(-1.2, Color::RED), (0.0, Color::GREEN), (1.2, Color::BLUE)] {
        let ball = Sphere::new(Point3::new(x, 0.0, 0.0), 0.55)?;
        world = world.with(ball, material(color)?);
    }
    let light = PointLight::new(Color::WHITE, Point3::new(3.0, 4.0, 5.0))?;
    let world = world.lit_by(Box::new(light));
    let camera = camera(Point3::new(0.0, 0.6, 4.2), Point3::ORIGIN, FRAC_PI_4)?;
    Ok(traced(camera, move |ray| world.color_for(ray)))
}

/// Whether the light of a source reaches a hit.
type IsLit = fn(&World<Color>, &Ray, &Hit, &Illumination) -> bool;

const OURS: IsLit = |world, ray, hit, light| !is_shadowed(world, ray, hit, light);

/// A world in the light of one source.
fn lit(world: World<Color>, light: impl Light, is_lit: IsLit) -> Result<View, Error> {
    let (eye, to) = (Point3::new(2.2, 3.8, 5.0), Point3::new(0.0, 0.9, 0.0));
    Ok(traced(camera(eye, to, FRAC_PI_4)?, move |ray| {
        let Some((hit, color)) = world.hit(ray, Interval::AHEAD) else {
            return Color::BLACK;
        };
        let light = light.illumination(ray.at(hit.t));
        let light = light.filter(|light| is_lit(&world, ray, &hit, light));
        let cosine = light.map_or(0.0, |light| hit.normal.dot(light.direction));
        shade(*color, cosine)
    }))
}

const LEVEL: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const SLOPE: Normal3 = Normal3::new(0.3, 1.0, 0.2);

/// A floor with a ball over it.
fn floor(normal: Normal3, ball: Point3) -> Made<World<Color>> {
    Ok(World::new(Color::BLACK)?
        .with(Plane::new(Point3::ORIGIN, normal)?, Color::gray(0.8))
        .with(Sphere::new(ball, 0.4)?, Color::GREEN))
}

fn on_a_slope() -> Made<World<Color>> {
    floor(SLOPE, Point3::new(-0.2, 0.9, 0.1))
}

const LAMP: Point3 = Point3::new(0.0, 2.6, 0.0);

fn lamp() -> Made<PointLight> {
    PointLight::new(Color::WHITE, LAMP)
}

const THEIR_LAMP: IsLit =
    |world, ray, hit, _| protocol::point_light_illuminates(LAMP, ray.at(hit.t), world);

/// One ball below the lamp, and a red one above it.
fn below_and_above() -> Made<World<Color>> {
    let above = Sphere::new(Point3::new(0.6, 3.4, 0.3), 0.4)?;
    Ok(floor(LEVEL, Point3::new(-0.9, 0.9, 0.0))?.with(above, Color::RED))
}

pub fn too_far() -> Scene {
    beside(
        "point-light",
        "t compared with a distance, in lengths of the direction and in lengths",
        |_| lit(below_and_above()?, lamp()?, THEIR_LAMP),
        |_| lit(below_and_above()?, lamp()?, OURS),
    )
}

pub fn hidden() -> Scene {
    beside(
        "point-light-slope",
        "the least t asked of the nearest hit only, and of every hit",
        |_| lit(on_a_slope()?, lamp()?, THEIR_LAMP),
        |_| lit(on_a_slope()?, lamp()?, OURS),
    )
}

fn in_the_cone(is_lit: IsLit) -> Result<View, Error> {
    let light = SpotLight::new(Color::WHITE, LAMP, Vector3::new(0.0, -1.0, 0.0), 0.6)?;
    lit(floor(LEVEL, Point3::new(0.2, 0.9, 0.0))?, light, is_lit)
}

const THEIR_SPOT: IsLit =
    |world, ray, hit, _| protocol::spot_light_illuminates(LAMP, ray.at(hit.t), world);

pub fn spot() -> Scene {
    beside(
        "spot-light",
        "the shadow ray sent away from the light, and towards it",
        |_| in_the_cone(THEIR_SPOT),
        |_| in_the_cone(OURS),
    )
}

const AWAY: Vector3 = Vector3::new(0.2, -0.9, -0.4);

fn sun() -> Made<DirectionalLight> {
    DirectionalLight::new(Color::WHITE, AWAY)
}

const THEIR_SUN: IsLit =
    |world, ray, hit, _| protocol::directional_light_illuminates(AWAY, ray.at(hit.t), world);

pub fn acne() -> Scene {
    beside(
        "directional-light",
        "every hit of the shadow ray counted, and none of the surface itself",
        |_| lit(on_a_slope()?, sun()?, THEIR_SUN),
        |_| lit(on_a_slope()?, sun()?, OURS),
    )
}

/// How large the scene is: one of millimetres, measured in metres.
const SIZE: f64 = 0.001;

/// The light that a ray brings back.
type Trace = fn(&ShadowedWorld, &Ray, depth: u32) -> Color;

const WITH_ONE_COUNTER: Trace = |world, ray, recursion| OneCounter { world, recursion }.trace(ray);
const OFFSET: Trace = |world, ray, depth| RecursiveTracer::new(world).trace(ray, depth);

/// The reflected ray that begins a thousandth too early.
pub fn mirrors() -> Scene {
    beside(
        "mirror",
        "three mirroring balls of radius 0.001: reflected at t - 0.001, and offset",
        |settings| mirroring_balls(settings, WITH_ONE_COUNTER),
        |settings| mirroring_balls(settings, OFFSET),
    )
    .reflecting()
}

/// The spheres of the stage's first scene, closer together.
fn mirroring_balls(settings: &Settings, trace: Trace) -> Result<View, Error> {
    let half = Color::gray(0.5);
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let mirror = Reflective::new(Color::gray(0.3), Color::BLACK, 64.0, half)?;
    let light = Point3::new(8.0 * SIZE, 8.0 * SIZE, 8.0 * SIZE);
    let light = PointLight::new(Color::WHITE, light)?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor, Box::new(mirror))
        .lit_by(LightSource::new(light, true));
    for (x, color) in [(-2.2, Color::RED), (0.0, Color::GREEN), (2.2, Color::BLUE)] {
        let sphere = Sphere::new(Point3::new(x * SIZE, SIZE, 0.0), SIZE)?;
        let material = Reflective::new(color, Color::WHITE, 64.0, half)?;
        world = world.with(sphere, Box::new(material));
    }
    let eye = Point3::new(4.0 * SIZE, 4.0 * SIZE, 9.0 * SIZE);
    let (gaze, up) = (Vector3::new(-4.0, -3.5, -9.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, FRAC_PI_4)?;
    let depth = settings.depth;
    Ok(traced(camera, move |ray| trace(&world, ray, depth)))
}
