//! Colours of matt and shiny surfaces, and the powers of their highlights.

use a02_lab::exact::DoubleDouble;
use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Case, Fails, Holds, Id, Known, Number, Outcome, Refused, Ulps};

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
fn power(id: Id, cosine: f64, exponent: f64) -> Case {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let ours = highlight(exponent, Vector3::new(sine, 0.0, cosine), FRONT);
    let is_power = cosine > 0.0 && cosine < 1.0 && exponent.is_finite();
    let exact = DoubleDouble::from(cosine).power(exponent as u64).value();
    Case {
        id,
        what: format!("highlight, cosine {cosine}, exponent {exponent:e}"),
        condition: (cosine > 0.0).then_some(exponent).into(),
        certified: is_power.then_some(Number(exact)),
        ..Case::of(ours, protocol::highlight(cosine, exponent))
    }
}

pub fn cases() -> Vec<Case> {
    [powers(), colours()].concat()
}

fn powers() -> Vec<Case> {
    let above = 1.0_f64.next_up();
    let of_no_direction = Ray::new(Point3::ORIGIN, Vector3::new(f64::NAN, 0.0, 1.0));
    vec![
        Case {
            exact: Number(0.0),
            protocol: Fails,
            ..power("F14", -0.3, 0.0)
        },
        Case {
            exact: Number(1.0),
            protocol: Holds,
            ..power("F15", 0.5, 0.0)
        },
        Case {
            exact: Number(1.0),
            protocol: Fails,
            ..power("F17", above, 1e17)
        },
        Case {
            exact: Refused,
            protocol: Fails,
            ..power("F18", above, f64::INFINITY)
        },
        Case {
            exact: Refused,
            protocol: Fails,
            ..power("F19", 0.0, -1.0)
        },
        Case {
            id: "F20",
            what: "a ray of direction NaN, whose highlight has exponent 0".into(),
            exact: Refused,
            protocol: Fails,
            ..Case::of(
                of_no_direction.map(|_| true),
                protocol::highlight(f64::NAN, 0.0),
            )
        },
        // Powers of the cosine as a double, not as a decimal. Only the power is rounded: the
        // sine belongs to a coordinate in which the mirrored light is 0.
        Case {
            exact: Number(0.904_837_413_559_398_8),
            bound: Ulps(1.0),
            protocol: Holds,
            ..power("F16", 1.0 - 1e-7, 1e6)
        },
        Case {
            exact: Number(0.367_887_579_387_309_76),
            bound: Ulps(1.0),
            protocol: Holds,
            ..power("F22", 1.0 - 1e-12, 1e12)
        },
        Case {
            exact: Number(0.0),
            protocol: Fails,
            ..power("F34", 0.0, 0.0)
        },
        Case {
            exact: Refused,
            protocol: Fails,
            ..power("F35", 0.5, f64::NAN)
        },
    ]
}

/// Without the sum over lights, only one counts; the highlight has the colour of the
/// light, not of the surface; a light brighter than 1 is valid, and only the picture is
/// clamped.
fn colours() -> Vec<Case> {
    // Light from a little below the surface, which would mirror it to the eye:
    // r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
    let below = Vector3::new(0.8, 0.0, -0.6);
    let eye = Vector3::new(-0.8, 0.0, 0.6);
    let white_highlight = protocol::highlight(1.0, 64.0);
    vec![
        Case {
            id: "F36",
            what: "highlight of a light from behind the surface, exponent 2".into(),
            exact: Number(0.0),
            protocol: Fails,
            ..Case::of(highlight(2.0, eye, below), protocol::highlight(0.28, 2.0))
        },
        Case {
            id: "L01",
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
            id: "L02",
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
            id: "L03",
            what: "a surface of 1/4 under a light of 3".into(),
            exact: Number(0.75),
            condition: Known(OF_A_PRODUCT),
            protocol: Fails,
            ..Case::of(matt(0.25, &[3.0]), protocol::clamped_product(0.25, 3.0))
        },
        Case {
            id: "L04",
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
