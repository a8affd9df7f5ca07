//! Surfaces as an eye sees them: in light from before, from behind and along the surface, with
//! normals aslant to the geometric normal, from all distances.

use crate::prelude::*;

/// The words for a surface that an eye sees in messages.
pub const SEEN: &str = "eye towards {} at the distance {}, normal and geometric normal {}, ambient light {}, \
    colours of lights and where they are {}";

/// A surface at the origin that an eye sees. Directions have length 1.
#[derive(Clone)]
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
    /// An eye above and light from there, aslant, from behind, none but ambient light,
    /// a normal aslant to the geometric normal, light along the surface, two lights of which one is
    /// behind, and two lights beside ambient light.
    #[must_use]
    pub fn simple() -> [Self; 8] {
        let (up, pink) = ([0.0, 1.0, 0.0], [1.0, 0.5, 0.5]);
        let from_above = Self {
            to_eye: up,
            distance: 1.0,
            normals: [up, up],
            ambient: Color::BLACK,
            lights: vec![[pink, up]],
        };
        [
            from_above.clone(),
            Self {
                lights: vec![[pink, [0.6, 0.8, 0.0]]],
                ..from_above.clone()
            },
            Self {
                lights: vec![[pink, [0.6, -0.8, 0.0]]],
                ..from_above.clone()
            },
            Self {
                ambient: Color::new(1.0, 0.5, 0.5),
                lights: Vec::new(),
                ..from_above.clone()
            },
            Self {
                normals: [[0.6, 0.8, 0.0], up],
                ..from_above.clone()
            },
            Self {
                lights: vec![[pink, [1.0, 0.0, 0.0]]],
                ..from_above.clone()
            },
            Self {
                to_eye: [0.0, 0.8, 0.6],
                lights: vec![
                    [pink, [0.0, 0.8, -0.6]],
                    [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]],
                ],
                ..from_above.clone()
            },
            Self {
                ambient: Color::gray(0.25),
                lights: vec![[pink, up], [[0.0, 0.0, 1.0], [0.6, 0.8, 0.0]]],
                ..from_above
            },
        ]
    }

    /// An eye before a surface, and two lights, one of which shines along it.
    pub fn any(random: &mut Random) -> Self {
        let [normal, bend, eye, light] = [(); 4].map(|()| vector(random.triple(1.0)));
        let geometric_normal = normal + bend * 0.4;
        let height = 1e-6 * random.between(-1.0, 1.0);
        let grazing = normal.cross(light) + normal * height;
        let lights = [light, grazing].map(|light| [random.color().channels(), direction(light)]);
        Self {
            to_eye: direction(eye * eye.dot(geometric_normal).signum()),
            distance: random.scale(),
            normals: [normal, geometric_normal].map(direction),
            ambient: random.color(),
            lights: lights.to_vec(),
        }
    }

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

/// A direction of length 1, as code gets it.
fn direction(any: Vector3) -> [f64; 3] {
    array(unit(array(any)))
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
