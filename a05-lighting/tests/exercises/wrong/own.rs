//! `Own`: a light or a material of a function, for wrong solutions.

use std::fmt;

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Light, Lighting, Material};
use common::Color;

/// A light or a material that is one function.
pub struct Own<F>(pub F);

impl<F> fmt::Debug for Own<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Own")
    }
}

impl<F> Light for Own<F>
where
    F: Fn(Point3) -> Option<Illumination> + Send + Sync + 'static,
{
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        self.0(point)
    }
}

impl<F> Material for Own<F>
where
    F: Fn(&Ray, &Hit, &dyn Lighting) -> Color + Send + Sync + 'static,
{
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        self.0(ray, hit, lighting)
    }
}
