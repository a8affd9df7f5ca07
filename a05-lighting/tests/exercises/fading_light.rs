//! Lamps of many colours, and points whose distance and direction are known.

use a02_math::{Point3, Vector3};
use a05_lighting::{Lambert, Light};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{balls, color, show, unit};

pub fn check<L: Light + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Point3) -> Result<L, ArgumentError>,
) {
    let mut expect = |color: Color, at: Point3, way: Vector3, d: f64| {
        let got = new(color, at).map(|light| light.illumination(at + way * -d));
        let got = got.ok().flatten();
        let what = |of| {
            let (way, at) = (way.to_glam(), at.to_glam());
            format!(
                "{of} at the distance {d} along {way:.3} from a lamp at {at} with {:?}",
                color.channels()
            )
        };
        let bound = Bound::Absolute(1e-12);
        let exact = color.channels().map(|channel| channel / (d * d));
        let got_color = got.map(|light| light.color.channels());
        check.expect(what("colour"), Some(exact), bound, got_color);
        let exact = way.to_glam().to_array();
        let direction = got.map(|light| light.direction.to_glam().to_array());
        check.expect(what("direction"), Some(exact), bound, direction);
        let distance = got.map(|light| light.distance);
        check.expect(what("distance"), Some(d), bound, distance);
    };
    let (lamp, at) = (Color::new(1.0, 0.5, 0.25), Point3::new(3.0, -1.0, 2.0));
    for way in [
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, -1.0, 0.0),
        Vector3::new(0.6, 0.0, 0.8),
        Vector3::new(-0.48, 0.6, 0.64),
    ] {
        for d in [2.0, 1.0, 0.5, 8.0] {
            expect(lamp, at, way, d);
        }
    }
    let mut random = Random::new(1);
    for _ in 0..40 {
        let [x, y, z] = [(); 3].map(|()| random.between(-9.0, 9.0));
        let (color, way) = (color(&mut random), unit(&mut random));
        expect(color, Point3::new(x, y, z), way, random.between(0.3, 20.0));
    }
    for at in [at, Point3::ORIGIN] {
        let got = new(lamp, at).map(|light| light.illumination(at).is_none());
        check.expect("in the lamp there is no light", true, Bound::Equal, got);
    }

    let lamp = new(Color::gray(2.5), Point3::new(0.2, 2.2, 1.5));
    let world = lamp.and_then(|lamp| Ok(balls(Lambert::new)?.lit_by(Box::new(lamp))));
    show(check, world);
}
