//! Lights in unusual positions, and the protocol's shadow rays.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::registry::ALL_SHAPES;
use a04_intersections::{Plane, Sphere, World};
use a04_lab::rows;
use a04_lab::support::{Triple, point};
use a05_lighting::{
    DirectionalLight, Lambert, Light, PointLight, SpotLight, instruments::instrumented,
};
use common::steps::{self, StepKind};
use common::{ArgumentError, Color, Error};
use corpus::{Question, Shape};
use measure::extremes::{AgainstProtocol, Case, Outcome, Row, tried};

use super::tilted_floor::{Expected, TiltedFloor};
use crate::protocol::{
    directional_light_illuminates, lambert, point_light_illuminates, spot_light_illuminates,
};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
/// Position of the lights that a ball may hide.
const LAMP: Point3 = Point3::new(0.0, 4.0, 0.0);
/// A ray to the origin, past the objects above it.
const EYE_RAY: Ray = Ray::derived(Point3::new(-3.0, 4.0, 0.0), Vector3::new(0.6, -0.8, 0.0));

/// A white floor, ambient light of 1/4, and one more light, which casts shadows.
fn world(light: Result<impl Light, ArgumentError>) -> Result<ShadowedWorld, Error> {
    let floor = Plane::new(Point3::ORIGIN, UP)?;
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor, Box::new(Lambert::new(Color::WHITE)?));
    Ok(world.lit_by(LightSource::new(light?, true)))
}

fn lit_from(position: Point3) -> Result<ShadowedWorld, Error> {
    world(PointLight::new(Color::WHITE, position))
}

fn lit_by_a_spot() -> Result<ShadowedWorld, Error> {
    world(SpotLight::new(Color::WHITE, LAMP, DOWN, 0.5))
}

fn above(height: f64) -> Point3 {
    Point3::new(0.0, height, 0.0)
}

/// The brightness of the floor at the origin, seen from straight above, under a light.
fn brightness(light: Point3) -> Outcome {
    tried(|| {
        let ray = Ray::derived(above(1.0), DOWN);
        Ok(RecursiveTracer::new(&lit_from(light)?).trace(&ray, 1).r)
    })
}

/// The same, and by the protocol.
pub fn under_a_light(height: f64) -> Case {
    let theirs = 0.25 + lambert(UP, above(height), Point3::ORIGIN);
    Case::of(brightness(above(height)), theirs)
}

/// The number of rays that are tested against the floor, without the camera's ray.
fn shadow_rays(light: Point3) -> Outcome {
    tried(|| {
        let world = lit_from(light)?;
        let world = instrumented::world(world, ALL_SHAPES, |surface| surface, |(_, light)| light);
        let (_, counts) = steps::counted(|| RecursiveTracer::new(&world).trace(&EYE_RAY, 1))?;
        Ok(counts[StepKind::Test] as f64 - 1.0)
    })
}

/// The brightness of the floor under a light at a position, by our code alone.
pub fn under_a_light_at(position: Triple) -> Case {
    Case::of_ours(brightness(point(position)))
}

/// How many shadow rays a light at a position costs.
pub fn rays_to_a_light_at(position: Triple) -> Case {
    Case::of_ours(shadow_rays(point(position)))
}

/// The protocol's function of a light.
type Illuminates = fn(Point3, Point3, &World<()>) -> bool;

/// A shadow ray from the floor to a lamp: whether the lamp shines on the floor, with a ball at some height.
pub fn under_a_ball_in_a_row(row: &Row, question: &Question) -> Case {
    let Shape::Sphere { center, radius } = question.shape else {
        return Row::unknown();
    };
    let is_spot = ["I17", "I18"].contains(&row.id.as_str());
    let (lit, illuminates): (_, Illuminates) = if is_spot {
        (lit_by_a_spot(), spot_light_illuminates)
    } else {
        (lit_from(LAMP), point_light_illuminates)
    };
    let ball = || Sphere::new(point(center), radius);
    let ours = tried(|| {
        let world = lit?.with(ball()?, Box::new(Lambert::new(Color::WHITE)?));
        Ok(RecursiveTracer::new(&world).trace(&EYE_RAY, 1).r > 0.25)
    });
    let theirs = tried(|| {
        let floor = World::new(Color::BLACK)?.with(Plane::new(Point3::ORIGIN, UP)?, ());
        let world = floor.with(ball()?, ());
        let shadow_ray = rows::line_of(question).raw_ray();
        Ok(illuminates(shadow_ray.at(1.0), shadow_ray.origin(), &world))
    });
    Case::of(ours, theirs)
}

/// The number of points that are judged wrongly, or why there is none.
type Counts = Result<AgainstProtocol<usize>, Error>;

/// A lamp on a slanted ceiling: all points below it are lit.
pub fn under_a_ceiling(points: usize) -> Counts {
    let floor = TiltedFloor::new(1.0)?;
    let lamp = floor.above(4.0);
    let ceiling = Plane::new(lamp, Normal3::new(0.1, 1.0, 0.3))?;
    let world = floor.world()?.with(ceiling, ());
    let light = PointLight::new(Color::WHITE, lamp)?;
    let expected = Expected {
        world: &world,
        light: &light,
        is_lit: true,
    };
    floor.misjudged(points, &expected, |point| {
        point_light_illuminates(lamp, point, &world)
    })
}

/// A ball that touches a tilted floor, in a scene of this size: all points below it are in its shadow.
pub fn under_a_ball(points: usize, size: f64) -> Counts {
    let floor = TiltedFloor::new(size)?;
    let lamp = floor.above(5.0);
    let ball = Sphere::new(floor.above(0.5), 0.5 * size)?;
    let world = floor.world()?.with(ball, ());
    let light = PointLight::new(Color::WHITE, lamp)?;
    let expected = Expected {
        world: &world,
        light: &light,
        is_lit: false,
    };
    floor.misjudged(points, &expected, |point| {
        point_light_illuminates(lamp, point, &world)
    })
}

/// An empty floor under a far light: all points are lit.
pub fn under_the_sun(points: usize) -> Counts {
    let floor = TiltedFloor::new(1.0)?;
    let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
    let world = floor.world()?;
    let light = DirectionalLight::new(Color::WHITE, direction)?;
    let expected = Expected {
        world: &world,
        light: &light,
        is_lit: true,
    };
    floor.misjudged(points, &expected, |point| {
        directional_light_illuminates(direction, point, &world)
    })
}
