//! `stage`: the scenes of this stage for its program, and its
//! world for the renderers.

use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{Ray, TracedWorld, View, traced_scene};
use a04_intersections::instruments::instrumented::push_background;
use a04_intersections::instruments::objects;
use a04_intersections::registry::ALL_SHAPES;
use common::{Color, Stage};
use scene_export::{Values, WrittenLight, WrittenShape};

use crate::LitWorld;
use crate::instruments::instrumented;
use crate::registry;
use crate::scenes::{
    lambert, lighting_1, phong, phong_directional, phong_spot, phong_spot_ambient,
};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let new = traced_scene;
    let scenes = vec![
        new("lighting-1", "four objects without light", |_| {
            lighting_1().map(View::boxed)
        }),
        new("lambert", "matt, under a point light", |_| {
            lambert().map(View::boxed)
        }),
        new("phong", "shiny, under a point light", |_| {
            phong().map(View::boxed)
        }),
        new("phong-directional", "under a far light", |_| {
            phong_directional().map(View::boxed)
        }),
        new("phong-spot", "in the cone of a spot light", |_| {
            phong_spot().map(View::boxed)
        }),
        new(
            "phong-spot-ambient",
            "and a little light from everywhere",
            |_| phong_spot_ambient().map(View::boxed),
        ),
    ];
    Stage {
        name: "a05-lighting",
        about: "Lights and materials: Lambert and Phong",
        scenes,
        open: Some(|path| registry::FORMAT.open(path)),
    }
}

impl TracedWorld for LitWorld {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self.color_for(ray)
    }

    fn for_engine(&self, _: u32) -> Option<engine::Scene<'_>> {
        Some(registry::for_engine(self))
    }

    fn written_shapes(&self) -> Vec<WrittenShape> {
        ALL_SHAPES.written(self.objects())
    }

    fn written_materials(&self) -> Vec<Option<Values>> {
        let objects = self.objects().objects();
        objects
            .map(|(_, material)| registry::ALL_MATERIALS.written(&**material))
            .collect()
    }

    fn written_lights(&self) -> Vec<WrittenLight> {
        let lights = self.lights().iter();
        lights
            .map(|light| registry::LIGHTS.written(&**light))
            .collect()
    }

    fn nearest(&self, ray: &Ray) -> Option<(usize, f64)> {
        objects::nearest(self.objects(), ray)
    }

    fn object_name(&self, number: usize) -> String {
        objects::object_name(self.objects(), number)
    }

    fn instrumented(self: Box<Self>, instruments: Instruments) -> Box<dyn TracedWorld> {
        let omissions = instruments.omissions();
        let surface =
            |material| instrumented::material(material, registry::ALL_MATERIALS, omissions);
        if let Instruments::Silent(_) = instruments {
            let world = instrumented::map_surfaces(*self, surface);
            return Box::new(move |ray: &Ray| world.color_for(ray));
        }
        let world = instrumented::world(*self, ALL_SHAPES, surface, instrumented::light);
        Box::new(move |ray: &Ray| {
            let color = world.color_for(ray);
            push_background(world.objects().background());
            color
        })
    }
}
