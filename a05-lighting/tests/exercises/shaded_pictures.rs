//! Pictures of scenes in the colours of students' code.

use a04_intersections::instruments::instrumented::push_background;
use a05_lighting::instruments::instrumented::{self, push_light};
use a05_lighting::registry::ALL_MATERIALS;

use crate::prelude::*;

/// Renders a view in the colours of this function of the diffuse colour of the material, the ray,
/// its hit, and the lights; and records their steps.
pub fn shaded(
    view: View<LitWorld>,
    settings: &Settings,
    color: impl Fn(Color, &Ray, &Hit, &LitWorld) -> Color + Sync,
) -> Result<Image, Error> {
    let view = view.map(|world| {
        instrumented::map_world(world, |_, shape| shape, |own| own, instrumented::light)
    });
    let only_ambient = ReceivedLight {
        ambient: Color::WHITE,
        lights: Vec::new(),
    };
    let world = &view.world;
    let radiance = |ray: &Ray| {
        let background = world.objects().background();
        let shown = match world.objects().hit(ray, Interval::AHEAD) {
            Some((hit, material)) => {
                let diffuse = material.color_for(ray, &hit, &only_ambient);
                instrumented::shaded(ray, &hit, ALL_MATERIALS, &**material, || {
                    color(diffuse, ray, &hit, world)
                })
            }
            None => background,
        };
        push_background(background);
        shown
    };
    paint(&*view.camera, &radiance, settings)
}

/// A student's light in a scene.
pub struct Lit<P> {
    /// The scene, whose objects become shiny.
    pub view: fn() -> Made<View<LitWorld>>,
    /// The name of the light's type in the steps of a pixel.
    pub name: &'static str,
    /// The parameters of the light.
    pub light: P,
}

impl<P: Clone + Sync + 'static> Lit<P> {
    /// The picture of the scene with this name, which is compared.
    pub fn scene(self, name: &'static str) -> StudentPicture<LightAt<P>> {
        StudentPicture::scene(name, move |light, settings| self.rendered(light, settings))
    }

    /// A picture of the scene in another light, to be looked at.
    pub fn own(self) -> StudentPicture<LightAt<P>> {
        StudentPicture::own(move |light, settings| self.rendered(light, settings))
    }

    fn rendered(&self, light_at: &LightAt<P>, settings: &Settings) -> Result<Image, Error> {
        shaded((self.view)()?, settings, |diffuse, ray, hit, world| {
            let light = light_at(self.light.clone(), ray.at(hit.t));
            push_light(1, self.name, light);
            let received = ReceivedLight {
                ambient: world.ambient(),
                lights: light.into_iter().collect(),
            };
            let shiny = Phong::new(diffuse, Color::WHITE, 64.0);
            shiny.map_or(Color::BLACK, |shiny| shiny.color_for(ray, hit, &received))
        })
    }
}
