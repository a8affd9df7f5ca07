//! The engine hits shapes as the lesson's list does, to the last bit: a pixel is the hit of a ray.

use std::hash::{DefaultHasher, Hash, Hasher};

use a02_math::Vector3;
use a03_rays_cameras::{Ray, View};
use a04_intersections::{Geometry, Hit, Interval, World};
use a05_lighting::{Lighting, Material};
use a06_shadows_reflection::{ShadowedWorld, Surface};
use a07_transforms::registry::{ALL_SHAPES, FORMAT};
use a07_transforms::traced;
use common::{Color, Settings, Size};
use random_scene::Numbers;
use scene_file::FirstMistake;
use testing::Random;

use crate::compare::{compare, compare_scenes};
use crate::own_types::geometry;
use crate::rays::Rays;
use crate::scenes::style;

/// The surface of this number, whose colour is `t`, a hash of all other numbers of ray and hit, and its number.
#[derive(Debug)]
struct Bits(usize);

impl Material for Bits {
    fn color_for(&self, ray: &Ray, hit: &Hit, _: &dyn Lighting) -> Color {
        let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
        let numbers = [o, d, hit.normal.to_glam(), hit.geometric_normal.to_glam()];
        let mut hasher = DefaultHasher::new();
        numbers
            .map(|v| v.to_array().map(f64::to_bits))
            .hash(&mut hasher);
        Color::new(hit.t, (hasher.finish() >> 11) as f64, 1.0 + self.0 as f64)
    }
}

impl Surface for Bits {}

/// The view of these rays, in which each shape has a number.
fn view(rays: Rays, shapes: impl IntoIterator<Item = Box<dyn Geometry>>) -> View {
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::BLACK).unwrap();
    for (number, shape) in shapes.into_iter().enumerate() {
        world = world.with(shape, Box::new(Bits(number)));
    }
    traced(View::new(rays, world))
}

/// Compares the hits of shapes, and returns the number of rays that hit one.
pub fn hits<G: Geometry + Clone>(shapes: &[G], rays: &[Ray]) -> usize {
    let boxed = |shape: &G| -> Box<dyn Geometry> { Box::new(shape.clone()) };
    // Rays that differ little traverse the tree together: four of each ray, and 64 of some.
    let near = |ray: &Ray, k: u32| {
        let aside = Vector3::new(1e-3, -2e-4, 3e-4) * f64::from(k);
        Ray::new(ray.origin(), ray.direction() + aside).unwrap()
    };
    let mut all = rays.to_vec();
    all.resize(all.len().next_multiple_of(64), rays[0]);
    for ray in rays {
        all.extend([*ray, near(ray, 1), near(ray, 2), near(ray, 3)]);
    }
    all.resize(all.len().next_multiple_of(64), rays[0]);
    for ray in rays.iter().step_by(33) {
        all.extend((0..64).map(|k| near(ray, k)));
    }
    let again = || view(Rays(all.clone()), shapes.iter().map(boxed));
    let settings = Settings {
        size: Size::new(32, 2 * all.len().div_ceil(64) as u32).unwrap(),
        ..Settings::default()
    };
    compare(0, again, &settings);
    let world = World::new(Color::BLACK).unwrap();
    let world = shapes
        .iter()
        .fold(world, |world, shape| world.with(shape.clone(), ()));
    let is_hit = |ray: &&Ray| world.hit(ray, Interval::AHEAD).is_some();
    rays.iter().filter(is_hit).count()
}

/// Also of a student's own.
#[test]
fn shapes_are_met_as_in_the_list() {
    compare_scenes(FORMAT, 0..60, |seed, file| {
        let mut first = FirstMistake::of(file);
        let objects = ALL_SHAPES.read_objects(file, &mut first, |_| Ok(()));
        let mut shapes: Vec<_> = objects.into_iter().map(|(shape, ())| shape).collect();
        let mut random = Random::new(seed);
        let below = &mut |end| random.below(end);
        shapes.push(geometry(&mut Numbers::new(below, style(seed)))?);
        first.result(Some(())).ok()?;
        Some(view(Rays::new(seed, style(seed)), shapes))
    });
}
