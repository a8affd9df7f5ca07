//! Wrong solutions: the sum with a factor left out, or one too many.

use a02_math::{Direction, Normal3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lighting, Material};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::lambert;

#[derive(Debug)]
struct Lambert {
    diffuse: Color,
    ambient: fn(Color, Color) -> Color,
    share: fn(Color, Normal3, &Illumination) -> Color,
}

impl Material for Lambert {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = (self.ambient)(self.diffuse, lighting.ambient());
        lighting.for_each_light(ray, hit, &mut |light| {
            color += (self.share)(self.diffuse, hit.normal, light);
        });
        color
    }
}

fn check(
    check: &mut Check,
    ambient: fn(Color, Color) -> Color,
    share: fn(Color, Normal3, &Illumination) -> Color,
) {
    lambert::check(check, |diffuse| {
        Ok(Lambert {
            diffuse,
            ambient,
            share,
        })
    });
}

fn product(diffuse: Color, ambient: Color) -> Color {
    diffuse * ambient
}

fn share(diffuse: Color, n: Normal3, light: &Illumination) -> Color {
    diffuse * light.color * n.dot(light.direction).max(0.0)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "light from behind is subtracted",
        says: "a light behind the surface",
        check: |c| {
            check(c, product, |d, n, light| {
                d * light.color * n.dot(light.direction)
            });
        },
    },
    Wrong {
        mistake: "the magnitude of the cosine",
        says: "a light behind the surface",
        check: |c| {
            check(c, product, |d, n, light| {
                d * light.color * n.dot(light.direction).abs()
            });
        },
    },
    Wrong {
        mistake: "no ambient light",
        says: "ambient light alone",
        check: |c| check(c, |_, _| Color::BLACK, share),
    },
    Wrong {
        mistake: "the ambient light without the material",
        says: "ambient light alone",
        check: |c| check(c, |_, ambient| ambient, share),
    },
    Wrong {
        mistake: "the colour of the light is left out",
        says: "a light above the surface",
        check: |c| {
            check(c, product, |d, n, light| {
                d * n.dot(light.direction).max(0.0)
            });
        },
    },
];
