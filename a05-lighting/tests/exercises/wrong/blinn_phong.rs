//! Highlights at another place, of another size, or behind the surface.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lighting};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::blinn_phong::check;
use crate::own::Own;

/// The material's colours and exponent, and the vectors of length 1 from a hit.
struct Shading {
    diffuse: Color,
    specular: Color,
    exponent: f64,
    normal: Vector3,
    light: Illumination,
    to_eye: Vector3,
}

impl Shading {
    fn cosine(&self) -> f64 {
        self.normal.dot(self.light.direction)
    }

    /// The highlight of a vector half way.
    fn highlight(&self, half: Vector3) -> f64 {
        libm::pow(self.normal.dot(half).clamp(0.0, 1.0), self.exponent)
    }

    fn half(&self) -> Vector3 {
        let half = (self.light.direction + self.to_eye).normalized();
        half.unwrap_or_default()
    }

    /// Matt light and a highlight, if the surface faces the light.
    fn color(&self, highlight: f64) -> Color {
        let is_lit = f64::from(u8::from(self.cosine() > 0.0));
        (self.diffuse * self.cosine() + self.specular * highlight) * self.light.color * is_lit
    }
}

/// The material whose light of each lamp is this.
fn material(c: &mut Check, color: fn(&Shading) -> Color) {
    check(c, |diffuse, specular, exponent| {
        Ok(Own(move |ray: &Ray, hit: &Hit, lighting: &dyn Lighting| {
            let mut sum = diffuse * lighting.ambient();
            lighting.for_each_light(ray, hit, &mut |light| {
                sum += color(&Shading {
                    diffuse,
                    specular,
                    exponent,
                    normal: Vector3::from(hit.normal),
                    light: *light,
                    to_eye: -ray.direction(),
                });
            });
            sum
        }))
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "Phong's mirrored light instead of the half vector",
        says: "light aslant, eye above, exponent 1: expected (0.07, 0.4, 0), got (0.07",
        check: |c| {
            material(c, |s| {
                let mirrored = s.light.direction.reflected_on(s.normal.as_normal());
                s.color(libm::pow(s.to_eye.dot(mirrored).max(0.0), s.exponent))
            });
        },
    },
    Wrong {
        mistake: "a half vector that is not made unit",
        says: "light aslant, eye above, exponent 1: expected (0.07, 0.4, 0), got (0.07",
        check: |c| {
            material(c, |s| {
                s.color(s.highlight((s.light.direction + s.to_eye) * 0.5))
            });
        },
    },
    Wrong {
        mistake: "the ray's direction added, which leads from the eye",
        says: "light aslant, eye above, exponent 1: expected (0.07, 0.4, 0), got (0.07",
        check: |c| {
            material(c, |s| {
                let half = (s.light.direction - s.to_eye).normalized();
                s.color(s.highlight(half.unwrap_or(s.normal)))
            });
        },
    },
    Wrong {
        mistake: "light from behind",
        says: "light from behind, exponent 1: expected (0, 0, 0), got (-0.",
        check: |c| {
            material(c, |s| {
                let sum = s.diffuse * s.cosine() + s.specular * s.highlight(s.half());
                sum * s.light.color
            });
        },
    },
    Wrong {
        mistake: "a highlight of light from behind",
        says: "light from behind, exponent 0: expected (0, 0, 0), got (0, 0.5, 0)",
        check: |c| {
            material(c, |s| {
                let matt = s.diffuse * s.cosine().max(0.0);
                (matt + s.specular * s.highlight(s.half())) * s.light.color
            });
        },
    },
    Wrong {
        mistake: "a highlight of light along the surface",
        says: "light along the surface, exponent 1: expected (0, 0, 0), got (0, 0.35",
        check: |c| {
            material(c, |s| {
                let is_lit = f64::from(u8::from(s.cosine() >= 0.0));
                let sum = s.diffuse * s.cosine() + s.specular * s.highlight(s.half());
                sum * s.light.color * is_lit
            });
        },
    },
    Wrong {
        mistake: "a highlight also where the half vector is below the surface",
        says: ", exponent ",
        check: |c| {
            material(c, |s| {
                s.color(libm::pow(s.normal.dot(s.half()), s.exponent))
            });
        },
    },
    Wrong {
        mistake: "without the exponent",
        says: "light aslant, eye above, exponent 2: expected (0.07, 0.32, 0), got (0.07",
        check: |c| material(c, |s| s.color(s.normal.dot(s.half()).max(0.0))),
    },
    Wrong {
        mistake: "the highlight not in the light's colour",
        says: "light and eye along the normal, exponent 8: expected (0.25, 0.5, 0), got (0.25, 1, 0)",
        check: |c| {
            material(c, |s| {
                let highlight = s.specular * s.highlight(s.half());
                let lit = if s.cosine() > 0.0 {
                    highlight
                } else {
                    Color::BLACK
                };
                s.color(0.0) + lit
            });
        },
    },
    Wrong {
        mistake: "the highlight times the diffuse colour",
        says: "light and eye along the normal, exponent 8: expected (0.25, 0.5, 0), got (0.25, 0, 0)",
        check: |c| {
            material(c, |s| {
                s.color(0.0) + (s.color(s.highlight(s.half())) + s.color(0.0) * -1.0) * s.diffuse
            });
        },
    },
    Wrong {
        mistake: "the highlight times the cosine, too",
        says: "light aslant, eye above, exponent 1: expected (0.07, 0.4, 0), got (0.07",
        check: |c| material(c, |s| s.color(s.highlight(s.half()) * s.cosine())),
    },
    Wrong {
        mistake: "matt light without the cosine",
        says: "light aslant, eye above, exponent 1: expected (0.07, 0.4, 0), got (0.25",
        check: |c| {
            material(c, |s| {
                if s.cosine() > 0.0 {
                    (s.diffuse + s.specular * s.highlight(s.half())) * s.light.color
                } else {
                    Color::BLACK
                }
            });
        },
    },
];
