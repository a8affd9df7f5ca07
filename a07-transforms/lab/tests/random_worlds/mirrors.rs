//! Extreme scenes of stage 6: surfaces that mirror, lights that cast shadows, and hits whose numbers are none.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::{Ray, View};
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use a05_lighting::{DirectionalLight, Illumination, Lambert, Light, Phong, PointLight, SpotLight};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface, traced};
use common::{ArgumentError, Color};

use crate::random_scene::Place;
use crate::same_pictures::compare_scenes;

/// Two of three surfaces mirror.
fn surface(place: &mut Place) -> Result<Box<dyn Surface>, ArgumentError> {
    let (diffuse, specular, reflection) = (place.color(), place.color(), place.color());
    let exponent = [0.0, 1.0, 2.5, 64.0][place.numbers.below(4)];
    Ok(match place.numbers.below(6) {
        0 => Box::new(Lambert::new(diffuse)?),
        1 => Box::new(Phong::new(diffuse, specular, exponent)?),
        _ => Box::new(Reflective::new(diffuse, specular, exponent, reflection)?),
    })
}

fn light(place: &mut Place) -> Result<LightSource, ArgumentError> {
    let (color, from, direction) = (place.color(), place.point(), place.direction());
    let casts_shadows = place.numbers.below(4) > 0;
    Ok(match place.numbers.below(3) {
        0 => LightSource::new(PointLight::new(color, from)?, casts_shadows),
        1 => LightSource::new(DirectionalLight::new(color, direction)?, casts_shadows),
        _ => LightSource::new(SpotLight::new(color, from, direction, 0.7)?, casts_shadows),
    })
}

/// The world of these shapes, with random surfaces and up to three lights.
pub fn world(
    place: &mut Place,
    shapes: Vec<Box<dyn Geometry>>,
) -> Result<ShadowedWorld, ArgumentError> {
    let mut world = ShadowedWorld::empty(place.color(), place.color())?;
    for shape in shapes {
        world = world.with(shape, surface(place)?);
    }
    for _ in 0..place.numbers.below(4) {
        world = world.lit_by(light(place)?);
    }
    Ok(world)
}

fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let shapes = place.shapes();
    let world = world(&mut place, shapes)?;
    Ok(traced(View::new(place.camera(seed)?, world)))
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    compare_scenes(0..40, view);
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

/// Rays that leave such a hit have no origin or no direction. They must not take those beside them
/// along.
#[test]
fn numbers_that_are_none_spoil_no_other_ray() {
    let view = |seed, mut place: Place| -> Result<_, ArgumentError> {
        let mut shapes = place.shapes();
        for variant in 0..8 {
            let sphere = Sphere::new(place.point(), place.length())?;
            let variant = variant % 4;
            shapes.push(Box::new(Unfinished { sphere, variant }));
        }
        let sun = DirectionalLight::new(Color::WHITE, place.direction())?;
        let light = LightSource::new(Nowhere(sun), true);
        let world = world(&mut place, shapes)?.lit_by(light);
        Ok(traced(View::new(place.camera(seed)?, world)))
    };
    compare_scenes(0..40, view);
}
