//! Surfaces as an eye sees them.

use crate::prelude::*;

/// A surface at the origin that an eye sees. Directions have length 1.
#[derive(Clone, Default)]
pub struct Seen {
    /// The direction to the eye.
    pub to_eye: [f64; 3],
    /// The distance of the eye.
    pub distance: f64,
    /// The shading normal, and the geometric normal.
    pub normals: [[f64; 3]; 2],
    /// The ambient light.
    pub ambient: Color,
    /// Each light, and the direction to it.
    pub lights: Vec<[[f64; 3]; 2]>,
}

input! { Seen: to_eye, distance, normals, ambient, lights }

impl Seen {
    /// The ray from the eye.
    #[must_use]
    pub fn ray(&self) -> Ray {
        let to_eye = unit(self.to_eye);
        Ray::derived(Point3::ORIGIN + to_eye * self.distance, -to_eye)
    }

    /// The hit of the ray.
    #[must_use]
    pub fn hit(&self) -> Hit {
        let [normal, geometric_normal] = self.normals.map(|n| unit(n).as_normal());
        Hit {
            geometric_normal,
            ..Hit::new(self.distance, normal)
        }
    }

    /// The light that the hit receives.
    #[must_use]
    pub fn light(&self) -> ReceivedLight {
        let lights = self.lights.iter();
        let lights = lights.map(|[[r, g, b], direction]| Illumination {
            color: Color::new(*r, *g, *b),
            direction: unit(*direction),
            ..Illumination::default()
        });
        ReceivedLight {
            ambient: self.ambient,
            lights: lights.collect(),
        }
    }
}

/// The light that every hit receives.
#[derive(Clone, Debug, Default)]
pub struct ReceivedLight {
    /// The ambient light.
    pub ambient: Color,
    /// The light of each source.
    pub lights: Vec<Illumination>,
}

impl Lighting for ReceivedLight {
    fn ambient(&self) -> Color {
        self.ambient
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.lights.iter().for_each(shade);
    }
}
