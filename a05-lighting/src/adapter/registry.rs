//! `registry`: one row for each light and material of this stage: its table in a scene file and how it
//! is read and written, its section in the book, and its numbers for the engine. All materials have one
//! table, of which a key may choose the type.
//!
//! A light or a material without a row works, too: the engine asks it, hit by hit.

mod light_row;
mod material_row;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::View;
use a03_rays_cameras::registry::{Format, read_camera};
use a04_intersections::registry::{ALL_SHAPES, Shapes};
use common::Color;
use scene_export::{Values, exact_angle};
use scene_file::{Error, FirstMistake, Item, SceneFile};

use crate::{DirectionalLight, Lambert, LitWorld, Phong, PointLight, SingleColor, SpotLight};
pub use light_row::{LightKind, LightRow, Lights};
pub use material_row::{MaterialKind, MaterialRow, Materials};

/// The lights of this stage.
pub const LIGHTS: Lights = Lights(&[
    LightRow::of::<PointLight>("point_light"),
    LightRow::of::<SpotLight>("spot_light"),
    LightRow::of::<DirectionalLight>("directional_light"),
]);

/// The materials of this stage. The first reads a table of which no key chooses another type.
pub const MATERIALS: &[MaterialRow] = &[
    MaterialRow::of::<Phong>("", "a05-lighting.md#phong-the-highlight"),
    MaterialRow::of::<Lambert>("", "a05-lighting.md#lambert-the-cosine"),
    MaterialRow::of::<SingleColor>("color", "a05-lighting.md#two-questions"),
];

/// All materials that this stage knows.
pub const ALL_MATERIALS: Materials = Materials(&[MATERIALS]);

/// The scene files of this stage.
pub const FORMAT: Format = Format { stage: 5, view };

impl LightKind for PointLight {
    fn read(item: &Item) -> Result<Self, Error> {
        let color = item.vector("color", Color::new)?;
        item.check(Self::new(color, item.vector("position", Point3::new)?))
    }

    fn content(&self) -> Values {
        vec![
            ("color", self.color.channels().into()),
            ("position", self.position.to_glam().to_array().into()),
        ]
    }

    fn for_engine(&self) -> Option<engine::Emitter<'static>> {
        Some(engine::Emitter::Point {
            color: self.color,
            position: self.position.to_glam(),
        })
    }
}

impl LightKind for SpotLight {
    fn read(item: &Item) -> Result<Self, Error> {
        let color = item.vector("color", Color::new)?;
        let half_angle = item.angle("half_angle")?;
        let position = item.vector("position", Point3::new)?;
        let direction = item.vector("direction", Vector3::new)?;
        item.check(Self::new(color, position, direction, half_angle))
    }

    fn content(&self) -> Values {
        let cosine = self.cos_half_angle;
        let half_angle = exact_angle(libm::acos(cosine), |angle| libm::cos(angle) == cosine);
        let mut values = self.source.content();
        values.push(("direction", self.direction.to_glam().to_array().into()));
        values.push(("half_angle", vec![half_angle]));
        values
    }

    fn for_engine(&self) -> Option<engine::Emitter<'static>> {
        Some(engine::Emitter::Spot {
            color: self.source.color,
            position: self.source.position.to_glam(),
            direction: self.direction.to_glam(),
            cos_half_angle: self.cos_half_angle,
        })
    }
}

impl LightKind for DirectionalLight {
    fn read(item: &Item) -> Result<Self, Error> {
        let color = item.vector("color", Color::new)?;
        item.check(Self::new(color, item.vector("direction", Vector3::new)?))
    }

    fn content(&self) -> Values {
        vec![
            ("color", self.color.channels().into()),
            ("direction", self.direction.to_glam().to_array().into()),
        ]
    }

    fn for_engine(&self) -> Option<engine::Emitter<'static>> {
        Some(engine::Emitter::Directional {
            color: self.color,
            direction: self.direction.to_glam(),
        })
    }
}

impl MaterialKind for SingleColor {
    /// The table is that of a shape.
    fn read(item: &Item) -> Result<Self, Error> {
        item.check(Self::new(item.color("color")))
    }

    fn content(&self) -> Values {
        vec![("color", self.color.channels().into())]
    }

    fn for_engine(&self) -> Option<engine::Shading<'static>> {
        Some(engine::Shading::SingleColor(self.color))
    }
}

impl MaterialKind for Lambert {
    fn read(item: &Item) -> Result<Self, Error> {
        item.check(Self::new(item.color("diffuse")))
    }

    fn content(&self) -> Values {
        vec![("diffuse", self.diffuse.channels().into())]
    }

    fn for_engine(&self) -> Option<engine::Shading<'static>> {
        Some(engine::Shading::Phong(engine::Phong {
            diffuse: self.diffuse,
            specular: Color::BLACK,
            exponent: 0.0,
        }))
    }
}

impl MaterialKind for Phong {
    fn read(item: &Item) -> Result<Self, Error> {
        let (diffuse, specular, exponent) = read_phong(item)?;
        item.check(Self::new(diffuse, specular, exponent))
    }

    /// The highlight only where there is one.
    fn content(&self) -> Values {
        let mut values = self.matt.content();
        if self.specular != Color::BLACK {
            values.push(("specular", self.specular.channels().into()));
            values.push(("exponent", vec![self.exponent]));
        }
        values
    }

    fn for_engine(&self) -> Option<engine::Shading<'static>> {
        Some(engine::Shading::Phong(engine::Phong {
            diffuse: self.matt.diffuse,
            specular: self.specular,
            exponent: self.exponent,
        }))
    }

    fn as_phong(&self) -> Option<&Phong> {
        Some(self)
    }
}

/// A world without shadows as a scene of the engine.
#[must_use]
pub fn for_engine(world: &LitWorld) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.objects().background(), world.ambient(), 1);
    ALL_SHAPES.add_objects(&mut scene, world.objects(), |material| {
        engine::Surface::matt(
            ALL_MATERIALS.for_engine(&**material, |ray, hit| material.color_for(ray, hit, world)),
        )
    });
    for light in world.lights() {
        scene.add_light(engine::Light {
            kind: LIGHTS.for_engine(&**light),
            casts_shadows: false,
        });
    }
    scene
}

/// The camera and the world of a file.
fn view(file: &SceneFile) -> Result<View, Error> {
    let surface = |shape: &Item| ALL_MATERIALS.read_of(shape, file);
    let without_shadows = |item: &Item| match item.flag("shadows") {
        Some(true) => Err(item.error("shadows", "lights cast shadows from stage 6 on")),
        _ => LIGHTS.read(item),
    };
    let mut first = FirstMistake::of(file);
    let world = read_world(file, &mut first, ALL_SHAPES, surface, without_shadows);
    let camera = first.keep(read_camera(file));
    let (world, camera) = first.result(world.zip(camera))?;
    Ok(View { camera, world }.boxed())
}

/// The world of a file, of a stage's own shapes, surfaces and lights. Mistakes are kept in `first`;
/// without a mistake there is a world.
pub fn read_world<S, L>(
    file: &SceneFile,
    first: &mut FirstMistake,
    shapes: Shapes,
    surface: impl Fn(&Item) -> Result<S, Error>,
    light: impl Fn(&Item) -> Result<L, Error>,
) -> Option<LitWorld<S, L>> {
    let item = &file.world;
    let empty = LitWorld::empty(item.color("background"), item.color("ambient"));
    let empty = first.keep(item.check(empty));
    let objects = shapes.read_objects(file, first, surface);
    let lights = file.lights.iter();
    let lights: Vec<_> = lights.filter_map(|item| first.keep(light(item))).collect();
    let mut world = empty?;
    for (geometry, surface) in objects {
        world.world = world.world.with(geometry, surface);
    }
    world.lights = lights;
    Some(world)
}

/// The diffuse and specular reflectance and the exponent of a Phong material.
pub fn read_phong(item: &Item) -> Result<(Color, Color, f64), Error> {
    let has_highlight = item.find("specular").or(item.find("exponent")).is_some();
    let exponent = if has_highlight {
        item.number("exponent")?
    } else {
        1.0
    };
    Ok((item.color("diffuse"), item.color("specular"), exponent))
}
