//! A ball before, behind and beyond lights in worlds of all sizes, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { is_shadowed => std::sync::Arc::new(is_shadowed) }

type Code = Arc<dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Send + Sync>;

/// A point of the floor, centre and radius of a ball, the direction to a lamp, and its distance.
type Lit = ([f64; 3], ([f64; 3], f64), [f64; 3], f64);

pub fn exercise() -> Exercise<Code> {
    let points = Questions {
        words: "floor y = 0 at {}, ball around {} of radius {}, lamp towards {} at the distance {}",
        simple: simple(),
        others: random(any),
        answer,
    };
    Exercise {
        questions: points.into(),
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
        ..Exercise::default()
    }
}

/// A ball above the origin, and a lamp above it in this distance.
fn above(y: f64, radius: f64, distance: f64) -> Lit {
    ([0.0; 3], ([0.0, y, 0.0], radius), [0.0, 1.0, 0.0], distance)
}

/// A ball from a fraction of the way to a lamp above the origin to another one.
fn across([from, to]: [f64; 2], distance: f64) -> Lit {
    let (middle, radius) = (f64::midpoint(from, to), (to - from) / 2.0);
    above(middle * distance, radius * distance, distance)
}

/// A lamp towards this direction that is fixed to the near side of a ball.
fn fixed_to_ball(direction: [f64; 3], distance: f64) -> Lit {
    let radius = distance / 4.0;
    let centre = unit(direction) * (distance + radius);
    ([0.0; 3], (array(centre), radius), direction, distance)
}

fn simple() -> Vec<Lit> {
    let infinity = f64::INFINITY;
    let mut simple = vec![
        above(4.0, 1.0, 8.0),
        above(4e-9, 1e-9, 8e-9),
        // Just before the lamp, beyond it, and the lamp's own.
        above(7.96875, 0.015_625, 8.0),
        above(12.0, 1.0, 8.0),
        above(10.0, 2.0, 8.0),
        above(12.0, 1.0, infinity),
        above(-4.0, 1.0, infinity),
    ];
    // Before the sun, in small and in large worlds.
    for size in [1e-9, 1e-4, 1e6] {
        simple.push(above(4.0 * size, size, infinity));
        simple.push(above(-4.0 * size, size, infinity));
    }
    for distance in [8.0, 8e-6] {
        simple.push(across([0.996, 0.999], distance));
        simple.push(across([0.9997, 0.99985], distance));
        simple.push(across([0.001, 0.003], distance));
        // Closer to the surface, and to the lamp.
        simple.push(across([1e-6, 1e-5], distance));
        simple.push(across([0.99999, 0.999_995], distance));
        simple.push(across([0.999_999, 0.999_999_5], distance));
    }
    for distance in [8.0, 8e-6, 8e6] {
        for direction in [[3.0, 4.0, 0.0], [-2.0, 3.0, 6.0], [1.0, 1.0, 1.0]] {
            simple.push(fixed_to_ball(direction, distance));
        }
    }
    // Below the floor, with a ball before the lamp and beyond it.
    for y in [-4.0, -12.0] {
        simple.push(([0.0; 3], ([0.0, y, 0.0], 1.0), [0.0, -1.0, 0.0], 8.0));
    }
    // In the triangle, which leans, and beyond it; the ball is far away.
    let in_triangle = [0.0, 1.5, -4.0];
    let length = vector(in_triangle).magnitude();
    let ball = ([40.0, 1.0, 0.0], 1.0);
    simple.push(([0.0; 3], ball, in_triangle, length));
    simple.push(([0.0; 3], ball, in_triangle, 2.0 * length));
    simple
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
    Some(is_shadowed(world.objects(), &ray, &hit, &light))
}
