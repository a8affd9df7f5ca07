//! Worlds of stage 6 with shapes, materials and lights of a student's own.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, Ray, View};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a04_lab::support::Numbers;
use a05_lighting::{
    DirectionalLight, Illumination, Lambert, Light, Lighting, Material, Phong, PointLight,
    SingleColor, SpotLight,
};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface, traced};
use common::{ArgumentError, Color, Image, Sampling, Settings, Size};

use crate::same_pictures::compare;

/// An endless upright cylinder around the y axis.
#[derive(Debug)]
struct Column(f64);

impl Geometry for Column {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        let a = d.x() * d.x() + d.z() * d.z();
        let b = (o.x() * d.x() + o.z() * d.z()) / a;
        let c = (o.x() * o.x() + o.z() * o.z() - self.0 * self.0) / a;
        let root = (b * b - c).sqrt();
        let mut roots = [-b - root, -b + root].into_iter();
        let t = roots.find(|t| within.contains(*t))?;
        let p = ray.at(t);
        Some(Hit::new(t, Normal3::new(p.x(), 0.0, p.z()).normalized()?))
    }
}

/// A lamp whose light fades with the square of the distance, up to a wall.
#[derive(Debug)]
struct FadingLamp(PointLight);

impl Light for FadingLamp {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.0.illumination(point).filter(|_| point.x() < 1.3)?;
        let fading = 4.0 / (light.distance * light.distance);
        Some(Illumination {
            color: light.color * fading,
            ..light
        })
    }
}

/// As bright in light from behind, in three steps.
#[derive(Debug)]
struct Translucent(Color);

impl Material for Translucent {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = lighting.ambient();
        for normal in [hit.normal, -hit.normal] {
            let side = Hit { normal, ..*hit };
            lighting.for_each_light(ray, &side, &mut |light| {
                let steps = (3.0 * normal.dot(light.direction)).ceil();
                color += self.0 * light.color * steps;
            });
        }
        color
    }
}

impl Surface for Translucent {
    fn mirror_reflectance(&self) -> Color {
        self.0 * 0.5
    }
}

/// From -2 to 2, in eighths.
fn vector(numbers: &mut Numbers) -> Vector3 {
    let [x, y, z] = [0; 3].map(|_| numbers.below(33) as f64 / 8.0 - 2.0);
    Vector3::new(x, y, z)
}

fn point(numbers: &mut Numbers) -> Point3 {
    Point3::ORIGIN + vector(numbers)
}

/// Black in one of four.
fn color(numbers: &mut Numbers) -> Color {
    let [r, g, b] = [0; 3].map(|_| numbers.between(0.0, 1.0));
    Color::new(r, g, b) * f64::from(u8::from(numbers.below(4) > 0))
}

fn geometry(numbers: &mut Numbers) -> Result<Box<dyn Geometry>, ArgumentError> {
    let [a, b, c] = [0; 3].map(|_| point(numbers));
    Ok(match numbers.below(7) {
        0 => Box::new(Plane::new(a, vector(numbers).as_normal())?),
        1 => Box::new(Sphere::new(a, numbers.between(0.2, 1.2))?),
        2 => Box::new(AxisAlignedBox::new(a, b)?),
        3 => Box::new(Column(numbers.between(0.0, 1.0))),
        4 => {
            let normals = [0; 3].map(|_| vector(numbers).as_normal());
            Box::new(Triangle::new(a, b, c)?.with_normals(normals)?)
        }
        _ => Box::new(Triangle::new(a, b, c)?),
    })
}

fn surface(numbers: &mut Numbers) -> Result<Box<dyn Surface>, ArgumentError> {
    let [diffuse, specular, reflection] = [0; 3].map(|_| color(numbers));
    let exponent = [0.0, 1.0, 2.5, 3.0, 64.0, 1024.0][numbers.below(6)];
    Ok(match numbers.below(6) {
        0 => Box::new(SingleColor::new(diffuse)?),
        1 => Box::new(Lambert::new(diffuse)?),
        2 => Box::new(Phong::new(diffuse, specular, exponent)?),
        3 => Box::new(Translucent(diffuse)),
        _ => Box::new(Reflective::new(diffuse, specular, exponent, reflection)?),
    })
}

fn light(numbers: &mut Numbers) -> Result<LightSource, ArgumentError> {
    let (color, place, direction) = (color(numbers), point(numbers), vector(numbers));
    let casts_shadows = numbers.below(4) > 0;
    let point_light = PointLight::new(color, place)?;
    Ok(match numbers.below(4) {
        0 => LightSource::new(point_light, casts_shadows),
        1 => LightSource::new(FadingLamp(point_light), casts_shadows),
        2 => LightSource::new(DirectionalLight::new(color, direction)?, casts_shadows),
        _ => LightSource::new(SpotLight::new(color, place, direction, 0.7)?, casts_shadows),
    })
}

/// A triangle with the eye in its plane, and other objects.
fn view(seed: u64) -> Result<View<ShadowedWorld>, ArgumentError> {
    let numbers = &mut Numbers::new(seed, 0);
    let [a, b, c] = [0; 3].map(|_| point(numbers));
    let mut world = ShadowedWorld::empty(color(numbers), color(numbers))?
        .with(Triangle::new(a, b, c)?, surface(numbers)?);
    // One of ten has enough objects for a tree of several levels.
    let objects = if seed.is_multiple_of(10) {
        100
    } else {
        numbers.below(7)
    };
    for _ in 0..objects {
        if let Ok(geometry) = geometry(numbers) {
            world = world.with(geometry, surface(numbers)?);
        }
    }
    for _ in 0..numbers.below(4) {
        world = world.lit_by(light(numbers)?);
    }
    let eye = a + (b - a) * 2.5 + (c - a) * 1.25;
    let middle = a + (b - a) * 0.25 + (c - a) * 0.5;
    // The engine searches for the rays of a narrow picture together.
    let opening = [0.9, 0.05][seed as usize / 2 % 2];
    let camera = PerspectiveCamera::new(eye, middle - eye, (b - a).cross(c - a), opening)?;
    Ok(View::new(camera, world))
}

/// Compares the renderers in a picture of random settings, and returns the lesson's.
fn check_same(seed: u64, size: Size, depth: u32, view: impl Fn() -> View) -> Image {
    let settings = Settings {
        size,
        samples: 1 + seed as u32 % 2,
        sampling: [Sampling::Center, Sampling::Random][seed as usize % 2],
        depth,
        ..Settings::default()
    };
    compare(seed, view, &settings)
}

#[test]
fn all_renderers_draw_the_same_pictures_of_random_worlds() {
    let size = Size::new(24, 19).unwrap();
    let mut pictures = [0; 2];
    for seed in (0..600).filter(|seed| view(*seed).is_ok()) {
        let lesson = check_same(seed, size, 6, || traced(view(seed).unwrap()));
        let first = lesson.pixels()[0];
        pictures[usize::from(lesson.pixels().iter().any(|color| *color != first))] += 1;
    }
    assert!(
        pictures[1] > 400,
        "{pictures:?} pictures of one colour and of many"
    );
}

/// A camera of random rays, which do not go the same way.
struct Scattered(u64);

impl Camera for Scattered {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        let numbers = &mut Numbers::new(self.0, 64 * y as usize + x as usize);
        loop {
            if let Ok(ray) = Ray::new(point(numbers), vector(numbers)) {
                return ray;
            }
        }
    }
}

#[test]
fn all_renderers_trace_random_rays_to_any_depth() {
    let mut lit = 0;
    for seed in (0..100).filter(|seed| view(*seed).is_ok()) {
        // More rays than a batch of the engine has, and fewer.
        let size = Size::new(1 + seed as u32 % 40, 1 + seed as u32 % 7).unwrap();
        for depth in [0, 1, 3, 8] {
            let scattered = || traced(View::new(Scattered(seed), view(seed).unwrap().world));
            let lesson = check_same(2 * seed, size, depth, scattered);
            let is_lit = |color: &&Color| **color != Color::BLACK;
            lit += lesson.pixels().iter().filter(is_lit).count();
        }
    }
    assert!(lit > 10_000, "{lit}");
}
