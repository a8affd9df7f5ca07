//! Highlights, and whether a light reaches a point.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Hit, Interval, Plane, Sphere, World};
use a05_lighting::{
    DirectionalLight, Light, Lighting, LitWorld, Material, Phong, PointLight, SpotLight,
};
use a06_shadows_reflection::{is_shadowed, protocol};
use common::{ArgumentError, Color, Error, Image, Progress, Scene, Settings};

use super::{beside, shade};

type Made<T> = Result<T, ArgumentError>;

fn camera(eye: Point3, to: Point3) -> Made<PerspectiveCamera> {
    let up = Vector3::new(0.0, 1.0, 0.0);
    PerspectiveCamera::new(eye, to - eye, up, FRAC_PI_4)
}

pub fn highlight() -> Scene {
    let about = "the highlight multiplied by the colour of the surface, and not";
    beside(
        "highlight",
        about,
        |settings, progress| balls(|color| Ok(Box::new(Printed(color))), settings, progress),
        |settings, progress| {
            let shiny = |color| -> Made<Box<dyn Material>> {
                Ok(Box::new(Phong::new(color, Color::WHITE, EXPONENT)?))
            };
            balls(shiny, settings, progress)
        },
    )
}

const EXPONENT: f64 = 64.0;

/// Phong's material as the formula is printed.
#[derive(Debug)]
struct Printed(Color);

impl Material for Printed {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = Color::BLACK;
        lighting.for_each_light(ray, hit, &mut |light| {
            let mirrored = light.direction.reflected_on(hit.normal);
            let cosine = (-ray.direction()).dot(mirrored);
            let highlight = a05_lighting::protocol::highlight(cosine, EXPONENT);
            let n_l = hit.normal.dot(light.direction);
            let ambient = lighting.ambient().r;
            let channel =
                |cr| a05_lighting::protocol::phong(cr, ambient, light.color.r, n_l, highlight);
            color = self.0.map(channel);
        });
        color
    }
}

fn balls(
    material: impl Fn(Color) -> Made<Box<dyn Material>>,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let mut world = LitWorld::new(Color::BLACK, Color::gray(0.2))?;
    for (x, color) in [(-1.2, Color::RED), (0.0, Color::GREEN), (1.2, Color::BLUE)] {
        let ball = Sphere::new(Point3::new(x, 0.0, 0.0), 0.55)?;
        world = world.with(ball, material(color)?);
    }
    let light = PointLight::new(Color::WHITE, Point3::new(3.0, 4.0, 5.0))?;
    let world = world.lit_by(Box::new(light));
    let camera = camera(Point3::new(0.0, 0.6, 4.2), Point3::ORIGIN)?;
    render(&camera, |ray| world.color_for(ray), settings, progress)
}

/// The lamp of the pictures of shadows.
const LAMP: Point3 = Point3::new(0.0, 2.6, 0.0);

fn lamp() -> Made<PointLight> {
    PointLight::new(Color::WHITE, LAMP)
}

/// A floor, level or on a slope.
fn floor(normal: Normal3) -> Made<World<Color>> {
    let plane = Plane::new(Point3::ORIGIN, normal)?;
    Ok(World::new(Color::BLACK)?.with(plane, Color::gray(0.8)))
}

fn with_ball(world: World<Color>, c: Point3, color: Color) -> Made<World<Color>> {
    Ok(world.with(Sphere::new(c, 0.4)?, color))
}

/// A world in the light of one source, `is_lit` telling whether it arrives.
fn lit(
    world: &World<Color>,
    light: &impl Light,
    is_lit: impl Fn(&Ray, &Hit) -> bool + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let camera = camera(Point3::new(2.2, 3.8, 5.0), Point3::new(0.0, 0.9, 0.0))?;
    let color = |ray: &Ray| {
        let Some((hit, color)) = world.hit(ray, Interval::AHEAD) else {
            return Color::BLACK;
        };
        let light = light.illumination(ray.at(hit.t));
        let light = light.filter(|_| is_lit(ray, &hit));
        let cosine = light.map_or(0.0, |light| hit.normal.dot(light.direction));
        shade(*color, cosine)
    };
    render(&camera, color, settings, progress)
}

/// The same world with the shadows of the stage.
fn right(
    world: &World<Color>,
    light: &impl Light,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let is_lit = |ray: &Ray, hit: &Hit| {
        let light = light.illumination(ray.at(hit.t));
        light.is_some_and(|light| !is_shadowed(world, ray, hit, &light))
    };
    lit(world, light, is_lit, settings, progress)
}

const LEVEL: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const SLOPE: Normal3 = Normal3::new(0.3, 1.0, 0.2);

/// One ball below the lamp, and a red one above it.
fn below_and_above() -> Made<World<Color>> {
    let world = with_ball(floor(LEVEL)?, Point3::new(-0.9, 0.9, 0.0), Color::GREEN)?;
    with_ball(world, Point3::new(0.6, 3.4, 0.3), Color::RED)
}

pub fn too_far() -> Scene {
    beside(
        "point-light",
        "t compared with a distance, in lengths of the direction and in lengths",
        |settings, progress| {
            let world = below_and_above()?;
            let is_lit = |ray: &Ray, hit: &Hit| {
                protocol::point_light_illuminates(LAMP, ray.at(hit.t), &world)
            };
            lit(&world, &lamp()?, is_lit, settings, progress)
        },
        |settings, progress| right(&below_and_above()?, &lamp()?, settings, progress),
    )
}

fn on_a_slope() -> Made<World<Color>> {
    with_ball(floor(SLOPE)?, Point3::new(-0.2, 0.9, 0.1), Color::GREEN)
}

pub fn hidden() -> Scene {
    beside(
        "point-light-slope",
        "the least t asked of the nearest hit only, and of every hit",
        |settings, progress| {
            let world = on_a_slope()?;
            let is_lit = |ray: &Ray, hit: &Hit| {
                protocol::point_light_illuminates(LAMP, ray.at(hit.t), &world)
            };
            lit(&world, &lamp()?, is_lit, settings, progress)
        },
        |settings, progress| right(&on_a_slope()?, &lamp()?, settings, progress),
    )
}

fn spot_light() -> Made<SpotLight> {
    let down = Vector3::new(0.0, -1.0, 0.0);
    SpotLight::new(Color::WHITE, LAMP, down, 0.6)
}

fn under_the_spot() -> Made<World<Color>> {
    with_ball(floor(LEVEL)?, Point3::new(0.2, 0.9, 0.0), Color::GREEN)
}

pub fn spot() -> Scene {
    beside(
        "spot-light",
        "the shadow ray sent away from the light, and towards it",
        |settings, progress| {
            let world = under_the_spot()?;
            let is_lit = |ray: &Ray, hit: &Hit| {
                protocol::spot_light_illuminates(LAMP, ray.at(hit.t), &world)
            };
            lit(&world, &spot_light()?, is_lit, settings, progress)
        },
        |settings, progress| right(&under_the_spot()?, &spot_light()?, settings, progress),
    )
}

const SUNWARDS: Vector3 = Vector3::new(-0.2, 0.9, 0.4);

fn sun() -> Made<DirectionalLight> {
    DirectionalLight::new(Color::WHITE, -SUNWARDS)
}

pub fn acne() -> Scene {
    beside(
        "directional-light",
        "every hit of the shadow ray counted, and none of the surface itself",
        |settings, progress| {
            let world = on_a_slope()?;
            let is_lit = |ray: &Ray, hit: &Hit| {
                protocol::directional_light_illuminates(-SUNWARDS, ray.at(hit.t), &world)
            };
            lit(&world, &sun()?, is_lit, settings, progress)
        },
        |settings, progress| right(&on_a_slope()?, &sun()?, settings, progress),
    )
}
