//! The lesson's shapes and the engine, asked the cases of the corpus of ray failures.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Ray, Sampler};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a07_transforms::registry::ALL_SHAPES;
use a07_transforms::{Disc, Node, Transform};
use common::{Color, Error, Settings, Size};
use corpus::{Question, Shape, Step};
use engine::{Camera, Renderer, Scene, Shading, Surface};

/// Whether the lesson has the shape of a question.
#[must_use]
pub fn lesson_has(question: &Question) -> bool {
    !matches!(question.shape, Shape::Tube { .. })
}

/// Whether the engine can be asked: the lesson has the shape, and the interval is that of a whole ray.
#[must_use]
pub fn engine_has(question: &Question) -> bool {
    lesson_has(question) && question.within == [0.0, f64::INFINITY]
}

/// The nearest hit of the lesson's shapes.
///
/// # Errors
///
/// If a constructor refuses the numbers of the shape.
pub fn lesson(question: &Question) -> Result<Option<Hit>, Error> {
    let [min, max] = question.within;
    let hit = world(question)?
        .hit(&ray(question), Interval { min, max })
        .map(|(hit, ())| hit);
    Ok(hit)
}

/// The `t` of the hit that the engine finds, in a picture of one pixel.
///
/// # Errors
///
/// If a constructor refuses the numbers of the shape.
pub fn engine(question: &Question) -> Result<Option<f64>, Error> {
    let world = world(question)?;
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    ALL_SHAPES.add_objects(&mut scene, &world, |()| {
        // The colour of a hit: t, and that there is one.
        let shade = |_: &_, hit: &engine::Hit| Color::new(hit.t, 1.0, 0.0);
        Surface::matt(Shading::Other(Box::new(shade)))
    });
    let settings = Settings {
        size: Size::new(1, 1)?,
        ..Settings::default()
    };
    let ray = ray(question);
    let camera = Camera::Other(Box::new(|_, _, _| (&ray).into()));
    let renderer = Renderer::new(scene, camera, &settings);
    let image = renderer.render(&Sampler::new(&settings), &settings, &())?;
    let [t, is_hit, _] = image
        .rows()
        .flatten()
        .next()
        .map_or([0.0; 3], |color| color.channels());
    Ok((is_hit > 0.0).then_some(t))
}

/// The ray of a question, whose direction keeps its length.
#[must_use]
pub fn ray(question: &Question) -> Ray {
    let [x, y, z] = question.direction;
    Ray::derived(point(question.origin), Vector3::new(x, y, z))
}

/// The shape of a question as a list of the lesson's shapes, each under a node for each step; empty
/// if the lesson has no such shape.
///
/// # Errors
///
/// If a constructor refuses the numbers of the shape.
pub fn world(question: &Question) -> Result<World<()>, Error> {
    let mut world = World::new(Color::BLACK)?;
    for mut shape in shapes(&question.shape)? {
        for step in question.under.iter().rev() {
            let transform = match *step {
                Step::Translate(by) => Transform::IDENTITY.translate(point(by))?,
                Step::Scale([x, y, z]) => Transform::IDENTITY.scale(x, y, z)?,
            };
            shape = Box::new(Node::new(transform).with(shape));
        }
        world = world.with(shape, ());
    }
    Ok(world)
}

/// The shapes of the lesson that a shape consists of.
fn shapes(shape: &Shape) -> Result<Vec<Box<dyn Geometry>>, Error> {
    let one: Box<dyn Geometry> = match *shape {
        Shape::Plane { point: a, normal } => Box::new(Plane::new(point(a), normal3(normal))?),
        Shape::Sphere { center, radius } => Box::new(Sphere::new(point(center), radius)?),
        Shape::Box { low, high } => Box::new(AxisAlignedBox::new(point(low), point(high))?),
        Shape::Disc {
            center,
            normal,
            radius,
        } => Box::new(Disc::new(point(center), normal3(normal), radius)?),
        Shape::Tube { .. } => return Ok(Vec::new()),
        Shape::Triangles(ref triangles) => {
            let mut all: Vec<Box<dyn Geometry>> = Vec::new();
            for corners in triangles {
                let [a, b, c] = corners.map(point);
                all.push(Box::new(Triangle::new(a, b, c)?));
            }
            return Ok(all);
        }
    };
    Ok(vec![one])
}

fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

fn normal3([x, y, z]: [f64; 3]) -> Normal3 {
    Normal3::new(x, y, z)
}
