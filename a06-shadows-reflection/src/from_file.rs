//! Reads scenes from files: mirrors, and lights that cast shadows.

use a03_rays_cameras::View;
use a03_rays_cameras::from_file::camera;
use a04_intersections::Geometry;
use a04_intersections::from_file::geometry;
use a05_lighting::from_file::{light, phong, single_color, world};
use scene_file::{Error, Item, SceneFile};

use crate::{LightSource, Reflective, ShadowedWorld, Surface, traced};

/// The camera and the world of a file.
pub fn view(file: &SceneFile) -> Result<View, Error> {
    shadowed(file, geometry).map(traced)
}

/// The camera and the world of a file, with a stage's own geometries.
pub fn shadowed(
    file: &SceneFile,
    geometry: fn(&Item) -> Result<Box<dyn Geometry>, Error>,
) -> Result<View<ShadowedWorld>, Error> {
    let surface = |item: &Item| -> Result<Box<dyn Surface>, Error> {
        if let Some(color) = single_color(item)? {
            return Ok(Box::new(color));
        }
        let material = item.named("material", &file.materials)?;
        let (diffuse, specular, exponent) = phong(material)?;
        let reflection = material.color("reflection");
        let mirror = Reflective::new(diffuse, specular, exponent, reflection);
        Ok(Box::new(material.check(mirror)?))
    };
    let source = |item: &Item| {
        Ok(LightSource {
            light: light(item)?,
            casts_shadows: item.flag("shadows").unwrap_or(true),
        })
    };
    let world = world(file, geometry, surface, source)?;
    let camera = camera(file)?;
    Ok(View { camera, world })
}
