//! Translates the lights and materials of this stage for the engine.

use std::any::Any;

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a04_intersections::fast::{add_objects, shapes};
use common::Color;

use crate::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};

/// The engine's light: numbers if the engine has the light's type, otherwise a
/// function.
#[must_use]
pub fn light(light: &dyn Light) -> engine::LightKind<'_> {
    let any: &dyn Any = light;
    if let Some(PointLight { color, position }) = any.downcast_ref() {
        engine::LightKind::Point {
            color: *color,
            position: position.to_glam(),
        }
    } else if let Some(spot) = any.downcast_ref::<SpotLight>() {
        engine::LightKind::Spot {
            color: spot.source.color,
            position: spot.source.position.to_glam(),
            direction: spot.direction.to_glam(),
            cos_half_angle: spot.cos_half_angle,
        }
    } else if let Some(DirectionalLight { color, direction }) = any.downcast_ref() {
        engine::LightKind::Directional {
            color: *color,
            direction: direction.to_glam(),
        }
    } else {
        engine::LightKind::Other(Box::new(|point| {
            let light = light.illumination(Point3::from_glam(point))?;
            Some(engine::Illumination {
                color: light.color,
                direction: light.direction.to_glam(),
                distance: light.distance,
            })
        }))
    }
}

/// The engine's material: numbers if the engine has the material's type, otherwise the
/// function `color`.
pub fn shading<'a>(
    material: &'a dyn Material,
    color: impl Fn(&Ray, &Hit) -> Color + Send + Sync + 'a,
) -> engine::Shading<'a> {
    let any: &dyn Any = material;
    if let Some(phong) = any.downcast_ref::<Phong>() {
        phong.into()
    } else if let Some(lambert) = any.downcast_ref::<Lambert>() {
        engine::Shading::Phong(engine::Phong {
            diffuse: lambert.diffuse,
            specular: Color::BLACK,
            exponent: 0.0,
        })
    } else if let Some(SingleColor { color }) = any.downcast_ref() {
        engine::Shading::SingleColor(*color)
    } else {
        engine::Shading::Other(Box::new(move |ray, hit| color(&ray.into(), &hit.into())))
    }
}

impl From<&Phong> for engine::Shading<'_> {
    fn from(phong: &Phong) -> Self {
        Self::Phong(engine::Phong {
            diffuse: phong.matt.diffuse,
            specular: phong.specular,
            exponent: phong.exponent,
        })
    }
}

/// A world without shadows as a scene of the engine.
#[must_use]
pub fn scene(world: &LitWorld) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.objects().background(), world.ambient(), 1);
    add_objects(&mut scene, world.objects(), shapes, |material| {
        let color = move |ray: &Ray, hit: &Hit| material.color_for(ray, hit, world);
        engine::Surface::matt(shading(&**material, color))
    });
    for light in world.lights() {
        scene.add_light(engine::Light {
            kind: self::light(&**light),
            casts_shadows: false,
        });
    }
    scene
}
