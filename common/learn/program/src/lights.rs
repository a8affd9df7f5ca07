//! Lights by your functions, and which of them reach a hit.

use crate::prelude::*;

#[derive(Debug)]
pub struct PointLight {
    pub color: Color,
    pub position: Point3,
}

impl PointLight {
    /// The lamp, in the form in which the file of `spot_light` makes it.
    pub fn new(color: Color, position: Point3) -> Made<Self> {
        let color = argument::color("light colour", color)?;
        Ok(Self { color, position })
    }
}

impl Light for PointLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        point_light(self.color, self.position, point)
    }
}

#[derive(Debug)]
pub struct DirectionalLight {
    pub color: Color,
    /// The direction in which the light travels.
    pub direction: Vector3,
}

impl Light for DirectionalLight {
    fn illumination(&self, _: Point3) -> Option<Illumination> {
        directional_light(self.color, self.direction)
    }
}

#[derive(Debug)]
pub struct SpotLight {
    pub color: Color,
    pub position: Point3,
    /// The middle of the cone, of length 1.
    pub axis: Vector3,
    /// In radians.
    pub half_angle: f64,
}

impl Light for SpotLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let Self {
            color,
            position,
            axis,
            half_angle,
        } = *self;
        spot_light(color, position, axis, half_angle, point)
    }
}

/// The lights of a world that reach a hit, under the name that they have in the file of `trace`.
pub struct RecursiveTracer<'a> {
    world: &'a ShadowedWorld,
}

impl<'a> RecursiveTracer<'a> {
    pub fn new(world: &'a ShadowedWorld) -> Self {
        Self { world }
    }
}

impl Lighting for RecursiveTracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        for source in self.world.lights() {
            let Some(light) = source.illumination(at(ray, hit.t)) else {
                continue;
            };
            let is_in_front = hit.normal.dot(light.direction) > 0.0;
            if is_in_front && !is_shadowed(self.world.objects(), ray, hit, &light) {
                shade(&light);
            }
        }
    }
}
