//! Tachyon 0.99: the scene in its language, and its command line.

use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::process::Command;

use crate::camera::unit;
use crate::description::{Camera, Light, LightKind, Material, Object, Shape, Triple};
use crate::tracer::{Job, Times, Tracer, is_installed, seconds};

pub struct Tachyon;

impl Tracer for Tachyon {
    fn name(&self) -> &'static str {
        "Tachyon"
    }

    fn installed(&self) -> bool {
        is_installed("tachyon")
    }

    fn write_scene(&self, job: &Job) -> io::Result<()> {
        let scene = job.description;
        let [width, height] = [job.size.width(), job.size.height()];
        let mut out = BufWriter::new(File::create(job.file(self, "dat"))?);
        writeln!(out, "BEGIN_SCENE\nRESOLUTION {width} {height}")?;
        camera(
            &mut out,
            &scene.camera,
            [width, height].map(f64::from),
            scene.depth,
        )?;
        writeln!(out, "BACKGROUND 0 0 0")?;
        for light in &scene.lights {
            writeln!(out, "{}", of_light(light))?;
        }
        for (i, material) in scene.materials.iter().enumerate() {
            texture(&mut out, i, material, scene.ambient)?;
        }
        for object in (scene.objects)() {
            shape(&mut out, &object)?;
        }
        writeln!(out, "END_SCENE")?;
        out.flush()
    }

    fn command(&self, job: &Job) -> Command {
        let mut command = Command::new("tachyon");
        command
            .arg(job.file(self, "dat"))
            .arg("-o")
            .arg(job.file(self, "png"));
        // Of its three highlights this one is Phong's own.
        command.args(["-format", "PNG", "-fullshade", "-shade_phong", "+V"]);
        command.args(["-numthreads", &job.threads.to_string()]);
        command
    }

    fn times(&self, log: &str) -> Option<Times> {
        Some(Times {
            build: seconds(log, "Preprocessing Time:")?,
            trace: seconds(log, "Ray Tracing Time:")?,
        })
    }
}

fn vector([x, y, z]: Triple) -> String {
    format!("{x} {y} {z}")
}

/// Tachyon's right hand is our left: its frustum goes from right to left. Its
/// rays pass through the corners of pixels: the frustum lies half a pixel lower
/// and farther to the left than ours.
fn camera(
    out: &mut impl Write,
    camera: &Camera,
    [width, height]: [f64; 2],
    depth: u32,
) -> io::Result<()> {
    let top = libm::tan(camera.angle / 2.0);
    let left = top * width / height;
    let half_a_pixel = top / height;
    writeln!(
        out,
        "CAMERA PROJECTION PERSPECTIVE ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {depth} \
         CENTER {} VIEWDIR {} UPDIR {} FRUSTUM {} {} {} {} END_CAMERA",
        vector(camera.eye),
        vector(camera.gaze),
        vector(camera.up),
        left + half_a_pixel,
        half_a_pixel - left,
        -top - half_a_pixel,
        top - half_a_pixel,
    )
}

fn of_light(light: &Light) -> String {
    let color = vector(light.color);
    match &light.kind {
        LightKind::Point(place) => {
            format!("LIGHT CENTER {} RAD 0.001 COLOR {color}", vector(*place))
        }
        LightKind::Spot(place, direction, degrees) => format!(
            "SPOTLIGHT CENTER {} RAD 0.001 DIRECTION {} FALLOFF_START {degrees} \
             FALLOFF_END {degrees} COLOR {color}",
            vector(*place),
            vector(unit((*direction).into()).to_array()),
        ),
        LightKind::Directional(direction) => {
            let direction = vector(*direction);
            format!("DIRECTIONAL_LIGHT DIRECTION {direction} COLOR {color}")
        }
    }
}

/// Tachyon's word for the share that mirrors is "specular".
fn texture(out: &mut impl Write, i: usize, material: &Material, ambient: f64) -> io::Result<()> {
    let Material {
        color,
        specular,
        exponent,
        reflection,
    } = material;
    writeln!(
        out,
        "TEXDEF M{i} AMBIENT {ambient} DIFFUSE 1 SPECULAR {reflection} OPACITY 1 \
         PHONG PLASTIC {specular} PHONG_SIZE {exponent} COLOR {} TEXFUNC 0",
        vector(*color)
    )
}

fn shape(out: &mut impl Write, object: &Object) -> io::Result<()> {
    let texture = format!("M{}", object.material);
    match &object.shape {
        Shape::Plane(normal) => {
            let normal = vector(*normal);
            writeln!(out, "PLANE CENTER 0 0 0 NORMAL {normal} {texture}")
        }
        Shape::Sphere(center, radius) => {
            let center = vector(*center);
            writeln!(out, "SPHERE CENTER {center} RAD {radius} {texture}")
        }
        Shape::Cube(center, half) => {
            let [low, high] = [-half, *half].map(|half| vector(center.map(|c| c + half)));
            writeln!(out, "BOX MIN {low} MAX {high} {texture}")
        }
        Shape::Disc(center, normal, radius) => {
            let (center, normal) = (vector(*center), vector(*normal));
            writeln!(
                out,
                "RING CENTER {center} NORMAL {normal} INNER 0 OUTER {radius} {texture}"
            )
        }
        Shape::Triangle(corners) => {
            let [a, b, c] = corners.map(vector);
            writeln!(out, "TRI V0 {a} V1 {b} V2 {c} {texture}")
        }
        Shape::Mesh(mesh) => mesh.triangles.iter().try_for_each(|triangle| {
            let of_corner = |of: &[Triple]| triangle.map(|i| vector(of[i as usize]));
            let ([a, b, c], [na, nb, nc]) = (of_corner(&mesh.corners), of_corner(&mesh.normals));
            writeln!(
                out,
                "STRI V0 {a} V1 {b} V2 {c} N0 {na} N1 {nb} N2 {nc} {texture}"
            )
        }),
        Shape::Node(..) => Err(ErrorKind::Unsupported.into()),
    }
}
