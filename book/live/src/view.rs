//! `View`: camera and world of a traced picture, so that a page can turn the camera
//! and name the surface that a ray meets.

use std::fmt::Debug;

use a02_math::Point3;
use a03_rays_cameras::{Camera, Ray, StripeRule, StripedSky, scenes as a03};
use a04_intersections::{Geometry, Hit, Interval, World, scenes as a04};
use a05_lighting::{LitWorld, scenes as a05};
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld, scenes as a06};
use a07_transforms::scenes as a07;
use common::{ArgumentError, Color, Settings};

/// A world of one of the stages.
pub enum Subject {
    Sky(StripedSky),
    Colors(World<Color>),
    Lit(LitWorld),
    Shadowed(ShadowedWorld),
}

pub struct View {
    pub camera: Box<dyn Camera>,
    pub subject: Subject,
    /// The point that the camera is turned around.
    pub centre: Point3,
}

/// The view of a picture; none if the picture is not a traced scene of a stage.
pub fn view(picture: &str, settings: &Settings) -> Result<Option<View>, ArgumentError> {
    let sky = |rule| {
        let (camera, sky) = a03::striped_sky(settings.size, rule)?;
        let camera: Box<dyn Camera> = Box::new(camera);
        Ok((camera, Subject::Sky(sky)))
    };
    let colors = |(camera, world)| (camera, Subject::Colors(world));
    let lit = |(camera, world)| (camera, Subject::Lit(world));
    let shadowed = |(camera, world)| (camera, Subject::Shadowed(world));
    let (camera, subject) = match picture {
        "a03-rays-cameras-striped-sky" => sky(StripeRule::Direction)?,
        "a03-rays-cameras-striped-sky-straight" => sky(StripeRule::Wall)?,
        "a04-intersections-scene-1" => colors(a04::scene_1()?),
        "a04-intersections-scene-2" => colors(a04::scene_2()?),
        "a04-intersections-scene-3" => colors(a04::scene_3()?),
        "a04-intersections-scene-4" => colors(a04::scene_4()?),
        "a04-intersections-scene-5" => colors(a04::scene_5()?),
        "a04-intersections-scene-6" => colors(a04::scene_6()?),
        "a05-lighting-lighting-1" => lit(a05::lighting_1()?),
        "a05-lighting-lambert" => lit(a05::lambert()?),
        "a05-lighting-phong" => lit(a05::phong()?),
        "a05-lighting-phong-directional" => lit(a05::phong_directional()?),
        "a05-lighting-phong-spot" => lit(a05::phong_spot()?),
        "a05-lighting-phong-spot-ambient" => lit(a05::phong_spot_ambient()?),
        "a06-shadows-reflection-sphere" => shadowed(a06::sphere()?),
        "a06-shadows-reflection-aab" => shadowed(a06::aab()?),
        "a07-transforms-sphere-transformation" => shadowed(a07::sphere_transformation()?),
        "a07-transforms-box-transformations" => shadowed(a07::box_transformations()?),
        "a07-transforms-disc" => shadowed(a07::disc()?),
        _ => return Ok(None),
    };
    // The objects that a camera at the origin looks at are three to six before it.
    let centre = match picture {
        "a04-intersections-scene-2" | "a04-intersections-scene-4" => Point3::new(0.0, 0.0, -3.0),
        "a04-intersections-scene-5" | "a04-intersections-scene-6" => Point3::new(0.0, 0.0, -4.5),
        _ => Point3::ORIGIN,
    };
    Ok(Some(View {
        camera,
        subject,
        centre,
    }))
}

/// The surface that a ray has met.
pub struct Met {
    pub hit: Hit,
    /// The types of the geometry and of its material.
    pub names: String,
}

impl View {
    /// The light that comes back along rays, as the stage of the picture computes it.
    pub fn radiance(&self, depth: u32) -> Box<dyn Fn(&Ray) -> Color + Sync + '_> {
        match &self.subject {
            Subject::Sky(sky) => Box::new(|ray| sky.color_for(ray)),
            Subject::Colors(world) => Box::new(|ray| world.color_for(ray)),
            Subject::Lit(world) => Box::new(|ray| world.color_for(ray)),
            Subject::Shadowed(world) => {
                let tracer = RecursiveTracer::new(world);
                Box::new(move |ray| tracer.trace(ray, depth))
            }
        }
    }

    /// The nearest surface along a ray.
    pub fn meet(&self, ray: &Ray) -> Option<Met> {
        match &self.subject {
            Subject::Sky(_) => None,
            Subject::Colors(world) => nearest(world, ray, |_| String::new()),
            Subject::Lit(world) => nearest(world.objects(), ray, material),
            Subject::Shadowed(world) => nearest(world.objects(), ray, material),
        }
    }
}

fn nearest<S>(world: &World<S>, ray: &Ray, material: impl Fn(&S) -> String) -> Option<Met> {
    let (hit, _) = world.hit(ray, Interval::AHEAD)?;
    // The world says where, and the geometry of the same `t` which.
    let at_hit = |geometry: &dyn Geometry| {
        let own = geometry.hit(ray, Interval::AHEAD);
        own.is_some_and(|own| own.t == hit.t)
    };
    let (geometry, surface) = world.objects().find(|(geometry, _)| at_hit(*geometry))?;
    let names = format!("{}{}", type_name(geometry), material(surface));
    Some(Met { hit, names })
}

fn material(surface: &impl Debug) -> String {
    format!(", {}", type_name(surface))
}

/// The name of a type, with which its `Debug` text begins.
fn type_name(value: &(impl Debug + ?Sized)) -> String {
    let text = format!("{value:?}");
    let name = text.split(|c: char| !c.is_alphanumeric()).next();
    name.unwrap_or_default().to_owned()
}
