//! Short forms for points, rays and hits, tables of exact hits, and random shapes and rays.

pub use a02_math::arrays::{point, vector};
use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::registry::{ALL_SHAPES, FORMAT};
use a04_intersections::{Geometry, Hit, Interval};
use random_scene::{Numbers, SceneText, Style};
use scene_file::{Error, FirstMistake};
use testing::Random;

/// A ray whose direction keeps its length.
pub fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The nearest hit of a shape ahead of the ray's origin.
pub fn hit(shape: &dyn Geometry, ray: &Ray) -> Option<Hit> {
    shape.hit(ray, Interval::AHEAD)
}

/// Origin and direction of a ray, and `t` and normal of its hit.
pub type Case = ([f64; 3], [f64; 3], Option<(f64, [f64; 3])>);

/// Compares the hits of a shape with exact ones.
pub fn assert_hits(shape: &dyn Geometry, cases: &[Case]) {
    for &(o, d, expected) in cases {
        let expected = expected.map(|(t, normal)| Hit::new(t, vector(normal).as_normal()));
        let found = hit(shape, &ray(o, d)).map(|hit| hit.with_scale(0.0));
        assert_eq!(found, expected, "{shape:?} {o:?} {d:?}");
    }
}

/// A vector of three random numbers from `-width` to `width`.
pub fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

/// A vector of random multiples of `1 / steps` from `-width` to `width`.
fn grid_vector(random: &mut Random, width: u32, steps: u32) -> Vector3 {
    let [x, y, z] = [(); 3].map(|()| random.below(2 * width * steps + 1));
    vector([x, y, z].map(|count| f64::from(count) / f64::from(steps) - f64::from(width)))
}

/// A point of eighths from -2 to 2.
pub fn eighths(random: &mut Random) -> Point3 {
    Point3::ORIGIN + grid_vector(random, 2, 8)
}

/// The shapes of the random scene with this number.
pub fn random_shapes(seed: u64) -> Vec<Box<dyn Geometry>> {
    let mut random = Random::new(seed);
    let below = &mut |end| random.below(end);
    let text = SceneText::new(below, Style::Plain, 4, &|text| shapes(text).is_ok());
    shapes(&text).unwrap()
}

fn shapes(text: &SceneText) -> Result<Vec<Box<dyn Geometry>>, Error> {
    let file = FORMAT.read(&text.scene, &|name| text.mesh(name))?;
    let mut first = FirstMistake::of(&file);
    let objects = ALL_SHAPES.read_objects(&file, &mut first, |_| Ok(()));
    let shapes = objects.into_iter().map(|(shape, ())| shape);
    first.result(Some(shapes.collect()))
}

/// The ray with this number, from other random numbers than the shapes: half of them go along axes, through edges and
/// through corners.
pub fn random_ray(n: u32) -> Ray {
    let mut random = Random::new(!u64::from(n));
    let below = &mut |end| random.below(end);
    let mut numbers = Numbers::new(below, Style::Plain);
    loop {
        if let Ok(ray) = Ray::new(point(numbers.point()), vector(numbers.direction())) {
            return ray;
        }
    }
}
