//! The engine brings back the light of the lesson's tracer, to the last bit: for shapes,
//! materials and lights of all kinds, also of kinds that it does not know.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, PixelRandom, Ray, fast};
use a04_intersections::fast::shapes;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a05_lighting::{
    DirectionalLight, Illumination, Lambert, Light, Lighting, Material, Phong, PointLight,
    SingleColor, SpotLight,
};
use a06_shadows_reflection::fast::scene;
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use common::{Color, Settings, Size};
use engine::Renderer;

/// The `n`-th of the random numbers of a world, from -1 to 1.
struct Numbers(PixelRandom);

impl Numbers {
    fn number(&self, n: u32) -> f64 {
        2.0 * self.0.uniform(n.into()) - 1.0
    }

    fn vector(&self, n: u32) -> Vector3 {
        let [x, y, z] = [0, 1, 2].map(|axis| self.number(3 * n + axis));
        Vector3::new(x, y, z)
    }

    fn color(&self, n: u32) -> Color {
        let v = self.vector(n);
        Color::new(v.x().abs(), v.y().abs(), v.z().abs())
    }
}

/// A shape, a material and a light of types that the engine does not know.
#[derive(Debug)]
struct OwnShape(Sphere);

impl Geometry for OwnShape {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }
}

#[derive(Debug)]
struct OwnMaterial(Color);

impl Material for OwnMaterial {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = lighting.ambient();
        lighting.for_each_light(ray, hit, &mut |light| color += self.0 * light.color);
        color
    }
}

impl Surface for OwnMaterial {
    fn reflection(&self) -> Color {
        self.0 * 0.5
    }
}

#[derive(Debug)]
struct OwnLight(PointLight);

impl Light for OwnLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        self.0.illumination(point).filter(|_| point.x() < 0.3)
    }
}

/// Materials of all kinds in turn, also black ones.
fn surface(numbers: &Numbers, i: u32) -> Box<dyn Surface> {
    let (a, b) = (numbers.color(10 * i), numbers.color(10 * i + 1));
    match i % 7 {
        0 => Box::new(SingleColor::new(a).unwrap()),
        1 => Box::new(Lambert::new(a).unwrap()),
        2 => Box::new(Phong::new(a, b, 20.0).unwrap()),
        3 => Box::new(Phong::new(Color::BLACK, Color::BLACK, 0.0).unwrap()),
        4 => Box::new(Reflective::new(a, Color::BLACK, 1.0, b).unwrap()),
        5 => Box::new(OwnMaterial(b)),
        _ => Box::new(Reflective::new(a, b, 7.5, Color::gray(0.5)).unwrap()),
    }
}

/// Shapes of all kinds over a floor, in light of all kinds.
fn world(seed: u64, shapes: u32) -> ShadowedWorld {
    let numbers = Numbers(PixelRandom::new(seed, 0, 0));
    let small = 2.0 / libm::cbrt(f64::from(shapes.max(1)));
    let position = Point3::new(1.0, 4.0, 2.0);
    let lamp = PointLight::new(Color::gray(0.5), position).unwrap();
    let own = PointLight::new(Color::new(0.1, 0.3, 0.1), Point3::new(-2.0, 2.0, 2.0));
    let sun = DirectionalLight::new(Color::new(0.3, 0.2, 0.1), Vector3::new(1.0, -2.0, -1.0));
    let down = Vector3::new(0.1, -1.0, 0.0);
    let spot = SpotLight::new(Color::WHITE, Point3::new(-1.0, 3.0, 0.0), down, 0.5);
    let floor = Plane::new(Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0));
    let mut world = ShadowedWorld::empty(Color::new(0.1, 0.2, 0.4), Color::gray(0.1))
        .unwrap()
        .lit_by(LightSource::new(lamp, true))
        .lit_by(LightSource::new(sun.unwrap(), seed.is_multiple_of(2)))
        .lit_by(LightSource::new(spot.unwrap(), true))
        .lit_by(LightSource::new(OwnLight(own.unwrap()), true))
        .with(floor.unwrap(), surface(&numbers, seed as u32));
    for i in 0..shapes {
        let at = Point3::ORIGIN + numbers.vector(1000 + 4 * i);
        let (a, b) = (
            numbers.vector(1001 + 4 * i) * small,
            numbers.vector(1002 + 4 * i) * small,
        );
        let surface = surface(&numbers, i);
        world = match i % 5 {
            0 => world.with(Sphere::new(at, small / 2.0).unwrap(), surface),
            1 => world.with(AxisAlignedBox::new(at, at + a).unwrap(), surface),
            4 => world.with(OwnShape(Sphere::new(at, small / 2.0).unwrap()), surface),
            2 => world.with(Triangle::new(at, at + a, at + b).unwrap(), surface),
            _ => {
                let normals = [a, b, a + b].map(Vector3::as_normal);
                let flat = Triangle::new(at, at + a, at + b).unwrap();
                world.with(flat.with_normals(normals).unwrap(), surface)
            }
        };
    }
    world
}

/// All rays of a small picture, and as many from and to anywhere.
fn rays(camera: &PerspectiveCamera) -> Vec<Ray> {
    let size = Size::new(37, 21).unwrap();
    let numbers = Numbers(PixelRandom::new(7, 7, 7));
    let places = (0..size.height()).flat_map(|y| (0..size.width()).map(move |x| (x, y)));
    let seen = places.map(|(x, y)| camera.ray_for(size, x.into(), y.into()));
    let anywhere = (0..size.pixels() as u32).map(|i| {
        let o = Point3::ORIGIN + numbers.vector(2 * i) * 2.0;
        Ray::new(o, numbers.vector(2 * i + 1)).unwrap()
    });
    seen.chain(anywhere).collect()
}

/// The light along rays by the engine, and by the lesson.
fn both(world: &ShadowedWorld, camera: &PerspectiveCamera, rays: &[Ray], depth: u32) {
    let renderer = Renderer::new(
        scene(world, depth, shapes),
        fast::camera(camera),
        &Settings::default(),
    );
    let of_engine: Vec<_> = rays.iter().map(engine::Ray::from).collect();
    let mut light = vec![Color::WHITE; rays.len()];
    renderer.trace(&of_engine, &mut light);
    let tracer = RecursiveTracer::new(world);
    for (ray, light) in rays.iter().zip(light) {
        assert_eq!(light, tracer.trace(ray, depth), "{ray:?}");
    }
}

fn camera(e: Point3) -> PerspectiveCamera {
    let up = Vector3::new(0.0, 1.0, 0.0);
    PerspectiveCamera::new(e, Point3::ORIGIN - e, up, 0.8).unwrap()
}

#[test]
fn colours_are_the_same() {
    let camera = camera(Point3::new(2.0, 1.5, 3.0));
    let rays = rays(&camera);
    for (seed, shapes) in [0, 1, 3, 5, 16, 40, 300].into_iter().enumerate() {
        let world = world(seed as u64, shapes);
        for (depth, count) in [(0, 5), (1, rays.len()), (3, rays.len()), (8, rays.len())] {
            both(&world, &camera, &rays[..count], depth);
        }
    }
}

#[test]
fn any_number_of_rays_will_do() {
    let world = world(2, 7);
    let camera = camera(Point3::new(0.0, 0.0, 4.0));
    let rays = rays(&camera);
    for count in 0..10 {
        both(&world, &camera, &rays[300..300 + count], 4);
    }
}
