//! Surfaces between all indices, compared with the solution.

use crate::prelude::*;

yours! { reflectance }

/// The reflectance by the cosine and the indices before and beyond the surface.
type Code = fn(f64, f64, f64) -> f64;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(of_diamond),
        ..Exercise::asked(|reflectance: &Code, [cosine, from, to]: [_; 3]| {
            reflectance(cosine, from, to)
        })
    }
}

/// The objects mirror as much light as diamond.
fn of_diamond(reflectance: &Code, settings: &Settings) -> Result<Image, Error> {
    rendered(&scenes::sphere()?, settings, |world, ray, depth| {
        let Some((hit, surface)) = world.objects().hit(ray, Interval::AHEAD) else {
            return Color::BLACK;
        };
        let (tracer, to_eye) = (RecursiveTracer::new(world), -ray.direction());
        let weight = reflectance(to_eye.dot(hit.normal), 1.0, 2.4);
        let mirrored = secondary_ray(ray, &hit, to_eye.reflected_on(hit.normal));
        surface.color_for(ray, &hit, &tracer) + tracer.trace(&mirrored, depth) * weight
    })
}
