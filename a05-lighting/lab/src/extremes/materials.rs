//! Colours of matt and shiny surfaces, each by a formula of its own, and the powers of their highlights.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Case, Fails, Known, Number, Outcome};

use crate::protocol;
use a05_lighting::{DirectionalLight, Lambert, LitWorld, Material, Phong};

/// The condition of a reflectance times the sum of lights: 1 for either.
const OF_A_PRODUCT: f64 = 2.0;
const FRONT: Vector3 = Vector3::new(0.0, 0.0, 1.0);

/// The colour of a surface that faces (0, 0, 1), seen from the direction `eye`, in gray
/// lights from one direction.
fn seen(
    material: Result<impl Material, ArgumentError>,
    eye: Vector3,
    lights: &[f64],
    from: Vector3,
) -> Result<Color, ArgumentError> {
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK)?;
    for light in lights {
        let light = DirectionalLight::new(Color::gray(*light), -from)?;
        world = world.lit_by(Box::new(light));
    }
    let ray = Ray::derived(Point3::ORIGIN, -eye);
    Ok(material?.color_for(&ray, &Hit::new(1.0, FRONT.as_normal()), &world))
}

/// The brightness of a gray matt surface under lights from straight above.
fn matt(diffuse: f64, lights: &[f64]) -> Outcome {
    let seen = seen(Lambert::new(Color::gray(diffuse)), FRONT, lights, FRONT);
    seen.map(|color| color.r).into()
}

/// A white highlight on a black surface.
fn highlight(exponent: f64, eye: Vector3, from: Vector3) -> Outcome {
    let phong = Phong::new(Color::BLACK, Color::WHITE, exponent);
    seen(phong, eye, &[1.0], from).map(|color| color.r).into()
}

/// The green of a white highlight on a red surface.
fn green_of_a_highlight_on_red() -> Outcome {
    let phong = Phong::new(Color::RED, Color::WHITE, 64.0);
    seen(phong, FRONT, &[1.0], FRONT)
        .map(|color| color.g)
        .into()
}

/// The highlight of a light straight above, for a cosine of the angle between the mirrored
/// light and the eye.
pub fn power(cosine: f64, exponent: f64) -> Case {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let ours = highlight(exponent, Vector3::new(sine, 0.0, cosine), FRONT);
    Case::of(ours, protocol::highlight(cosine, exponent))
}

/// Without the sum over lights, only one counts; the highlight has the colour of the
/// light, not of the surface; a light brighter than 1 is valid, and only the picture is
/// clamped.
pub fn cases() -> Vec<Case> {
    // Light from a little below the surface, which would mirror it to the eye:
    // r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
    let below = Vector3::new(0.8, 0.0, -0.6);
    let eye = Vector3::new(-0.8, 0.0, 0.6);
    let white_highlight = protocol::highlight(1.0, 64.0);
    vec![
        Case {
            id: "F36".into(),
            what: "highlight of a light from behind the surface, exponent 2".into(),
            exact: Number(0.0),
            protocol: Fails,
            ..Case::of(highlight(2.0, eye, below), protocol::highlight(0.28, 2.0))
        },
        Case {
            id: "L01".into(),
            what: "white under lights of 1/4 and 1/2".into(),
            exact: Number(0.75),
            condition: Known(OF_A_PRODUCT),
            protocol: Fails,
            ..Case::of(
                matt(1.0, &[0.25, 0.5]),
                protocol::phong(1.0, 0.0, 0.25, 1.0, 0.0),
            )
        },
        Case {
            id: "L02".into(),
            what: "white highlight on red: its green".into(),
            exact: Number(1.0),
            condition: Known(OF_A_PRODUCT),
            protocol: Fails,
            ..Case::of(
                green_of_a_highlight_on_red(),
                protocol::phong(0.0, 0.0, 1.0, 1.0, white_highlight),
            )
        },
        Case {
            id: "L03".into(),
            what: "a surface of 1/4 under a light of 3".into(),
            exact: Number(0.75),
            condition: Known(OF_A_PRODUCT),
            protocol: Fails,
            ..Case::of(matt(0.25, &[3.0]), protocol::clamped_product(0.25, 3.0))
        },
        Case {
            id: "L04".into(),
            what: "a surface of 1/10 under a light of 1/10".into(),
            exact: Number(0.01),
            condition: Known(OF_A_PRODUCT),
            // Half a level of 255.
            bound: Absolute(1.0 / 510.0),
            protocol: Fails,
            ..Case::of(matt(0.1, &[0.1]), protocol::integer_product(0.1, 0.1))
        },
    ]
}
