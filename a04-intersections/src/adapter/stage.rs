//! `stage`: the scenes of this stage for its program, and its
//! world for the renderers.

use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{Ray, TracedWorld, View, traced_scene};
use common::steps::{self, StepKind};
use common::{Color, Stage};
use scene_export::{Values, WrittenShape};

use crate::instruments::{instrumented, objects};
use crate::registry::{self, ALL_SHAPES};
use crate::scenes::{scene_1, scene_2, scene_3, scene_4, scene_5, scene_6};
use crate::{Interval, World};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let new = traced_scene;
    let scenes = vec![
        new("scene-1", "a green plane, up to the horizon", |_| {
            scene_1().map(View::boxed)
        }),
        new("scene-2", "a red sphere", |_| scene_2().map(View::boxed)),
        new("scene-3", "a blue box, from above its corner", |_| {
            scene_3().map(View::boxed)
        }),
        new("scene-4", "a magenta triangle", |_| {
            scene_4().map(View::boxed)
        }),
        new("scene-5", "two red spheres, one farther away", |_| {
            scene_5().map(View::boxed)
        }),
        new("scene-6", "the same without perspective", |_| {
            scene_6().map(View::boxed)
        }),
    ];
    Stage {
        name: "a04-intersections",
        about: "Where rays meet planes, boxes, triangles and spheres",
        scenes,
        open: Some(|path| registry::FORMAT.open(path)),
    }
}

impl TracedWorld for World<Color> {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self.color_for(ray)
    }

    fn for_engine(&self, _: u32) -> Option<engine::Scene<'_>> {
        Some(registry::for_engine(self))
    }

    fn written_shapes(&self) -> Vec<WrittenShape> {
        ALL_SHAPES.written(self)
    }

    fn written_materials(&self) -> Vec<Option<Values>> {
        let mut written = Vec::new();
        for (_, color) in self.objects() {
            written.push(Some(vec![("color", color.channels().into())]));
        }
        written
    }

    fn nearest(&self, ray: &Ray) -> Option<(usize, f64)> {
        objects::nearest(self, ray)
    }

    fn object_name(&self, number: usize) -> String {
        objects::object_name(self, number)
    }

    fn instrumented(self: Box<Self>, instruments: Instruments) -> Box<dyn TracedWorld> {
        if let Instruments::Silent(_) = instruments {
            return self;
        }
        let world = instrumented::world(*self, ALL_SHAPES, |color| color);
        Box::new(move |ray: &Ray| {
            let color = world.color_for(ray);
            if steps::is_tracing() {
                let nearest = steps::untraced(|| world.hit(ray, Interval::AHEAD));
                if let Some((hit, color)) = nearest {
                    instrumented::shaded(ray, &hit, || {
                        instrumented::push_color(StepKind::Color, "colour", *color);
                    });
                }
                instrumented::push_background(world.background());
            }
            color
        })
    }
}
