//! Points near the rim of a narrow cone: inside or outside?
//!
//! The half angle is 1e-3. One half of the points lies inside and one outside,
//! all at the same distance from the rim; every eighth lies straight behind.

use std::rc::Rc;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use common::{ArgumentError, Color};
use measure::experiment::{Axis, Curve, Experiment, Unit};

use crate::lab::protocol;
use crate::{Light, SpotLight};

const HALF_ANGLE: f64 = 1e-3;
const COS_HALF_ANGLE: f64 = 0.999_999_500_000_041_7;
const DIRECTION: Vector3 = Vector3::new(1.0, 2.0, 3.0);

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "spot-rim",
        about: "How near to the rim of a spot light is inside told from outside?",
        knob: "from rim (half angles)",
        work: "points",
        error: "share of points judged wrongly",
        unit: Unit::Share,
        exact: "against the side on which a point was put; one in eight lies behind",
        seeds: &[12],
        against: Axis::Knob,
        curves: Box::new(|effort| {
            let count = effort.choose(4_096, 65_536) as u32;
            let knobs = [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11];
            let tasks = knobs.map(|knob| (knob, tasks(knob, count).unwrap_or_default()));
            let curve = |method, illuminates: fn(&SpotLight, Point3) -> bool| {
                let lit = move |(light, point, _): &Task| illuminates(light, *point);
                Curve::of_decisions(method, &tasks, lit, |(.., is_lit), lit| lit != *is_lit)
            };
            // Rounding is far below a billionth of the half angle.
            let far = 1e-9..=1.0;
            vec![
                curve("arc cosine (protocol)", |_, p| {
                    protocol::spot_light_illuminates(Point3::ORIGIN, DIRECTION, HALF_ANGLE, p)
                })
                .with_remark("lights one in four points straight behind"),
                // As the renderer's light decides, but without a direction of length 1.
                curve("cosines", |_, p| {
                    let v = p - Point3::ORIGIN;
                    let lengths = (v.dot(v) * DIRECTION.dot(DIRECTION)).sqrt();
                    v.dot(DIRECTION) >= COS_HALF_ANGLE * lengths
                })
                .with_bound(0.0, far.clone()),
                curve("cosines, as rendered", Light::illuminates)
                    .with_bound(0.0, far)
                    .with_remark("with the direction and the distance, which the material needs"),
                curve("arc tangent", |_, p| DIRECTION.angle(p - Point3::ORIGIN) <= HALF_ANGLE).with_remark(
                    "not in the renderer: dearer than the cosines, and no eye sees a billionth of an angle",
                ),
            ]
        }),
    }
}

/// A light at the origin, and a point on which it shines or not.
type Task = (SpotLight, Point3, bool);

/// Points near the rim of the light's cone.
fn tasks(knob: f64, count: u32) -> Result<Rc<[Task]>, ArgumentError> {
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, DIRECTION, HALF_ANGLE)?;
    let w = DIRECTION.unit("direction")?;
    let u = w.cross(Vector3::new(0.0, 1.0, 0.0)).unit("u")?;
    let v = w.cross(u);
    let points = (0..count).map(|i| {
        let random = PixelRandom::new(12, i, 0);
        let distance = 1.0 + 9.0 * random.uniform(0);
        if i % 8 == 0 {
            return (light, Point3::ORIGIN - DIRECTION * distance, false);
        }
        let inside = random.uniform(1) < 0.5;
        let angle = HALF_ANGLE * if inside { 1.0 - knob } else { 1.0 + knob };
        let around = 6.3 * random.uniform(2);
        let aside = u * libm::cos(around) + v * libm::sin(around);
        let way = w * libm::cos(angle) + aside * libm::sin(angle);
        (light, Point3::ORIGIN + way * distance, inside)
    });
    Ok(points.collect())
}
