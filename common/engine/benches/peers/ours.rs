//! The engine: the description as its scene, rendered by a child process in which this
//! benchmark runs itself.

use std::error::Error;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use common::{Color, Settings, Transfer, picture_file};
use engine::{Phong, Renderer, Scene, Shading, Surface, Transform};
use glam::{DMat4, DVec3};

use crate::camera::{basis, unit};
use crate::description::{Camera, Description, Light, LightKind, Material, Object, Shape, Triple};
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

/// The work of the child: renders, and writes the picture. Returns the times.
pub fn render_to(
    description: &Description,
    settings: &Settings,
    threads: u16,
    path: &Path,
) -> Result<Times, Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()?;
    let (image, times) = pool.install(|| {
        let started = Instant::now();
        let renderer = Renderer::new(scene(description), camera(&description.camera), settings);
        let build = started.elapsed().as_secs_f64();

        let (started, before) = (Instant::now(), processor_seconds());
        let samples = Samples::new(settings);
        let image = renderer.render(&samples, settings, &())?;
        let trace = started.elapsed().as_secs_f64();
        if let (1, Some(before), Some(after)) = (threads, before, processor_seconds()) {
            eprintln!(
                "using 1 thread(s) with {} CPU-seconds total",
                after - before
            );
        }
        Ok::<_, common::Error>((image, Times { build, trace }))
    })?;
    picture_file::save_png(path, settings.size, &image.to_rgb8(Transfer::Linear))?;
    Ok(times)
}

/// The time that this thread had a processor, where the system reports it (Linux).
fn processor_seconds() -> Option<f64> {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = statistics.split(' ').next()?.parse().ok()?;
    Some(1e-9 * nanoseconds)
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
    for light in &description.lights {
        scene.add_light(of_light(light));
    }
    let materials = description.materials.iter();
    let surfaces: Vec<_> = materials
        .map(|material| scene.add_surface(surface(material)))
        .collect();
    for Object { shape, material } in (description.objects)() {
        let surface = surfaces[material];
        match shape {
            Shape::Mesh(mesh) => {
                for corners in &mesh.triangles {
                    let of_corner = |of: &[Triple]| corners.map(|i| DVec3::from(of[i as usize]));
                    let triangle = flat(of_corner(&mesh.corners));
                    let triangle = smooth(triangle, of_corner(&mesh.normals).map(unit));
                    scene.add_shape(engine::Shape::Triangle(triangle), surface);
                }
            }
            shape => {
                if let Some(shape) = of_shape(shape) {
                    scene.add_shape(shape, surface);
                }
            }
        }
    }
    scene
}

/// None for a mesh, which is more than one shape.
fn of_shape(shape: Shape) -> Option<engine::Shape<'static>> {
    Some(match shape {
        Shape::Plane(normal) => engine::Shape::Plane(plane([0.0; 3], normal)),
        Shape::Sphere(center, radius) => engine::Shape::Sphere(engine::Sphere {
            center: center.into(),
            radius,
        }),
        Shape::Cube(center, half) => engine::Shape::Box(engine::AxisAlignedBox {
            min: center.map(|middle| middle - half),
            max: center.map(|middle| middle + half),
        }),
        Shape::Disc(center, normal, radius) => engine::Shape::Disc(engine::Disc {
            plane: plane(center, normal),
            radius,
        }),
        Shape::Triangle(corners) => engine::Shape::Triangle(flat(corners.map(DVec3::from))),
        Shape::Node(shape, matrices) => {
            let transformed = |shape: engine::Shape<'static>, matrix| {
                let inverse = DMat4::inverse(&matrix);
                shape.transformed(&Transform { matrix, inverse })
            };
            matrices.into_iter().fold(of_shape(*shape)?, transformed)
        }
        Shape::Mesh(_) => return None,
    })
}

fn plane(point: Triple, normal: Triple) -> engine::Plane {
    engine::Plane {
        point: point.into(),
        normal: unit(normal.into()),
    }
}

fn of_light(light: &Light) -> engine::Light<'static> {
    let [r, g, b] = light.color;
    let color = Color::new(r, g, b);
    engine::Light {
        kind: match light.kind {
            LightKind::Point(position) => engine::LightKind::Point {
                color,
                position: position.into(),
            },
            LightKind::Spot(position, direction, degrees) => engine::LightKind::Spot {
                color,
                position: position.into(),
                direction: unit(direction.into()),
                cos_half_angle: libm::cos(degrees.to_radians()),
            },
            LightKind::Directional(direction) => engine::LightKind::Directional {
                color,
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
