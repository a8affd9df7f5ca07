//! Earth and moon at any time, compared with the solution.

use crate::prelude::*;
use crate::solutions::orbits::orbits as solution;

type Orbits = Result<[Transform; 2], ArgumentError>;

pub fn check(check: &mut Check, orbits: impl Fn(f64, f64) -> Orbits) {
    let places = |orbits: Orbits| {
        let [earth, moon] = orbits.ok()?.map(|body| {
            let (place, ahead) = (
                body.matrix() * Point3::ORIGIN,
                body.matrix() * Vector3::new(1.0, 0.0, 0.0),
            );
            [place.to_glam().to_array(), ahead.to_glam().to_array()]
        });
        let places =
            Answer::named("the place of the earth", earth[0]).and("the place of the moon", moon[0]);
        Some(
            places
                .and("x on the earth", earth[1])
                .and("x on the moon", moon[1]),
        )
    };
    check.compare(
        "year {}, month {}",
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, -1.0)],
        random(|r| (r.between(-9.0, 9.0), r.between(-9.0, 9.0))),
        |(year, month)| places(solution(year, month)),
        |(year, month)| places(orbits(year, month)),
    );
    let (eye, at) = (Point3::new(0.0, 9.0, 13.0), Point3::new(0.0, -0.4, 0.0));
    show_lit(check, twelve_months(orbits), eye, at);
}

fn twelve_months(orbits: impl Fn(f64, f64) -> Orbits) -> Result<World<Color>, ArgumentError> {
    let sun = Sphere::new(Point3::ORIGIN, 1.2)?;
    let mut world = World::new(Color::gray(0.03))?.with(sun, Color::new(1.0, 0.85, 0.2));
    for month in 0..12 {
        let angle = std::f64::consts::TAU / 12.0 * f64::from(month);
        let [earth, moon] = orbits(angle, 3.0 * angle)?.map(Node::new);
        let [large, small] = [0.45, 0.18].map(|r| Sphere::new(Point3::ORIGIN, r));
        world = world
            .with(earth.with(large?), Color::new(0.2, 0.5, 1.0))
            .with(moon.with(small?), Color::gray(0.9));
    }
    Ok(world)
}

/// Transforms of which each is a turn about y and then a way along x.
fn variant(c: &mut Check, of: fn(f64, f64) -> [Vec<(f64, f64)>; 2]) {
    check(c, |year, month| {
        let [earth, moon] = of(year, month).map(|steps| {
            steps
                .into_iter()
                .try_fold(Transform::IDENTITY, |t, (angle, way)| {
                    t.rotate_y(angle)?.translate(Point3::new(way, 0.0, 0.0))
                })
        });
        Ok([earth?, moon?])
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong(
        "the last call happens first: the earth turns on the spot",
        |c| {
            variant(c, |year, month| {
                [
                    vec![(0.0, 5.0), (year, 0.0)],
                    vec![(0.0, 5.0), (year, 1.0), (month, 0.0)],
                ]
            });
        },
    ),
    wrong("the moon is a child of the earth, not of the sun", |c| {
        variant(c, |year, month| [vec![(year, 5.0)], vec![(month, 1.0)]]);
    }),
    wrong("the month is an angle as the turned earth sees it", |c| {
        variant(c, |year, month| {
            [vec![(year, 5.0)], vec![(year, 5.0), (month - year, 1.0)]]
        });
    }),
];
