//! Eyes at known cosines from the direction in which a light is mirrored.

use a02_math::Vector3;
use a05_lighting::Material;
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::lit::{Shot, color, expect_scene, frame, lamp, objects};

/// Some roundings of a power with an exponent up to 64.
const BOUND: Bound = Bound::Absolute(1e-11);

pub fn check<M: Material>(
    check: &mut Check,
    new: impl Fn(Color, Color, f64) -> Result<M, ArgumentError>,
) {
    let mut random = Random::new(52);
    // The cosines of normal and light, and of the mirrored light and the eye.
    let mut case = |kind: &str, exponent: i32, has_ambient: bool, cosines: &[[f64; 2]]| {
        let (diffuse, specular) = (color(&mut random), color(&mut random));
        let ambient = if has_ambient {
            color(&mut random)
        } else {
            Color::BLACK
        };
        let Ok(shiny) = new(diffuse, specular, f64::from(exponent)) else {
            return;
        };
        let mut shot = Shot::new(&mut random, ambient);
        let mut exact = diffuse * ambient;
        let mut words = vec![format!(
            "{kind}; diffuse {:?}, specular {:?}, exponent {exponent}, ambient light {:?}",
            diffuse.channels(),
            specular.channels(),
            ambient.channels()
        )];
        for [lit, seen] in cosines {
            let Some((n, e)) = shot.turn(&mut random, *lit, *seen) else {
                continue;
            };
            let light = shot.light_from(&mut random, n);
            exact += diffuse * light * lit.max(0.0);
            if *lit > 0.0 {
                let power = (0..exponent).fold(1.0, |power, _| power * seen.max(0.0));
                exact += specular * light * power;
            }
            shot.e = e;
            words.push(format!(
                "light {:?} with n · l = {lit} and e · r = {seen}",
                light.channels()
            ));
        }
        check.expect(words.join(", "), exact.channels(), BOUND, shot.seen(&shiny));
    };
    for _ in 0..10 {
        case(
            "the light is mirrored into the eye",
            8,
            false,
            &[[0.8, 1.0]],
        );
        case(
            "the eye beside the mirrored light",
            2,
            false,
            &[[0.8, 0.75]],
        );
        case("the eye beside the mirrored light", 5, false, &[[0.6, 0.5]]);
        case(
            "the eye far from the mirrored light",
            1,
            false,
            &[[0.8, -0.25]],
        );
        case(
            "the eye far from the mirrored light",
            2,
            false,
            &[[0.8, -0.25]],
        );
        case("light from behind", 1, false, &[[-0.5, 0.5]]);
        case("light from behind", 2, false, &[[-0.5, 0.5]]);
        case("ambient light alone", 8, true, &[]);
        case("a light and ambient light", 3, true, &[[0.5, 0.9]]);
    }
    two_lights(check, &new, &mut random);
    expect_scene(check, "phong", || {
        let material = |color| Ok(Box::new(new(color, Color::WHITE, 64.0)?) as _);
        Ok(objects(material, Color::BLACK)?.lit_by(lamp()?))
    });
}

/// Eye and two lights along the normal: each adds its highlight in full.
fn two_lights<M: Material>(
    check: &mut Check,
    new: &impl Fn(Color, Color, f64) -> Result<M, ArgumentError>,
    random: &mut Random,
) {
    let Ok(shiny) = new(Color::BLACK, Color::WHITE, 7.0) else {
        return;
    };
    let [n, ..]: [Vector3; 3] = frame(random);
    let mut shot = Shot::new(random, Color::BLACK);
    (shot.n, shot.e) = (n, n);
    let exact = shot.light_from(random, n) + shot.light_from(random, n);
    let what = "two lights, mirrored into the eye; specular [1.0, 1.0, 1.0], exponent 7";
    check.expect(what, exact.channels(), BOUND, shot.seen(&shiny));
}
