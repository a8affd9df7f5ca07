//! Pictures of students' shapes.

use std::f64::consts::FRAC_PI_4;

use a02_math::arrays::point;
use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{PerspectiveCamera, Ray, TracedWorld, View, paint};
use a04_intersections::{Interval, World};
use common::{Color, Error, Image, Settings};
use testing::exercises::{Made, StudentPicture};

use crate::shape::{NewShape, Shape};

/// A scene in which the student's shape of these parameters stands instead of the lesson's.
pub fn scene<P: Clone + 'static>(
    name: &'static str,
    view: fn() -> Made<View<World<Color>>>,
    parameters: P,
) -> StudentPicture<NewShape<P>> {
    StudentPicture::scene(name, move |new: &NewShape<P>, settings| {
        let View { camera, world } = view()?;
        let color = world.objects().map(|(_, color)| *color).next();
        let black = World::new(world.background())?;
        let world = black.with(new(parameters.clone())?, color.unwrap_or(Color::WHITE));
        let world = Box::new(world).instrumented(Instruments::LESSON);
        paint(&camera, &|ray: &Ray| world.radiance(ray, 1), settings)
    })
}

/// Where an eye is, and at which point it looks.
#[derive(Clone, Copy)]
pub struct Eye {
    /// The eye.
    pub from: [f64; 3],
    /// The point.
    pub to: [f64; 3],
}

impl Eye {
    /// Shows shapes, coloured by their normals: red faces right or left, green up or down, blue
    /// near or far.
    pub fn show_shapes(
        self,
        shapes: impl IntoIterator<Item = Shape>,
        settings: &Settings,
    ) -> Result<Image, Error> {
        let mut world = World::new(Color::gray(0.1))?;
        for shape in shapes {
            world = world.with(shape, Color::WHITE);
        }
        self.show(&world, settings, &|_, _, normal| {
            let [r, g, b] = normal.to_glam().abs().to_array();
            Color::new(r, g, b)
        })
    }

    /// Shows a world, coloured by surface, point and normal.
    pub fn show(
        self,
        world: &World<Color>,
        settings: &Settings,
        color: &(dyn Fn(Color, Point3, Normal3) -> Color + Sync),
    ) -> Result<Image, Error> {
        let [from, to] = [self.from, self.to].map(point);
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(from, to - from, up, FRAC_PI_4)?;
        let radiance = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
            Some((hit, surface)) => color(*surface, ray.at(hit.t), hit.normal),
            None => world.background(),
        };
        paint(&camera, &radiance, settings)
    }
}

/// Shows the student's shape of these parameters.
pub fn shape_picture<P: Clone + 'static>(parameters: P, eye: Eye) -> StudentPicture<NewShape<P>> {
    StudentPicture::own(move |new: &NewShape<P>, settings| {
        eye.show_shapes([new(parameters.clone())?], settings)
    })
}
