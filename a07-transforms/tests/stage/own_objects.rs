//! A shape, a light and a material of a student's own, each with one method:
//! they render by the lesson and with all work alike.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere};
use a05_lighting::{Illumination, Lambert, Light, Lighting, Material, PointLight};
use a06_shadows_reflection::{
    LightSource, Reflective, ShadowedWorld, Surface, View, diagonal_camera, traced_scene,
};
use a07_transforms::fast::shapes;
use a07_transforms::{Node, Transform};
use common::{ArgumentError, Color, Image, Renderer, Sampling, Settings, Size};

/// An endless upright cylinder around the y axis.
#[derive(Debug)]
struct Column {
    r: f64,
}

impl Geometry for Column {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        let a = d.x() * d.x() + d.z() * d.z();
        let b = (o.x() * d.x() + o.z() * d.z()) / a;
        let c = (o.x() * o.x() + o.z() * o.z() - self.r * self.r) / a;
        let root = (b * b - c).sqrt();
        let t = [-b - root, -b + root]
            .into_iter()
            .find(|t| within.contains(*t))?;
        let p = ray.at(t);
        let normal = Normal3::new(p.x(), 0.0, p.z()).normalized()?;
        Some(Hit::new(t, normal))
    }
}

/// A lamp whose light fades with the square of the distance.
#[derive(Debug)]
struct FadingLamp(Point3);

impl Light for FadingLamp {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let way = self.0 - point;
        Some(Illumination {
            color: Color::WHITE * (30.0 / way.dot(way)),
            direction: way.normalized()?,
            distance: way.magnitude(),
        })
    }
}

/// Light in three steps, as in a cartoon.
#[derive(Debug)]
struct Toon(Color);

impl Material for Toon {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut steps = 0.0;
        lighting.for_each_light(ray, hit, &mut |light| {
            steps += (3.0 * hit.normal.dot(light.direction)).ceil() / 3.0;
        });
        self.0 * (lighting.ambient() + Color::gray(steps))
    }
}

impl Surface for Toon {}

/// As bright in light from behind.
#[derive(Debug)]
struct Translucent;

impl Material for Translucent {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = Color::BLACK;
        for normal in [hit.normal, -hit.normal] {
            let side = Hit { normal, ..*hit };
            lighting.for_each_light(ray, &side, &mut |light| color += light.color * 0.25);
        }
        color
    }
}

impl Surface for Translucent {}

/// A mirror for a floor, under a lamp.
fn world() -> Result<ShadowedWorld, ArgumentError> {
    let half = Color::gray(0.5);
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let lamp = PointLight::new(Color::WHITE, Point3::new(2.0, 6.0, 5.0))?;
    let mirror = Reflective::new(half, Color::WHITE, 64.0, half)?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(0.1))?
        .with(floor, Box::new(mirror))
        .lit_by(LightSource::new(lamp, true)))
}

fn ball() -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::new(0.0, 1.0, 0.0), 1.0)
}

fn red() -> Result<Box<dyn Surface>, ArgumentError> {
    Ok(Box::new(Lambert::new(Color::RED)?))
}

/// The picture of the lesson, after a comparison with the engine and with all work.
fn picture<F>(world: F) -> Image
where
    F: Fn() -> Result<ShadowedWorld, ArgumentError> + Copy + Send + Sync + 'static,
{
    let view = move |_: &Settings| -> Result<View, ArgumentError> {
        Ok((diagonal_camera(5.0)?, world()?))
    };
    let scene = traced_scene("own", "objects of a student's own", view, shapes);
    let render = |renderer| {
        let settings = Settings {
            size: Size::new(48, 36).unwrap(),
            samples: 2,
            sampling: Sampling::Random,
            renderer,
            ..Settings::default()
        };
        scene.render(&settings, &()).unwrap()
    };
    let [lesson, engine, all] = Renderer::ALL.map(render);
    let bits = |image: &Image| -> Vec<_> {
        let pixels = image.pixels().iter();
        pixels
            .map(|color| color.channels().map(f64::to_bits))
            .collect()
    };
    assert_eq!(bits(&engine), bits(&lesson));
    assert_eq!(bits(&all), bits(&lesson));
    lesson
}

/// How many pixels differ.
fn differences(a: &Image, b: &Image) -> usize {
    let pairs = a.pixels().iter().zip(b.pixels());
    pairs.filter(|(a, b)| a != b).count()
}

#[test]
fn an_own_shape_renders_alone_and_in_a_node() {
    let without = picture(world);
    let alone = picture(|| Ok(world()?.with(Column { r: 0.5 }, red()?)));
    let moved = picture(|| {
        let aslant = Transform::IDENTITY.rotate_z(0.5)?;
        Ok(world()?.with(Node::new(aslant).with(Column { r: 0.5 }), red()?))
    });
    assert!(differences(&without, &alone) > 200);
    assert!(differences(&alone, &moved) > 200);
}

#[test]
fn an_own_light_renders_with_and_without_shadows() {
    let lamp = |casts_shadows| {
        let lamp = FadingLamp(Point3::new(2.0, 4.0, 0.0));
        LightSource::new(lamp, casts_shadows)
    };
    let dark = picture(|| Ok(world()?.with(ball()?, red()?)));
    let casting = picture(move || Ok(world()?.with(ball()?, red()?).lit_by(lamp(true))));
    let shining = picture(move || Ok(world()?.with(ball()?, red()?).lit_by(lamp(false))));
    assert!(differences(&dark, &casting) > 200);
    assert!(differences(&casting, &shining) > 20);
}

#[test]
fn own_materials_render_in_all_light_that_reaches_them() {
    let without = picture(world);
    let toon = picture(|| Ok(world()?.with(ball()?, Box::new(Toon(Color::GREEN)))));
    let translucent = picture(|| {
        let inside = LightSource::new(FadingLamp(Point3::new(0.0, 1.0, 0.0)), false);
        let world = world()?.with(ball()?, Box::new(Translucent));
        Ok(world.lit_by(inside))
    });
    assert!(differences(&without, &toon) > 50);
    assert!(differences(&toon, &translucent) > 50);
}
