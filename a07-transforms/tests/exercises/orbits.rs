//! Earth and moon at any time, compared with the solution.

use crate::prelude::*;
use crate::solutions::orbits::orbits as solution;

type Orbits = Result<[Transform; 2], ArgumentError>;

pub fn check(check: &mut Check, orbits: impl Fn(f64, f64) -> Orbits) {
    let places = |orbits: Orbits| {
        let [earth, moon] = orbits.ok()?.map(|body| {
            let place = (body.matrix() * Point3::ORIGIN).to_glam().to_array();
            let x = (body.matrix() * vector([1.0, 0.0, 0.0]))
                .to_glam()
                .to_array();
            Answer::named("the place", place).and("the turned x axis", x)
        });
        Some(Answer::named("earth", earth).and("moon", moon))
    };
    check.compare(
        "year {}, month {}",
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, -1.0)],
        random(|r| (r.between(-9.0, 9.0), r.between(-9.0, 9.0))),
        |(year, month)| places(solution(year, month)),
        |(year, month)| places(orbits(year, month)),
    );
    let (eye, at) = ([0.0, 9.0, 13.0], [0.0, -0.4, 0.0]);
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

/// Turns about y, each followed by a way along x.
fn chained(steps: &[(f64, f64)]) -> Result<Transform, ArgumentError> {
    steps
        .iter()
        .try_fold(Transform::IDENTITY, |t, (angle, way)| {
            t.rotate_y(*angle)?.translate(Point3::new(*way, 0.0, 0.0))
        })
}

pub const VARIANTS: &[Variant] = &[
    wrong("the earth is moved first, then turned", |c| {
        check(c, |year, month| {
            let earth = [(0.0, 5.0), (year, 0.0)];
            Ok([chained(&earth)?, chained(&[earth[0], (year + month, 1.0)])?])
        });
    }),
    wrong("the moon is a child of the earth", |c| {
        check(c, |year, month| {
            Ok([chained(&[(year, 5.0)])?, chained(&[(month, 1.0)])?])
        });
    }),
    wrong("the month is seen by the turned earth", |c| {
        check(c, |year, month| {
            Ok([
                chained(&[(year, 5.0)])?,
                chained(&[(year, 5.0), (month - year, 1.0)])?,
            ])
        });
    }),
];
