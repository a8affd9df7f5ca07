//! `registry`: one row for each surface of this stage, and how surfaces and lights that cast shadows
//! are read from a scene file and translated for the engine.

use std::any::Any;

use a03_rays_cameras::registry::{Format, read_camera};
use a03_rays_cameras::{Ray, View};
use a04_intersections::Hit;
use a04_intersections::registry::{ALL_SHAPES, Shapes};
use a05_lighting::registry::{
    LIGHTS, MATERIALS as LIT_MATERIALS, MaterialKind, MaterialRow, Materials, read_phong,
    read_world,
};
use a05_lighting::{Material, Phong};
use common::Color;
use scene_export::Values;
use scene_file::{Error, FirstMistake, Item, SceneFile};

use crate::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, traced};

/// The materials of this stage. The first reads a table of which no key chooses another type.
pub const MATERIALS: &[MaterialRow] = &[MaterialRow::of::<Reflective>(
    "",
    "a05-lighting.md#phong-the-highlight",
)];

/// All materials that this stage knows.
pub const ALL_MATERIALS: Materials = Materials(&[MATERIALS, LIT_MATERIALS]);

/// The scene files of this stage.
pub const FORMAT: Format = Format {
    stage: 6,
    view: |file| read_view(file, ALL_SHAPES).map(traced),
};

impl MaterialKind for Reflective {
    fn read(item: &Item) -> Result<Self, Error> {
        let (diffuse, specular, exponent) = read_phong(item)?;
        let reflection = item.color("reflection");
        item.check(Self::new(diffuse, specular, exponent, reflection))
    }

    /// The reflection only where there is one.
    fn content(&self) -> Values {
        let mut values = self.shiny.content();
        if self.reflection != Color::BLACK {
            values.push(("reflection", self.reflection.channels().into()));
        }
        values
    }

    fn for_engine(&self) -> Option<engine::Shading<'static>> {
        self.shiny.for_engine()
    }

    fn as_phong(&self) -> Option<&Phong> {
        Some(&self.shiny)
    }
}

/// A material of the stage below mirrors nothing.
impl Surface for Box<dyn Material> {}

/// A material as a surface.
fn surface(material: Box<dyn Material>) -> Box<dyn Surface> {
    let any: &dyn Any = &*material;
    match any.downcast_ref::<Reflective>() {
        Some(mirror) => Box::new(*mirror),
        None => Box::new(material),
    }
}

/// A world as a scene of the engine, whose rays may hit `depth` surfaces in turn.
#[must_use]
pub fn for_engine(world: &ShadowedWorld, depth: u32, shapes: Shapes) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.objects().background(), world.ambient(), depth);
    shapes.add_objects(&mut scene, world.objects(), |surface| {
        let surface: &dyn Surface = &**surface;
        let material: &dyn Material = surface;
        let color = move |ray: &Ray, hit: &Hit| {
            let lighting = RecursiveTracer::new(world);
            surface.color_for(ray, hit, &lighting)
        };
        engine::Surface {
            shading: ALL_MATERIALS.for_engine(material, color),
            reflection: surface.mirror_reflectance(),
        }
    });
    for source in world.lights() {
        scene.add_light(engine::Light {
            kind: LIGHTS.for_engine(&*source.light),
            casts_shadows: source.casts_shadows(),
        });
    }
    scene
}

/// The camera and the world of a file, with the shapes of a stage.
pub fn read_view(file: &SceneFile, shapes: Shapes) -> Result<View<ShadowedWorld>, Error> {
    let surface = |shape: &Item| ALL_MATERIALS.read_of(shape, file).map(surface);
    let source = |item: &Item| {
        Ok(LightSource {
            light: LIGHTS.read(item)?,
            casts_shadows: item.flag("shadows").unwrap_or(true),
        })
    };
    let mut first = FirstMistake::of(file);
    let world = read_world(file, &mut first, shapes, surface, source);
    let camera = first.keep(read_camera(file));
    let (world, camera) = first.result(world.zip(camera))?;
    Ok(View { camera, world })
}
