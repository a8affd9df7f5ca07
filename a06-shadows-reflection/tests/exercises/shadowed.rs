//! A ball before, behind and beyond lights in worlds of all sizes, compared with the lesson.

use std::sync::Arc;

use crate::prelude::*;

yours! { is_shadowed => std::sync::Arc::new(is_shadowed) }

type Code = Arc<dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Send + Sync>;
type Other = Variant<Code>;

/// A point of the floor, centre and radius of a ball, the direction to a lamp, and its distance.
type Lit = ([f64; 3], ([f64; 3], f64), [f64; 3], f64);

pub fn exercise() -> Exercise<Code> {
    let above = |y, radius, distance| -> Lit {
        ([0.0; 3], ([0.0, y, 0.0], radius), [0.0, 1.0, 0.0], distance)
    };
    let points = Questions {
        words: "floor y = 0 at {}, ball around {} of radius {}, lamp towards {} at the distance {}"
            .into(),
        simple: vec![
            above(4.0, 1.0, 8.0),
            above(4e-9, 1e-9, 8e-9),
            // Just before the lamp, beyond it, and the lamp's own.
            above(7.96875, 0.015_625, 8.0),
            above(12.0, 1.0, 8.0),
            above(10.0, 2.0, 8.0),
            above(12.0, 1.0, f64::INFINITY),
            above(-4.0, 1.0, f64::INFINITY),
        ],
        others: random(any),
        answer,
    };
    Exercise {
        questions: vec![points.into()],
        picture: Picture::scene("aab", |is_shadowed: &Code, settings| {
            traced_picture(scenes::aab()?, settings, |world, ray, depth| {
                let tracer = Tracer {
                    world,
                    is_shadowed: &**is_shadowed,
                    secondary_ray: &secondary_ray,
                };
                tracer.trace(ray, depth)
            })
        }),
        right: vec![Other::new("a nearest hit", up_to(|d| d * (1.0 - 1e-6)))],
        wrong: vec![
            Other::new("objects beyond it cast none", up_to(|_| 1e300)),
            Other::new("the lamp's ceiling blocks nothing", up_to(|d| d)),
            Other::new("no length is fixed", up_to(|d| d - 1e-6)),
            Other::new("an object before it is seen", up_to(|d| d * 0.99)),
        ],
        ..Exercise::default()
    }
}

fn any(r: &mut Random) -> Lit {
    let distance = [1e-6, 1.0, 1e6][r.below(3) as usize] * r.between(1.0, 9.0);
    let [x, _, z] = r.triple(1.0);
    let [u, v, w] = r.triple(1.0);
    let p = vector([x, 0.0, z]) * distance;
    let to_lamp = unit([u, v.abs() + 0.1, w]);
    // Where the ball begins and ends, as fractions of the distance.
    let ends = [[0.2, 0.4], [0.992, 0.999], [1.0, 1.2], [1.1, 1.3]];
    let [from, to] = ends[r.below(4) as usize];
    let centre = p + to_lamp * (distance * f64::midpoint(from, to));
    let radius = distance * (to - from) / 2.0;
    (array(p), (array(centre), radius), array(to_lamp), distance)
}

fn answer(is_shadowed: &Code, (p, (centre, radius), to_lamp, distance): Lit) -> Option<bool> {
    // The eye is beside the point, as far as the lamp or 1.
    let size = if distance < 1e9 { distance } else { 1.0 };
    let to_eye = vector([3.0, 2.0, 1.0]) * size;
    let ray = Ray::new(point(p) + to_eye, -to_eye).ok()?;
    let world = mirrors(centre, radius, [0.0; 3]).ok()?;
    let (hit, _) = world.objects().hit(&ray, Interval::AHEAD)?;
    let light = Illumination {
        direction: unit(to_lamp),
        distance,
        ..Illumination::default()
    };
    Some(is_shadowed(world.objects(), &ray, &hit, &light))
}

/// Whether anything is hit from the surface on, up to an end that follows from the distance.
fn up_to(end: fn(f64) -> f64) -> Code {
    Arc::new(move |world, ray, hit, light| {
        let to_light = secondary_ray(ray, hit, light.direction);
        let between = Interval::before(end(light.distance));
        world.hit(&to_light, between).is_some()
    })
}
