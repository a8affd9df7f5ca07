//! POV-Ray 3.7: the scene in its language, and its command line.
//!
//! Its coordinates are left-handed only if the camera says so: given our right,
//! up and forward vectors it shows our picture.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::process::Command;

use crate::camera::basis;
use crate::description::{Camera, Light, Material, Mesh, Object, Shape, Triple};
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
        light(&mut out, &scene.light)?;
        for (i, material) in scene.materials.iter().enumerate() {
            texture(&mut out, i, material, scene.ambient)?;
        }
        for object in (scene.objects)() {
            shape(&mut out, &object)?;
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

fn list<const N: usize>(out: &mut impl Write, name: &str, items: &[[f64; N]]) -> io::Result<()> {
    write!(out, "  {name} {{ {}", items.len())?;
    for item in items {
        write!(
            out,
            ",\n<{}>",
            item.map(|number| number.to_string()).join(", ")
        )?;
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

fn light(out: &mut impl Write, light: &Light) -> io::Result<()> {
    match light {
        Light::Point(place) => writeln!(out, "light_source {{ {} rgb 1 }}", vector(*place)),
        // It starts somewhere, outside of everything.
        Light::Directional(direction) => writeln!(
            out,
            "light_source {{ {} rgb 1 parallel point_at 0 }}",
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

fn shape(out: &mut impl Write, object: &Object) -> io::Result<()> {
    let texture = format!("texture {{ M{} }}", object.material);
    match &object.shape {
        Shape::Plane(point, normal) => {
            let (point, normal) = (vector(*point), vector(*normal));
            writeln!(
                out,
                "plane {{ {normal}, vdot({point}, {normal}) {texture} }}"
            )
        }
        Shape::Sphere(centre, radius) => {
            writeln!(out, "sphere {{ {}, {radius} {texture} }}", vector(*centre))
        }
        Shape::Box(low, high) => {
            writeln!(
                out,
                "box {{ {}, {} {texture} }}",
                vector(*low),
                vector(*high)
            )
        }
        Shape::Triangle(corners) => {
            writeln!(
                out,
                "triangle {{ {} {texture} }}",
                corners.map(vector).join(", ")
            )
        }
        Shape::Mesh(Mesh {
            corners,
            normals,
            triangles,
        }) => {
            writeln!(out, "mesh2 {{")?;
            list(out, "vertex_vectors", corners)?;
            list(out, "normal_vectors", normals)?;
            let triangles: Vec<_> = triangles.iter().map(|t| t.map(|i| i as f64)).collect();
            list(out, "face_indices", &triangles)?;
            writeln!(out, "  {texture} }}")
        }
    }
}
