//! Asks formulas and libraries in Rust the cases of the corpus, and writes what they find.
//!
//! `cargo run --release --manifest-path common/corpus/adapters/Cargo.toml` writes `results/NAME.txt` for each.

use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

use a04_lab::formula::sphere::SphereQuery;
use a04_lab::formula::triangle::{self, PlaneHit, fused, watertight};
use a04_lab::line::{Line, line};
use a04_lab::protocol::{self, Compared};
use a04_lab::support::{point, vector};
use a07_lab::asked::{self, engine_has, lesson_has};
use corpus::{CASES, Found, Question, Shape};

/// Something that can be asked.
struct Adapter {
    /// The name of the file of its results.
    name: &'static str,
    /// Its version and options, for the table.
    title: &'static str,
    /// What it finds; none if it has no such shape, or its documentation excludes the question.
    ask: fn(&Question) -> Option<Found>,
}

const ADAPTERS: [Adapter; 7] = [
    Adapter {
        name: "lesson",
        title: "the lesson",
        ask: lesson,
    },
    Adapter {
        name: "engine",
        title: "the engine, `--fast`",
        ask: engine,
    },
    Adapter {
        name: "protocol",
        title: "the course's protocol, as printed",
        ask: by_the_protocol,
    },
    Adapter {
        name: "moeller-trumbore",
        title: "Möller-Trumbore in doubles",
        ask: moeller_trumbore,
    },
    Adapter {
        name: "woop-compensated",
        title: "Woop, Benthin and Wald in doubles, with Kahan's difference of products",
        ask: woop_compensated,
    },
    Adapter {
        name: "parry",
        title: "`parry3d-f64` 0.31.1, `cast_local_ray`, `solid = false`",
        ask: parry,
    },
    Adapter {
        name: "bvh",
        title: "`bvh` 0.13.0 in doubles, without SIMD",
        ask: bvh,
    },
];

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
    for adapter in ADAPTERS {
        let mut text = format!("# {}\n# double\n", adapter.title);
        for case in corpus::read(CASES).map_err(io::Error::other)? {
            // A `String` takes all.
            let _ = match (adapter.ask)(&case.question) {
                None => Ok(()),
                Some(None) => writeln!(text, "{} miss", case.question.id),
                Some(Some(t)) => writeln!(text, "{} {t:?}", case.question.id),
            };
        }
        fs::write(folder.join(adapter.name).with_extension("txt"), text)?;
    }
    Ok(())
}

fn lesson(question: &Question) -> Option<Found> {
    let hit = || asked::lesson(question).ok();
    let hit = lesson_has(question).then(hit)??;
    Some(hit.map(|hit| hit.t))
}

fn engine(question: &Question) -> Option<Found> {
    let found = || asked::engine(question).ok();
    engine_has(question).then(found)?
}

/// The formulas as printed.
fn by_the_protocol(question: &Question) -> Option<Found> {
    if !question.under.is_empty() {
        return None;
    }
    let ray = asked::ray(question);
    // Its normals have length 1.
    let unit = |normal| vector(normal).as_normal().normalized();
    let found = match &question.shape {
        Shape::Plane { point: a, normal } => protocol::plane(point(*a), unit(*normal)?, &ray),
        Shape::Sphere { center, radius } => protocol::sphere(&SphereQuery {
            center: *center,
            radius: *radius,
            line: line_of(question),
        }),
        Shape::Box { low, high } => {
            protocol::axis_aligned_box(point(*low), point(*high), &ray, Compared::Three)
        }
        Shape::Disc {
            center,
            normal,
            radius,
        } => a07_lab::protocol::disc(point(*center), unit(*normal)?, *radius, &ray),
        Shape::Triangles(all) => {
            let found = |corners: &[_; 3]| protocol::triangle(&corners.map(point), &ray);
            nearest(all.iter().map(found))
        }
        Shape::Tube { .. } => return None,
    };
    Some(within(question, found))
}

fn moeller_trumbore(question: &Question) -> Option<Found> {
    let line = line_of(question);
    of_triangles(question, |corners| {
        met(triangle::moeller_trumbore(corners, &line))
    })
}

/// The lesson's test of triangles with Kahan's difference of products.
fn woop_compensated(question: &Question) -> Option<Found> {
    let line = line_of(question);
    of_triangles(question, |corners| watertight(corners, &line, fused))
}

/// `parry3d-f64`: hollow shapes, from the origin of the ray on.
fn parry(question: &Question) -> Option<Found> {
    use parry3d_f64::bounding_volume::Aabb;
    use parry3d_f64::math::{Pose, Vector};
    use parry3d_f64::query::{Ray, RayCast};
    use parry3d_f64::shape::{Ball, HalfSpace, TriMesh, Triangle};
    let v = Vector::from_array;
    let [min, max] = question.within;
    if min != 0.0 || !question.under.is_empty() {
        return None;
    }
    let max = max.min(f64::MAX);
    let ray = Ray::new(v(question.origin), v(question.direction));
    match &question.shape {
        Shape::Sphere { center, radius } => {
            let pose = Pose::from_translation(v(*center));
            Some(Ball::new(*radius).cast_ray(&pose, &ray, max, false))
        }
        Shape::Box { low, high } => {
            Some(Aabb::new(v(*low), v(*high)).cast_local_ray(&ray, max, false))
        }
        // Its half space is solid on one side: only from outside of it.
        Shape::Plane { point, normal } => {
            let normal = v(*normal).normalize();
            let is_outside = (ray.origin - v(*point)).dot(normal) > 0.0;
            let pose = Pose::from_translation(v(*point));
            is_outside.then(|| HalfSpace::new(normal).cast_ray(&pose, &ray, max, false))
        }
        Shape::Triangles(all) => match all.as_slice() {
            [[a, b, c]] => {
                Some(Triangle::new(v(*a), v(*b), v(*c)).cast_local_ray(&ray, max, false))
            }
            all => {
                let corners = all.iter().flatten().map(|corner| v(*corner)).collect();
                let faces = (0..all.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]);
                let mesh = TriMesh::new(corners, faces.collect()).ok()?;
                Some(mesh.cast_local_ray(&ray, max, false))
            }
        },
        Shape::Disc { .. } | Shape::Tube { .. } => None,
    }
}

/// `bvh`: boxes, and triangles in both directions, because it culls those that are seen from behind. Rays in
/// the plane of a face of a box are not asked: its documentation says that they miss.
fn bvh(question: &Question) -> Option<Found> {
    use bvh::{aabb::Aabb, ray::Ray};
    use nalgebra::{Point3, Vector3};
    let (o, d) = (question.origin, question.direction);
    let ray = Ray::new(Point3::from(o), Vector3::from(d));
    // Its distances are lengths.
    let length = Vector3::from(d).norm();
    match &question.shape {
        Shape::Box { low, high } if question.under.is_empty() => {
            let is_in_face = |i: usize| d[i] == 0.0 && (o[i] == low[i] || o[i] == high[i]);
            if (0..3).any(is_in_face) {
                return None;
            }
            let aabb = Aabb::with_bounds(Point3::from(*low), Point3::from(*high));
            let ends = ray.intersection_slice_for_aabb(&aabb);
            // From inside, the first of both is 0.
            let surface = ends.map(|(enter, leave)| if enter > 0.0 { enter } else { leave });
            Some(within(question, surface.map(|distance| distance / length)))
        }
        _ => of_triangles(question, |corners| {
            let [a, b, c] = corners.map(Point3::from);
            let front = ray.intersects_triangle(&a, &b, &c).distance;
            let back = ray.intersects_triangle(&a, &c, &b).distance;
            let distance = Some(front.min(back)).filter(|distance| *distance != f64::INFINITY);
            distance.map(|distance| distance / length)
        }),
    }
}

/// The nearest answer of a formula for triangles; none if the question is about another shape.
fn of_triangles(
    question: &Question,
    formula: impl Fn(&[[f64; 3]; 3]) -> Found,
) -> Option<Found> {
    match &question.shape {
        Shape::Triangles(all) if question.under.is_empty() => {
            let found = |corners| within(question, formula(corners));
            Some(nearest(all.iter().map(found)))
        }
        _ => None,
    }
}

/// The `t` within a triangle. The numbers of a ray along the plane are infinite or no numbers.
fn met(PlaneHit { t, beta, gamma }: PlaneHit<f64>) -> Found {
    let is_inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
    (is_inside && !t.is_nan()).then_some(t)
}

/// The least answer.
fn nearest(found: impl IntoIterator<Item = Found>) -> Found {
    let found = found.into_iter().flatten();
    found.reduce(|a, b| if b < a { b } else { a })
}

/// An answer within the interval of a question, for what has no interval itself.
fn within(question: &Question, found: Found) -> Found {
    let [min, max] = question.within;
    found.filter(|t| t.is_nan() || (min < *t && *t < max))
}

fn line_of(question: &Question) -> Line {
    line(question.origin, question.direction)
}
