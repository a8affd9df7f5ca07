//! All renderers draw the same pictures of random scenes of extreme numbers, after shadows and
//! mirrors.
//!
//! `RANDOM_SCENES=6000 cargo test --release -p a06-shadows-reflection --test stage extreme` compares thousands, in minutes.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::{Ray, View};
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use a04_lab::random_scene::Place;
use a04_lab::same_pictures::compare_scenes;
use a05_lighting::{DirectionalLight, Illumination, Light};
use a06_lab::random_scene::world;
use a06_shadows_reflection::{LightSource, traced};
use common::{ArgumentError, Color};

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
    let view = |seed, mut place: Place| {
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
