//! The book's pictures of mistakes: too little, right, and too much.
//! Takes the arguments of the stages' programs.

mod mesh;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{AxisAlignedBox, Hit, Interval, Plane, Sphere, World};
use a06_shadows_reflection::secondary_ray;
use common::{Color, Error, Image, Progress, Scene, Settings, Transfer};
use measure::{Effort, Stage};

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    program::run(&stage(), a01_image_display::viewer())
}

/// The pictures as a stage, so that its program can show and its test lock them.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "go-wrong",
        about: "What can go wrong: too little, right, and too much",
        scenes: vec![lift(), gamma(), mesh::cracks()],
        experiments: Vec::new,
        extremes: |_: Effort| Vec::new(),
    }
}

/// Width and height of each picture, in pixels.
const PANEL: (u32, u32) = (240, 240);

/// Where a shadow ray begins.
type Lifted = fn(&Ray, &Hit) -> Ray;

fn lift() -> Scene {
    let about = "a shadow ray that is lifted not at all, by 64 roundings, and by 0.2";
    let lifts: [Lifted; 3] = [
        |ray, hit| by(0.0, ray, hit),
        |ray, hit| secondary_ray(ray, hit, sunwards()),
        |ray, hit| by(0.2, ray, hit),
    ];
    let panels = lifts.map(|lifted| {
        move |settings: &Settings, progress: &dyn Progress| shadows(lifted, settings, progress)
    });
    Scene::side_by_side("lift", about, panels, PANEL)
}

/// The shadow ray of a hit, lifted by a length.
#[must_use]
pub fn by(lift: f64, ray: &Ray, hit: &Hit) -> Ray {
    let point = ray.at(hit.t) + Vector3::from(hit.face) * lift;
    Ray::derived(point, sunwards())
}

/// The direction to the light; its length is 1.
#[must_use]
pub const fn sunwards() -> Vector3 {
    Vector3::new(0.6, 0.48, 0.64)
}

const SLOPE: Vector3 = Vector3::new(-0.1, 1.0, 0.15);

/// A ball and a flat box on a slope, and their shadows.
pub fn shadows(
    lifted: impl Fn(&Ray, &Hit) -> Ray + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let normal = SLOPE.unit("slope")?;
    let floor = Plane::new(Point3::ORIGIN, Normal3::from_glam(normal.to_glam()))?;
    let ball = Sphere::new(Point3::ORIGIN + normal * 0.5, 0.5)?;
    let (lbf, run) = (Point3::new(-1.6, -0.5, -0.6), Point3::new(-0.8, 0.05, 0.4));
    let world = World::new(Color::BLACK)?
        .with(floor, Color::gray(0.8))
        .with(ball, Color::RED)
        .with(AxisAlignedBox::new(lbf, run)?, Color::new(0.3, 0.5, 1.0));
    let (eye, up) = (Point3::new(-0.6, 2.6, 4.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, Point3::new(-0.7, 0.1, 0.0) - eye, up, 0.7)?;
    let color = |ray: &Ray| {
        let Some((hit, color)) = world.hit(ray, Interval::AHEAD) else {
            return world.background();
        };
        let is_dark = world.is_hit(&lifted(ray, &hit), Interval::AHEAD);
        let cosine = hit.normal.dot(sunwards()).max(0.0);
        *color * if is_dark { 0.2 } else { 0.2 + 0.8 * cosine }
    };
    render(&camera, color, settings, progress)
}

fn gamma() -> Scene {
    let about = "the same light in bytes: linear, by gamma 2.2, by the curve of sRGB";
    let transfers = [Transfer::Linear, Transfer::Gamma, Transfer::Srgb];
    let panels = transfers.map(|transfer| {
        move |settings: &Settings, progress: &dyn Progress| {
            let stage = a05_lighting::stage();
            let image = stage.scene("lambert")?.render(settings, progress)?;
            // The file is written as it is, so the curve comes first.
            Ok(image.map(|color| color.map(|channel| transfer.encode(channel))))
        }
    });
    Scene::side_by_side("gamma", about, panels, PANEL)
}
