//! `Form`: a shape in plain numbers. A point is reprojected onto it, and it is hit in any precision.

use a02_math::arrays::array;
use a02_math::{Direction, Point3, Vector3};
use a04_lab::formula::{aligned_box, plane, sphere, triangle};
use a04_lab::line::Line;
use a04_lab::number::Real;
use a04_lab::support::{Triple, point, vector};

use crate::enclosure::Enclosure;

/// The numbers of a shape of this stage.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    Sphere {
        center: Triple,
        radius: f64,
    },
    /// Through a point, with a normal of length 1.
    Plane {
        a: Triple,
        normal: Triple,
    },
    Box {
        least: Triple,
        greatest: Triple,
    },
    Triangle {
        corners: [Triple; 3],
    },
}

/// A point that is reprojected onto a surface.
#[derive(Clone, Copy, Debug)]
pub struct OnSurface {
    pub point: Point3,
    /// The greatest rounding errors of its coordinates.
    pub error: Vector3,
}

/// The greatest relative error of `n` roundings, γ(n) (Physically Based Rendering, 4th edition,
/// section 6.8.1).
fn gamma(n: f64) -> f64 {
    let roundings = n * f64::EPSILON / 2.0;
    roundings / (1.0 - roundings)
}

impl Form {
    /// The point of the surface near a point, and the bounds of its error: those of Physically Based
    /// Rendering, 4th edition, section 6.8.5, which has those of its transforms, too, for the sphere
    /// around the origin and the disc of height 0 that become this sphere and plane. Its boxes are
    /// triangles; a face of ours has its coordinate without any error.
    pub fn reproject(&self, p: Point3) -> OnSurface {
        match *self {
            Self::Sphere { center, radius } => {
                let from_center = p - point(center);
                let on_sphere = from_center * (radius / from_center.magnitude());
                let of_sphere = magnitudes(on_sphere) * gamma(5.0);
                let of_translation =
                    (magnitudes(on_sphere) + magnitudes(vector(center))) * gamma(3.0);
                OnSurface {
                    point: point(center) + on_sphere,
                    error: of_sphere * (1.0 + gamma(3.0)) + of_translation,
                }
            }
            Self::Plane { a, normal } => {
                let on_plane = p + vector(normal) * (point(a) - p).dot(vector(normal));
                // A row of a rotation has length 1, so that no coordinate is greater than this.
                let aside = (on_plane - point(a)).magnitude();
                OnSurface {
                    point: on_plane,
                    error: (magnitudes(vector(a)) + Vector3::new(aside, aside, aside)) * gamma(3.0),
                }
            }
            Self::Box { least, greatest } => OnSurface {
                point: on_nearest_face(least, greatest, array(p)),
                error: Vector3::default(),
            },
            Self::Triangle { corners } => {
                let [a, b, c] = corners.map(point);
                let across = (b - a).cross(c - a);
                let squared = across.dot(across);
                let beta = (p - a).cross(c - a).dot(across) / squared;
                let gamma_of_c = (b - a).cross(p - a).dot(across) / squared;
                let weights = [1.0 - beta - gamma_of_c, beta, gamma_of_c];
                let (mut sum, mut of_magnitudes) = (Vector3::default(), Vector3::default());
                for (corner, weight) in corners.iter().zip(weights) {
                    sum = sum + vector(*corner) * weight;
                    of_magnitudes = of_magnitudes + magnitudes(vector(*corner)) * weight.abs();
                }
                OnSurface {
                    point: Point3::ORIGIN + sum,
                    error: of_magnitudes * gamma(7.0),
                }
            }
        }
    }

    /// The `t` of the nearest hit ahead, by the lesson's formulas in numbers of a type.
    pub fn hit<F: Real>(&self, line: &Line<F>) -> Option<F> {
        match *self {
            Self::Sphere { center, radius } => sphere::stable(&sphere::Shot {
                center: center.map(F::of),
                radius: F::of(radius),
                line: *line,
            }),
            Self::Plane { a, normal } => {
                let t = plane::t(&a.map(F::of), &normal.map(F::of), line);
                (t > F::of(0.0)).then_some(t)
            }
            Self::Box { least, greatest } => {
                aligned_box::slabs(&least.map(F::of), &greatest.map(F::of), line)
            }
            Self::Triangle { corners } => {
                let corners = corners.map(|corner| corner.map(F::of));
                triangle::watertight(&corners, line, triangle::rounded)
            }
        }
    }

    /// Whether the line hits the shape ahead, whatever the rounding errors of `t` are: its enclosure
    /// is above 0. The sign of the distance from a face of a box is exact.
    pub fn is_certainly_hit(&self, line: &Line) -> bool {
        let exact = line.to::<Enclosure>();
        match *self {
            Self::Sphere { center, radius } => {
                let shot = sphere::Shot {
                    center: center.map(Enclosure::from),
                    radius: Enclosure::from(radius),
                    line: exact,
                };
                let terms = sphere::terms(&shot.from_center(), shot.radius, &shot.line.direction);
                let is_met = terms.discriminant.high >= 0.0;
                is_met && terms.plain_roots().iter().any(|t| t.low > 0.0)
            }
            Self::Plane { a, normal } => {
                let [a, normal] = [a, normal].map(|triple| triple.map(Enclosure::from));
                plane::t(&a, &normal, &exact).low > 0.0
            }
            Self::Box { .. } => self.hit(line).is_some(),
            Self::Triangle { corners } => {
                let corners = corners.map(|corner| corner.map(Enclosure::from));
                let meeting = triangle::moeller_trumbore(&corners, &exact);
                meeting.t.low > 0.0 && self.hit(line).is_some()
            }
        }
    }
}

fn magnitudes(v: Vector3) -> Vector3 {
    vector(array(v).map(f64::abs))
}

/// The point with one coordinate replaced by that of the nearest face of a box.
fn on_nearest_face(least: Triple, greatest: Triple, p: Triple) -> Point3 {
    let (mut nearest, mut distance) = (p, f64::INFINITY);
    for axis in 0..3 {
        for face in [least[axis], greatest[axis]] {
            let from_face = (p[axis] - face).abs();
            if from_face < distance {
                distance = from_face;
                nearest = p;
                nearest[axis] = face;
            }
        }
    }
    point(nearest)
}
