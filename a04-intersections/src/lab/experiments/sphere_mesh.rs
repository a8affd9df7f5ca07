//! The sphere as many triangles: the cost of a mesh compared with a formula.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use common::{ArgumentError, Color};
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::lab::support::vector;
use crate::{Hit, Interval, Sphere, Triangle, World};

/// An icosphere: an icosahedron whose faces are divided into four.
pub struct Mesh {
    pub corners: Vec<Vector3>,
    /// Indices of three corners, counterclockwise seen from outside.
    pub faces: Vec<[usize; 3]>,
}

impl Mesh {
    /// 20 · 4^`divisions` triangles with corners on the unit sphere.
    pub fn icosphere(divisions: u32) -> Self {
        let golden = f64::midpoint(1.0, 5_f64.sqrt());
        let signs = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        let corners = signs.into_iter().flat_map(|(one, more)| {
            let (one, more) = (one, more * golden);
            [[0.0, one, more], [one, more, 0.0], [more, 0.0, one]]
        });
        let corners = corners.map(|corner| on_unit_sphere(vector(corner)));
        let corners: Vec<_> = corners.collect();
        // The distance of neighbours on the unit sphere is 1.05, of others more.
        let is_edge = |i: usize, j: usize| (corners[i] - corners[j]).magnitude() < 1.1;
        let mut faces = Vec::new();
        for i in 0..12 {
            for j in (i + 1..12).filter(|j| is_edge(i, *j)) {
                for k in (j + 1..12).filter(|k| is_edge(i, *k) && is_edge(j, *k)) {
                    let [a, b, c] = [i, j, k].map(|corner| corners[corner]);
                    let is_outwards = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if is_outwards { [i, j, k] } else { [i, k, j] });
                }
            }
        }
        let mut mesh = Self { corners, faces };
        (0..divisions).for_each(|_| mesh.divide());
        mesh
    }

    fn divide(&mut self) {
        let mut middles = HashMap::new();
        let corners = &mut self.corners;
        let mut middle = |i: usize, j: usize| {
            *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                corners.push(on_unit_sphere(corners[i] + corners[j]));
                corners.len() - 1
            })
        };
        let quarters = |&[a, b, c]: &[usize; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        self.faces = self.faces.iter().flat_map(quarters).collect();
    }
}

fn on_unit_sphere(v: Vector3) -> Vector3 {
    v * (1.0 / v.magnitude())
}

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
    /// Squared radius of the greatest ball inside of the mesh.
    inner: f64,
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
    Ok(Ball { world, inner })
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
        let objects = ball.world.objects.len() as f64;
        let work = objects * rays.len() as f64;
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
    let world = World::new(Color::BLACK)?.with(Sphere::new(Point3::ORIGIN, 1.0)?, ());
    let sphere = [Rc::new(Ball { world, inner: 1.0 })];
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
        shading("smooth Lambert", &balls, |hit| hit.normal.dot(W)).with_slope(-1.0, all),
        shading("flat Lambert", &balls, |hit| hit.face.dot(W)).with_slope(-0.5, all),
        // The rounding of roots near 1.
        shading("depth of the sphere", &sphere, depth).with_bound(4.0 * f64::EPSILON, 1.0..=1.0),
    ])
}

/// The sphere of more and more triangles; every ray tests all of them.
pub fn experiment() -> Experiment<'static> {
    Experiment::new("sphere-mesh")
        .asking("How many triangles make a sphere?")
        .over(Axis::Work, "objects", "tests")
        .with_error("rms error of depth, Lambert or area")
        .with_unit(Unit::Other("radii, white = 1, or all = 1"))
        .with_exact(
            "against the sphere's closed forms; Lambert is lit from the eye, \
             the silhouette is an area",
        )
        // The arguments are constants that the constructors accept.
        .with_curves(|effort| curves(effort).unwrap_or_default())
}
