//! Shiny surfaces, compared with the solution.

use crate::prelude::*;

yours! {
    phong => shading(|(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        phong(colors, exponent, ray, hit, lighting)
    })
}

type Code = Shading<([Color; 2], f64)>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::scene("phong", |phong: &Code, settings| {
            shaded(scenes::phong()?, settings, |diffuse, ray, hit, lights| {
                phong(([diffuse, Color::WHITE], 64.0), ray, hit, lights)
            })
        }),
        wrong: vec![
            Other::new(
                "light from behind has no highlight",
                textbook(|lit, exponent| {
                    let cosine = lit.to_light.dot(lit.to_eye.reflected_on(lit.normal));
                    libm::pow(cosine.clamp(0.0, 1.0), exponent)
                }),
            ),
            Other::new(
                "an exponent may be a fraction",
                textbook(|lit, exponent| right(lit, exponent.trunc())),
            ),
            Other::new(
                "the exponent counts once",
                textbook(|lit, exponent| right(lit, 2.0 * exponent)),
            ),
            Other::new(
                "a highlight does not fade with the cosine to the normal",
                textbook(|lit, exponent| {
                    right(lit, exponent) * lit.normal.dot(lit.to_light).max(0.0)
                }),
            ),
            Other::new(
                "the direction of the ray leads away from the eye",
                textbook(|lit, exponent| {
                    let to_eye = -lit.to_eye;
                    right(&Lit { to_eye, ..*lit }, exponent)
                }),
            ),
            Other::new(
                "the mirrored light is 2 (n · l) n - l, not 2 (n · l) (n - l)",
                textbook(|lit, exponent| {
                    let cosine = lit.normal.dot(lit.to_light);
                    let mirrored = (Vector3::from(lit.normal) - lit.to_light) * (2.0 * cosine);
                    let highlight = mirrored.dot(lit.to_eye).clamp(0.0, 1.0);
                    lit.is_before() * libm::pow(highlight, exponent)
                }),
            ),
        ],
        ..materials([Materials {
            words: "diffuse and specular {}, exponent {}",
            first: ([Color::RED, Color::BLUE], 2.0),
            any: |r| ([r.color(), r.color()], r.between(0.5, 40.0)),
        }])
    }
}

/// A surface in the light of a lamp.
struct Lit {
    normal: Normal3,
    to_light: Vector3,
    to_eye: Vector3,
}

impl Lit {
    /// 1 if the light is before the surface, or 0.
    fn is_before(&self) -> f64 {
        f64::from(self.normal.dot(self.to_light) > 0.0)
    }
}

/// The highlight by the eye, which is mirrored instead of the light.
fn right(lit: &Lit, exponent: f64) -> f64 {
    let cosine = lit.to_light.dot(lit.to_eye.reflected_on(lit.normal));
    lit.is_before() * libm::pow(cosine.clamp(0.0, 1.0), exponent)
}

/// The sum over the lights, with a highlight that follows from the directions and the exponent.
fn textbook(highlight: fn(&Lit, f64) -> f64) -> Code {
    shading(
        move |([diffuse, specular], exponent): ([_; 2], _), ray, hit, lighting| {
            sum(diffuse, ray, hit, lighting, |light| {
                let lit = Lit {
                    normal: hit.normal,
                    to_light: light.direction,
                    to_eye: -ray.direction(),
                };
                let cosine = lit.normal.dot(lit.to_light).max(0.0);
                (diffuse * cosine + specular * highlight(&lit, exponent)) * light.color
            })
        },
    )
}
