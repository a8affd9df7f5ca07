//! A ray tracer of your own: a scene, and the functions that draw it, from the sphere to the loop over the
//! pixels. `cargo run` writes it to `picture.png`. Everything here is yours to change.

#![allow(dead_code, reason = "you call the functions that you like")]

mod functions;
mod lights;
mod materials;
mod mesh;
mod prelude;
mod transform;

use std::path::Path;
use std::process::ExitCode;

use prelude::*;

const SIZE: [u32; 2] = [480, 320];
/// Rays through each pixel. More of them make edges smoother, and take as much longer.
const SAMPLES: u32 = 16;
/// How many mirrors a ray meets at most, one after the other.
const DEPTH: u32 = 6;

fn main() -> ExitCode {
    match draw(Path::new("picture.png")) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn draw(file: &Path) -> Result<(), Error> {
    let settings = Settings {
        size: Size::new(SIZE[0], SIZE[1])?,
        sampling: Sampling::Stratified,
        samples: SAMPLES,
        ..Settings::default()
    };
    let (camera, world) = (camera()?, world()?);
    let image = picture(&camera, &|ray| trace(&world, ray, DEPTH), &settings)?;
    // What screens expect; with `Transfer::Linear` it looks as dark as the course's pictures.
    let bytes = image.to_rgb8(Transfer::Srgb);
    picture_file::save_png(file, image.size(), &bytes)?;
    println!("{}", file.display());
    Ok(())
}

fn camera() -> Result<PerspectiveCamera, ArgumentError> {
    let (eye, middle) = (Point3::new(1.2, 2.6, 8.0), Point3::new(0.0, 0.85, 0.0));
    let up = Vector3::new(0.0, 1.0, 0.0);
    PerspectiveCamera::new(eye, middle - eye, up, 36_f64.to_radians())
}

fn world() -> Result<ShadowedWorld, ArgumentError> {
    let (sky, ambient) = (Color::new(0.04, 0.06, 0.12), Color::gray(0.08));
    let up = Normal3::new(0.0, 1.0, 0.0);
    let floor = Plane::new(Point3::ORIGIN, up)?;
    let pool = Disc::new(Point3::new(0.0, 0.001, 0.0), up, 3.4)?;
    let large = Sphere::new(Point3::new(0.2, 1.0, -0.8), 1.0)?;
    let small = Sphere::new(Point3::new(1.5, 0.4, 1.2), 0.4)?;

    let cube = AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5))?;
    let upright = Transform::new(&[
        Step::Translate([-1.9, 0.75, -0.6]),
        Step::Rotate(1, 0.6),
        Step::Scale([0.8, 1.5, 0.8]),
    ]);
    let pillar = Node::new(upright).with(cube);

    Ok(ShadowedWorld::empty(sky, ambient)?
        .with(floor, matt(Color::new(0.30, 0.34, 0.30)))
        .with(pool, mirror(Color::gray(0.02), Color::new(0.45, 0.5, 0.55)))
        .with(large, mirror(Color::gray(0.05), Color::gray(0.7)))
        .with(small, shiny(Color::new(0.75, 0.10, 0.05)))
        .with(pillar, matt(Color::new(0.85, 0.55, 0.10)))
        .with(pyramid()?, shiny(Color::new(0.10, 0.35, 0.60)))
        .lit_by(lamp(Color::new(0.75, 0.68, 0.55), [3.0, 5.0, 4.0]))
        .lit_by(sun(Color::new(0.12, 0.14, 0.22), [1.0, -1.5, -1.0]))
        .lit_by(spot(
            Color::new(0.35, 0.25, 0.45),
            [-4.0, 4.0, 3.0],
            [0.2, 0.0, 0.0],
            0.35,
        )))
}

/// A pyramid of four triangles.
fn pyramid() -> Result<Mesh, ArgumentError> {
    let top = Point3::new(-0.5, 1.0, 1.5);
    let corners = [[-1.1, 1.0], [-0.4, 0.9], [0.1, 1.6], [-0.6, 2.1]];
    let mut mesh = Mesh::new()?;
    for (number, [x, z]) in corners.into_iter().enumerate() {
        let [next_x, next_z] = corners[(number + 1) % corners.len()];
        let [a, b] = [Point3::new(x, 0.0, z), Point3::new(next_x, 0.0, next_z)];
        mesh = mesh.with(Triangle::new(b, a, top)?);
    }
    Ok(mesh)
}

fn matt(diffuse: Color) -> Box<dyn Surface> {
    Box::new(Lambert { diffuse })
}

fn shiny(diffuse: Color) -> Box<dyn Surface> {
    Box::new(Reflective {
        diffuse,
        specular: Color::gray(0.6),
        exponent: 60.0,
        reflection: Color::gray(0.08),
    })
}

fn mirror(diffuse: Color, reflection: Color) -> Box<dyn Surface> {
    Box::new(Reflective {
        diffuse,
        specular: Color::WHITE,
        exponent: 200.0,
        reflection,
    })
}

fn lamp(color: Color, at: [f64; 3]) -> LightSource {
    let position = point(at);
    LightSource::new(PointLight { color, position }, true)
}

fn sun(color: Color, direction: [f64; 3]) -> LightSource {
    let direction = vector(direction);
    LightSource::new(DirectionalLight { color, direction }, true)
}

/// A spot light of this half angle in radians, from one point to another.
fn spot(color: Color, from: [f64; 3], to: [f64; 3], half_angle: f64) -> LightSource {
    let position = point(from);
    let axis = (point(to) - position).normalized().unwrap_or_default();
    let spot = SpotLight {
        color,
        position,
        axis,
        half_angle,
    };
    LightSource::new(spot, true)
}
