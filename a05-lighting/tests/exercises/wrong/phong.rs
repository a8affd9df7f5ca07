//! Wrong solutions: the highlight with another cosine or another factor.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lambert, Lighting, Material};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::phong;

/// The highlight from e, n, l, light, specular colour and exponent.
type Highlight = fn([Vector3; 3], &Illumination, Color, f64) -> Color;

#[derive(Debug)]
struct Phong(Lambert, Color, f64, Highlight);

impl Material for Phong {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = self.0.color_for(ray, hit, lighting);
        lighting.for_each_light(ray, hit, &mut |light| {
            let (e, n) = (-ray.direction(), Vector3::from(hit.normal));
            color += (self.3)([e, n, light.direction], light, self.1, self.2);
        });
        color
    }
}

fn check(check: &mut Check, highlight: Highlight) {
    phong::check(check, |diffuse, specular, exponent| {
        Ok(Phong(Lambert::new(diffuse)?, specular, exponent, highlight))
    });
}

fn cosine([e, n, l]: [Vector3; 3]) -> f64 {
    e.dot(l.reflected_on(n.as_normal()))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "light from behind has a highlight",
        says: "light from behind",
        check: |c| {
            check(c, |v, light, cs, p| {
                cs * light.color * libm::pow(cosine(v).max(0.0), p)
            });
        },
    },
    Wrong {
        mistake: "an even exponent makes a negative cosine positive",
        says: "the eye far from the mirrored light",
        check: |c| {
            check(c, |v, light, cs, p| {
                if v[1].dot(v[2]) > 0.0 {
                    cs * light.color * libm::pow(cosine(v), p)
                } else {
                    Color::BLACK
                }
            });
        },
    },
    Wrong {
        mistake: "the half vector of Blinn",
        says: "the eye beside the mirrored light",
        check: |c| {
            check(c, |[e, n, l], light, cs, p| {
                let half = (e + l).normalized().unwrap_or_default();
                if n.dot(l) > 0.0 {
                    cs * light.color * libm::pow(n.dot(half).max(0.0), p)
                } else {
                    Color::BLACK
                }
            });
        },
    },
    Wrong {
        mistake: "the colour of the light is left out",
        says: "the light is mirrored into the eye",
        check: |c| {
            check(c, |v, _, cs, p| {
                if v[1].dot(v[2]) > 0.0 {
                    cs * libm::pow(cosine(v).max(0.0), p)
                } else {
                    Color::BLACK
                }
            });
        },
    },
    Wrong {
        mistake: "the exponent is left out",
        says: "the eye beside the mirrored light",
        check: |c| {
            check(c, |v, light, cs, _| {
                if v[1].dot(v[2]) > 0.0 {
                    cs * light.color * cosine(v).max(0.0)
                } else {
                    Color::BLACK
                }
            });
        },
    },
];
