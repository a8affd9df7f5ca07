//! Helpers of the checks of lights and materials.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Hit, Plane, Sphere};
use a05_lighting::{Illumination, Lighting, LitWorld, Material};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

/// Lights from these directions of length 1, all of the same colour.
pub struct Lights<'a> {
    pub color: Color,
    pub directions: &'a [Vector3],
}

impl Lighting for Lights<'_> {
    fn ambient(&self) -> Color {
        Color::BLACK
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        for &direction in self.directions {
            shade(&Illumination {
                color: self.color,
                direction,
                distance: f64::INFINITY,
            });
        }
    }
}

/// The colour of a material with a normal for an eye in a direction of length 1.
pub fn seen(material: &impl Material, normal: Normal3, eye: Vector3, lights: &Lights) -> [f64; 3] {
    let ray = Ray::derived(Point3::ORIGIN + eye, -eye);
    let t = eye.dot(eye);
    material
        .color_for(&ray, &Hit::new(t, normal), lights)
        .channels()
}

/// A random direction of length 1.
pub fn unit(random: &mut Random) -> Vector3 {
    Vector3::from_glam(random.unit().into())
}

/// A random colour, brighter than white in parts.
pub fn color(random: &mut Random) -> Color {
    let [r, g, b] = [(); 3].map(|()| random.between(0.0, 1.5));
    Color::new(r, g, b)
}

/// Two balls on a floor, of materials with these colours, and no light.
pub fn balls<M: Material + 'static>(
    material: impl Fn(Color) -> Result<M, ArgumentError>,
) -> Result<LitWorld, ArgumentError> {
    let boxed = |color| material(color).map(|material| Box::new(material) as Box<dyn Material>);
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let (red, blue) = (Color::new(0.8, 0.3, 0.2), Color::new(0.3, 0.4, 0.8));
    Ok(LitWorld::new(Color::gray(0.1), Color::gray(0.05))?
        .with(floor, boxed(Color::gray(0.6))?)
        .with(Sphere::new(Point3::new(-1.1, 1.0, 0.0), 1.0)?, boxed(red)?)
        .with(Sphere::new(Point3::new(1.1, 0.7, 0.6), 0.7)?, boxed(blue)?))
}

/// Shows a world from above.
pub fn show(check: &mut Check, world: Result<LitWorld, ArgumentError>) {
    check.picture(|settings| {
        let world = world?;
        let (eye, at) = (Point3::new(1.0, 4.0, 7.0), Point3::new(0.0, 0.6, 0.0));
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(eye, at - eye, up, FRAC_PI_4)?;
        render(&camera, |ray| world.color_for(ray), settings, &())
    });
}
