//! Mirrors whose colours are geometric series, and one that shows a coloured wall.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Plane;
use a05_lighting::SingleColor;
use a06_shadows_reflection::{Reflective, ShadowedWorld};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::traced::{expect_scene, sphere};

const BOUND: Bound = Bound::Absolute(1e-12);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);

pub fn check(check: &mut Check, trace: impl Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync) {
    let mut random = Random::new(63);
    for _ in 0..10 {
        let mut color = || {
            Color::new(
                random.between(0.0, 0.9),
                random.between(0.0, 0.9),
                random.between(0.1, 0.9),
            )
        };
        let [background, own, mirror, other, back] = [(); 5].map(|()| color());
        let mut expect = |kind: &str,
                          world: &Result<ShadowedWorld, ArgumentError>,
                          d,
                          depth: u32,
                          exact: Color| {
            let Ok(world) = world else { return };
            let ray = Ray::derived(Point3::new(0.5, 1.0, 0.0), d);
            let got = trace(world, &ray, depth);
            let words = format!(
                "own colour {:?}, reflectance {:?}, background {:?}, ray along {:.2}",
                own.channels(),
                mirror.channels(),
                background.channels(),
                d.to_glam()
            );
            check.expect(
                format!("{kind}, depth {depth}; {words}"),
                exact.channels(),
                BOUND,
                got.channels(),
            );
        };
        let floor = world(background, &[(0.0, own, mirror)]);
        expect("no surface", &floor, -DOWN, 3, background);
        expect("one mirror", &floor, DOWN, 0, Color::BLACK);
        expect("one mirror", &floor, DOWN, 1, own);
        expect("one mirror", &floor, DOWN, 2, own + mirror * background);
        expect("one mirror", &floor, DOWN, 9, own + mirror * background);

        let facing = world(background, &[(0.0, own, mirror), (2.0, other, back)]);
        let mut exact = Color::BLACK;
        let mut share = Color::WHITE;
        for depth in 1..7 {
            let (color, reflected) = if depth % 2 == 1 {
                (own, mirror)
            } else {
                (other, back)
            };
            exact += share * color;
            share = share * reflected;
            expect("two facing mirrors", &facing, DOWN, depth, exact);
        }

        // The ray goes down to the right, and the reflected one up to the wall x = 3.
        let wall = Plane::new(Point3::new(3.0, 0.0, 0.0), Normal3::new(-1.0, 0.0, 0.0));
        let with_wall = world(background, &[(0.0, own, mirror)])
            .and_then(|world| Ok(world.with(wall?, Box::new(SingleColor::new(other)?))));
        let aslant = Vector3::new(0.6, -0.8, 0.0);
        expect(
            "a wall in a mirror",
            &with_wall,
            aslant,
            2,
            own + mirror * other,
        );
    }
    expect_scene(check, "sphere", sphere, trace);
}

/// Horizontal mirrors at these heights, with colour and reflectance, in ambient light
/// alone.
fn world(
    background: Color,
    mirrors: &[(f64, Color, Color)],
) -> Result<ShadowedWorld, ArgumentError> {
    let mut world = ShadowedWorld::empty(background, Color::WHITE)?;
    for (height, color, reflectance) in mirrors {
        let plane = Plane::new(Point3::new(0.0, *height, 0.0), Normal3::new(0.0, 1.0, 0.0))?;
        let mirror = Reflective::new(*color, Color::BLACK, 1.0, *reflectance)?;
        world = world.with(plane, Box::new(mirror));
    }
    Ok(world)
}
