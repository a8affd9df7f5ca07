//! This workbook: the description as our world, rendered by a child process
//! that this benchmark calls itself in.

use std::error::Error;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, render_rows};
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight};
use a06_shadows_reflection::{
    LightSource, Reflective, ShadowedWorld, Surface, TracedLight, foci, tracer,
};
use common::{ArgumentError, Color, Renderer, Settings, Transfer, picture_file};

use crate::description::{Camera, Description, Light, Material, Object, Shape, Triple};
use crate::tracer::{Job, Times, Tracer, seconds};

pub struct Ours;

impl Tracer for Ours {
    fn name(&self) -> &'static str {
        "ours"
    }

    fn installed(&self) -> bool {
        true
    }

    fn write_scene(&self, _: &Job) -> io::Result<()> {
        Ok(())
    }

    fn command(&self, job: &Job) -> Command {
        let this = std::env::current_exe().unwrap_or_default();
        let mut command = Command::new(this);
        command.args(["--render", job.description.name]);
        command.args(["--size", &job.size.to_string()]);
        command.args(["--threads", &job.threads.to_string()]);
        command.arg("-o").arg(job.file(self, "png"));
        command
    }

    fn times(&self, log: &str) -> Option<Times> {
        Some(Times {
            build: seconds(log, "build:")?,
            trace: seconds(log, "trace:")?,
        })
    }
}

/// What the child does: renders, prints its times, and writes the picture.
pub fn render_to(
    description: &Description,
    settings: &Settings,
    threads: u16,
    path: &Path,
) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()?;

    let started = Instant::now();
    let camera = camera(&description.camera)?;
    let world = world(description)?;
    let foci = foci(&camera, &world);
    let world = world.prepared(foci);
    println!("build: {} seconds", started.elapsed().as_secs_f64());

    let started = Instant::now();
    let light = TracedLight {
        tracer: tracer(&world, settings.renderer != Renderer::AllWork, settings),
        depth: description.depth,
    };
    let mut rgb = vec![0; 3 * settings.size.pixels()];
    let bytes = |colors: &[Color], rgb: &mut [u8]| Transfer::Linear.write_rgb8(colors, rgb);
    pool.install(|| render_rows(&camera, light, settings, &(), &mut rgb, bytes))?;
    println!("trace: {} seconds", started.elapsed().as_secs_f64());

    picture_file::save_png(path, settings.size, &rgb)?;
    Ok(())
}

fn camera(camera: &Camera) -> Result<PerspectiveCamera, ArgumentError> {
    let (gaze, up) = (vector(camera.gaze), vector(camera.up));
    PerspectiveCamera::new(point(camera.eye), gaze, up, camera.angle)
}

fn world(description: &Description) -> Result<ShadowedWorld, ArgumentError> {
    let ambient = Color::gray(description.ambient);
    let mut world = ShadowedWorld::empty(Color::BLACK, ambient)?.lit_by(match description.light {
        Light::Point(place) => LightSource::new(PointLight::new(Color::WHITE, point(place))?, true),
        Light::Directional(direction) => LightSource::new(
            DirectionalLight::new(Color::WHITE, vector(direction))?,
            true,
        ),
    });
    for Object { shape, material } in (description.objects)() {
        let surface = || surface(&description.materials[material]);
        world = match shape {
            Shape::Plane(a, n) => world.with(Plane::new(point(a), normal(n))?, surface()?),
            Shape::Sphere(c, r) => world.with(Sphere::new(point(c), r)?, surface()?),
            Shape::Box(low, high) => {
                world.with(AxisAlignedBox::new(point(low), point(high))?, surface()?)
            }
            Shape::Triangle(corners) => world.with(triangle(corners)?, surface()?),
            Shape::Mesh(mesh) => mesh.triangles.iter().try_fold(world, |world, corners| {
                let flat = triangle(corners.map(|i| mesh.corners[i]))?;
                let normals = corners.map(|i| normal(mesh.normals[i]));
                Ok(world.with(flat.with_normals(normals)?, surface()?))
            })?,
        };
    }
    Ok(world)
}

fn surface(material: &Material) -> Result<Box<dyn Surface>, ArgumentError> {
    let color = color(material.color);
    let (specular, exponent) = (Color::gray(material.specular), material.exponent);
    Ok(if material.reflection > 0.0 {
        let reflection = Color::gray(material.reflection);
        Box::new(Reflective::new(color, specular, exponent, reflection)?)
    } else if material.specular > 0.0 {
        Box::new(Phong::new(color, specular, exponent)?)
    } else {
        Box::new(Lambert::new(color)?)
    })
}

fn triangle([a, b, c]: [Triple; 3]) -> Result<Triangle, ArgumentError> {
    Triangle::new(point(a), point(b), point(c))
}

fn point([x, y, z]: Triple) -> Point3 {
    Point3::new(x, y, z)
}

fn vector([x, y, z]: Triple) -> Vector3 {
    Vector3::new(x, y, z)
}

fn normal([x, y, z]: Triple) -> Normal3 {
    Normal3::new(x, y, z)
}

fn color([r, g, b]: Triple) -> Color {
    Color::new(r, g, b)
}
