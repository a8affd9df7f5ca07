//! Lights at known cosines from a normal: above, grazing and behind, one and several.

use a05_lighting::Material;
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::lit::{Shot, color, expect_scene, lamp, objects};

pub fn check<M: Material>(check: &mut Check, new: impl Fn(Color) -> Result<M, ArgumentError>) {
    let mut random = Random::new(51);
    let mut case = |kind: &str, has_ambient: bool, cosines: &[f64]| {
        let diffuse = color(&mut random);
        let ambient = if has_ambient {
            color(&mut random)
        } else {
            Color::BLACK
        };
        let Ok(matt) = new(diffuse) else { return };
        // The eye does not matter.
        let mut shot = Shot::new(&mut random, ambient);
        let mut exact = diffuse * ambient;
        let mut words = vec![
            format!("{kind}; material {:?}", diffuse.channels()),
            format!("ambient light {:?}", ambient.channels()),
        ];
        for cosine in cosines {
            let light = shot.light(&mut random, *cosine);
            exact += diffuse * light * cosine.max(0.0);
            words.push(format!(
                "light {:?} with n · l = {cosine}",
                light.channels()
            ));
        }
        check.expect(
            words.join(", "),
            exact.channels(),
            Bound::Absolute(1e-12),
            shot.seen(&matt),
        );
    };
    for _ in 0..10 {
        case("a light above the surface", false, &[1.0]);
        case("a light at an angle", false, &[0.5]);
        case("a light behind the surface", false, &[-0.5]);
        case("ambient light alone", true, &[]);
        case("two lights and ambient light", true, &[0.25, 0.75]);
        case("a light above and one behind", true, &[0.5, -1.0]);
    }
    expect_scene(check, "lambert", || {
        let material = |color| Ok(Box::new(new(color)?) as _);
        Ok(objects(material, Color::BLACK)?.lit_by(lamp()?))
    });
}
