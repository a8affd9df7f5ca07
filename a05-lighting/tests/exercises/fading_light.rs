//! Distances that are powers of two, whose squares are exact.

use a02_math::{Point3, Vector3};
use a05_lighting::{Lambert, Light};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::scene::{balls, show};

pub fn check<L: Light + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Point3) -> Result<L, ArgumentError>,
) {
    let at = Point3::new(3.0, -1.0, 2.0);
    let Ok(light) = new(Color::new(1.0, 0.5, 0.25), at) else {
        return;
    };
    for way in [
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, -1.0, 0.0),
        Vector3::new(0.6, 0.0, 0.8),
        Vector3::new(-0.48, 0.6, 0.64),
    ] {
        for d in [0.5, 1.0, 2.0, 8.0] {
            let got = light.illumination(at + way * -d);
            let what = |of| {
                format!(
                    "{of} at the distance {d} from the lamp, along {}",
                    way.to_glam()
                )
            };
            let share = 1.0 / (d * d);
            let bound = Bound::Absolute(1e-13);
            let color = got.map(|light| light.color.channels());
            check.expect(
                what("colour"),
                Some([share, share / 2.0, share / 4.0]),
                bound,
                color,
            );
            let direction = got.map(|light| light.direction.to_glam().to_array());
            check.expect(
                what("direction"),
                Some(way.to_glam().to_array()),
                bound,
                direction,
            );
            check.expect(
                what("distance"),
                Some(d),
                bound,
                got.map(|light| light.distance),
            );
        }
    }
    let got = light.illumination(at).is_none();
    check.expect("in the lamp there is no light", true, Bound::Equal, got);

    let lamp = new(Color::gray(2.5), Point3::new(0.2, 2.2, 1.5));
    let world = lamp.and_then(|lamp| Ok(balls(Lambert::new)?.lit_by(Box::new(lamp))));
    show(check, world);
}
