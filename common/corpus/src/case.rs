//! `Question`: a ray and a shape; `Case`: with the exact answer.

/// A ray and a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Unique: the family, and a number.
    pub id: String,
    /// The kind of difficulty, such as `needle`.
    pub family: String,
    /// What happens, in a sentence.
    pub says: String,
    /// The address of the public report or of the paper, or `ours`.
    pub source: String,
    /// The shape, in its own space.
    pub shape: Shape,
    /// The steps from the space of the shape to that of the ray, the last of which is applied
    /// first.
    pub under: Vec<Step>,
    /// The origin of the ray.
    pub origin: [f64; 3],
    /// The direction of the ray, of any length, which is the unit of `t`.
    pub direction: [f64; 3],
    /// The open interval of valid `t`.
    pub within: [f64; 2],
}

/// A question, and what exact arithmetic says.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The ray and the shape.
    pub question: Question,
    /// The exact answer.
    pub answer: ExactAnswer,
    /// How many times greater the relative change of `t` may be than those of all numbers of ray
    /// and shape: the sum of `|∂t/∂x · x / t|`. Infinite where the ray touches a round shape, 0
    /// where there is no `t`.
    pub condition: f64,
    /// Whether the ray meets a border: some changes of all numbers by up to 16 rounding errors make a hit of a
    /// miss, or the opposite.
    pub is_border: bool,
    /// The least and the greatest `t` of the hits under such changes, where `t` moves farther than its condition
    /// explains, such as for a ray that starts on the surface.
    pub between: Option<[f64; 2]>,
}

/// A shape. Borders belong to it; a ray hits its surface, also from inside.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points `p` with `(p - point) · normal = 0`.
    Plane {
        /// One of its points.
        point: [f64; 3],
        /// Perpendicular to it, of any length but 0.
        normal: [f64; 3],
    },
    /// All points at a distance from a point.
    Sphere {
        /// Its middle.
        center: [f64; 3],
        /// The distance.
        radius: f64,
    },
    /// The surface of a box whose faces are perpendicular to the axes.
    Box {
        /// The least coordinates.
        low: [f64; 3],
        /// The greatest coordinates.
        high: [f64; 3],
    },
    /// The part of a plane within a distance of a point.
    Disc {
        /// Its middle.
        center: [f64; 3],
        /// Perpendicular to it, of any length but 0.
        normal: [f64; 3],
        /// The distance.
        radius: f64,
    },
    /// A round tube, open at both ends.
    Tube {
        /// The middle of one end.
        from: [f64; 3],
        /// The middle of the other end.
        to: [f64; 3],
        /// The distance of its wall from the axis.
        radius: f64,
    },
    /// One triangle or several, each of three corners.
    Triangles(Vec<[[f64; 3]; 3]>),
}

/// A step from one space to the one around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Adds to the coordinates.
    Translate([f64; 3]),
    /// Multiplies the coordinates. No factor is 0.
    Scale([f64; 3]),
}

/// What exact arithmetic says of a ray and a shape.
#[derive(Clone, Debug, PartialEq)]
pub enum ExactAnswer {
    /// The ray hits the shape.
    Hit(Hit),
    /// The ray misses the shape within the interval.
    Miss,
    /// The ray lies in the plane of a flat shape and meets it, so that there is no single `t`.
    Coplanar,
}

/// The nearest hit within the interval.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// `t`, rounded to 40 significant digits.
    pub digits: String,
    /// `t`, rounded to a double.
    pub t: f64,
    /// The geometric normal of length 1, out of a closed shape; of a triangle, to the side from
    /// which its corners run counterclockwise. To 40 significant digits. `None` on an edge, where
    /// two normals are right.
    pub normal: Option<[String; 3]>,
}
