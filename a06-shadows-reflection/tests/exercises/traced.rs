//! Worlds of mirrors, and a tracer with the student's code in it.

use a04_intersections::kinds::KINDS as SHAPES;
use a06_shadows_reflection::instruments::recorded::RecordedWorld;

use crate::prelude::*;

/// The objects of a world.
pub type Objects = World<Box<dyn Surface>>;

/// Whether an object lies between a hit and a light.
pub type IsShadowed<'a> = &'a dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool;

/// The ray that leaves a hit in a direction.
pub type Leaving<'a> = &'a dyn Fn(&Ray, &Hit, Vector3) -> Ray;

/// Computes colours by their definition, with functions in the place of `is_shadowed` and
/// `secondary_ray`.
pub struct Tracer<'a>(pub &'a ShadowedWorld, pub IsShadowed<'a>, pub Leaving<'a>);

impl Tracer<'_> {
    /// `c + cr f`, with the colour `f` that the reflected ray brings back.
    pub fn trace(&self, ray: &Ray, depth: u32) -> Color {
        let Self(world, _, leaving) = self;
        let objects = world.objects();
        let Some((hit, surface)) = objects.hit(ray, Interval::AHEAD).filter(|_| depth > 0) else {
            return objects.background() * f64::from(depth.min(1));
        };
        let direction = (-ray.direction()).reflected_on(hit.normal);
        let color = surface.color_for(ray, &hit, self);
        color + surface.reflection() * self.trace(&leaving(ray, &hit, direction), depth - 1)
    }
}

impl Lighting for Tracer<'_> {
    fn ambient(&self) -> Color {
        self.0.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let Self(world, is_shadowed, _) = self;
        let lights = world.lights().iter();
        lights
            .filter_map(|light| light.illumination(ray.at(hit.t)))
            .filter(|light| hit.normal.dot(light.direction) > 0.0)
            .filter(|light| !is_shadowed(world.objects(), ray, hit, light))
            .for_each(|light| shade(&light));
    }
}

/// The picture of a scene in the colours of this function, which records its steps.
pub fn reflected_scene(
    view: Made<View<ShadowedWorld>>,
    color: impl Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync,
) -> impl FnOnce(&Settings) -> Result<Image, Error> {
    let recorded = |world| RecordedWorld::new(world, SHAPES, false);
    let view = view.map(|view| view.map(recorded));
    rendered(view, move |world: &RecordedWorld, ray, depth| {
        world.color(|world| color(world, ray, depth))
    })
}

/// A floor y = 0, a ball and a smooth triangle that mirror, and a lamp.
pub fn mirrors(c: [f64; 3], r: f64, reflection: [f64; 3]) -> Made<ShadowedWorld> {
    let of = |own| Reflective::new(own, Color::WHITE, 8.0, color(reflection)).map(Box::new);
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 9.0, 4.0))?;
    let triangle = smooth_triangle(point([0.0, 1.5, -4.0]), vector([0.0, -0.5, 1.0]), 2.0)?;
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    Ok(ShadowedWorld::empty(Color::gray(0.5), Color::gray(0.25))?
        .with(floor, of(Color::WHITE)?)
        .with(Sphere::new(point(c), r)?, of(Color::RED)?)
        .with(triangle, of(Color::BLUE)?)
        .lit_by(LightSource::new(lamp, true)))
}

/// A triangle around a point with the normal `n`, whose corners have another one.
pub fn smooth_triangle(p: Point3, n: Vector3, size: f64) -> Made<Triangle> {
    let u = n.cross(Vector3::new(n.y(), n.z(), -n.x())).unit("side")? * size;
    let v = n.unit("normal")?.cross(u);
    let [a, b, c] = [(2.0, 0.0), (-1.0, 2.0), (-1.0, -2.0)].map(|(x, y)| p + u * x + v * y);
    Triangle::new(a, b, c)?.with_normals([(n + u * (1.0 / size)).as_normal(); 3])
}
