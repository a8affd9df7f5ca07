//! Spheres: the normal seen from inside, and the root of a miss. Far, huge and tiny spheres, tangent rays, and
//! rays that no scene contains are rows of `cases.toml`.

use a02_math::{Direction, Point3};
use common::{ArgumentError, Color};
use measure::extremes::{Case, Outcome, tried};

use super::nearest_hit;
use crate::formula::sphere::SphereQuery;
use crate::line::{Line, line};
use crate::protocol::{self, Quadratic};
use crate::support::{Triple, vector};
use a04_intersections::{Geometry, Interval, Sphere, World};

const ORIGIN: Triple = [0.0; 3];
const UP: Triple = [0.0, 0.0, 1.0];

fn unit() -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::ORIGIN, 1.0)
}

/// A line towards the unit sphere.
fn towards_unit(line: Line) -> SphereQuery {
    SphereQuery {
        center: ORIGIN,
        radius: 1.0,
        line,
    }
}

/// The cosine between the normal of a hit from inside the unit sphere and the ray: of the hit in a
/// world, where the normal faces the eye, and of the shape's, as in the protocol, where it points
/// outwards.
pub fn seen_from_inside() -> Case {
    let inside = line(ORIGIN, UP);
    let facing = tried(|| {
        let world = World::new(Color::BLACK)?.with(unit()?, ());
        let hit = world.hit(&inside.unit_ray()?, Interval::AHEAD);
        Ok(hit.map(|(hit, ())| hit.normal.dot(vector(UP))))
    });
    let outwards = tried(|| {
        let hit = unit()?.hit(&inside.raw_ray(), Interval::AHEAD);
        Ok(hit.map(|hit| hit.normal.dot(vector(UP))))
    });
    Case::of(facing, outwards)
}

/// A miss, where the protocol draws the root before it tests its sign.
pub fn root_of_a_miss() -> Case {
    let past = line([-5.0, 2.0, 0.0], [1.0, 0.0, 0.0]);
    let Quadratic { a, b, discriminant } = protocol::sphere_equation(&towards_unit(past));
    let theirs: Outcome = ((-b - discriminant.sqrt()) / (2.0 * a)).into();
    Case::of(nearest_hit(unit(), past), theirs)
}
