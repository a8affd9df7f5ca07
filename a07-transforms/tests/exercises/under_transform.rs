//! Points, directions and normals of the unit ball under random transforms.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use a05_lighting::Phong;
use a07_transforms::Transform;
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::steps::{ABOVE, Step, expect_scene, frame, hit_of_child, lit_from, on_ball, point};

/// Rounding errors of coordinates up to 1e4.
const BOUND: Bound = Bound::Absolute(1e-9);

type RayToObject = fn(&Transform, &Ray) -> Ray;
type NormalFromObject = fn(&Transform, Normal3) -> Option<Normal3>;

pub fn check(check: &mut Check, ray_to_object: RayToObject, normal_from_object: NormalFromObject) {
    let mut random = Random::new(72);
    let mut case = |kind: &str, steps: &[Step]| {
        let transform = steps
            .iter()
            .fold(Transform::IDENTITY, |t, step| step.after(t));
        // A point and a direction of the object, and the same in the space around it.
        let (o, [n, side, other]) = (point(&mut random, 3.0), frame(&mut random));
        let d = (side + other * 0.5) * random.between(0.2, 4.0);
        let m = transform.matrix();
        let ray = Ray::derived(m * o, m * d);
        let got = ray_to_object(&transform, &ray);
        let words = format!("chain {steps:.2?}");
        let [from, along] = [ray.origin().to_glam(), ray.direction().to_glam()];
        let ray_words = format!("{words}, ray from {from:.2} along {along:.2}");
        let mut expect = |what: &str, words: &str, exact: [f64; 3], got: [f64; 3]| {
            check.expect(format!("{what}, {kind}; {words}"), exact, BOUND, got);
        };
        let origins = [o, got.origin()].map(|p| p.to_glam().to_array());
        expect(
            "the origin in the space of the object",
            &ray_words,
            origins[0],
            origins[1],
        );
        let directions = [d, got.direction()].map(|d| d.to_glam().to_array());
        expect(
            "the direction in the space of the object",
            &ray_words,
            directions[0],
            directions[1],
        );

        let (_, exact) = on_ball(&transform, [n, side, other]);
        let got = normal_from_object(&transform, n.as_normal());
        let words = format!("{words}, normal {:.3}", n.to_glam());
        let got = got.map_or([f64::NAN; 3], |n| n.to_glam().to_array());
        expect(
            "the normal in the space around the object",
            &words,
            exact.to_glam().to_array(),
            got,
        );
    };
    case("moved", &[Step::Translate([2.0, 0.0, 0.0])]);
    case("stretched", &[Step::Scale([2.0, 1.0, 1.0])]);
    case("turned", &[Step::RotateZ(std::f64::consts::FRAC_PI_2)]);
    for count in [1, 2, 3, 4, 2, 3, 4, 3] {
        let mut random = Random::new(720 + count);
        let steps: Vec<_> = (0..count).map(|_| Step::random(&mut random)).collect();
        case("after some steps", &steps);
    }
    expect_scene(check, "sphere-transformation", 20.0, || {
        let moved = Moved {
            child: Sphere::new(Point3::ORIGIN, 1.0)?,
            transform: Transform::IDENTITY.scale(6.0, 1.2, 4.0)?,
            functions: (ray_to_object, normal_from_object),
        };
        let material = Phong::new(Color::new(0.6, 0.0, 0.0), Color::WHITE, 64.0)?;
        Ok(lit_from(ABOVE, false, 0.25)?.with(moved, Box::new(material)))
    });
}

/// A sphere under a transform, by the student's functions.
#[derive(Debug)]
struct Moved {
    child: Sphere,
    transform: Transform,
    functions: (RayToObject, NormalFromObject),
}

impl Geometry for Moved {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (ray_to_object, normal_from_object) = self.functions;
        let to_object = |ray: &Ray| ray_to_object(&self.transform, ray);
        let from_object = |n| normal_from_object(&self.transform, n);
        hit_of_child(&self.child, ray, within, &to_object, &from_object)
    }
}
