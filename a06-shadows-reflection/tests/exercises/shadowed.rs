//! A ball before, behind and beyond lights in worlds of all sizes, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { is_shadowed => std::sync::Arc::new(is_shadowed) }

type Code = Arc<dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Send + Sync>;

/// A point of the floor, centre and radius of a ball, the direction to a lamp, and its distance.
type Lit = ([f64; 3], ([f64; 3], f64), [f64; 3], f64);

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("aab", |is_shadowed: &Code, settings| {
            traced_picture(scenes::aab()?, settings, |world, ray, depth| {
                let tracer = Tracer {
                    world,
                    is_shadowed: &**is_shadowed,
                    secondary_ray: &secondary_ray,
                };
                tracer.trace(ray, depth)
            })
        }),
        ..Exercise::asked(answer)
    }
}

fn answer(is_shadowed: &Code, (p, (centre, radius), to_lamp, distance): Lit) -> Option<Answer> {
    // The eye is beside the point, as far as the lamp or, before the sun, the ball.
    let to_ball = (point(centre) - point(p)).magnitude();
    let size = if distance.is_finite() {
        distance
    } else {
        to_ball
    };
    let to_eye = vector([3.0, 2.0, 1.0]) * size;
    let ray = Ray::new(point(p) + to_eye, -to_eye).ok()?;
    let world = mirrors(centre, radius, Color::BLACK).ok()?;
    let (hit, _) = world.objects().hit(&ray, Interval::AHEAD)?;
    let light = Illumination {
        direction: unit(to_lamp),
        distance,
        ..Illumination::default()
    };
    let is_shadowed = is_shadowed(world.objects(), &ray, &hit, &light);
    Some(Answer::named("an object between", is_shadowed))
}
