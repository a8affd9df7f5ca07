//! Reads scenes from files: lights, materials and the world.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::View;
use a03_rays_cameras::from_file::camera;
use a04_intersections::Geometry;
use a04_intersections::from_file::{add_objects, geometry};
use common::Color;
use scene_file::{Error, Item, SceneFile};

use crate::{
    DirectionalLight, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};

/// The camera and the world of a file.
pub fn view(file: &SceneFile) -> Result<View, Error> {
    let surface = |item: &Item| -> Result<Box<dyn Material>, Error> {
        if let Some(color) = single_color(item)? {
            return Ok(Box::new(color));
        }
        let material = item.named("material", &file.materials)?;
        let (diffuse, specular, exponent) = phong(material)?;
        Ok(Box::new(
            material.check(Phong::new(diffuse, specular, exponent))?,
        ))
    };
    let without_shadows = |item: &Item| match item.flag("shadows") {
        Some(true) => Err(item.error("shadows", "lights cast shadows from stage 6 on")),
        _ => light(item),
    };
    let world = world(file, geometry, surface, without_shadows)?;
    let camera = camera(file)?;
    Ok(View { camera, world }.boxed())
}

/// The world of a file, of a stage's own geometries, surfaces and lights.
pub fn world<S, L>(
    file: &SceneFile,
    geometry: fn(&Item) -> Result<Box<dyn Geometry>, Error>,
    surface: impl Fn(&Item) -> Result<S, Error>,
    light: impl Fn(&Item) -> Result<L, Error>,
) -> Result<LitWorld<S, L>, Error> {
    let item = &file.world;
    let empty = LitWorld::empty(item.color("background"), item.color("ambient"));
    let mut world = item.check(empty)?;
    add_objects(&mut world.world, file, geometry, surface)?;
    for item in &file.lights {
        world.lights.push(light(item)?);
    }
    Ok(world)
}

/// A light of this stage.
pub fn light(item: &Item) -> Result<Box<dyn Light>, Error> {
    let color = item.vector("color", Color::new)?;
    let position = || item.vector("position", Point3::new);
    let direction = || item.vector("direction", Vector3::new);
    Ok(match item.kind.name {
        "directional_light" => Box::new(item.check(DirectionalLight::new(color, direction()?))?),
        "spot_light" => {
            let half_angle = item.angle("half_angle")?;
            Box::new(item.check(SpotLight::new(color, position()?, direction()?, half_angle))?)
        }
        _ => Box::new(item.check(PointLight::new(color, position()?))?),
    })
}

/// The colour of a shape, if it has one instead of a material.
pub fn single_color(item: &Item) -> Result<Option<SingleColor>, Error> {
    match item.find_vector("color", Color::new) {
        Some(_) if item.find("material").is_some() => {
            Err(item.error("color", "a shape has a color or a material, not both"))
        }
        Some(color) => item.check(SingleColor::new(color)).map(Some),
        None => Ok(None),
    }
}

/// The diffuse and specular reflectance and the exponent of a material.
pub fn phong(item: &Item) -> Result<(Color, Color, f64), Error> {
    let has_highlight = item.find("specular").or(item.find("exponent")).is_some();
    let exponent = if has_highlight {
        item.number("exponent")?
    } else {
        1.0
    };
    Ok((item.color("diffuse"), item.color("specular"), exponent))
}
