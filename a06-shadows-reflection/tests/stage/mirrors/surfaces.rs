//! Surfaces that mirror and surfaces that do not.

use a02_math::{Point3, Vector3};
use a04_intersections::{AxisAlignedBox, Sphere};
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SingleColor};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use common::{ArgumentError, Color};

use super::{UP, balls, mirror, plane, trace, views, world};

/// Mirrors, shadows and both kinds of lights.
fn everything() -> ShadowedWorld {
    let shiny = Phong::new(Color::gray(0.5), Color::WHITE, 20.0).unwrap();
    let tinted = Reflective::new(Color::RED, Color::WHITE, 64.0, Color::new(0.0, 0.5, 0.9));
    let (lbf, run) = (Point3::new(-4.0, 0.0, -3.0), Point3::new(-3.0, 2.0, 3.0));
    let sun = DirectionalLight::new(Color::gray(0.5), Vector3::new(1.0, -2.0, 0.5)).unwrap();
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 6.0, 4.0)).unwrap();
    balls(world(Color::new(0.1, 0.2, 0.3), Color::gray(0.25)))
        .with(
            plane(Point3::ORIGIN, UP),
            mirror(Color::gray(0.3), Color::gray(0.5)),
        )
        .with(AxisAlignedBox::new(lbf, run).unwrap(), Box::new(shiny))
        .with(
            Sphere::new(Point3::new(0.0, 4.0, -3.0), 2.0).unwrap(),
            Box::new(tinted.unwrap()),
        )
        .lit_by(LightSource::new(sun, true))
        .lit_by(LightSource::new(lamp, true))
}

/// A counter of depth in the tracer, used up by the first ray, would darken
/// all others.
#[test]
fn a_tracer_remembers_nothing() {
    let world = everything();
    let tracer = RecursiveTracer::new(&world);
    let views = views();
    let forwards: Vec<_> = views.iter().map(|ray| tracer.trace(ray, 4)).collect();
    let backwards: Vec<_> = views.iter().rev().map(|ray| tracer.trace(ray, 4)).collect();
    assert!(forwards.iter().eq(backwards.iter().rev()));
    let fresh = views.iter().map(|ray| trace(&world, ray, 4));
    assert!(fresh.eq(forwards));
}

#[test]
fn a_mirror_of_nothing_is_the_shiny_surface_under_it() {
    let (diffuse, specular) = (Color::new(0.2, 0.4, 0.6), Color::gray(0.5));
    let ball = Sphere::new(Point3::new(0.0, 2.0, 0.0), 2.0).unwrap();
    let with = |surface: Box<dyn Surface>| {
        let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 6.0, 4.0)).unwrap();
        world(Color::WHITE, Color::gray(0.25))
            .with(ball, surface)
            .lit_by(LightSource::new(lamp, true))
    };
    let blind = Reflective::new(diffuse, specular, 8.0, Color::BLACK).unwrap();
    let [blind, shiny] = [
        with(Box::new(blind)),
        with(Box::new(Phong::new(diffuse, specular, 8.0).unwrap())),
    ];
    for ray in views() {
        assert_eq!(trace(&blind, &ray, 3), trace(&shiny, &ray, 3));
    }
}

#[test]
fn only_reflective_surfaces_reflect() {
    let white = Color::WHITE;
    let surfaces: [(Box<dyn Surface>, Color); 4] = [
        (Box::new(SingleColor::new(white).unwrap()), Color::BLACK),
        (Box::new(Lambert::new(white).unwrap()), Color::BLACK),
        (
            Box::new(Phong::new(white, white, 1.0).unwrap()),
            Color::BLACK,
        ),
        (mirror(white, Color::YELLOW), Color::YELLOW),
    ];
    for (surface, expected) in surfaces {
        assert_eq!(surface.reflection(), expected);
    }
}

#[test]
fn bad_arguments_are_refused_by_name() {
    let white = Color::WHITE;
    let assert_refused = |result: Result<Reflective, ArgumentError>, name: &str, allowed: &str| {
        let said = result.unwrap_err().to_string();
        assert!(said.starts_with(name) && said.contains(allowed), "{said}");
    };
    for number in [f64::NAN, f64::INFINITY, -0.5] {
        let bad = Color::new(1.0, 1.0, number);
        let (color, least) = ("channels from 0 to 1e50", "at least 0");
        for (result, name, allowed) in [
            (Reflective::new(bad, white, 1.0, white), "diffuse is", color),
            (
                Reflective::new(white, bad, 1.0, white),
                "specular is",
                color,
            ),
            (
                Reflective::new(white, white, number, white),
                "exponent is",
                least,
            ),
        ] {
            assert_refused(result, name, allowed);
        }
    }
    for number in [f64::NAN, f64::INFINITY, -0.5, 1.0_f64.next_up()] {
        let bad = Color::new(1.0, 1.0, number);
        let result = Reflective::new(white, white, 1.0, bad);
        assert_refused(result, "reflection is", "from 0 to 1");
    }
}
