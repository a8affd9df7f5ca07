//! Earth and moon at any time, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(f64, f64) -> Made<[Transform; 2]>) {
    check.compare(
        "year {}, month {}",
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, -1.0)],
        random(|r| (r.between(-9.0, 9.0), r.between(-9.0, 9.0))),
        [orbits, yours],
        |orbits, (year, month)| {
            let [earth, moon] = orbits(year, month).ok()?.map(|body| {
                let moved = |x| (body.matrix() * point([x, 0.0, 0.0])).to_glam().to_array();
                Answer::named("the place", moved(0.0)).and("x = 1 moved", moved(1.0))
            });
            Some(Answer::named("earth", earth).and("moon", moon))
        },
    );
    let (eye, at) = ([0.0, 9.0, 13.0], [0.0, -0.4, 0.0]);
    show_lit(check, twelve_months(yours), eye, at);
}

fn twelve_months(orbits: impl Fn(f64, f64) -> Made<[Transform; 2]>) -> Made<World<Color>> {
    let sun = Sphere::new(Point3::ORIGIN, 1.2)?;
    let mut world = World::new(Color::gray(0.03))?.with(sun, Color::new(1.0, 0.85, 0.2));
    for month in 0..12 {
        let angle = TAU / 12.0 * f64::from(month);
        let [earth, moon] = orbits(angle, 3.0 * angle)?.map(Node::new);
        let [large, small] = [0.45, 0.18].map(|r| Sphere::new(Point3::ORIGIN, r));
        world = world
            .with(earth.with(large?), Color::new(0.2, 0.5, 1.0))
            .with(moon.with(small?), Color::gray(0.9));
    }
    Ok(world)
}

variants! { check:
    yours => orbits;
    wrong "the earth is turned after it is moved" => |year, month| {
        let moved = Transform::IDENTITY.translate(Point3::new(5.0, 0.0, 0.0))?;
        Ok([moved.rotate_y(year)?, orbits(year, month)?[1]])
    };
    wrong "the moon is a child of the earth" => |year, month| {
        Ok([orbits(year, month)?[0], orbits(0.0, month)?[1]])
    };
    wrong "the month is seen by the turned earth" => |year, month| orbits(year, month - year);
}
