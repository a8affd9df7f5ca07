//! Fog that halves the light from behind, a whole number of times.

use std::f64::consts::LN_2;

use a02_math::{Normal3, Point3};
use a04_intersections::{Interval, Plane, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::show;

pub fn check(check: &mut Check, fogged: impl Fn(Color, Color, f64, f64) -> Color + Sync) {
    let color = Color::new(1.0, 0.5, 0.0);
    let fog = Color::new(0.0, 0.5, 1.0);
    for scale in [0.25, 1.0, 8.0] {
        for (halvings, left) in [(0.0, 1.0), (1.0, 0.5), (2.0, 0.25), (5.0, 0.031_25)] {
            let got = fogged(color, fog, LN_2 / scale, halvings * scale);
            let what = format!("at {halvings} times the distance {scale}, which halves the colour");
            let exact = [left, 0.5, 1.0 - left];
            check.expect(what, exact, Bound::Absolute(1e-14), got.channels());
        }
    }
    let mut random = Random::new(1);
    for halvings in (0..6).cycle().take(40) {
        let [color, fog] = [(); 2].map(|()| {
            let [r, g, b] = [(); 3].map(|()| random.between(0.0, 2.0));
            Color::new(r, g, b)
        });
        let distance = random.between(0.1, 50.0);
        let density = LN_2 * f64::from(halvings) / distance;
        let left = 1.0 / f64::from(1 << halvings);
        let exact = color * left + fog * (1.0 - left);
        let got = fogged(color, fog, density, distance).channels();
        let what = format!(
            "{:?} in fog of {:?}, density {density:.4}, distance {distance}",
            color.channels(),
            fog.channels()
        );
        check.expect(what, exact.channels(), Bound::Absolute(1e-13), got);
    }
    let got = fogged(color, fog, 0.1, f64::INFINITY).channels();
    check.expect("infinitely far away", fog.channels(), Bound::Equal, got);
    for distance in [0.0, 1e9, f64::INFINITY] {
        let got = fogged(color, fog, 0.0, distance).channels();
        let what = format!("without fog, at the distance {distance}");
        check.expect(what, color.channels(), Bound::Equal, got);
    }

    let Ok(world) = row() else { return };
    let (eye, at) = (Point3::new(-3.0, 2.5, 6.0), Point3::new(0.5, 0.7, -4.0));
    show(check, eye, at, |ray| {
        let fog = Color::new(0.7, 0.75, 0.8);
        let Some((hit, &color)) = world.hit(ray, Interval::AHEAD) else {
            return fogged(world.background(), fog, 0.08, f64::INFINITY);
        };
        let shade = f64::midpoint(1.0, hit.normal.y());
        fogged(color * shade, fog, 0.08, hit.t)
    });
}

fn row() -> Result<World<Color>, ArgumentError> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let mut world = World::new(Color::new(0.1, 0.2, 0.5))?.with(floor, Color::new(0.3, 0.35, 0.2));
    for k in 0..9 {
        let c = Point3::new(0.0, 1.0, -4.0 * f64::from(k));
        world = world.with(Sphere::new(c, 1.0)?, Color::new(0.9, 0.2, 0.1));
    }
    Ok(world)
}
