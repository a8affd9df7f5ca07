//! The engine: the description as its scene, rendered by a child process in which this
//! benchmark runs itself.

use std::error::Error;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use common::{Color, Settings, Transfer, picture_file};
use engine::{LightKind, Phong, Renderer, Scene, Shading, Surface};
use glam::DVec3;

use crate::camera::{basis, unit};
use crate::description::{Camera, Description, Light, Material, Object, Shape};
use crate::samples::Samples;
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

/// The work of the child: it renders, prints its times, and writes the picture.
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
    let renderer = Renderer::new(scene(description), camera(&description.camera), settings);
    println!("build: {} seconds", started.elapsed().as_secs_f64());

    let started = Instant::now();
    let samples = Samples::new(settings);
    let mut rgb = vec![0; 3 * settings.size.pixels()];
    let bytes = |colors: &[Color], rgb: &mut [u8]| Transfer::Linear.write_rgb8(colors, rgb);
    pool.install(|| renderer.render_rows(&samples, settings, &(), &mut rgb, bytes))?;
    println!("trace: {} seconds", started.elapsed().as_secs_f64());

    picture_file::save_png(path, settings.size, &rgb)?;
    Ok(())
}

fn camera(camera: &Camera) -> engine::Camera<'static> {
    engine::Camera::Perspective {
        basis: basis(camera),
        half_tangent: libm::tan(camera.angle / 2.0),
    }
}

fn scene(description: &Description) -> Scene<'static> {
    let ambient = Color::gray(description.ambient);
    let mut scene = Scene::new(Color::BLACK, ambient, description.depth);
    scene.add_light(light(&description.light));
    let materials = description.materials.iter();
    let surfaces: Vec<_> = materials
        .map(|material| scene.add_surface(surface(material)))
        .collect();
    for Object { shape, material } in (description.objects)() {
        let mut add = |shape| scene.add_shape(shape, surfaces[material]);
        match shape {
            Shape::Plane(point, normal) => add(engine::Shape::Plane(engine::Plane {
                point: point.into(),
                normal: unit(normal.into()),
            })),
            Shape::Sphere(center, radius) => add(engine::Shape::Sphere(engine::Sphere {
                center: center.into(),
                radius,
            })),
            Shape::Box(min, max) => {
                add(engine::Shape::Box(engine::AxisAlignedBox { min, max }));
            }
            Shape::Triangle(corners) => {
                add(engine::Shape::Triangle(flat(corners.map(DVec3::from))));
            }
            Shape::Mesh(mesh) => {
                for corners in &mesh.triangles {
                    let normals = corners.map(|i| unit(mesh.normals[i].into()));
                    let triangle = flat(corners.map(|i| mesh.corners[i].into()));
                    add(engine::Shape::Triangle(smooth(triangle, normals)));
                }
            }
        }
    }
    scene
}

fn light(light: &Light) -> engine::Light<'static> {
    engine::Light {
        kind: match *light {
            Light::Point(position) => LightKind::Point {
                color: Color::WHITE,
                position: position.into(),
            },
            Light::Directional(direction) => LightKind::Directional {
                color: Color::WHITE,
                direction: unit(direction.into()),
            },
        },
        casts_shadows: true,
    }
}

fn surface(material: &Material) -> Surface<'static> {
    let [r, g, b] = material.color;
    Surface {
        shading: Shading::Phong(Phong {
            diffuse: Color::new(r, g, b),
            specular: Color::gray(material.specular),
            exponent: material.exponent,
        }),
        reflection: Color::gray(material.reflection),
    }
}

/// A triangle with one normal, on the side where its corners run counterclockwise.
fn flat(corners: [DVec3; 3]) -> engine::Triangle {
    let [a, b, c] = corners;
    // Measured in the longest edge, so that even tiny triangles keep their normals.
    let edges = [b - a, c - a, c - b];
    let longest = edges.map(DVec3::length).into_iter().fold(0.0, f64::max);
    let [ab, ac] = [edges[0], edges[1]].map(|edge| edge * (1.0 / longest));
    let face = unit(ab.cross(ac));
    engine::Triangle {
        corners,
        normals: [face; 3],
        face,
    }
}

/// The triangle with these normals, its face on their side.
fn smooth(triangle: engine::Triangle, normals: [DVec3; 3]) -> engine::Triangle {
    let [a, b, c] = normals;
    let is_turned = (a + b + c).dot(triangle.face) < 0.0;
    engine::Triangle {
        normals,
        face: if is_turned {
            -triangle.face
        } else {
            triangle.face
        },
        ..triangle
    }
}
