//! The book's pictures of mistakes: too little, right, and too much.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, PixelRandom, Ray, render};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a04_lab::protocol;
use a06_lab::coarse_ball::{ON_THE_CURVED_SURFACE, ON_THE_TRIANGLE, Start, coarse_ball};
use a06_shadows_reflection::{mirror_direction, secondary_ray};
use common::{Color, Error, Image, Progress, Scene, Settings, Size, Stage, Transfer};

use crate::side_by_side::side_by_side;

/// The pictures as a stage, so that its program can show and its test lock them.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "go-wrong",
        about: "What can go wrong: too little, right, and too much",
        scenes: vec![
            offset(),
            gamma(),
            cracks(),
            terminator(),
            rim(),
            coincident(),
        ],
        open: None,
    }
}

/// Width and height of each picture, in pixels.
const PANEL: (u32, u32) = (240, 240);

fn offset() -> Scene {
    let about = "a shadow ray that is offset not at all, by 64 roundings, and by 0.2";
    let shadow_rays: [fn(&Ray, &Hit) -> Ray; 3] = [
        |ray, hit| by(0.0, ray, hit),
        |ray, hit| secondary_ray(ray, hit, sunwards()),
        |ray, hit| by(0.2, ray, hit),
    ];
    let panels = shadow_rays.map(|shadow_ray| {
        move |settings: &Settings, progress: &dyn Progress| shadows(shadow_ray, settings, progress)
    });
    side_by_side("offset", about, panels, PANEL)
}

/// The shadow ray of a hit, offset by a length.
#[must_use]
pub fn by(offset: f64, ray: &Ray, hit: &Hit) -> Ray {
    let point = ray.at(hit.t) + Vector3::from(hit.geometric_normal) * offset;
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
    shadow_ray: impl Fn(&Ray, &Hit) -> Ray + Sync,
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
        let is_dark = world.is_hit(&shadow_ray(ray, &hit), Interval::AHEAD);
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
    side_by_side("gamma", about, panels, PANEL)
}

/// Cracks between triangles. Rays that aim nowhere hardly ever meet an edge, so
/// the corners of this wall lie exactly behind the middles of pixels.
fn cracks() -> Scene {
    let about = "a wall of triangles: by Cramer's rule, and by the test without gaps";
    let theirs: Test = |corners| Box::new(move |ray| protocol::triangle(&corners, ray).is_some());
    let ours: Test = |[a, b, c]| match Triangle::new(a, b, c) {
        Ok(triangle) => Box::new(move |ray| triangle.hit(ray, Interval::AHEAD).is_some()),
        Err(_) => Box::new(|_| false),
    };
    let panels = [theirs, ours].map(|test| {
        move |settings: &Settings, progress: &dyn Progress| wall(test, settings, progress)
    });
    side_by_side("cracks", about, panels, PANEL)
}

/// Whether rays meet a triangle.
type Test = fn([Point3; 3]) -> Box<dyn Fn(&Ray) -> bool + Sync>;

/// Pixels from corner to corner.
const STEP: u32 = 20;

/// A wall before a light: light that shines through is white.
fn wall(test: Test, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    let (eye, gaze) = (Point3::new(0.1, 0.2, 0.3), Vector3::new(1.0, -0.3, -2.0));
    let camera = PerspectiveCamera::new(eye, gaze, Vector3::new(0.0, 1.0, 0.0), 0.8)?;
    let triangles = triangles(&camera, settings.size).into_iter();
    let triangles: Vec<_> = triangles.map(|corners| (corners, test(corners))).collect();
    let color = |ray: &Ray| {
        let met = triangles.iter().find(|(_, is_met)| is_met(ray));
        met.map_or(Color::WHITE, |&([a, b, c], _)| {
            let normal = (b - a).cross(c - a).normalized();
            let cosine = normal.map_or(0.0, |n| n.dot(ray.direction()).abs());
            Color::new(0.2, 0.3, 0.5) * cosine
        })
    };
    render(&camera, color, settings, progress)
}

/// The triangles between corners at a fixed distance in pixels, and beyond the
/// border; each corner is 3 to 3.5 away.
fn triangles(camera: &PerspectiveCamera, size: Size) -> Vec<[Point3; 3]> {
    let [columns, rows] = [size.width(), size.height()].map(|side| side / STEP + 2);
    let corner = |column: u32, row: u32| {
        let place = |index: u32| f64::from(STEP) * (f64::from(index) - 0.5);
        let ray = camera.ray_for(size, place(column), place(row));
        let number = PixelRandom::new(4, row * columns + column, 0).uniform(0);
        ray.at(3.0 + 0.5 * number)
    };
    let cells = (1..rows).flat_map(|row| (1..columns).map(move |column| (column, row)));
    cells
        .flat_map(|(column, row)| {
            let (left, below) = (column - 1, row - 1);
            let [a, b] = [corner(left, below), corner(column, below)];
            let [c, d] = [corner(column, row), corner(left, row)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// The shadow terminator of a ball: where its normal is still turned to the light, some of its
/// triangles are turned away.
fn terminator() -> Scene {
    let about = "a ball of 80 triangles, the same by Hanika's start, and one of 320 triangles";
    let panels: [(u32, Start); 3] = [
        (1, ON_THE_TRIANGLE),
        (1, ON_THE_CURVED_SURFACE),
        (2, ON_THE_TRIANGLE),
    ];
    let panels = panels.map(|(divisions, start)| {
        move |settings: &Settings, progress: &dyn Progress| {
            smooth_ball(divisions, start, settings, progress)
        }
    });
    side_by_side("terminator", about, panels, PANEL)
}

/// A smooth matt ball of 20 · 4^`divisions` triangles in bright light from far away.
fn smooth_ball(
    divisions: u32,
    start: Start,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let ball = coarse_ball(divisions, Color::new(0.25, 0.35, 0.5))?;
    let to_light = Vector3::new(3.0 / 7.0, 6.0 / 7.0, -2.0 / 7.0);
    let (eye, up) = (Point3::new(1.5, 1.0, 4.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, Point3::ORIGIN - eye, up, 0.52)?;
    let color = |ray: &Ray| {
        let Some((hit, corners)) = ball.hit(ray, Interval::AHEAD) else {
            return ball.background();
        };
        let cosine = hit.normal.dot(to_light);
        let shadow_ray = start(ray, &hit, corners, to_light);
        let is_dark = cosine <= 0.0 || ball.is_hit(&shadow_ray, Interval::AHEAD);
        Color::gray(if is_dark { 0.1 } else { 0.1 + 1.5 * cosine })
    };
    render(&camera, color, settings, progress)
}

/// The rim of a smooth mirror: where its normal leans, rays are reflected into its triangles.
fn rim() -> Scene {
    let about = "a mirroring ball of 80 triangles under an even sky, the same as the lesson has it, \
        and one of 320 triangles";
    let about_the_normal: Mirror = |ray, hit| (-ray.direction()).reflected_on(hit.normal);
    let panels = [
        (1, about_the_normal),
        (1, mirror_direction),
        (2, about_the_normal),
    ];
    let panels = panels.map(|(divisions, mirror)| {
        move |settings: &Settings, progress: &dyn Progress| {
            mirroring_ball(divisions, mirror, settings, progress)
        }
    });
    side_by_side("rim", about, panels, PANEL)
}

/// The direction in which the surface at a hit mirrors a ray.
type Mirror = fn(&Ray, &Hit) -> Vector3;

/// A smooth ball of 20 · 4^`divisions` triangles that mirrors seven tenths of the light of the sky.
fn mirroring_ball(
    divisions: u32,
    mirror: Mirror,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let ball = coarse_ball(divisions, Color::new(0.75, 0.85, 1.0))?;
    let (eye, up) = (Point3::new(1.5, 1.0, 4.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, Point3::ORIGIN - eye, up, 0.52)?;
    let color = |ray: &Ray| {
        let (mut ray, mut mirrored) = (*ray, 1.0);
        for _ in 0..6 {
            let Some((hit, _)) = ball.hit(&ray, Interval::AHEAD) else {
                return ball.background() * mirrored;
            };
            mirrored *= 0.7;
            ray = secondary_ray(&ray, &hit, mirror(&ray, &hit));
        }
        Color::BLACK
    };
    render(&camera, color, settings, progress)
}

/// A rug in the plane of its floor: rounding decides for each pixel which of them is nearer.
fn coincident() -> Scene {
    let about =
        "a rug in the plane of the floor, after and before it in the list, and 1e-9 above it";
    let panels = [(0.0, true), (0.0, false), (1e-9, true)].map(|(height, floor_is_first)| {
        move |settings: &Settings, progress: &dyn Progress| {
            rug(height, floor_is_first, settings, progress)
        }
    });
    side_by_side("coincident", about, panels, PANEL)
}

/// A blue rug, a flat box, at a height above a red floor.
fn rug(
    height: f64,
    floor_is_first: bool,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let (lbf, run) = (
        Point3::new(-2.0, height, -2.0),
        Point3::new(2.0, height, 2.0),
    );
    let rug = AxisAlignedBox::new(lbf, run)?;
    let (red, blue) = (Color::new(0.8, 0.2, 0.15), Color::new(0.2, 0.3, 0.8));
    let empty = World::new(Color::gray(0.9))?;
    let world = if floor_is_first {
        empty.with(floor, red).with(rug, blue)
    } else {
        empty.with(rug, blue).with(floor, red)
    };
    let (eye, up) = (Point3::new(1.3, 2.7, 5.1), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, Point3::ORIGIN - eye, up, 0.9)?;
    render(&camera, |ray| world.color_for(ray), settings, progress)
}
