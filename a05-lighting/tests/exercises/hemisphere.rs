//! Normals with known cosines, and the mean light of sky and ground.

use a02_math::Vector3;
use a05_lighting::Material;
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{Lights, balls, color, seen, show, unit};

pub fn check<M: Material + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Color, Color) -> Result<M, ArgumentError>,
) {
    let mut expect = |[diffuse, sky, ground]: [Color; 3], normal: Vector3, share: f64| {
        let Ok(material) = new(diffuse, sky, ground) else {
            return;
        };
        let lamp = Lights {
            color: Color::WHITE,
            directions: &[normal],
        };
        let [diffuse, sky, ground] = [diffuse, sky, ground].map(Color::channels);
        let what = format!(
            "normal {:.3}, diffuse {diffuse:?}, sky {sky:?}, ground {ground:?}",
            normal.to_glam()
        );
        let light: [f64; 3] = std::array::from_fn(|i| share * sky[i] + (1.0 - share) * ground[i]);
        let exact = std::array::from_fn(|i| diffuse[i] * light[i]);
        let got = seen(&material, normal.as_normal(), normal, &lamp);
        check.expect(what, exact, Bound::Absolute(1e-14), got);
    };
    let day = [[1.0, 0.5, 0.25], [0.2, 0.6, 1.0], [0.4, 0.2, 0.0]];
    let day = day.map(|[r, g, b]| Color::new(r, g, b));
    for (normal, sky) in [
        ([0.0, 1.0, 0.0], 1.0),
        ([0.0, -1.0, 0.0], 0.0),
        // A wall sees as much of the sky as of the ground.
        ([1.0, 0.0, 0.0], 0.5),
        ([0.0, 0.0, -1.0], 0.5),
        ([0.8, 0.6, 0.0], 0.8),
        ([0.0, -0.6, 0.8], 0.2),
    ] {
        expect(day, Vector3::from_glam(normal.into()), sky);
    }
    let mut random = Random::new(2);
    for _ in 0..60 {
        let colors = [(); 3].map(|()| color(&mut random));
        let normal = unit(&mut random);
        expect(colors, normal, f64::midpoint(1.0, normal.y()));
    }

    let (sky, ground) = (Color::new(0.8, 0.95, 1.2), Color::new(0.3, 0.22, 0.1));
    show(check, balls(|color| new(color, sky, ground)));
}
