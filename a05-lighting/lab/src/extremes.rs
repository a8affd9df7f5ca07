//! The stiff and extreme cases of this stage: far lights, lights inside of objects, lights
//! without a position; points at the edge of a cone, on its axis, and behind the light;
//! colours by the protocol's printed formulas; powers for exponents from 0 to overflow.

use std::f64::consts::PI;

use a02_lab::exact::DoubleDouble;
use a02_lab::protocol::angle_by_arc_cosine;
use a02_math::arrays::{point, vector};
use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Plane, Sphere};
use a04_lab::support::{Numbers, Triple};
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::Outcome::{self, Flag, Number, Refused};
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Ulps, greatest, tried};

use crate::protocol;
use a05_lighting::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SpotLight,
};

pub fn cases(effort: Effort) -> Vec<Case> {
    [spots(effort), lights(), materials()].concat()
}

/// Whether a spot light at the origin, of this direction and half angle, shines on a point.
type Lit = fn(Vector3, f64, Point3) -> Outcome;

#[rustfmt::skip]
fn spots(effort: Effort) -> Vec<Case> {
    let count = effort.choose(10_000, 100_000);
    let (ones, ahead) = ([1.0; 3], [0.0, 0.0, -1.0]);
    let beside = |angle: f64| [libm::sin(angle), 0.0, -libm::cos(angle)];
    let ours: Lit = |direction, half_angle, point| {
        let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
        light.map(|light| light.illuminates(point)).into()
    };
    let theirs: Lit = |direction, half_angle, point|
        protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, point).into();
    let spot = |id, what: &str, (direction, angle): (Triple, f64), at, exact: Outcome, says| {
        let [ours, theirs] = [ours, theirs].map(|is_lit| is_lit(vector(direction), angle, point(at)));
        Case::new(id, format!("spot, {what}: lit"), exact, Equal, ours).protocol(says, theirs)
    };
    // Directions of any length below √3.
    let number = |is_counted: &dyn Fn(Vector3) -> bool| {
        let directions = (0..count).map(|i| Numbers::new(9, i).triple(-1.0, 1.0));
        directions.filter(|v| is_counted(*v)).count()
    };
    let behind = |is_lit: Lit|
        number(&|v| is_lit(v, 0.1, Point3::ORIGIN - v * 3.0) == Flag(true));
    let not_numbers = |angle: fn(Vector3, Vector3) -> f64| number(&|v| angle(v, v * 3.0).is_nan());
    let (x, diagonal) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    vec![
        spot("F06", "a point on the axis", (ones, 0.1), ones, Flag(true), Holds),
        spot("F07", "a point straight behind", (ones, 0.1), [-1.0; 3], Flag(false), Fails),
        spot("F08", "half angle 0, a point on the axis", ([1.0, 1.0, 8.0], 0.0), [1.0, 1.0, 8.0], Refused, Fails),
        spot("F09", "half angle π, a point straight behind", (ahead, PI), [0.0, 0.0, 1.0], Flag(true), Holds),
        spot("F10", "half angle 1e-9, a point at 1e-8", (ahead, 1e-9), beside(1e-8), Refused, Fails),
        spot("F11", "the position itself", (ahead, 0.1), [0.0; 3], Flag(false), Fails),
        spot("F12", "half angle NaN", (ahead, f64::NAN), ahead, Refused, Fails),
        spot("F13", "a point 1e200 away on the axis", (ahead, 0.1), [0.0, 0.0, -1e200], Flag(true), Fails),
        spot("F37", "half angle 1e-7, a point at 1.2e-7", (ahead, 1e-7), beside(1.2e-7), Flag(false), Holds),
        spot("F38", "half angle 1e-7, a point at 0.8e-7", (ahead, 1e-7), beside(0.8e-7), Flag(true), Holds),
        Case::new("I09", format!("spot, {count} points straight behind: lit"), 0.0, Equal, behind(ours))
            .protocol(Fails, behind(theirs)),
        Case::new("S15", format!("{count} angles between parallel vectors: NaN"),
            0.0, Equal, not_numbers(Vector3::angle)).protocol(Fails, not_numbers(angle_by_arc_cosine)),
        Case::new("F39", "angle between (2, 0, 0) and (1, 1, 0)", PI / 4.0, Ulps(1.0), x.angle(diagonal))
            .protocol(Fails, protocol::angle(x, diagonal)),
    ]
}

/// A white shape with a light, and ambient light of 1/4.
fn world(shape: impl Geometry, light: impl Light) -> Result<LitWorld, ArgumentError> {
    let white = Box::new(Lambert::new(Color::WHITE)?);
    let world = LitWorld::new(Color::BLACK, Color::gray(0.25))?;
    Ok(world.with(shape, white).lit_by(Box::new(light)))
}

/// The brightness of a white wall at the origin, seen from straight before it.
fn brightness(n: Normal3, light: Result<impl Light, ArgumentError>) -> Outcome {
    tried(|| {
        let world = world(Plane::new(Point3::ORIGIN, n)?, light?)?;
        let n = Vector3::from(n);
        Ok(world.color_for(&Ray::derived(Point3::ORIGIN + n, -n)).r)
    })
}

/// A light in the centre of the unit sphere lights it from inside only. The protocol's normal
/// points to the eye.
#[rustfmt::skip]
fn lights() -> Vec<Case> {
    let (up, wall) = (Normal3::new(0.0, 1.0, 0.0), Normal3::new(1.0, 0.0, 0.0));
    let lamp = |y| PointLight::new(Color::WHITE, Point3::new(0.0, y, 0.0));
    let theirs = |y| protocol::lambert(up, Point3::new(0.0, y, 0.0), Point3::ORIGIN);
    let sun = |x, y| DirectionalLight::new(Color::WHITE, Vector3::new(x, y, 0.0));
    let nan = PointLight::new(Color::gray(f64::NAN), Point3::ORIGIN);
    let inside = |ray: Result<Ray, _>| Ok(world(Sphere::new(Point3::ORIGIN, 1.0)?, lamp(0.0)?)?.color_for(&ray?).r);
    let off_inside = |i| {
        let mut numbers = Numbers::new(6, i);
        let mut vector = || numbers.triple(-0.5, 0.5);
        let seen: Result<f64, ArgumentError> = inside(Ray::new(Point3::ORIGIN + vector(), vector()));
        seen.map_or(f64::NAN, |seen| seen - 1.25)
    };
    let rounding = Absolute(4.0 * f64::EPSILON);
    let sphere = |id, side, z: f64, exact: f64, says| {
        let ours = inside(Ray::new(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, -1.0)));
        let normal = Vector3::new(0.0, 0.0, if z > 1.0 { 1.0 } else { -1.0 });
        let theirs = protocol::lambert(normal.as_normal(), Point3::ORIGIN, Point3::ORIGIN + normal);
        let what = format!("light in the centre of a sphere seen from {side}: brightness");
        Case::new(id, what, exact, rounding, ours).protocol(says, 0.25 + theirs)
    };
    vec![
        sphere("I05", "outside", 3.0, 0.25, Holds),
        sphere("I06", "inside", 0.5, 1.25, Fails),
        Case::new("I19", "the same from 1000 eyes inside: greatest error",
            0.0, rounding, greatest((0..1000).map(off_inside))),
        Case::new("I07", "point light at 1e200", Refused, Equal, lamp(1e200).map(|_| true))
            .protocol(Fails, theirs(1e200)),
        Case::new("I20", "point light at 1e100: brightness below", 1.25, Ulps(1.0), brightness(up, lamp(1e100)))
            .protocol(Holds, 0.25 + theirs(1e100)),
        Case::new("I21", "point light at 1e-100: brightness below", 1.25, Ulps(1.0), brightness(up, lamp(1e-100)))
            .protocol(Holds, 0.25 + theirs(1e-100)),
        Case::new("I22", "directional light at the origin: lit", true, Equal,
            sun(0.0, -1.0).map(|light| light.illuminates(Point3::ORIGIN)))
            .protocol(Fails, protocol::directional_light_illuminates(Point3::ORIGIN, Point3::ORIGIN)),
        Case::new("I23", "directional light at a wall: brightness", 1.25, Equal, brightness(wall, sun(-1.0, 0.0)))
            .protocol(Fails, 0.25 + wall.dot(protocol::DIRECTIONAL_LIGHT_FROM).max(0.0)),
        Case::new("I24", "directional light of direction 0", Refused, Equal, sun(0.0, 0.0).map(|_| true)),
        Case::new("I25", "point light of colour NaN", Refused, Equal, nan.map(|_| true)),
    ]
}

const FRONT: Vector3 = Vector3::new(0.0, 0.0, 1.0);

/// The colour of a surface that faces (0, 0, 1), seen from the direction `eye`, in gray
/// lights from one direction.
fn seen(
    material: Result<impl Material, ArgumentError>,
    eye: Vector3,
    lights: &[f64],
    from: Vector3,
) -> Result<Color, ArgumentError> {
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK)?;
    for light in lights {
        let light = DirectionalLight::new(Color::gray(*light), -from)?;
        world = world.lit_by(Box::new(light));
    }
    let ray = Ray::derived(Point3::ORIGIN, -eye);
    Ok(material?.color_for(&ray, &Hit::new(1.0, FRONT.as_normal()), &world))
}

/// Without the sum over lights, only one counts; the highlight has the colour of the
/// light, not of the surface; a light brighter than 1 is valid, and only the picture is
/// clamped. The bound of the dark product is half a level of 255.
#[rustfmt::skip]
fn materials() -> Vec<Case> {
    let nan = Vector3::new(f64::NAN, 0.0, 1.0);
    let above = 1.0_f64.next_up();
    // Light from a little below the surface, which would mirror it to the eye:
    // r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
    let (below, eye) = (Vector3::new(0.8, 0.0, -0.6), Vector3::new(-0.8, 0.0, 0.6));
    let matt = |diffuse, lights: &[f64]|
        seen(Lambert::new(Color::gray(diffuse)), FRONT, lights, FRONT).map(|c| c.r);
    let green = seen(Phong::new(Color::RED, Color::WHITE, 64.0), FRONT, &[1.0], FRONT).map(|c| c.g);
    // A white highlight on a black surface.
    let highlight = |exponent, eye, from|
        seen(Phong::new(Color::BLACK, Color::WHITE, exponent), eye, &[1.0], from).map(|c| c.r);
    // The highlight of a light straight above, for a cosine of the angle between the mirrored
    // light and the eye.
    let power = |id, cosine: f64, exponent: f64, exact: Outcome, bound, says| {
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let ours = highlight(exponent, Vector3::new(sine, 0.0, cosine), FRONT);
        let what = format!("highlight, cosine {cosine}, exponent {exponent:e}");
        let case = Case::new(id, what, exact, bound, ours).condition((cosine > 0.0).then_some(exponent));
        let is_power = cosine > 0.0 && cosine < 1.0 && exponent.is_finite();
        let certified = || DoubleDouble::from(cosine).power(exponent as u64).value();
        case.certified(is_power.then(certified)).protocol(says, protocol::highlight(cosine, exponent))
    };
    vec![
        power("F14", -0.3, 0.0, Number(0.0), Equal, Fails),
        power("F15", 0.5, 0.0, Number(1.0), Equal, Holds),
        power("F17", above, 1e17, Number(1.0), Equal, Fails),
        power("F18", above, f64::INFINITY, Refused, Equal, Fails),
        power("F19", 0.0, -1.0, Refused, Equal, Fails),
        Case::new("F20", "a ray of direction NaN, whose highlight has exponent 0",
            Refused, Equal, Ray::new(Point3::ORIGIN, nan).map(|_| true))
            .protocol(Fails, protocol::highlight(f64::NAN, 0.0)),
        // Powers of the cosine as a double, not as a decimal. Only the power is rounded: the
        // sine belongs to a coordinate in which the mirrored light is 0.
        power("F16", 1.0 - 1e-7, 1e6, Number(0.904_837_413_559_398_8), Ulps(1.0), Holds),
        power("F22", 1.0 - 1e-12, 1e12, Number(0.367_887_579_387_309_76), Ulps(1.0), Holds),
        power("F34", 0.0, 0.0, Number(0.0), Equal, Fails),
        power("F35", 0.5, f64::NAN, Refused, Equal, Fails),
        Case::new("F36", "highlight of a light from behind the surface, exponent 2",
            0.0, Equal, highlight(2.0, eye, below)).protocol(Fails, protocol::highlight(0.28, 2.0)),
        Case::new("L01", "white under lights of 1/4 and 1/2", 0.75, Equal, matt(1.0, &[0.25, 0.5]))
            .protocol(Fails, protocol::phong(1.0, 0.0, 0.25, 1.0, 0.0)),
        Case::new("L02", "white highlight on red: its green", 1.0, Equal, green)
            .protocol(Fails, protocol::phong(0.0, 0.0, 1.0, 1.0, protocol::highlight(1.0, 64.0))),
        Case::new("L03", "a surface of 1/4 under a light of 3", 0.75, Equal, matt(0.25, &[3.0]))
            .protocol(Fails, protocol::clamped_product(0.25, 3.0)),
        Case::new("L04", "a surface of 1/10 under a light of 1/10", 0.01, Absolute(1.0 / 510.0), matt(0.1, &[0.1]))
            .protocol(Fails, protocol::integer_product(0.1, 0.1)),
    ]
}
