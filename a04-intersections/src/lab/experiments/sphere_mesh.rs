//! The sphere as many triangles: the cost of a mesh compared with a formula.

use std::f64::consts::PI;
use std::rc::Rc;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use common::{ArgumentError, Color};
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use super::icosphere::Mesh;
use crate::{Hit, Interval, Sphere, Triangle, World};

/// The view: towards -w, u to the right and v upwards. Slanted, so that no face
/// and no edge of the icosahedron is parallel to it.
const U: Vector3 = Vector3::new(3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0);
const V: Vector3 = Vector3::new(6.0 / 7.0, 2.0 / 7.0, -3.0 / 7.0);
const W: Vector3 = Vector3::new(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0);

/// Distance of the origins of the parallel rays.
const BEFORE: f64 = 2.0;

/// Parallel rays by the square of their distance from the axis, which is spread
/// evenly over an interval; each is rotated by the golden angle (Vogel, "A
/// Better Way to Construct the Sunflower Head", 1979).
fn rays(count: usize, least: f64, most: f64) -> Vec<(f64, Ray)> {
    let golden_angle = PI * (3.0 - 5_f64.sqrt());
    let ray = |n: usize| {
        let square = least + (most - least) * (n as f64 + 0.5) / count as f64;
        let (sin, cos) = libm::sincos(golden_angle * n as f64);
        let aside = U * (square.sqrt() * cos) + V * (square.sqrt() * sin);
        let origin = Point3::ORIGIN + aside + W * BEFORE;
        (square, Ray::derived(origin, -W))
    };
    (0..count).map(ray).collect()
}

/// A unit sphere in a world of its own.
struct Ball {
    world: World<()>,
    objects: f64,
    /// Squared radius of the greatest ball inside of the mesh.
    inner: f64,
}

fn round() -> Result<Ball, ArgumentError> {
    Ok(Ball {
        world: World::new(Color::BLACK)?.with(Sphere::new(Point3::ORIGIN, 1.0)?, ()),
        objects: 1.0,
        inner: 1.0,
    })
}

/// A ball of triangles, with the normals of the sphere at their corners.
fn angular(divisions: u32) -> Result<Ball, ArgumentError> {
    let mesh = Mesh::icosphere(divisions);
    let mut world = World::new(Color::BLACK)?;
    let mut inner = f64::INFINITY;
    for face in &mesh.faces {
        let ways = face.map(|corner| mesh.corners[corner]);
        let [a, b, c] = ways.map(|way| Point3::ORIGIN + way);
        let triangle = Triangle::new(a, b, c)?.with_normals(ways.map(Vector3::as_normal))?;
        let normal = (b - a).cross(c - a);
        let distance = normal.dot(ways[0]) / normal.magnitude();
        inner = inner.min(distance * distance);
        world = world.with(triangle, ());
    }
    Ok(Ball {
        world,
        objects: mesh.faces.len() as f64,
        inner,
    })
}

/// A curve over all meshes, by the errors of rays whose squared distances from the axis
/// are in a range.
fn curve(
    method: &'static str,
    balls: &[Rc<Ball>],
    rays: impl Fn(&Ball) -> Vec<(f64, Ray)>,
    errors: impl Fn(&Ball, &[(f64, Ray)]) -> Vec<f64> + Copy + 'static,
) -> Curve<'static> {
    let points = balls.iter().map(|ball| {
        let (ball, rays) = (Rc::clone(ball), rays(ball));
        let (objects, work) = (ball.objects, ball.objects * rays.len() as f64);
        let run = move || errors(&ball, &rays);
        Point::new(objects, work, run(), run)
    });
    Curve::new(method, points)
}

/// Fraction of the sphere's disc that the mesh does not cover. It lies outside of
/// the greatest ball inside of the mesh, so the rays are only there.
fn silhouette(ball: &Ball, rays: &[(f64, Ray)]) -> Vec<f64> {
    let passes = |(_, ray): &&(f64, Ray)| !ball.world.is_hit(ray, Interval::AHEAD);
    let share = rays.iter().filter(passes).count() as f64 / rays.len() as f64;
    vec![(1.0 - ball.inner) * share]
}

fn curves(effort: Effort) -> Result<Vec<Curve<'static>>, ArgumentError> {
    let divisions = 1..=effort.choose(3, 4) as u32;
    let balls = divisions.map(|divisions| angular(divisions).map(Rc::new));
    let balls = balls.collect::<Result<Vec<_>, _>>()?;
    let sphere = [Rc::new(round()?)];
    let count = effort.choose(2048, 4096);
    // The exact value is the height of the sphere over the plane through its centre. The
    // rays pass within nine tenths of the radius, because near the rim depth and normals
    // change too fast for a comparison.
    let shading = |method, balls: &[_], quantity: fn(Hit) -> f64| {
        let error = move |ball: &Ball, (square, ray): &(f64, Ray)| {
            let hit = ball.world.hit(ray, Interval::AHEAD);
            hit.map_or(1.0, |(hit, ())| quantity(hit) - (1.0 - square).sqrt())
        };
        let errors =
            move |ball: &Ball, rays: &[_]| rays.iter().map(|ray| error(ball, ray)).collect();
        curve(method, balls, |_| rays(count, 0.0, 0.81), errors)
    };
    let at_rim = |ball: &Ball| rays(count, ball.inner, 1.0);
    let all = (0.0, f64::INFINITY);
    let depth = |hit: Hit| BEFORE - hit.t;
    Ok(vec![
        curve("silhouette", &balls, at_rim, silhouette).with_slope(-1.0, all),
        shading("depth", &balls, depth).with_slope(-1.0, all),
        shading("smooth Lambert", &balls, |hit| hit.normal.dot(W))
            .with_slope(-1.0, all)
            .with_remark(
                "normals interpolated between the corners double the slope for next to nothing",
            ),
        shading("flat Lambert", &balls, |hit| hit.face.dot(W)).with_slope(-0.5, all),
        // The rounding of roots near 1.
        shading("depth of the sphere", &sphere, depth)
            .with_bound(4.0 * f64::EPSILON, 1.0..=1.0)
            .with_remark("one object instead of thousands, and exact: spheres are no meshes here"),
    ])
}

/// The sphere of more and more triangles; every ray tests all of them.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "sphere-mesh",
        about: "How many triangles make a sphere?",
        knob: "objects",
        work: "tests",
        error: "rms error of depth, Lambert or area",
        unit: Unit::Other("radii, white = 1, or all = 1"),
        exact: "against the sphere's closed forms; Lambert is lit from the eye, the silhouette is an area",
        seeds: &[],
        against: Axis::Work,
        // The arguments are constants that the constructors accept.
        curves: Box::new(|effort| curves(effort).unwrap_or_default()),
    }
}
