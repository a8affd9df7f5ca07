//! A ball in coarse triangles, whose shadow rays have a student's start.

use crate::prelude::*;

/// The direction to the light of the picture, of length 1.
const TO_LIGHT: Vector3 = Vector3::new(3.0 / 7.0, 6.0 / 7.0, -2.0 / 7.0);

/// Three corners of a ball around the origin.
type Corners = [Point3; 3];

/// The start of the shadow rays, by the corners, their normals, and the weights of the point.
type ShadowStart<'a> = &'a (dyn Fn(Corners, [Normal3; 3], [f64; 3]) -> Point3 + Sync);

/// The picture of the ball.
pub fn picture(shadow_start: ShadowStart, settings: &Settings) -> Result<Image, Error> {
    let ball = ball()?;
    let eye = Point3::new(1.5, 1.0, 4.0);
    let (gaze, up) = (Point3::ORIGIN - eye, Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, 0.52)?;
    paint(
        &camera,
        &|ray| ball_color(&ball, ray, shadow_start),
        settings,
    )
}

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
    let outwards = secondary_ray(ray, &hit, hit.geometric_normal.into());
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
