//! Rays that are traced together bring back what each brings back alone, to the
//! last bit.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, foci,
};
use common::{Color, Size};
use measure::tally::{Work, counted};

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

/// Materials of all kinds in turn, also black ones.
fn surface(numbers: &Numbers, i: u32) -> Box<dyn Surface> {
    let (a, b) = (numbers.color(10 * i), numbers.color(10 * i + 1));
    match i % 6 {
        0 => Box::new(SingleColor::new(a).unwrap()),
        1 => Box::new(Lambert::new(a).unwrap()),
        2 => Box::new(Phong::new(a, b, 20.0).unwrap()),
        3 => Box::new(Phong::new(Color::BLACK, Color::BLACK, 0.0).unwrap()),
        4 => Box::new(Reflective::new(a, Color::BLACK, 1.0, b).unwrap()),
        _ => Box::new(Reflective::new(a, b, 7.5, Color::gray(0.5)).unwrap()),
    }
}

/// Shapes of all kinds over a floor, in light of all kinds.
fn world(seed: u64, shapes: u32) -> ShadowedWorld {
    let numbers = Numbers(PixelRandom::new(seed, 0, 0));
    let small = 2.0 / libm::cbrt(f64::from(shapes.max(1)));
    let position = Point3::new(1.0, 4.0, 2.0);
    let lamp = PointLight::new(Color::gray(0.5), position).unwrap();
    let sun = DirectionalLight::new(Color::new(0.3, 0.2, 0.1), Vector3::new(1.0, -2.0, -1.0));
    let down = Vector3::new(0.1, -1.0, 0.0);
    let spot = SpotLight::new(Color::WHITE, Point3::new(-1.0, 3.0, 0.0), down, 0.5);
    let floor = Plane::new(Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0));
    let mut world = ShadowedWorld::empty(Color::new(0.1, 0.2, 0.4), Color::gray(0.1))
        .unwrap()
        .lit_by(LightSource::new(lamp, true))
        .lit_by(LightSource::new(sun.unwrap(), seed.is_multiple_of(2)))
        .lit_by(LightSource::new(spot.unwrap(), true))
        .with(floor.unwrap(), surface(&numbers, seed as u32));
    for i in 0..shapes {
        let at = Point3::ORIGIN + numbers.vector(1000 + 4 * i);
        let (a, b) = (
            numbers.vector(1001 + 4 * i) * small,
            numbers.vector(1002 + 4 * i) * small,
        );
        let surface = surface(&numbers, i);
        world = match i % 4 {
            0 => world.with(Sphere::new(at, small / 2.0).unwrap(), surface),
            1 => world.with(AxisAlignedBox::new(at, at + a).unwrap(), surface),
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

/// And as many rays are followed for them: no light is looked for in vain.
#[test]
fn colours_are_the_same() {
    let (e, up) = (Point3::new(2.0, 1.5, 3.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(e, Point3::ORIGIN - e, up, 0.8).unwrap();
    let rays = rays(&camera);
    for (seed, shapes) in [0, 1, 3, 5, 16, 40, 300].into_iter().enumerate() {
        let world = world(seed as u64, shapes);
        let foci = foci(&camera, &world);
        let world = world.prepared(foci);
        for (depth, count, cut) in [
            (0, 5, None),
            (1, rays.len(), None),
            (8, rays.len(), None),
            (8, rays.len(), Some(0.05)),
        ] {
            let tracer = RecursiveTracer::new(&world, true).cut_below(cut);
            let rays = &rays[..count];
            let together = || {
                let mut colors = vec![Color::WHITE; count];
                tracer.trace_together(rays, depth, &mut colors);
                colors
            };
            let alone = || rays.iter().map(|ray| tracer.trace(ray, depth)).collect();
            let (together, work) = counted(together).unwrap();
            let (alone, of_alone): (Vec<_>, _) = counted(alone).unwrap();
            for (ray, (together, alone)) in rays.iter().zip(together.iter().zip(alone)) {
                assert_eq!(*together, alone, "{shapes} shapes, {ray:?}");
            }
            for kind in [Work::ReflectedRay, Work::ShadowRay, Work::Power] {
                assert_eq!(work[kind], of_alone[kind], "{shapes} shapes: {kind:?}");
            }
        }
    }
}

#[test]
fn any_number_of_rays_will_do() {
    let world = world(2, 7).prepared([]);
    let tracer = RecursiveTracer::new(&world, true);
    let camera = PerspectiveCamera::new(
        Point3::new(0.0, 0.0, 4.0),
        Vector3::new(0.0, 0.0, -1.0),
        Vector3::new(0.0, 1.0, 0.0),
        0.8,
    );
    let rays = rays(&camera.unwrap());
    for count in 0..10 {
        let mut together = vec![Color::WHITE; count];
        tracer.trace_together(&rays[300..300 + count], 4, &mut together);
        let alone = rays[300..].iter().map(|ray| tracer.trace(ray, 4));
        assert_eq!(together, alone.take(count).collect::<Vec<_>>());
    }
}
