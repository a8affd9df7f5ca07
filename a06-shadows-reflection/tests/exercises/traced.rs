//! Worlds of mirrors, and a tracer with the student's code in it.

use a03_rays_cameras::instruments::Instruments;
use a04_intersections::registry::ALL_SHAPES;
use a06_shadows_reflection::instruments::instrumented::InstrumentedWorld;

use crate::prelude::*;

/// The objects of a world.
pub type Objects = World<Box<dyn Surface>>;

/// Computes colours by their definition, with functions instead of the lesson's `is_shadowed` and
/// `secondary_ray`.
pub struct Tracer<'a> {
    /// The world.
    pub world: &'a ShadowedWorld,
    /// Whether an object lies between a hit and a light.
    pub is_shadowed: &'a dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool,
    /// The ray that leaves a hit in a direction.
    pub secondary_ray: &'a dyn Fn(&Ray, &Hit, Vector3) -> Ray,
}

impl Tracer<'_> {
    /// `c + cr f`, with the colour `f` that the reflected ray brings back.
    pub fn trace(&self, ray: &Ray, depth: u32) -> Color {
        if depth == 0 {
            return Color::BLACK;
        }
        let objects = self.world.objects();
        let Some((hit, surface)) = objects.hit(ray, Interval::AHEAD) else {
            return objects.background();
        };
        let direction = (-ray.direction()).reflected_on(hit.normal);
        let color = surface.color_for(ray, &hit, self);
        let reflected = (self.secondary_ray)(ray, &hit, direction);
        color + surface.mirror_reflectance() * self.trace(&reflected, depth - 1)
    }
}

impl Lighting for Tracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        for source in self.world.lights() {
            let Some(light) = source.illumination(ray.at(hit.t)) else {
                continue;
            };
            let is_before = hit.normal.dot(light.direction) > 0.0;
            if is_before && !(self.is_shadowed)(self.world.objects(), ray, hit, &light) {
                shade(&light);
            }
        }
    }
}

/// Renders a view in the colours of this function of the world, a ray, and the depth.
pub fn rendered<W: Sync>(
    view: &View<W>,
    settings: &Settings,
    color: impl Fn(&W, &Ray, u32) -> Color + Sync,
) -> Result<Image, Error> {
    let radiance = |ray: &Ray| color(&view.world, ray, settings.depth);
    paint(&*view.camera, &radiance, settings)
}

/// Renders a view in the colours of this function of the world, a ray, and the depth; and records
/// their steps.
pub fn traced_picture(
    view: View<ShadowedWorld>,
    settings: &Settings,
    color: impl Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync,
) -> Result<Image, Error> {
    let view = view.map(|world| InstrumentedWorld::new(world, ALL_SHAPES, Instruments::LESSON));
    rendered(&view, settings, |world, ray, depth| {
        world.color(|world| color(world, ray, depth))
    })
}

/// A floor y = 0, a ball and a smooth triangle that mirror, and a lamp.
pub fn mirrors(centre: [f64; 3], radius: f64, reflection: Color) -> Made<ShadowedWorld> {
    let mirror = |own| Reflective::new(own, Color::WHITE, 8.0, reflection).map(Box::new);
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 9.0, 4.0))?;
    let triangle = smooth_triangle(point([0.0, 1.5, -4.0]), vector([0.0, -1.5, 3.0]), 2.0)?;
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let ball = Sphere::new(point(centre), radius)?;
    Ok(ShadowedWorld::empty(Color::gray(0.5), Color::gray(0.25))?
        .with(floor, mirror(Color::WHITE)?)
        .with(ball, mirror(Color::RED)?)
        .with(triangle, mirror(Color::BLUE)?)
        .lit_by(LightSource::new(lamp, true)))
}

/// A floor y = 0 and a ceiling at this height, which face each other and mirror.
pub fn two_mirrors(height: f64, reflection: Color) -> Made<ShadowedWorld> {
    let mirror = |own| Reflective::new(own, Color::WHITE, 8.0, reflection).map(Box::new);
    let up = Normal3::new(0.0, 1.0, 0.0);
    let floor = Plane::new(Point3::ORIGIN, up)?;
    let ceiling = Plane::new(Point3::new(0.0, height, 0.0), up)?;
    Ok(ShadowedWorld::empty(Color::gray(0.5), Color::gray(0.25))?
        .with(floor, mirror(Color::WHITE)?)
        .with(ceiling, mirror(Color::RED)?))
}

/// A triangle around a point with the normal `n`, whose corners have another one.
pub fn smooth_triangle(p: Point3, n: Vector3, size: f64) -> Made<Triangle> {
    let u = n.cross(Vector3::new(n.y(), n.z(), -n.x())).unit("side")? * size;
    let v = n.unit("normal")?.cross(u);
    let [a, b, c] = [(2.0, 0.0), (-1.0, 2.0), (-1.0, -2.0)].map(|(x, y)| p + u * x + v * y);
    Triangle::new(a, b, c)?.with_normals([(n + u * (1.0 / size)).as_normal(); 3])
}
