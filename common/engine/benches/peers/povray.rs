//! POV-Ray 3.7: the scene in its language, and its command line.
//!
//! Its coordinates are left-handed only if the camera says so: given our right,
//! up and forward vectors it shows our picture.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::process::Command;

use glam::DMat4;

use crate::camera::basis;
use crate::description::{Camera, Light, LightKind, Material, Object, Shape, Triple};
use crate::tracer::{Job, Times, Tracer, is_installed, seconds};

pub struct PovRay;

impl Tracer for PovRay {
    fn name(&self) -> &'static str {
        "POV-Ray"
    }

    fn installed(&self) -> bool {
        is_installed("povray")
    }

    fn write_scene(&self, job: &Job) -> io::Result<()> {
        let scene = job.description;
        let mut out = BufWriter::new(File::create(job.file(self, "pov"))?);
        writeln!(out, "#version 3.7;")?;
        // Without `adc_bailout` no reflection is left out for being faint.
        writeln!(
            out,
            "global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}",
            scene.depth
        )?;
        let aspect = f64::from(job.size.width()) / f64::from(job.size.height());
        camera(&mut out, &scene.camera, aspect)?;
        for light in &scene.lights {
            writeln!(out, "{}", of_light(light))?;
        }
        for (i, material) in scene.materials.iter().enumerate() {
            texture(&mut out, i, material, scene.ambient)?;
        }
        for Object { shape, material } in (scene.objects)() {
            of_shape(&mut out, &shape, &format!("texture {{ M{material} }}"))?;
        }
        out.flush()
    }

    fn command(&self, job: &Job) -> Command {
        let mut command = Command::new("povray");
        command.current_dir(job.folder);
        command.args([
            format!("+I{}", job.file(self, "pov").display()),
            format!("+O{}", job.file(self, "png").display()),
            format!("+W{}", job.size.width()),
            format!("+H{}", job.size.height()),
            format!("+WT{}", job.threads),
            // 8 bits a channel, linear, one sample in each pixel, no window.
            "+FN8".to_owned(),
            "File_Gamma=1".to_owned(),
            "-A".to_owned(),
            "-D".to_owned(),
            "-V".to_owned(),
        ]);
        command
    }

    fn times(&self, log: &str) -> Option<Times> {
        Some(Times {
            build: seconds(log, "Bounding Time:")?,
            trace: seconds(log, "Trace Time:")?,
        })
    }
}

fn vector([x, y, z]: Triple) -> String {
    format!("<{x}, {y}, {z}>")
}

fn list<T: ToString + Copy>(out: &mut impl Write, name: &str, items: &[[T; 3]]) -> io::Result<()> {
    write!(out, "  {name} {{ {}", items.len())?;
    for item in items {
        let numbers = item.map(|number| number.to_string());
        write!(out, ",\n<{}>", numbers.join(", "))?;
    }
    writeln!(out, " }}")
}

/// The picture is 1 high, so that its distance follows from the opening angle.
fn camera(out: &mut impl Write, camera: &Camera, aspect: f64) -> io::Result<()> {
    let basis = basis(camera);
    let distance = 0.5 / libm::tan(camera.angle / 2.0);
    let [right, up, direction] =
        [basis.u * aspect, basis.v, basis.w * -distance].map(|v| vector(v.to_array()));
    writeln!(
        out,
        "camera {{ location {} right {right} up {up} direction {direction} }}",
        vector(camera.eye)
    )
}

fn of_light(light: &Light) -> String {
    let color = vector(light.color);
    match &light.kind {
        LightKind::Point(place) => format!("light_source {{ {} rgb {color} }}", vector(*place)),
        LightKind::Spot(place, direction, degrees) => {
            let at = [0, 1, 2].map(|axis| place[axis] + direction[axis]);
            format!(
                "light_source {{ {} rgb {color} spotlight point_at {} radius {degrees} \
                 falloff {degrees} tightness 0 }}",
                vector(*place),
                vector(at)
            )
        }
        // It starts somewhere, outside of everything.
        LightKind::Directional(direction) => format!(
            "light_source {{ {} rgb {color} parallel point_at 0 }}",
            vector(direction.map(|d| -1000.0 * d))
        ),
    }
}

fn texture(out: &mut impl Write, i: usize, material: &Material, ambient: f64) -> io::Result<()> {
    let Material {
        color,
        specular,
        exponent,
        reflection,
    } = material;
    writeln!(
        out,
        "#declare M{i} = texture {{ pigment {{ rgb {} }} finish {{ ambient {ambient} diffuse 1 \
         phong {specular} phong_size {exponent} reflection {reflection} }} }}",
        vector(*color)
    )
}

/// The shape; `rest` stands behind its own numbers.
fn of_shape(out: &mut impl Write, shape: &Shape, rest: &str) -> io::Result<()> {
    match shape {
        Shape::Plane(normal) => writeln!(out, "plane {{ {}, 0 {rest} }}", vector(*normal)),
        Shape::Sphere(center, radius) => {
            writeln!(out, "sphere {{ {}, {radius} {rest} }}", vector(*center))
        }
        Shape::Cube(center, half) => {
            let [low, high] = [-half, *half].map(|half| vector(center.map(|c| c + half)));
            writeln!(out, "box {{ {low}, {high} {rest} }}")
        }
        Shape::Disc(center, normal, radius) => {
            let (center, normal) = (vector(*center), vector(*normal));
            writeln!(out, "disc {{ {center}, {normal}, {radius} {rest} }}")
        }
        Shape::Triangle(corners) => {
            let corners = corners.map(vector).join(", ");
            writeln!(out, "triangle {{ {corners} {rest} }}")
        }
        Shape::Mesh(mesh) => {
            writeln!(out, "mesh2 {{")?;
            list(out, "vertex_vectors", &mesh.corners)?;
            list(out, "normal_vectors", &mesh.normals)?;
            list(out, "face_indices", &mesh.triangles)?;
            writeln!(out, "  {rest} }}")
        }
        Shape::Node(shape, matrices) => {
            let matrices = matrices.iter().map(matrix).collect::<String>();
            of_shape(out, shape, &(matrices + rest))
        }
    }
}

/// The images of the axes, and of the origin.
fn matrix(matrix: &DMat4) -> String {
    let columns = matrix.to_cols_array_2d();
    let numbers = columns.map(|[x, y, z, _]| format!("{x}, {y}, {z}"));
    format!("matrix <{}> ", numbers.join(", "))
}
