//! Parts of the way from the inner to the outer angle, and their values of
//! `x² (3 - 2 x)`.

use a02_math::{Point3, Vector3};
use a05_lighting::{Lambert, Light};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{balls, color, show, unit};

/// A spot light, and axes of length 1 that are perpendicular to each other: along
/// its direction and aside.
struct Spot {
    color: Color,
    at: Point3,
    axes: [Vector3; 3],
    angles: [f64; 2],
    length: f64,
}

pub fn check<L: Light + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Point3, Vector3, f64, f64) -> Result<L, ArgumentError>,
) {
    let mut expect = |spot: &Spot, angle: f64, (cos, sin): (f64, f64), exact: Option<f64>| {
        let Spot {
            color,
            at,
            axes,
            angles: [inner, outer],
            length,
        } = *spot;
        let [along, aside, across] = axes;
        let way = along * libm::cos(angle) + (aside * cos + across * sin) * libm::sin(angle);
        let light = new(color, at, along * length, inner, outer);
        let got = light.map(|light| light.illumination(at + way * 3.0));
        let got = got.ok().flatten().map(|light| light.color.channels());
        let what = format!(
            "light at {angle:.4} radians of a spot from {inner:.2} to {outer:.2}, direction {:.3}, colour {:?}",
            (along * length).to_glam(),
            color.channels()
        );
        let exact = exact.map(|share| color.channels().map(|channel| channel * share));
        check.expect(what, exact, Bound::Absolute(1e-12), got);
    };
    let around = [(1.0, 0.0), (0.6, -0.8), (-0.28, 0.96)];
    for length in [1.0, 3.0] {
        let spot = Spot {
            color: Color::WHITE,
            at: Point3::new(1.0, 5.0, -2.0),
            axes: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
                .map(|xyz| Vector3::from_glam(xyz.into())),
            angles: [0.4, 1.2],
            length,
        };
        for ((angle, exact), around) in [
            (0.0, Some(1.0)),
            (0.3999, Some(1.0)),
            // x is 3/4, 1/2 and 1/4.
            (0.6, Some(0.843_75)),
            (0.8, Some(0.5)),
            (1.0, Some(0.156_25)),
            (1.2001, None),
            // Above the lamp.
            (2.5, None),
            (3.1, None),
        ]
        .into_iter()
        .zip(around.into_iter().cycle())
        {
            expect(&spot, angle, around, exact);
        }
    }
    let mut random = Random::new(3);
    for around in around.into_iter().cycle().take(60) {
        let along = unit(&mut random);
        let Some(aside) = unit(&mut random).cross(along).normalized() else {
            continue;
        };
        let inner = random.between(0.0, 1.4);
        let outer = inner + random.between(0.05, 1.6);
        let [x, y, z] = [(); 3].map(|()| random.between(-9.0, 9.0));
        let spot = Spot {
            color: color(&mut random),
            at: Point3::new(x, y, z),
            axes: [along, aside, along.cross(aside)],
            angles: [inner, outer],
            length: random.between(0.1, 5.0),
        };
        let x = random.between(0.01, 0.99);
        let exact = x * x * (3.0 - 2.0 * x);
        expect(&spot, outer - x * (outer - inner), around, Some(exact));
        expect(&spot, inner * x, around, Some(1.0));
        expect(&spot, outer + (3.1 - outer) * x, around, None);
    }

    let position = Point3::new(0.5, 5.0, 2.5);
    let aim = Point3::new(-0.2, 0.0, 0.2) - position;
    let spot = new(Color::WHITE, position, aim, 0.2, 0.45);
    let world = spot.and_then(|spot| Ok(balls(Lambert::new)?.lit_by(Box::new(spot))));
    show(check, world);
}
