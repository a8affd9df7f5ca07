//! Shapes, materials and lights of a student's own, which no scene file can say, and those of the lessons that no
//! table makes.

use a02_math::arrays::{point, vector};
use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use a05_lighting::{
    DirectionalLight, Illumination, Lambert, Light, Lighting, Material, Phong, PointLight,
};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface};
use a07_transforms::{Node, Transform};
use common::Color;
use random_scene::Numbers;
use testing::Random;

use crate::rays::Rays;
use crate::scenes::style;

/// An endless upright cylinder around the y axis.
#[derive(Debug)]
struct Column(f64);

impl Geometry for Column {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        let a = d.x() * d.x() + d.z() * d.z();
        let b = (o.x() * d.x() + o.z() * d.z()) / a;
        let c = (o.x() * o.x() + o.z() * o.z() - self.0 * self.0) / a;
        let root = (b * b - c).sqrt();
        let mut roots = [-b - root, -b + root].into_iter();
        let t = roots.find(|t| within.contains(*t))?;
        let p = ray.at(t);
        Some(Hit::new(t, Normal3::new(p.x(), 0.0, p.z()).normalized()?))
    }
}

/// A lamp whose light fades with the square of the distance, but stays finite, up to a wall: infinite light that a
/// black surface scatters is no number, which the renderer without omissions alone would see.
#[derive(Debug)]
struct FadingLamp(PointLight);

impl Light for FadingLamp {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.0.illumination(point).filter(|_| point.x() < 1.3)?;
        let fading = 4.0 / (0.01 + light.distance * light.distance);
        Some(Illumination {
            color: light.color * fading,
            ..light
        })
    }
}

/// As bright in light from behind, in three steps.
#[derive(Debug)]
struct Translucent(Color);

impl Material for Translucent {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = lighting.ambient();
        for normal in [hit.normal, -hit.normal] {
            let side = Hit { normal, ..*hit };
            lighting.for_each_light(ray, &side, &mut |light| {
                let steps = (3.0 * normal.dot(light.direction)).ceil();
                color += self.0 * light.color * steps;
            });
        }
        color
    }
}

impl Surface for Translucent {
    fn mirror_reflectance(&self) -> Color {
        self.0 * 0.5
    }
}

/// Adds shapes with such surfaces, some of them in groups, a fading lamp, and lamps where rays hit the world.
pub fn with_own_types(mut world: ShadowedWorld, seed: u64) -> Option<ShadowedWorld> {
    let mut random = Random::new(seed);
    let below = &mut |end| random.below(end);
    let numbers = &mut Numbers::new(below, style(seed));
    for _ in 0..6 {
        let color = Color::gray(numbers.one_of(&[0.0, 0.5, 1.0]));
        let surface: Box<dyn Surface> = match numbers.below(3) {
            0 => Box::new(Lambert::new(color).ok()?),
            1 => Box::new(Phong::new(color, Color::WHITE, 3.0).ok()?),
            _ => Box::new(Translucent(color)),
        };
        world = world.with(geometry(numbers)?, surface);
    }
    let lamp = PointLight::new(Color::WHITE, point(numbers.point())).ok()?;
    let mut lights = vec![LightSource::new(FadingLamp(lamp), numbers.below(2) == 0)];
    for ray in Rays::new(seed, style(seed)).0.iter().step_by(600) {
        if let Some((hit, _)) = world.objects().hit(ray, Interval::AHEAD)
            && let Ok(lamp) = PointLight::new(Color::WHITE, ray.at(hit.t))
        {
            lights.push(LightSource::new(lamp, true));
        }
    }
    Some(lights.into_iter().fold(world, ShadowedWorld::lit_by))
}

/// A column or a ball, alone or together in a group.
pub fn geometry(numbers: &mut Numbers) -> Option<Box<dyn Geometry>> {
    let column = Column(numbers.unit * 0.5);
    let ball = Sphere::new(point(numbers.point()), numbers.unit * 0.5).ok()?;
    // In one case so unequal that the engine calls the node's own `hit`.
    let [x, y] = numbers.one_of(&[[1.0, 1.0], [-1.0, 0.5], [1.0, 1e-9]]);
    let turned = Transform::IDENTITY
        .rotate_x(0.3)
        .ok()?
        .scale(x, y, 1.0)
        .ok()?;
    Some(match numbers.below(4) {
        0 => Box::new(column),
        1 => Box::new(ball),
        2 => Box::new(Node::new(turned).with(column).with(ball)),
        _ => Box::new(
            Node::new(Transform::IDENTITY)
                .with(column)
                .with(Node::new(turned).with(ball)),
        ),
    })
}

/// A sphere whose hits have numbers that are NaN or infinite, such as a first try at a shape may find.
#[derive(Debug)]
struct Unfinished {
    sphere: Sphere,
    variant: usize,
}

impl Geometry for Unfinished {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.sphere.hit(ray, within)?;
        let nothing = Normal3::new(f64::NAN, f64::NAN, f64::NAN);
        Some(match self.variant {
            0 => Hit::new(hit.t, nothing),
            1 => Hit {
                geometric_normal: nothing,
                ..hit
            },
            2 => Hit {
                normal: nothing,
                ..hit
            },
            _ => hit.with_scale(f64::NAN),
        })
    }
}

/// A light without a distance.
#[derive(Debug)]
struct Nowhere(DirectionalLight);

impl Light for Nowhere {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let distance = if point.x() > 0.0 { 1e9 } else { f64::NAN };
        let light = self.0.illumination(point)?;
        Some(Illumination { distance, ..light })
    }
}

/// Adds unfinished shapes that mirror, and a light without a distance.
pub fn with_numbers_that_are_none(mut world: ShadowedWorld, seed: u64) -> Option<ShadowedWorld> {
    let mut random = Random::new(seed);
    let below = &mut |end| random.below(end);
    let numbers = &mut Numbers::new(below, style(seed));
    for variant in 0..8 {
        let sphere = Sphere::new(point(numbers.point()), numbers.unit * 0.5).ok()?;
        let variant = variant % 4;
        let mirror = Reflective::new(Color::WHITE, Color::WHITE, 2.5, Color::gray(0.5)).ok()?;
        world = world.with(Unfinished { sphere, variant }, Box::new(mirror));
    }
    let sun = DirectionalLight::new(Color::WHITE, vector(numbers.direction())).ok()?;
    Some(world.lit_by(LightSource::new(Nowhere(sun), true)))
}
