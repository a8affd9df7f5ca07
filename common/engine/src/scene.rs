//! `Scene`: shapes, surfaces and lights as plain numbers.

use common::{Color, Size};

use crate::accel::{Kind, Shapes};
use crate::adaptive::KnownLight;
use crate::shade::max_radiance;
use crate::shape::List;
use crate::{Camera, Light, Shape, Surface, Transform};

/// A scene.
pub struct Scene<'a> {
    /// The colour of rays without a hit.
    pub background: Color,
    /// The ambient light.
    pub ambient: Color,
    pub(crate) depth: u32,
    pub(crate) shapes: Shapes<'a>,
    /// The surfaces, by their indices.
    pub surfaces: Vec<Surface<'a>>,
    /// The lights.
    pub lights: Vec<Light<'a>>,
}

impl<'a> Scene<'a> {
    /// An empty scene: the colour of rays without a hit, the ambient light, and the largest number
    /// of surfaces that a path meets.
    #[must_use]
    pub fn new(background: Color, ambient: Color, depth: u32) -> Self {
        Self {
            background,
            ambient,
            depth,
            shapes: Shapes::default(),
            surfaces: Vec::new(),
            lights: Vec::new(),
        }
    }

    /// Adds a surface, and returns its index.
    pub fn add_surface(&mut self, surface: Surface<'a>) -> u32 {
        self.surfaces.push(surface);
        self.surfaces.len() as u32 - 1
    }

    /// Adds a shape with the surface of this index. Of several shapes hit at the same
    /// `t`, the first added counts.
    pub fn add_shape(&mut self, shape: Shape<'a>, surface: u32) {
        self.shapes.push(shape, surface);
    }

    /// Adds a light.
    pub fn add_light(&mut self, light: Light<'a>) {
        self.lights.push(light);
    }

    /// Upper bound of the channels of the light that any ray brings back; infinite where a light
    /// or a material is not one of the engine's.
    #[must_use]
    pub fn max_radiance(&self) -> f64 {
        max_radiance(self).largest_channel()
    }

    /// What the scene says of the light of its picture.
    #[must_use]
    pub fn known_light(&self, camera: &Camera, size: Size) -> KnownLight {
        let max = self.max_radiance();
        KnownLight::of(max, self.background, &self.shapes, camera, size)
    }

    /// Passes on each shape, in the order in which they were added: its transforms, from the
    /// outermost to the innermost, the shape under them, and the index of its surface. A shape
    /// that the engine does not know is passed on as one without hits.
    pub fn for_each_shape(&self, mut each: impl FnMut(&[Transform], &Shape<'_>, u32)) {
        let shapes = &self.shapes;
        let mut ids: Vec<_> = shapes.ids().map(|id| (shapes.attributes(id), id)).collect();
        ids.sort_unstable_by_key(|(own, _)| own.order);
        for (own, id) in ids {
            let index = id.index as usize;
            let shape = match id.kind {
                Kind::Transformed => {
                    let transformed = &shapes.transformed.shapes[index];
                    each(&transformed.steps, &transformed.shape, own.surface);
                    continue;
                }
                Kind::Sphere => Shape::Sphere(shapes.spheres.shapes[index]),
                Kind::Triangle => Shape::Triangle(shapes.triangles.shapes.get(index)),
                Kind::Box => Shape::Box(shapes.boxes.shapes[index]),
                Kind::Plane => Shape::Plane(shapes.planes.shapes[index]),
                Kind::Disc => Shape::Disc(shapes.discs.shapes[index]),
                Kind::Other => Shape::other(|_| None),
            };
            each(&[], &shape, own.surface);
        }
    }
}
