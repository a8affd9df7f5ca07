//! The places of earth and moon on circles, from sines and cosines that are
//! fractions.

use a02_math::{Point3, Vector3};
use a04_intersections::{Sphere, World};
use a07_transforms::{Node, Transform};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, show};

const BOUND: Bound = Bound::Absolute(1e-14);

pub fn check(
    check: &mut Check,
    orbits: impl Fn(f64, f64) -> Result<[Transform; 2], ArgumentError>,
) {
    let mut expect = |year: f64, month: f64, [sin, cos, sin_month, cos_month]: [f64; 4]| {
        let Ok([earth, moon]) = orbits(year, month) else {
            return;
        };
        // The sum of both angles.
        let sin_both = sin * cos_month + cos * sin_month;
        let cos_both = cos * cos_month - sin * sin_month;
        let when = format!("year {year:.3}, month {month:.3}");
        let places = [
            (
                "earth",
                earth,
                [5.0 * cos, 0.0, 0.0 - 5.0 * sin],
                [sin, cos],
            ),
            (
                "moon",
                moon,
                [5.0 * cos + cos_both, 0.0, 0.0 - 5.0 * sin - sin_both],
                [sin_both, cos_both],
            ),
        ];
        for (body, transform, place, [sin, cos]) in places {
            let got = (transform.matrix() * Point3::ORIGIN).to_glam().to_array();
            check.expect(format!("place of the {body}, {when}"), place, BOUND, got);
            let ahead = transform.matrix() * Vector3::new(0.0, 0.0, -1.0);
            let what = format!("direction into which the {body} turns its back, {when}");
            check.expect(
                what,
                [0.0 - sin, 0.0, 0.0 - cos],
                BOUND,
                ahead.to_glam().to_array(),
            );
            let up = transform.matrix() * Vector3::new(0.0, 1.0, 0.0);
            let what = format!("direction that is up on the {body}, {when}");
            check.expect(what, [0.0, 1.0, 0.0], BOUND, up.to_glam().to_array());
        }
    };
    for (sin, cos) in TURNS {
        for (sin_month, cos_month) in TURNS {
            let (year, month) = (libm::atan2(sin, cos), libm::atan2(sin_month, cos_month));
            expect(year, month, [sin, cos, sin_month, cos_month]);
        }
    }
    let mut random = Random::new(2);
    for _ in 0..30 {
        let [year, month] = [(); 2].map(|()| random.between(-9.0, 9.0));
        let [(sin, cos), (sin_month, cos_month)] = [year, month].map(libm::sincos);
        expect(year, month, [sin, cos, sin_month, cos_month]);
    }

    let (eye, at) = (Point3::new(0.0, 9.0, 13.0), Point3::new(0.0, -0.4, 0.0));
    show(check, twelve_months(orbits), eye, at);
}

fn twelve_months(
    orbits: impl Fn(f64, f64) -> Result<[Transform; 2], ArgumentError>,
) -> Result<World<Color>, ArgumentError> {
    let sun = Sphere::new(Point3::ORIGIN, 1.2)?;
    let mut world = World::new(Color::gray(0.03))?.with(sun, Color::new(1.0, 0.85, 0.2));
    for month in 0..12 {
        let angle = std::f64::consts::TAU / 12.0 * f64::from(month);
        let [earth, moon] = orbits(angle, 3.0 * angle)?;
        let body = |place, r| {
            Ok::<_, ArgumentError>(Node::new(place).with(Sphere::new(Point3::ORIGIN, r)?))
        };
        world = world
            .with(body(earth, 0.45)?, Color::new(0.2, 0.5, 1.0))
            .with(body(moon, 0.18)?, Color::gray(0.9));
    }
    Ok(world)
}
