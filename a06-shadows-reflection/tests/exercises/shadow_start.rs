//! Points on triangles that stand for bulges and for hollows, compared with the solution.

use crate::prelude::*;

/// A student's `shadow_start`.
pub type ShadowStart = fn([Point3; 3], [Normal3; 3], [f64; 3]) -> Point3;

pub fn check(check: &mut Check, yours: ShadowStart) {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, -4.0]];
    let up = [0.0, 1.0, 0.0];
    let bulge = [[-0.6, 0.8, 0.0], [0.6, 0.8, 0.0], up];
    let hollow = [[0.6, 0.8, 0.0], [-0.6, 0.8, 0.0], up];
    let half = [0.5, 0.5, 0.0];
    check.compare(
        "corners {}, their normals {}, weights {}",
        [
            (corners, [up; 3], [0.5, 0.25, 0.25]),
            (corners, bulge, [1.0, 0.0, 0.0]),
            (corners, bulge, half),
            (corners, hollow, half),
            (corners, [bulge[0], up, up], half),
        ],
        random(|r| {
            let size = r.scale();
            let corners = [(); 3].map(|()| r.triple(1.0).map(|x| x * size));
            let axis = r.triple(1.0);
            let normals = [(); 3].map(|()| array(unit(axis) + vector(r.triple(0.4))));
            let beta = r.between(0.0, 1.0);
            let gamma = (1.0 - beta) * r.between(0.0, 1.0);
            (corners, normals, [1.0 - beta - gamma, beta, gamma])
        }),
        [shadow_start, yours],
        |shadow_start, (corners, normals, weights)| {
            let normals = normals.map(|normal| unit(normal).as_normal());
            array(shadow_start(corners.map(point), normals, weights) - Point3::ORIGIN)
        },
    );
    check.picture(move |settings| {
        let ball = ball()?;
        let eye = Point3::new(1.5, 1.0, 4.0);
        let (gaze, up) = (Point3::ORIGIN - eye, Vector3::new(0.0, 1.0, 0.0));
        let camera = PerspectiveCamera::new(eye, gaze, up, 0.52)?;
        let color = |ray: &Ray| ball_color(&ball, ray, yours);
        paint(&camera, &color, settings)
    });
}

/// The direction to the light of the picture, of length 1.
const TO_LIGHT: Vector3 = Vector3::new(3.0 / 7.0, 6.0 / 7.0, -2.0 / 7.0);

/// Three corners of a ball around the origin.
type Corners = [Point3; 3];

/// A ball of radius 1 in 128 triangles, whose corners have the ball's normals.
fn ball() -> Made<World<Corners>> {
    let mut world = World::new(Color::new(0.25, 0.35, 0.5))?;
    for octant in 0..8 {
        let axis = |number: usize| {
            let mut axis = [0.0; 3];
            axis[number] = if octant >> number & 1 == 0 { 1.0 } else { -1.0 };
            vector(axis)
        };
        for corners in divided([axis(0), axis(1), axis(2)], 2) {
            let [a, b, c] = corners.map(|corner| Point3::ORIGIN + corner);
            let normals = corners.map(Vector3::as_normal);
            let triangle = Triangle::new(a, b, c)?.with_normals(normals)?;
            world = world.with(triangle, [a, b, c]);
        }
    }
    Ok(world)
}

/// A triangle on the ball, each edge of which is halved some times.
fn divided([a, b, c]: [Vector3; 3], times: u32) -> Vec<[Vector3; 3]> {
    if times == 0 {
        return vec![[a, b, c]];
    }
    let [ab, bc, ca] = [a + b, b + c, c + a].map(|middle| unit(array(middle)));
    [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        .into_iter()
        .flat_map(|part| divided(part, times - 1))
        .collect()
}

/// The colour of a matt white ball whose shadow rays have a student's start.
fn ball_color(ball: &World<Corners>, ray: &Ray, shadow_start: ShadowStart) -> Color {
    let Some((hit, corners)) = ball.hit(ray, Interval::AHEAD) else {
        return ball.background();
    };
    let cosine = hit.normal.dot(TO_LIGHT);
    // The ball's normal at a corner is the vector from its centre, the origin.
    let normals = corners.map(|corner| (corner - Point3::ORIGIN).as_normal());
    let p = ray.at(hit.t);
    let start = shadow_start(*corners, normals, weights(*corners, p));
    // At a corner the start is on the triangle, and is offset as by the lesson, outwards.
    let outwards = secondary_ray(ray, &hit, hit.face.into());
    let to_light = Ray::derived(outwards.origin() + (start - p), TO_LIGHT);
    if cosine <= 0.0 || ball.is_hit(&to_light, Interval::AHEAD) {
        return Color::gray(0.1);
    }
    Color::gray(0.1 + 1.5 * cosine)
}

/// The barycentric coordinates of a point of a triangle.
fn weights([a, b, c]: Corners, p: Point3) -> [f64; 3] {
    let (to_b, to_c, to_p) = (b - a, c - a, p - a);
    let n = to_b.cross(to_c);
    let beta = to_p.cross(to_c).dot(n) / n.dot(n);
    let gamma = to_b.cross(to_p).dot(n) / n.dot(n);
    [1.0 - beta - gamma, beta, gamma]
}

variants! { check:
    yours => shadow_start;
    right "as the mean of three points" => |corners, normals, weights| {
        let p = mean(corners, weights);
        let foot = |i: usize| p + Vector3::from(normals[i]) * (corners[i] - p).dot(normals[i]).max(0.0);
        mean([foot(0), foot(1), foot(2)], weights)
    };
    wrong "the curved surface lies above the triangle" => |corners, _, weights| {
        mean(corners, weights)
    };
    wrong "over a hollow the point stays" => |corners, normals, weights| {
        raised(corners, normals, weights, |depth| depth)
    };
    wrong "below a plane the depth is positive" => |corners, normals, weights| {
        raised(corners, normals, weights, |depth| (-depth).max(0.0))
    };
    wrong "at a corner the start is this corner" => |corners, normals, weights| {
        let p = mean(corners, weights);
        let third = |i: usize| (corners[i] - p).dot(normals[i]).max(0.0) / 3.0;
        p + along(normals, [third(0), third(1), third(2)])
    };
    wrong "each corner has a plane of its own" => |corners, normals, weights| {
        let p = mean(corners, weights);
        let normal = along(normals, weights).normalized().unwrap_or_default();
        let rise = |i: usize| weights[i] * (corners[i] - p).dot(normal).max(0.0);
        p + normal * (rise(0) + rise(1) + rise(2))
    };
}

/// The mean of three points by their weights.
fn mean([a, b, c]: Corners, weights: [f64; 3]) -> Point3 {
    a + (b - a) * weights[1] + (c - a) * weights[2]
}

/// The sum of three normals, each times a length.
fn along([a, b, c]: [Normal3; 3], lengths: [f64; 3]) -> Vector3 {
    Vector3::from(a) * lengths[0] + b * lengths[1] + c * lengths[2]
}

/// The start with another rise for each depth below a corner's plane.
fn raised(
    corners: Corners,
    normals: [Normal3; 3],
    weights: [f64; 3],
    rise: fn(f64) -> f64,
) -> Point3 {
    let p = mean(corners, weights);
    let length = |i: usize| weights[i] * rise((corners[i] - p).dot(normals[i]));
    p + along(normals, [length(0), length(1), length(2)])
}
