//! Highlights, and whether a light reaches a point.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::{Hit, Interval, Plane, Sphere, World};
use a05_lighting::{
    DirectionalLight, Illumination, Light, Lighting, LitWorld, Material, Phong, PointLight,
    SpotLight,
};
use a06_shadows_reflection::{is_shadowed, protocol};
use common::{ArgumentError, Color, Error, Scene};

use super::{beside, shade, traced};

type Made<T> = Result<T, ArgumentError>;

fn camera(eye: Point3, to: Point3) -> Made<PerspectiveCamera> {
    let up = Vector3::new(0.0, 1.0, 0.0);
    PerspectiveCamera::new(eye, to - eye, up, FRAC_PI_4)
}

pub fn highlight() -> Scene {
    beside(
        "highlight",
        "the highlight multiplied by the colour of the surface, and not",
        |_| balls(|color| Ok(Box::new(Printed(color)))),
        |_| balls(|color| Ok(Box::new(Phong::new(color, Color::WHITE, EXPONENT)?))),
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

fn balls(material: fn(Color) -> Made<Box<dyn Material>>) -> Result<View, Error> {
    let mut world = LitWorld::new(Color::BLACK, Color::gray(0.2))?;
    for (x, color) in [(-1.2, Color::RED), (0.0, Color::GREEN), (1.2, Color::BLUE)] {
        let ball = Sphere::new(Point3::new(x, 0.0, 0.0), 0.55)?;
        world = world.with(ball, material(color)?);
    }
    let light = PointLight::new(Color::WHITE, Point3::new(3.0, 4.0, 5.0))?;
    let world = world.lit_by(Box::new(light));
    let camera = camera(Point3::new(0.0, 0.6, 4.2), Point3::ORIGIN)?;
    Ok(traced(camera, move |ray| world.color_for(ray)))
}

/// Whether the light reaches a point of the world, by the protocol.
type Illuminates = fn(Point3, &World<Color>) -> bool;

/// A world in the light of one source: with the protocol's shadows, and the stage's.
fn shadows<L: Light>(
    name: &'static str,
    about: &'static str,
    world: fn() -> Made<World<Color>>,
    light: fn() -> Made<L>,
    illuminates: Illuminates,
) -> Scene {
    let wrong = move |_: &_| {
        lit(world()?, light()?, move |world, ray, hit, _| {
            illuminates(ray.at(hit.t), world)
        })
    };
    beside(name, about, wrong, move |_| {
        lit(world()?, light()?, |world, ray, hit, light| {
            !is_shadowed(world, ray, hit, light)
        })
    })
}

fn lit(
    world: World<Color>,
    light: impl Light,
    is_lit: impl Fn(&World<Color>, &Ray, &Hit, &Illumination) -> bool + Send + Sync + 'static,
) -> Result<View, Error> {
    let camera = camera(Point3::new(2.2, 3.8, 5.0), Point3::new(0.0, 0.9, 0.0))?;
    Ok(traced(camera, move |ray| {
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

/// One ball below the lamp, and a red one above it.
pub fn too_far() -> Scene {
    shadows(
        "point-light",
        "t compared with a distance, in lengths of the direction and in lengths",
        || {
            let above = Sphere::new(Point3::new(0.6, 3.4, 0.3), 0.4)?;
            Ok(floor(LEVEL, Point3::new(-0.9, 0.9, 0.0))?.with(above, Color::RED))
        },
        lamp,
        |point, world| protocol::point_light_illuminates(LAMP, point, world),
    )
}

pub fn hidden() -> Scene {
    shadows(
        "point-light-slope",
        "the least t asked of the nearest hit only, and of every hit",
        on_a_slope,
        lamp,
        |point, world| protocol::point_light_illuminates(LAMP, point, world),
    )
}

pub fn spot() -> Scene {
    shadows(
        "spot-light",
        "the shadow ray sent away from the light, and towards it",
        || floor(LEVEL, Point3::new(0.2, 0.9, 0.0)),
        || SpotLight::new(Color::WHITE, LAMP, Vector3::new(0.0, -1.0, 0.0), 0.6),
        |point, world| protocol::spot_light_illuminates(LAMP, point, world),
    )
}

const SUNWARDS: Vector3 = Vector3::new(-0.2, 0.9, 0.4);

pub fn acne() -> Scene {
    shadows(
        "directional-light",
        "every hit of the shadow ray counted, and none of the surface itself",
        on_a_slope,
        || DirectionalLight::new(Color::WHITE, -SUNWARDS),
        |point, world| protocol::directional_light_illuminates(-SUNWARDS, point, world),
    )
}
