//! `Triangle`: three corners, each with a normal of its own.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use common::{ArgumentError, argument, text};

use crate::{Geometry, Hit, Interval, SQUARED_LENGTHS, hit_of_scaled_ray};

/// A triangle. It has no thickness, and is seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    pub(crate) corners: [Point3; 3],
    pub(crate) normals: [Normal3; 3],
    pub(crate) geometric_normal: Normal3,
    /// See [`Face::scale`].
    pub(crate) scale: f64,
}

impl Triangle {
    /// The triangle of three corners that do not lie on a line, the farthest two
    /// of them at least 1e-100 apart, with flat shading. Its normal points to the
    /// side from which the corners run counterclockwise.
    pub fn new(a: Point3, b: Point3, c: Point3) -> Result<Self, ArgumentError> {
        let corners = [
            a.checked("corner a")?,
            b.checked("corner b")?,
            c.checked("corner c")?,
        ];
        let Face { normal, scale } = Face::new(corners)?;
        Ok(Self {
            corners,
            normals: [normal; 3],
            geometric_normal: normal,
            scale,
        })
    }

    /// This triangle with smooth shading: with the normals of `a`, `b` and `c`,
    /// each of any length but 0. Between the corners they are interpolated by
    /// barycentric coordinates.
    pub fn with_normals(mut self, normals: [Normal3; 3]) -> Result<Self, ArgumentError> {
        let [a, b, c] = normals;
        self.normals = [
            a.unit("normal of a")?,
            b.unit("normal of b")?,
            c.unit("normal of c")?,
        ];
        // The geometric normal points to the side of the corners' normals.
        let [a, b, c] = self.normals;
        if (a + b + c).dot(self.geometric_normal) < 0.0 {
            self.geometric_normal = -self.geometric_normal;
        }
        Ok(self)
    }

    /// The normal at barycentric coordinates: `(1 - β - γ) nA + β nB + γ nC`,
    /// normalised. If the sum is 0, the geometric normal.
    // ANCHOR: normal
    fn interpolated_normal(&self, beta: f64, gamma: f64) -> Normal3 {
        let [a, b, c] = self.normals;
        if a == b && b == c {
            return a;
        }
        let mean = a * (1.0 - beta - gamma) + b * beta + c * gamma;
        mean.normalized().unwrap_or(self.geometric_normal)
    }
    // ANCHOR_END: normal
}

/// What three corners have in common.
struct Face {
    /// The geometric normal: perpendicular to two edges, of length 1.
    normal: Normal3,
    /// The square of the longest edge, divided by the least height.
    ///
    /// The `t` of a hit is a weighted mean of the corners' depths, so its rounding error
    /// grows with the longest edge. The weights are areas divided by the area of the
    /// triangle, so their errors grow as the triangle becomes a needle.
    scale: f64,
}

impl Face {
    fn new([a, b, c]: [Point3; 3]) -> Result<Self, ArgumentError> {
        let on_a_line = || {
            let corners = [a, b, c].map(|corner| text::numbers(&corner.to_glam().to_array()));
            let corners = format!("[{}]", corners.join("], ["));
            ArgumentError::new("triangle", corners, "three corners that are not on a line")
        };
        // Divided by the longest edge, so that neither tiny nor huge triangles
        // lose their normal, and the order of the corners does not matter.
        let edges = [b - a, c - a, c - b];
        let longest = edges
            .map(Vector3::magnitude)
            .into_iter()
            .fold(0.0, f64::max);
        let [ab, ac] = [edges[0], edges[1]].map(|edge| edge * (1.0 / longest));
        let across = ab.cross(ac);
        // The least height of the triangle, in lengths of its longest edge.
        let least_height = across.magnitude();
        // For corners on a line the normal is only rounding error; for a point, NaN.
        if least_height > 4.0 * f64::EPSILON {
            // With shorter edges the areas in the hit test lose digits.
            let stands = longest >= argument::MIN_LENGTH;
            argument::check("longest edge", longest, stands, "at least 1e-100 long")?;
            Ok(Self {
                normal: across.as_normal().unit("triangle")?,
                scale: longest / least_height,
            })
        } else {
            Err(on_a_line())
        }
    }
}

/// The test of Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection",
/// JCGT 2(1), 2013: no ray passes between two triangles that share an edge,
/// because both compute the same number for it, with opposite signs.
impl Geometry for Triangle {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let space = ShearedSpace::new(ray);
        if !SQUARED_LENGTHS.contains(&(space.scale_z * space.scale_z)) {
            return hit_of_scaled_ray(self, ray, within);
        }
        let [a, b, c] = self.corners.map(|corner| space.sheared(corner));

        // The sign gives the axis's side of each edge; 0 is on the edge, a hit.
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        // Seen along its plane, the triangle has no area.
        if determinant == 0.0 || is_beside([a, b, c]) {
            return None;
        }

        let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        within.contains(t).then(|| Hit {
            t,
            normal: self.interpolated_normal(v / determinant, w / determinant),
            geometric_normal: self.geometric_normal,
            scale: self.scale,
        })
    }
    // ANCHOR_END: hit
}

/// The space in which a ray is the z axis, sheared so that z is measured in `t`.
struct ShearedSpace {
    /// The axes of the scene that become x, y and z. The direction's largest
    /// coordinate is along z.
    axes: [usize; 3],
    /// The origin of the ray along these axes.
    o: [f64; 3],
    shear: [f64; 2],
    scale_z: f64,
}

impl ShearedSpace {
    fn new(ray: &Ray) -> Self {
        let d = ray.direction().to_glam();
        let z = d.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (o, d) = (ray.origin().to_glam().to_array(), d.to_array());
        Self {
            axes: [x, y, z],
            o: [o[x], o[y], o[z]],
            shear: [d[x] / d[z], d[y] / d[z]],
            scale_z: 1.0 / d[z],
        }
    }

    // ANCHOR: sheared
    fn sheared(&self, point: Point3) -> [f64; 3] {
        let ([x, y, z], point) = (self.axes, point.to_glam().to_array());
        let depth = point[z] - self.o[2];
        [
            (point[x] - self.o[0]) - self.shear[0] * depth,
            (point[y] - self.o[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
    // ANCHOR_END: sheared
}

/// Whether all corners in sheared space lie on one side of the axis, in x or in y.
/// Then the ray misses the triangle. The signs of the areas may be wrong by rounding if
/// the ray lies in the plane of the triangle, or is so far away that the corners are
/// almost one point.
fn is_beside(corners: [[f64; 3]; 3]) -> bool {
    let all = |axis: usize, sign: f64| corners.iter().all(|c| sign * c[axis] > 0.0);
    all(0, 1.0) || all(0, -1.0) || all(1, 1.0) || all(1, -1.0)
}
