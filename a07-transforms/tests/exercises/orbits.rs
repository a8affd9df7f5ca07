//! Earth and moon at any time, compared with the solution.

use crate::prelude::*;

yours! { orbits }

type Code = fn(f64, f64) -> Made<[Transform; 2]>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [0.0, 9.0, 13.0],
        to: [0.0, -0.4, 0.0],
    };
    Exercise {
        picture: lit(eye, twelve_months),
        ..Exercise::asked(|orbits: &Code, (year, month)| {
            let [earth, moon] = orbits(year, month).ok()?;
            // Two points tell where a body is, and how it is turned.
            let moved = |body: &Transform, x| {
                let p = body.matrix() * Point3::new(x, 0.0, 0.0);
                array(p)
            };
            Some(
                Answer::named("earth", moved(&earth, 0.0))
                    .and("earth", moved(&earth, 1.0))
                    .and("moon", moved(&moon, 0.0))
                    .and("moon", moved(&moon, 1.0)),
            )
        })
    }
}

fn twelve_months(orbits: &Code) -> Made<World<Color>> {
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
