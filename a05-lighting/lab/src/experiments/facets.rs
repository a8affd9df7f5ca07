//! Model error beside rounding: a ball of triangles against the ball.

use std::f64::consts::TAU;
use std::rc::Rc;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Interval, Triangle, World};
use a04_lab::mesh::Mesh;
use a04_lab::support::Numbers;
use common::{Color, Error};
use measure::experiment::{Axis, Curve, Curves, Errors, Experiment, Point, Slope, Times, Unit};

/// The error of a ball of radius 1 that is made of N triangles.
///
/// N triangles of width h cover the ball, so that `h ~ N^(-1/2)`. A chord of the length h lies `1 -
/// cos(h/2)`, about `h²/8`, below its arc: the outline falls short by `N^-1`. The normal of a flat
/// triangle is off by up to about `0.6 h` at a corner: the brightness of flat shading is off by
/// `N^(-1/2)`. The corners have the ball's normals, which are their positions, so that the
/// interpolated normal at a point p of the triangle is `p / |p|`. The ray meets the ball at most
/// about `h²/5` above p, divided by the cosine of ray and normal, and the normal there differs by as
/// much: smooth shading is off by `N^-1`.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How many triangles does a ball need?",
        curves_are: Curves::Problems,
        parameter: "triangles",
        work: "tests of a triangle",
        error: "rms error",
        unit: Unit::Other("radius = 1, white = 1"),
        exact: "against the ball; brightness within 0.9 radii of the middle",
        against: Axis::Parameter,
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("facets")
    }
}

const SEED: u64 = 19;

fn curves() -> Vec<Curve<'static>> {
    let curve = |name, measure, normals, slope| Curve {
        slope: Some(Slope {
            value: slope,
            between: 0.0..=f64::INFINITY,
        }),
        ..Curve::new(name, points(measure, normals).unwrap_or_default())
    };
    vec![
        curve("outline", OUTLINE, Normals::Interpolated, -1.0),
        curve("brightness, flat", BRIGHTNESS, Normals::Flat, -0.5),
        curve(
            "brightness, smooth",
            BRIGHTNESS,
            Normals::Interpolated,
            -1.0,
        ),
    ]
}

/// The normals of the triangles' corners.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Normals {
    /// The normal of the triangle.
    Flat,
    /// The ball's normals at the corners, interpolated.
    Interpolated,
}

/// An error of a ball of triangles.
#[derive(Clone, Copy)]
struct Measure {
    /// The error of the `n`-th sample.
    error: fn(&World<()>, n: usize) -> Result<f64, Error>,
    /// The number of its rays.
    rays: usize,
}

/// See [`of_outline`].
const OUTLINE: Measure = Measure {
    error: of_outline,
    rays: BISECTIONS,
};

/// See [`of_brightness`].
const BRIGHTNESS: Measure = Measure {
    error: of_brightness,
    rays: 1,
};

/// Each number of triangles with its errors. A ray is tested against each triangle.
fn points(measure: Measure, normals: Normals) -> Result<Vec<Point<'static>>, Error> {
    let Measure { error, rays } = measure;
    let count = 1024 / rays;
    let mut points = Vec::new();
    // 20 triangles are too few for h to be small.
    for divisions in 1..=4 {
        let ball = Rc::new(ball(divisions, normals)?);
        let mut errors = Vec::new();
        for n in 0..count {
            errors.push(error(&ball, n)?);
        }
        let triangles = f64::from(20 * 4_u32.pow(divisions));
        points.push(Point {
            parameter: triangles,
            work: triangles * (count * rays) as f64,
            errors: Errors::of(errors),
            times: Times::of(move || {
                let errors = (0..count).map(|n| error(&ball, n).unwrap_or(f64::NAN));
                errors.sum::<f64>()
            }),
        });
    }
    Ok(points)
}

/// The ball of radius 1 around the origin in 20 · 4^`divisions` triangles.
fn ball(divisions: u32, normals: Normals) -> Result<World<()>, Error> {
    let mesh = Mesh::icosphere(divisions);
    let mut ball = World::new(Color::BLACK)?;
    for face in &mesh.faces {
        let corners = face.map(|corner| mesh.corners[corner]);
        let [a, b, c] = corners.map(|corner| Point3::ORIGIN + corner);
        let mut triangle = Triangle::new(a, b, c)?;
        if normals == Normals::Interpolated {
            triangle = triangle.with_normals(corners.map(Vector3::as_normal))?;
        }
        ball = ball.with(triangle, ());
    }
    Ok(ball)
}

/// A direction of view, from which parallel rays come.
struct View {
    /// Towards the eye.
    back: Vector3,
    /// At right angles to it and to each other.
    right: Vector3,
    up: Vector3,
}

impl View {
    fn random(numbers: &mut Numbers) -> Self {
        let [back, right] = numbers.perpendicular();
        Self {
            back,
            right,
            up: back.cross(right),
        }
    }

    /// The ray that passes the middle of the ball at a distance, in a direction around it.
    fn ray(&self, distance: f64, angle: f64) -> Result<Ray, Error> {
        let eye = self.place(distance, angle) + self.back * 3.0;
        Ok(Ray::new(Point3::ORIGIN + eye, -self.back)?)
    }

    /// The place of this ray on the plane through the middle.
    fn place(&self, distance: f64, angle: f64) -> Vector3 {
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        (self.right * cosine + self.up * sine) * distance
    }
}

/// They leave `2⁻²⁵`, far less than the least height of a chord here, 1e-4.
const BISECTIONS: usize = 24;

/// How far the outline of the triangles lies inside that of the ball, in a direction of a view. A
/// convex body is hit up to its outline, which bisection finds.
fn of_outline(ball: &World<()>, n: usize) -> Result<f64, Error> {
    let mut numbers = Numbers::new(SEED, n);
    let view = View::random(&mut numbers);
    let angle = numbers.between(0.0, TAU);
    let (mut inside, mut outside) = (0.5, 1.0);
    for _ in 0..BISECTIONS {
        let middle = f64::midpoint(inside, outside);
        if ball.is_hit(&view.ray(middle, angle)?, Interval::AHEAD) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Ok(1.0 - inside)
}

/// The difference of the brightness n · l at a point of a view, 0 where the surface is turned away
/// from the light.
fn of_brightness(ball: &World<()>, n: usize) -> Result<f64, Error> {
    let mut numbers = Numbers::new(SEED, n);
    let view = View::random(&mut numbers);
    // Evenly over the disc.
    let distance = 0.9 * numbers.between(0.0, 1.0).sqrt();
    let angle = numbers.between(0.0, TAU);
    let to_light = numbers.direction();
    let brightness = |normal: Normal3| to_light.dot(normal).max(0.0);

    let height = (1.0 - distance * distance).sqrt();
    let of_ball = (view.place(distance, angle) + view.back * height).as_normal();
    let ray = view.ray(distance, angle)?;
    let found = ball.hit(&ray, Interval::AHEAD);
    let of_triangles = found.map_or(0.0, |(hit, ())| brightness(hit.normal));
    Ok(of_triangles - brightness(of_ball))
}
